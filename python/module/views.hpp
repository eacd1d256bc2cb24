#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "arguments.hpp"
#include "arrays.hpp"
#include "lineatlas/camera.hpp"

namespace lineatlas::python {

using UpAxis = std::variant<std::string, Triple>; ///< "x", "y", "z" or a vector
using ViewOrCamera = std::variant<View, Camera>;
using Size = std::array<int, 2>;

constexpr Size usual_size{1024, 768}; ///< of pictures

using SizeArgument = Argument<Size, "size", "two whole numbers, width and height">;
using UpArgument = Argument<UpAxis, "up", "\"x\", \"y\", \"z\" or three numbers">;

glm::vec3 up_of(const UpAxis& up);

/// The view on `points` from the front; throws UsageError if there are none. `fov` in degrees.
View frame(std::span<const glm::vec3> points, Size size, const UpAxis& up, float fov,
           Projection projection = Projection::perspective,
           const std::optional<std::string>& direction = {});

/// The camera of a picture of `size`. `given`: nothing frames `points`, which `bounds` holds.
Camera camera_of(const std::optional<ViewOrCamera>& given, Size size, const UpAxis& up,
                 std::span<const glm::vec3> points, const Bounds& bounds);

using MaybeView =
    Argument<std::optional<ViewOrCamera>, "view", "a View, such as View(eye, target), or a Camera">;

} // namespace lineatlas::python
