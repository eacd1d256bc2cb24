#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "measure.hpp"

namespace lineatlas::bench {

/// One row's figures: a scene, or a scene with silhouettes.
struct SceneResult {
    std::string name; ///< "ship", "ship+s", "hidden 1x"
    std::uint32_t triangles = 0;
    std::uint32_t segments = 0;
    std::vector<Measured> methods;
    std::vector<Measured> depth; ///< drawing all triangles into a depth buffer, "1x" and "2x"
    /// The median sum of the stages of a profiled frame; NaN without profiles.
    double profiled_ms = std::numeric_limits<double>::quiet_NaN();

    /// True for rows of Table 1 and for models measured in the same way.
    bool is_of_table() const;
    /// The result of a method; null if it was not measured.
    const Measured* method(std::string_view method_name) const;
    const Measured* depth_at(int scale) const;
};

struct Report {
    std::string device; ///< the device and the sharing mode
    std::string gl;
    glm::ivec2 size{0};
    std::vector<SceneResult> scenes;

    const SceneResult* scene(std::string_view name) const;
    /// The result of OGL on this scene; for "+s" that of the scene without silhouettes. Null if it
    /// was not measured.
    const Measured* opengl_for(std::string_view scene_name) const;
};

/// Frames per second in Table 1 of the paper.
struct PaperFigure {
    std::string_view text; ///< as printed, e.g. "300+"
    double fps;
};
std::optional<PaperFigure> paper_figure(std::string_view scene, std::string_view method);

/// The paper's frame rate of a method over the paper's frame rate of OGL on the same scene.
std::optional<double> paper_to_opengl(std::string_view scene, std::string_view method);

/// A ratio that the project wants to reach.
struct Goal {
    std::string what; ///< "SAhi/OGL"
    std::string scene;
    std::optional<double> paper;
    std::optional<double> ours; ///< nothing if a figure for it was not measured
    double must, aim;
    bool at_most = false; ///< the bounds are upper bounds

    bool reaches(double bound) const { return ours && (at_most ? *ours <= bound : *ours >= bound); }
};
std::vector<Goal> goals(const Report& report);

} // namespace lineatlas::bench
