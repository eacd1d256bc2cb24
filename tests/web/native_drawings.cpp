// Writes, for each model, what a page would give the npm package, and what the library makes of it:
// web_test.mjs lets the package make the same. Prints milliseconds for each: lines, the first view,
// the next one. Usage: native_drawings FOLDER [SCENE...]
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "lineatlas/framing.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace {

using namespace lineatlas;
using Json = nlohmann::json;

constexpr glm::ivec2 size{1024, 768};

void write(const std::filesystem::path& path, std::string_view text) {
    std::ofstream file{path, std::ios::binary};
    if (!file.write(text.data(), static_cast<std::streamsize>(text.size()))) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
        std::exit(1);
    }
}

/// A ring, of which all but silhouettes is smooth.
Mesh torus() {
    constexpr std::uint32_t around = 48, across = 24;
    Mesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            constexpr float turn = 2 * std::numbers::pi_v<float>;
            const float u = turn * static_cast<float>(i) / around;
            const float v = turn * static_cast<float>(k) / across;
            const float radius = 2 + 0.7F * std::cos(v);
            mesh.positions.emplace_back(radius * std::cos(u), 0.7F * std::sin(v),
                                        radius * std::sin(u));
            const auto at = [&](std::uint32_t di, std::uint32_t dk) {
                return (i + di) % around * across + (k + dk) % across;
            };
            mesh.triangles.emplace_back(at(0, 0), at(0, 1), at(1, 0));
            mesh.triangles.emplace_back(at(0, 1), at(1, 1), at(1, 0));
        }
    }
    return mesh;
}

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.emplace_back((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                                    (i & 4U) != 0 ? high.z : low.z);
    for (const auto& [a, b, c, d] :
         {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
          std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}})
        add_polygon(mesh, std::array{first + a, first + b, first + c, first + d});
}

/// Two that pass through each other.
Mesh crossing_boxes() {
    Mesh mesh;
    add_box(mesh, {-1, -1, -1}, {1, 1, 1});
    add_box(mesh, {0.3F, -0.4F, -2}, {2, 0.5F, 2});
    return mesh;
}

/// As the package makes it of arrays: one object, of materials by number.
Mesh as_arrays(const Mesh& mesh) {
    Mesh made = make_mesh({.positions = {&mesh.positions.front().x, 3 * mesh.positions.size()},
                           .indices = {&mesh.triangles.front().x, 3 * mesh.triangles.size()},
                           .materials = mesh.triangle_group});
    if (made.groups.empty()) {
        made.groups.emplace_back();
        made.triangle_group.assign(made.triangles.size(), 0);
    }
    for (MeshGroup& group : made.groups) group.object = "model";
    made.triangle_object.assign(made.triangles.size(), 0);
    return made;
}

class Watch {
  public:
    /// Milliseconds since the last time.
    double take() {
        const auto now = Clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(last_, now)).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

template <class Vector>
Json numbers(const std::vector<Vector>& list) {
    Json json = Json::array();
    for (const Vector& v : list)
        for (int k = 0; k < 3; ++k) json.push_back(v[k]);
    return json;
}

void draw(const std::filesystem::path& folder, const std::string& name, const Mesh& given) {
    const Mesh mesh = as_arrays(given);
    Watch watch;
    const LineSet lines = extract_lines(mesh);
    LineVisibility visibility{lines, {.compute = "cpp"}};
    const double made = watch.take();
    const View view = frame_points(framing_of(lines).points, size);
    const Camera camera = make_camera(view, size, lines.bounds);
    watch.take();
    visibility.find(camera);
    const double first = watch.take();
    visibility.find(camera);
    const double next = watch.take();
    const auto drawing = [&](bool hidden) {
        Style style;
        style.hidden = hidden;
        const std::vector<Interval> intervals = visibility.find(camera, {.hidden = hidden});
        return make_vector_drawing(lines, camera, intervals, style, {.mesh = &mesh});
    };
    const auto matrix = [](const glm::mat4& m) {
        return std::vector<float>(glm::value_ptr(m), glm::value_ptr(m) + 16);
    };
    write(folder / (name + ".json"), Json{{"positions", numbers(given.positions)},
                                          {"indices", numbers(given.triangles)},
                                          {"materials", given.triangle_group},
                                          {"view", matrix(camera.view)},
                                          {"projection", matrix(camera.projection)},
                                          {"width", size.x},
                                          {"height", size.y},
                                          {"segments", lines.segments.size()}}
                                         .dump());
    write(folder / (name + ".svg"), to_svg(drawing(false)));
    write(folder / (name + "_hidden.svg"), to_svg(drawing(true)));
    write(folder / (name + ".dxf"), to_dxf(drawing(false)));
    write(folder / (name + "_drawing.json"), to_json(drawing(false)));
    std::printf("%-10s%9zu %8.1f %8.1f %8.1f\n", name.c_str(), mesh.triangles.size(), made, first,
                next);
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2) return 2;
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    for (const char* scene : std::span{arguments, static_cast<std::size_t>(count)}.subspan(2))
        draw(folder, scene, make_scene(scene).mesh);
    if (count > 2) return 0;
    write(folder / "kinds.json", Json(line_kind_names).dump());
    for (const char* scene : {"house", "clevis"}) draw(folder, scene, make_scene(scene).mesh);
    draw(folder, "torus", torus());
    draw(folder, "crossing", crossing_boxes());
}
