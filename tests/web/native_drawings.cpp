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
#include "lineatlas/io.hpp"
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

/// A ring, of which all but silhouettes is smooth where the rounds have many sides.
Mesh torus(std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            constexpr float turn = 2 * std::numbers::pi_v<float>;
            const float u = turn * static_cast<float>(i) / static_cast<float>(around);
            const float v = turn * static_cast<float>(k) / static_cast<float>(across);
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

/// Hills with a boundary, which hide each other.
Mesh terrain() {
    constexpr std::uint32_t side = 40;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x) {
            const float u = 0.2F * static_cast<float>(x), v = 0.2F * static_cast<float>(y);
            mesh.positions.emplace_back(u, std::sin(1.7F * u) * std::cos(1.3F * v), v);
        }
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t i = y * (side + 1) + x, below = i + side + 1;
            mesh.triangles.emplace_back(i, below, i + 1);
            mesh.triangles.emplace_back(i + 1, below, below + 1);
        }
    return mesh;
}

/// Boxes of several heights that stand side by side.
Mesh city() {
    Mesh mesh;
    for (int x = 0; x < 9; ++x)
        for (int z = 0; z < 9; ++z) {
            const auto u = static_cast<float>(x), v = static_cast<float>(z);
            add_box(mesh, {u, 0, v},
                    {u + 0.8F, static_cast<float>((7 * x + 5 * z) % 6 + 1), v + 0.8F});
        }
    return mesh;
}

/// Steps each of which lies on the one below.
Mesh stairs() {
    Mesh mesh;
    for (int i = 0; i < 12; ++i) {
        const auto step = static_cast<float>(i);
        add_box(mesh, {step, step, 0}, {12, step + 1, 6});
    }
    return mesh;
}

/// A tube along a helix, open at both ends.
Mesh spring() {
    constexpr std::uint32_t along = 160, across = 10;
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    Mesh mesh;
    for (std::uint32_t i = 0; i <= along; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const float u = 5 * turn * static_cast<float>(i) / along;
            const float v = turn * static_cast<float>(k) / across;
            const float radius = 2 + 0.3F * std::cos(v);
            mesh.positions.emplace_back(radius * std::cos(u), 0.15F * u + 0.3F * std::sin(v),
                                        radius * std::sin(u));
        }
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const std::uint32_t a = i * across + k, b = i * across + (k + 1) % across;
            mesh.triangles.emplace_back(a, b, a + across);
            mesh.triangles.emplace_back(b, b + across, a + across);
        }
    return mesh;
}

/// Loose triangles that cut each other.
Mesh shards() {
    std::uint32_t state = 1;
    const auto next = [&] {
        state = state * 1664525U + 1013904223U;
        return static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U);
    };
    Mesh mesh;
    for (std::uint32_t i = 0; i < 120; ++i) {
        const glm::vec3 middle{8 * next(), 8 * next(), 8 * next()};
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 off{next(), next(), next()};
            mesh.positions.push_back(middle + 3.0F * off);
        }
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

/// Two parts of two materials, faces of three to five corners, one of them concave, and a line.
constexpr std::string_view obj = R"(o house
v 0 0 0
v 4 0 0
v 4 3 0
v 2 5 0
v 0 3 0
v 0 0 3
v 4 0 3
v 4 3 3
v 2 5 3
v 0 3 3
usemtl wall
f 5 4 3 2 1
f 6 7 8 9 10
f 1 2 7 6
f 2 3 8 7
f 1 6 10 5
usemtl roof
f 3 4 9 8
f 4 5 10 9
o fence
usemtl wall
v 5 0 0
v 7 0 0
v 7 2 0
v 6 1 0
v 5 2 0
f -5/1 -4/1 -3//1 -2 -1
l 1 11 12
)";

