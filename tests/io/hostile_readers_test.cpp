// A reader that a hostile file has taken over may answer anything. The result must be a sound
// model, which the library then draws, or a message of one line, within the allowed memory and
// time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "base/printable.hpp"
#include "io/isolated.hpp"
#include "io/part_paths.hpp"
#include "io/reader_messages.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/visibility.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr std::uint32_t none = ModelPart::none;
constexpr std::uint32_t too_many = 1U << 24U;
const std::string escapes =
    "\x1b]0;title\x07\x1b[31mred\x1b[2J\x7f\xc2\x9b\r\nlineatlas: all is well";

LoadedMesh cube() {
    LoadedMesh loaded;
    for (unsigned i = 0; i < 8; ++i)
        loaded.mesh.positions.emplace_back(i & 1U, i >> 1U & 1U, i >> 2U & 1U);
    loaded.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                             {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    loaded.format = "OBJ";
    return loaded;
}

/// The same cube as one part.
LoadedMesh part(const std::string& name) {
    LoadedMesh loaded = cube();
    loaded.parts = {{.name = name, .parent = none, .object = 0}};
    loaded.mesh.triangle_object.assign(12, 0);
    return loaded;
}

using Change = void (*)(LoadedMesh&);

/// A reader's answer, made from a cube. is_sound: a file's own reader could give it.
struct Answer {
    std::string_view name;
    bool is_sound;
    Change change;
};

/// Claims that every side of a cube is curved, and that together they are one ball.
void add_ball(Mesh& mesh, double radius) {
    for (const glm::uvec3 corners : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            mesh.corner_normals.push_back(
                glm::normalize(mesh.positions[corners[k]] + glm::vec3{0.1F, 0.2F, 0.3F}));
    mesh.surfaces.shapes = {
        {.axis = {0, 0, 1},
         .curve = {.kind = SurfaceCurve::Kind::ellipse, .u = {radius, 0, 0}, .v = {0, 0, radius}}}};
    mesh.surfaces.surfaces = {{}};
    mesh.surfaces.of_triangle.assign(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        mesh.surfaces.parameters.push_back({glm::dvec2{0.1, 0.2}, {1.1, 0.2}, {0.1, 1.2}});
}

const std::vector<Answer> answers{
    {"as it is", true, [](LoadedMesh&) {}},
    {"names that a terminal obeys", true,
     [](LoadedMesh& loaded) {
         loaded = part(escapes);
         loaded.notes = {escapes};
         loaded.format = escapes;
         loaded.mesh.groups = {{.object = escapes, .material = "\xff\xc0\x80"}};
         loaded.mesh.triangle_group.assign(12, 0);
     }},
    {"a name of 8 MB", true,
     [](LoadedMesh& loaded) { loaded = part(std::string(std::size_t{8} << 20U, 'N')); }},
    {"a note of 8 MB", true,
     [](LoadedMesh& loaded) { loaded.notes = {std::string(std::size_t{8} << 20U, 'N')}; }},
    {"parts without objects", false,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.mesh.triangle_object.clear(); }},
    {"parts with objects for some triangles", false,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.mesh.triangle_object.pop_back(); }},
    {"objects of lines alone", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.polylines = {{0, 1}};
         loaded.mesh.polyline_object = {5};
     }},
    {"parts and objects of lines alone", false,
     [](LoadedMesh& loaded) {
         loaded = part("a");
         loaded.mesh.triangle_object.clear();
         loaded.mesh.polylines = {{0, 1}};
         loaded.mesh.polyline_object = {0};
     }},
    {"parts and lines without objects", false,
     [](LoadedMesh& loaded) {
         loaded = part("a"), loaded.mesh.polylines = {{0, 1}};
     }},
    {"objects without parts", false,
     [](LoadedMesh& loaded) { loaded.mesh.triangle_object.assign(12, 0); }},
    {"the last object that there may be", false,
     [](LoadedMesh& loaded) { loaded.mesh.triangle_object.assign(12, too_many - 1); }},
    {"an object that no part is", false,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.mesh.triangle_object[3] = 1; }},
    {"a part of an object that there is not", false,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.parts[0].object = 77777; }},
    {"a part in itself", false,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.parts[0].parent = 0; }},
    {"a part in a later one", false,
     [](LoadedMesh& loaded) {
         loaded = part("a");
         loaded.parts[0].parent = 1;
         loaded.parts.push_back({.name = "b"});
     }},
    {"the last shape", true,
     [](LoadedMesh& loaded) { loaded = part("a"), loaded.parts[0].shape = none - 1; }},
    {"2,000 parts in each other", true,
     [](LoadedMesh& loaded) {
         constexpr std::uint32_t count = 2000;
         const std::vector<glm::uvec3> triangles = loaded.mesh.triangles;
         loaded.mesh.triangles.clear();
         for (std::uint32_t i = 0; i < count; ++i) {
             loaded.mesh.triangles.push_back(triangles[i % triangles.size()]);
             loaded.mesh.triangle_object.push_back(i);
             loaded.parts.push_back(
                 {.name = std::to_string(i), .parent = i == 0 ? none : i - 1, .object = i});
         }
     }},
    {"an origin that is no number", false,
     [](LoadedMesh& loaded) { loaded.origin.x = std::nan(""); }},
    {"an infinite origin", false, [](LoadedMesh& loaded) { loaded.origin.y = HUGE_VAL; }},
    {"an origin of 1e308", false, [](LoadedMesh& loaded) { loaded.origin.z = -1e308; }},
    {"an upward axis that is no number", false,
     [](LoadedMesh& loaded) {
         loaded.up = {nan, 0, 0};
     }},
    {"an upward axis of zero", false,
     [](LoadedMesh& loaded) {
         loaded.up = {0, 0, 0};
     }},
    {"a long upward axis", false,
     [](LoadedMesh& loaded) {
         loaded.up = {1, 2, 3};
     }},
    {"a unit of 5e-324", false, [](LoadedMesh& loaded) { loaded.unit = 5e-324; }},
    {"a unit of 1e308", false, [](LoadedMesh& loaded) { loaded.unit = 1e308; }},
    {"a negative deflection", false, [](LoadedMesh& loaded) { loaded.deflection = -1; }},
    {"a deflection that is no number", false,
     [](LoadedMesh& loaded) { loaded.deflection = std::nan(""); }},
    {"a deflection of 1e308", false, [](LoadedMesh& loaded) { loaded.deflection = 1e308; }},
    {"a precision of 3e38", false, [](LoadedMesh& loaded) { loaded.mesh.precision = largest; }},
    {"a negative precision", false, [](LoadedMesh& loaded) { loaded.mesh.precision = -1; }},
    {"a precision that is no number", false,
     [](LoadedMesh& loaded) { loaded.mesh.precision = nan; }},
    {"a position that is no number", false,
     [](LoadedMesh& loaded) { loaded.mesh.positions[3].x = nan; }},
    {"an infinite position", false,
     [](LoadedMesh& loaded) { loaded.mesh.positions[3].y = -infinite; }},
    {"a position of 3e38", false,
     [](LoadedMesh& loaded) { loaded.mesh.positions[6] = glm::vec3{largest}; }},
    {"a model of 1e20", false,
     [](LoadedMesh& loaded) {
         for (glm::vec3& position : loaded.mesh.positions) position *= 1e20F;
     }},
    {"a model of 1e15", true,
     [](LoadedMesh& loaded) {
         for (glm::vec3& position : loaded.mesh.positions) position *= 1e15F;
     }},
    {"a model of 1e-44", false,
     [](LoadedMesh& loaded) {
         for (glm::vec3& position : loaded.mesh.positions) position *= 1e-44F;
     }},
    {"a model at one place", false,
     [](LoadedMesh& loaded) { loaded.mesh.positions.assign(8, glm::vec3{1}); }},
    {"a corner that there is not", false,
     [](LoadedMesh& loaded) { loaded.mesh.triangles[0].z = 8; }},
    {"triangles of one corner", true,
     [](LoadedMesh& loaded) { loaded.mesh.triangles.assign(12, glm::uvec3{0}); }},
    {"one triangle 2,000 times", true,
     [](LoadedMesh& loaded) {
         loaded.mesh.triangles.assign(2000, {0, 1, 2});
     }},
    {"a group that there is not", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.groups.resize(1);
         loaded.mesh.triangle_group.assign(12, 1);
     }},
    {"numbers of groups and no groups", false,
     [](LoadedMesh& loaded) { loaded.mesh.triangle_group.assign(12, 0); }},
    {"groups of no triangle", false, [](LoadedMesh& loaded) { loaded.mesh.groups.resize(3); }},
    {"a colour that is no number", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.groups = {{.object = "a", .material = "b", .color = {{nan, 0, 0}}}};
         loaded.mesh.triangle_group.assign(12, 0);
     }},
    {"an infinite colour", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.groups = {{.object = "a", .material = "b", .color = {{0, infinite, 0}}}};
         loaded.mesh.triangle_group.assign(12, 0);
     }},
    {"a line without points", false, [](LoadedMesh& loaded) { loaded.mesh.polylines = {{}}; }},
    {"lines of one point, and no triangle", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.triangles.clear();
         loaded.mesh.polylines = {{0}, {1}};
     }},
    {"a line without length", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.polylines = {{0, 0}};
     }},
    {"a point that there is not", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.polylines = {{0, 99}};
     }},
    {"nothing", false, [](LoadedMesh& loaded) { loaded.mesh = {}; }},
    {"edges from a vertex to itself", true,
     [](LoadedMesh& loaded) {
         loaded.mesh.known_edges = {{0, 0, KnownEdge::Kind::sharp, 0},
                                    {1, 1, KnownEdge::Kind::free, 5}};
     }},
    {"an edge to a vertex that there is not", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.known_edges = {{0, 8, KnownEdge::Kind::sharp, 0}};
     }},
    {"an edge of a kind that there is not", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.known_edges = {{0, 1, static_cast<KnownEdge::Kind>(5), 0}};
     }},
    {"edges where the mesh has none", true,
     [](LoadedMesh& loaded) {
         loaded.mesh.known_edges = {{0, 7, KnownEdge::Kind::sharp, 0},
                                    {1, 6, KnownEdge::Kind::free, none},
                                    {0, 1, KnownEdge::Kind::seam, none}};
     }},
    {"normals of zero", true,
     [](LoadedMesh& loaded) { loaded.mesh.corner_normals.assign(36, glm::vec3{0}); }},
    {"normals of 3e38", false,
     [](LoadedMesh& loaded) { loaded.mesh.corner_normals.assign(36, glm::vec3{largest}); }},
    {"normals that look inwards", true,
     [](LoadedMesh& loaded) {
         loaded.mesh.corner_normals.assign(36, {0, 0, -1});
     }},
    {"normals of all corners but one", false,
     [](LoadedMesh& loaded) {
         loaded.mesh.corner_normals.assign(35, {0, 0, 1});
     }},
    {"a ball as the surface of all sides", true,
     [](LoadedMesh& loaded) { add_ball(loaded.mesh, 1); }},
    {"a ball that is larger than all that is", true,
     [](LoadedMesh& loaded) { add_ball(loaded.mesh, 1e300); }},
    {"a net of poles with weights beside nothing", true,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         SurfaceShape& net = loaded.mesh.surfaces.shapes[0];
         net = {.kind = SurfaceShape::Kind::spline,
                .along_u = {.degree = 1, .knots = {0, 0, 1e-300, 1}},
                .along_v = {.degree = 1, .knots = {0, 0, 1, 1}},
                .poles = std::vector<glm::dvec4>(4, {1e300, -1e300, 1, 1e-300})};
     }},
    {"a surface that there is not", false,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         loaded.mesh.surfaces.of_triangle[7] = 1;
     }},
    {"a surface of a shape that there is not", false,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         loaded.mesh.surfaces.surfaces[0].shape = 1;
     }},
    {"surfaces of some triangles", false,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         loaded.mesh.surfaces.of_triangle.pop_back();
     }},
    {"a spline without poles", false,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         loaded.mesh.surfaces.shapes[0].kind = SurfaceShape::Kind::spline;
     }},
    {"a surface at NaN", false,
     [](LoadedMesh& loaded) {
         add_ball(loaded.mesh, 1);
         loaded.mesh.surfaces.parameters[3][1].x = std::numeric_limits<double>::quiet_NaN();
     }},
};

