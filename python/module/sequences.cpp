#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "lineatlas/camera_path.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/framing.hpp"
#include "model.hpp"
#include "process.hpp"
#include "views.hpp"

namespace lineatlas::python {
namespace {

constexpr int most_frames = 1'000'000;

using FramesArgument = Argument<int, "frames", "a whole number">;
using KeysArgument =
    Argument<std::map<double, View>, "keys", "a dictionary with a View for each frame">;

std::vector<View> turntable(const ModelArgument& model, FramesArgument frames,
                            const SizeArgument& size, const UpArgument& up, Real<"fov"> fov,
                            const std::string& projection, const std::optional<std::string>& view) {
    if (*frames < 1 || *frames > most_frames)
        throw UsageError("frames must be from 1 to " + std::to_string(most_frames));
    std::vector<View> views;
    std::string note;
    {
        const auto mesh = model_of(model);
        const Released released;
        const LineSet lines = extract_lines(mesh->mesh);
        Framing framing = framing_of(lines);
        note = std::move(framing.note);
        const Axis axis{.point = 0.5F * (lines.bounds.min + lines.bounds.max),
                        .direction = axis_of(up)};
        const View first =
            frame(swept(framing.points, axis), size, up, fov, parse_projection(projection), view);
        for (int i = 0; i < *frames; ++i)
            views.push_back(turned(first, axis, static_cast<double>(i) / *frames));
    }
    warn_user(note);
    return views;
}

std::vector<View> camera_path(const KeysArgument& keys) {
    std::vector<CameraPath::Key> ordered;
    for (const auto& [frame, view] : *keys) ordered.push_back({frame, view});
    const CameraPath path{std::move(ordered)};
    std::vector<View> views;
    for (int frame = path.first_frame(); frame <= path.last_frame(); ++frame)
        views.push_back(path.view(frame));
    return views;
}

} // namespace

void bind_sequences(py::module_& module) {
    module.def(
        "turntable", &turntable, py::arg("model"), py::arg("frames"), py::kw_only(),
        py::arg("size") = usual_size, py::arg("up") = "y", py::arg("fov") = 40.0F,
        py::arg("projection") = "perspective", py::arg("view") = py::none(),
        "Views of one turn around a mesh, or that of a file, which stays in the picture. The\n"
        "first view is that of frame(); the others follow counter-clockwise, seen from\n"
        "above.");
    module.def(
        "camera_path", &camera_path, py::arg("keys"),
        "A view for each whole frame, from the first key to the last, of a camera that moves\n"
        "smoothly. keys: a dictionary of frames and the View at each. The camera rests\n"
        "between two equal views.");
}

} // namespace lineatlas::python