std::string ply_of(const Mesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                       std::to_string(mesh.positions.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const glm::vec3& p : mesh.positions)
        for (int k = 0; k < 3; ++k) text += std::to_string(p[k]) + (k < 2 ? " " : "\n");
    for (const glm::uvec3& t : mesh.triangles)
        text += "3 " + std::to_string(t.x) + ' ' + std::to_string(t.y) + ' ' + std::to_string(t.z) +
                '\n';
    return text;
}

std::string stl_of(const Mesh& mesh) {
    std::string bytes(80, ' ');
    const auto append = [&](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    append(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const glm::uvec3& t : mesh.triangles) {
        append(glm::vec3{0});
        for (int k = 0; k < 3; ++k) append(mesh.positions[t[k]]);
        append(std::uint16_t{0});
    }
    return bytes;
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

Json matrices_of(const Camera& camera) {
    const auto matrix = [](const glm::mat4& m) {
        return std::vector<float>(glm::value_ptr(m), glm::value_ptr(m) + 16);
    };
    return {{"view", matrix(camera.view)},
            {"projection", matrix(camera.projection)},
            {"width", size.x},
            {"height", size.y}};
}

/// Writes a model as a file, what its reader makes of it, and the camera of that drawing.
void draw_file(const std::filesystem::path& folder, const std::string& name,
               std::string_view contents) {
    write(folder / name, contents);
    const Mesh mesh = load_mesh(folder / name).mesh;
    const LineSet lines = extract_lines(mesh);
    LineVisibility visibility{lines, {.compute = "cpp"}};
    const Camera camera =
        make_camera(frame_points(framing_of(lines).points, size), size, lines.bounds);
    const VectorDrawing drawing =
        make_vector_drawing(lines, camera, visibility.find(camera), {}, {.mesh = &mesh});
    write(folder / (name + ".svg"), to_svg(drawing));
    write(folder / (name + ".json"), matrices_of(camera).dump());
}

/// Writes what the reader says of a file that it refuses.
void refuse_file(const std::filesystem::path& folder, const std::string& name,
                 std::string_view contents) {
    const std::filesystem::path before = std::filesystem::current_path();
    write(folder / name, contents);
    std::filesystem::current_path(folder); // messages name the file as it is given
    std::string message = "read";
    try {
        load_mesh(name);
    } catch (const FileError& error) {
        message = error.what();
    }
    std::filesystem::current_path(before);
    write(folder / (name + ".error"), message);
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
    Json json = matrices_of(camera);
    json["positions"] = numbers(given.positions);
    json["indices"] = numbers(given.triangles);
    json["materials"] = given.triangle_group;
    json["segments"] = lines.segments.size();
    write(folder / (name + ".json"), json.dump());
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
    draw(folder, "torus", torus(48, 24));
    draw(folder, "ring", torus(12, 6));
    draw(folder, "crossing", crossing_boxes());
    draw(folder, "terrain", terrain());
    draw(folder, "city", city());
    draw(folder, "stairs", stairs());
    draw(folder, "spring", spring());
    draw(folder, "shards", shards());
    draw_file(folder, "house.obj", obj);
    draw_file(folder, "city.ply", ply_of(city()));
    draw_file(folder, "ring.stl", stl_of(torus(12, 6)));
    draw_file(folder, "roof.off",
              "OFF\n5 3 0\n0 0 0\n2 0 0\n2 0 2\n0 0 2\n1 2 1\n4 3 2 1 0\n3 0 1 4\n3 2 3 4\n");
    refuse_file(folder, "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    refuse_file(folder, "word.obj", "v 0 zero 0\n");
    refuse_file(folder, "short.ply", ply_of(stairs()).substr(0, 900));
    refuse_file(folder, "short.stl", stl_of(stairs()).substr(0, 900));
    refuse_file(
        folder, "picture.stl",
        "\x89PNG\r\n and so on, for more than eighty-four bytes: this is not what a facet is like");
    refuse_file(folder, "empty.obj", "");
    refuse_file(folder, "nothing.off", "OFF\n1 0 0\n0 0 0\n");
}