/// Answers that are no model. Each of these functions writes to the socket itself.
using Talk = void (*)(ReaderOutput&);

void start_answer(ReaderOutput& output) {
    output.value(reader::Answer::read);
}
[[noreturn]] void sleep_for_ever() {
    for (;;) ::pause();
}
void flood(ReaderOutput& output, std::uint64_t count) {
    output.value(count);
    const std::vector<char> zeros(std::size_t{1} << 20U);
    for (;;) output.values(std::span<const char>{zeros});
}
/// Write the answer up to the parts, and up to the groups.
void before_parts(ReaderOutput& output) {
    start_answer(output);
    output.value(std::uint64_t{0}); // notes
    output.value(glm::dvec3{0});
    output.text("OBJ");
    output.value(false);
    output.value(glm::vec3{0});
    output.value(0.0);
    output.value(0.0);
}
void before_groups(ReaderOutput& output) {
    const LoadedMesh loaded = cube();
    before_parts(output);
    output.value(std::uint64_t{0});
    output.values(loaded.mesh.positions);
    output.values(loaded.mesh.triangles);
    output.values(loaded.mesh.triangle_group);
}

constexpr std::uint64_t million_million = 1'000'000'000'000;
/// As many empty texts as would fit if each took only its received bytes.
constexpr std::uint64_t most_texts = (std::uint64_t{64} << 20U) / sizeof(std::uint64_t);

