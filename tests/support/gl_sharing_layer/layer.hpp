#pragma once

#include <cstdint>

/// A layer between the OpenCL loader and a driver without cl_khr_gl_sharing (OPENCL_LAYERS): it
/// implements that extension by copying, and counts what would be wrong on a driver that really
/// shares. LINEATLAS_TEST_LAYER names how it behaves, see Behaviour in layer.cpp; every call reads
/// it again.
namespace lineatlas::test {

struct LayerCounts {
    std::uint32_t contexts;   ///< made with a GL context
    std::uint32_t acquired;   ///< objects
    std::uint32_t released;   ///< objects
    std::uint32_t fences;     ///< events made of GL fences
    std::uint32_t gl_waits;   ///< glFinish
    std::uint32_t cl_waits;   ///< clFinish
    std::uint32_t no_images;  ///< textures for which the driver made no image: PoCL 7.1 makes none
    std::uint32_t violations; ///< of the rules of sharing; each is printed
};

/// The words of a probe about textures after these counts.
inline const char* said_of_textures(const LayerCounts& counts) {
    return counts.no_images > 0 ? "textures not: " : "textures too";
}

/// The type of the function that the layer exports. It returns the counts since its last call.
using TakeLayerCounts = LayerCounts();
inline constexpr const char* take_layer_counts_symbol = "lineatlas_test_take_layer_counts";

} // namespace lineatlas::test

extern "C" lineatlas::test::LayerCounts lineatlas_test_take_layer_counts();
