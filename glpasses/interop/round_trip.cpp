#include "round_trip.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "glpasses/objects.hpp"
#include "lineatlas/error.hpp"
#include "shared_table.hpp"

namespace lineatlas::interop {
namespace {

/// A two-dimensional GL texture that OpenCL has opened as an image. Only gl-sharing can do that.
/// The renderer passes depth as a buffer, which every mode can; see docs/interop.md.
class SharedTexture final : public Shared {
  public:
    /// Opens level 0 of `texture`. Its size and format must be final, and it must outlive this
    /// object. Throws DeviceError if the driver refuses, as it does for formats that OpenCL lacks.
    SharedTexture(const compute::OpenClBackend& device, GLuint texture) try
        : image_(device.context(), CL_MEM_READ_WRITE, GL_TEXTURE_2D, 0, texture, nullptr) {
    } catch (const cl::Error& error) {
        throw DeviceError(std::string{"sharing a GL texture failed: "} + error.what() +
                          " returned " + std::to_string(error.err()));
    }
    const cl::Image& image() const { return image_; } ///< for kernels, while compute has it

  private:
    _cl_mem* opened() const override { return image_(); }

    cl::ImageGL image_;
};

} // namespace

bool round_trip(compute::Device& device, SharingMode mode) {
    constexpr std::uint32_t n = 1023;
    constexpr std::size_t bytes = (n + 1) * sizeof(std::uint32_t);
    Sharing sharing{device, mode};
    SharedTable table{sharing, compute::table::work_space};
    table.fit(bytes);
    const std::uint32_t one = 1;
    glClearNamedBufferData(table.gl_to_write(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one);
    compute::Stages stages{device};
    stages.scan(table.compute(), n, compute::ScanKind::saturate); // ones become 0, 1, 2, ...
    // The table is copied on the GL side first, so that GL itself has read it.
    const gl::Buffer copy = gl::Buffer::create();
    glNamedBufferStorage(copy.id(), bytes, nullptr, 0);
    glCopyNamedBufferSubData(table.gl(), copy.id(), 0, 0, bytes);
    std::vector<std::uint32_t> seen(n + 1);
    glGetNamedBufferSubData(copy.id(), 0, bytes, seen.data());
    std::vector<std::uint32_t> expected(n + 1);
    std::iota(expected.begin(), expected.end(), 0U);
    return seen == expected;
}

bool texture_round_trip(compute::OpenClBackend& device) {
    constexpr std::size_t side = 64;
    constexpr std::array<std::size_t, 3> origin{0, 0, 0};
    constexpr std::array<std::size_t, 3> region{side, side, 1};
    const gl::Texture2D texture = gl::Texture2D::create();
    glTextureStorage2D(texture.id(), 1, GL_R32F, side, side);
    const float from_gl = 0.25F;
    glClearTexImage(texture.id(), 0, GL_RED, GL_FLOAT, &from_gl);

    SharedTexture shared{device, texture.id()};
    Sharing sharing{device, SharingMode::gl_sharing};
    std::vector<float> seen(side * side);
    sharing.to_compute(shared);
    std::vector<float> from_compute(side * side);
    std::iota(from_compute.begin(), from_compute.end(), 0.0F);
    try {
        device.queue().enqueueReadImage(shared.image(), CL_TRUE, origin, region, 0, 0, seen.data());
        device.queue().enqueueWriteImage(shared.image(), CL_TRUE, origin, region, 0, 0,
                                         from_compute.data());
    } catch (const cl::Error& error) {
        throw DeviceError(std::string{error.what()} + " returned " + std::to_string(error.err()));
    }
    sharing.to_gl(shared);
    if (std::ranges::count(seen, from_gl) != static_cast<std::ptrdiff_t>(seen.size())) return false;
    glGetTextureImage(texture.id(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(seen.size() * sizeof(float)), seen.data());
    return seen == from_compute;
}

} // namespace lineatlas::interop