const std::map<std::string_view, Talk> talks{
    {"closes and sleeps",
     [](ReaderOutput&) {
         ::close(reader::socket);
         sleep_for_ever();
     }},
    {"closes halfway and sleeps",
     [](ReaderOutput& output) {
         start_answer(output);
         output.value(std::uint64_t{3});
         ::close(reader::socket);
         sleep_for_ever();
     }},
    {"refuses in 100 MB",
     [](ReaderOutput& output) {
         output.value(reader::Answer::refused);
         output.text(std::string(std::size_t{100} << 20U, 'A'));
     }},
    {"refuses in what a terminal obeys",
     [](ReaderOutput& output) {
         output.value(reader::Answer::refused);
         output.text(escapes);
     }},
    {"floods with notes",
     [](ReaderOutput& output) {
         start_answer(output);
         flood(output, million_million);
     }},
    {"floods with notes that would fit",
     [](ReaderOutput& output) {
         start_answer(output);
         flood(output, most_texts);
     }},
    {"floods with parts",
     [](ReaderOutput& output) {
         before_parts(output);
         flood(output, million_million);
     }},
    {"floods with groups",
     [](ReaderOutput& output) {
         before_groups(output);
         flood(output, million_million);
     }},
    {"floods with lines",
     [](ReaderOutput& output) {
         before_groups(output);
         output.value(std::uint64_t{0});
         flood(output, most_texts);
     }},
    {"drips",
     [](ReaderOutput& output) {
         start_answer(output);
         output.value(std::uint64_t{1} << 20U);
         for (;;) output.value(std::uint8_t{0}), ::usleep(1000);
     }},
    {"goes on after its answer",
     [](ReaderOutput& output) {
         send(output, cube());
         for (;;) output.text(std::string(1000, 'X'));
     }},
};

