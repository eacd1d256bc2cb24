#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "buffers.hpp"
#include "document.hpp"

namespace lineatlas::gltf {

/// The elements of an accessor, one after another: floats, or whole numbers by
/// KHR_mesh_quantization. Sparse values are in their places.
struct Values {
    std::uint64_t width; ///< components of an element
    std::vector<double> numbers;
    double step = 0; ///< the distance from one whole number to the next; 0: they are floats

    std::size_t size() const { return numbers.size() / width; }
    const double* operator[](std::size_t i) const { return numbers.data() + i * width; }
};

/// Reads an accessor. `type`, `width`: those that it must have, such as "VEC3" and 3.
Values read_values(const Document& document, Buffers& buffers, std::uint64_t accessor,
                   std::string_view type, std::uint64_t width);

struct Points {
    std::vector<glm::dvec3> places;
    double step = 0; ///< of the grid that they lie on; 0: no grid
};

Points read_points(const Document& document, Buffers& buffers, std::uint64_t accessor);

std::vector<std::uint32_t> read_indices(const Document& document, Buffers& buffers,
                                        std::uint64_t accessor);

} // namespace lineatlas::gltf
