#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "arguments.hpp"
#include "arrays.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::python {

using UpAxis = std::variant<std::string, Triple>; ///< "x", "y", "z" or a vector
using ViewOrCamera = std::variant<View, Camera>;
using Size = std::array<int, 2>;

constexpr Size usual_size{1024, 768}; ///< of pictures

using SizeArgument = Argument<Size, "size", "two whole numbers, width and height">;
using UpArgument = Argument<UpAxis, "up", "\"x\", \"y\", \"z\" or three numbers">;

glm::vec3 up_of(const UpAxis& up);
/// The up axis of views that frame a model: x, y or z. Throws UsageError for others.
glm::vec3 axis_of(const UpAxis& up);

/// The view on `points` from the front. `fov` is in degrees. Throws UsageError without points.
View frame(std::span<const glm::vec3> points, Size size, const UpAxis& up, float fov,
           Projection projection = Projection::perspective,
           const std::optional<std::string>& direction = {});

/// A camera, and the text of a warning; empty: none.
struct Shot {
    Camera camera;
    std::string note{};
};

/// The camera of a picture of `size`. Without `given` it frames the lines.
Shot camera_of(const std::optional<ViewOrCamera>& given, Size size, const UpAxis& up,
               const LineSet& lines);

/// Issues a Python warning at the line that called the package; nothing for an empty text. Throws
/// Python's exception if warnings are errors.
void warn_user(const std::string& text);

using MaybeView =
    Argument<std::optional<ViewOrCamera>, "view", "a View, such as View(eye, target), or a Camera">;

} // namespace lineatlas::python