ReaderKind::Parse open_any(const fs::path& path, std::string_view) {
    const std::string way = path.stem().string();
    return [way](ReaderOutput& output) {
        if (const auto talk = talks.find(way); talk != talks.end()) return talk->second(output);
        LoadedMesh loaded = cube();
        std::ranges::find(answers, way, &Answer::name)->change(loaded);
        send(output, loaded);
    };
}

constexpr std::array kinds{ReaderKind{"mesh", open_any}};

class HostileReaders : public testing::Test {
  protected:
    /// Empty if a model came. Then `loaded` is that model.
    std::string answer(std::string_view way, const ReadLimits& limits, LoadedMesh& loaded) {
        const fs::path file = folder_.path() / (std::string{way} + ".obj");
        std::ofstream{file} << "something";
        try {
            loaded = load_mesh_isolated(file, limits);
            return {};
        } catch (const FileError& error) {
            return error.what();
        }
    }
    std::string refusal(std::string_view way, const ReadLimits& limits) {
        LoadedMesh loaded;
        const std::string text = answer(way, limits, loaded);
        EXPECT_FALSE(text.empty()) << way;
        return text.substr(std::min(text.size(), text.find("\": ") + 3));
    }

    TemporaryFolder folder_;
};

/// Uses a model in all ways in which a program does.
void use(LoadedMesh& loaded) {
    const LineSet lines = extract_lines(loaded.mesh, {.separate_objects = true});
    const PartPaths paths = part_paths(loaded);
    for (const std::uint32_t part : paths.of_triangle) ASSERT_LT(part, paths.paths.size());
    for (const std::uint32_t part : paths.of_polyline)
        ASSERT_TRUE(part == PartPaths::none || part < paths.paths.size());
    if (!lines.segments.empty()) {
        LineVisibility visibility{lines};
        visibility.find(make_camera(View{}, {64, 64}, lines.bounds));
    }
    keep_parts(loaded.mesh, paths, std::vector<bool>(paths.paths.size(), true), true);
}

