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
    std::vector<Measured> depth; ///< all triangles into a depth buffer, "1x" and "2x"
    /// What the stages of a profiled frame add up to, median; NaN without profiles.
    double profiled_ms = std::numeric_limits<double>::quiet_NaN();

    /// Whether it is one of Table 1, or a model measured likewise.
    bool is_of_table() const;
    /// Nothing if it was not measured.
    const Measured* method(std::string_view method_name) const;
    const Measured* depth_at(int scale) const;
};

struct Report {
    std::string device; ///< what computes, and how buffers are shared
    std::string gl;
    glm::ivec2 size{0};
    std::vector<SceneResult> scenes;

    const SceneResult* scene(std::string_view name) const;
    /// The frame time of OGL on this scene, or for "+s" on the scene without; nothing if not
    /// measured.
    const Measured* opengl_for(std::string_view scene_name) const;
};

/// Frames per second in Table 1 of the paper.
struct PaperFigure {
    std::string_view text; ///< as printed, e.g. "300+"
    double fps;
};
std::optional<PaperFigure> paper_figure(std::string_view scene, std::string_view method);

/// The paper's frame rate over its OGL's on the same scene, "+s" or not.
std::optional<double> paper_to_opengl(std::string_view scene, std::string_view method);

/// One of the ratios that the project sets itself.
struct Goal {
    std::string what; ///< "SAhi/OGL"
    std::string scene;
    std::optional<double> paper;
    std::optional<double> ours; ///< nothing if something it needs was not measured
    double must, aim;
    bool at_most = false; ///< smaller is better

    bool reaches(double bound) const { return ours && (at_most ? *ours <= bound : *ours >= bound); }
};
std::vector<Goal> goals(const Report& report);

} // namespace lineatlas::bench