TEST_F(HostileReaders, AreOnlyBelievedAnswersThatAFileCouldGive) {
    const std::string nonsense =
        "its reader gave an answer that makes no sense; the file is damaged or hostile";
    for (const Answer& each : answers) {
        SCOPED_TRACE(each.name);
        LoadedMesh loaded;
        const std::string text = answer(each.name, {}, loaded);
        EXPECT_EQ(text.empty(), each.is_sound) << text;
        EXPECT_TRUE(text.empty() || text.ends_with(nonsense)) << text;
        if (!text.empty()) continue;
        for (const std::string& note : loaded.notes) {
            EXPECT_LE(note.size(), longest_message + 3);
            EXPECT_EQ(note.find_first_of("\x1b\x7f\x07\n\r"), note.npos);
        }
        use(loaded);
    }
}

TEST_F(HostileReaders, ThatStopTalkingAreNotWaitedFor) {
    const std::string mute =
        "its reader closed its answer before it was whole; the file is damaged or hostile";
    for (const char* way : {"closes and sleeps", "closes halfway and sleeps"})
        EXPECT_EQ(refusal(way, {}), mute) << way;
}

TEST_F(HostileReaders, CannotFillThisProcessBeyondTheirOwnLimit) {
    if (reader::sanitized) GTEST_SKIP() << "sanitizers keep what is freed";
    const ReadLimits limits{.memory = std::uint64_t{64} << 20U, .time = 20s};
    const auto held = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss >> 10; // MiB
    };
    const long before = held();
    for (const char* way : {"floods with notes", "floods with notes that would fit",
                            "floods with parts", "floods with groups", "floods with lines"}) {
        EXPECT_NE(refusal(way, limits).find("makes no sense"), std::string::npos) << way;
        EXPECT_LE(held() - before, 80) << way;
    }
}

TEST_F(HostileReaders, AreTimedWhileTheirAnswerArrives) {
    const ReadLimits limits{.memory = 0, .time = 300ms};
    EXPECT_EQ(refusal("drips", limits),
              "reading it took more than 0.3 s; LoadOptions::read_seconds allows more");
    LoadedMesh loaded;
    EXPECT_EQ(answer("goes on after its answer", {}, loaded), "");
}

TEST_F(HostileReaders, RefuseInOneLineOfText) {
    LoadedMesh loaded;
    EXPECT_EQ(answer("refuses in what a terminal obeys", {}, loaded),
              "?]0;title??[31mred?[2J???\?lineatlas: all is well");
    EXPECT_NE(refusal("refuses in 100 MB", {}).find("makes no sense"), std::string::npos);
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv, lineatlas::test::kinds))
        return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
