// The tool with hostile files: odd meshes whose picture must be that of the clean one; things that
// are no files; styles, camera paths and pictures of pens. Exit code 0 and the right picture with
// at most one line, or 1 and one line.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "lineatlas/io.hpp"
#include "mesh_files.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class HostileInputs : public Tool {
  protected:
    /// One line, the file's name and `words` in it, exit code 1, nothing crashed.
    void expect_one_line(const std::string& arguments, const std::string& name,
                         const std::string& words) {
        const Result result = run(arguments);
        EXPECT_EQ(result.exit_code, 1) << arguments << "\n" << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
        for (const std::string& wanted : {name, words})
            EXPECT_NE(result.output.find(wanted), std::string::npos) << result.output;
        EXPECT_EQ(result.output.find("its reader"), std::string::npos) << result.output;
    }

    Image draw(const std::string& file, const std::string& note = "",
               const std::string& options = "") {
        const Result result =
            run("draw " + path(file) + " -o " + path("out.png") + " --size 200x150 " + options);
        EXPECT_EQ(result.exit_code, 0) << file << "\n" << result.output;
        if (note.empty())
            EXPECT_EQ(result.output, "") << file;
        else
            EXPECT_EQ(result.output, "lineatlas: " + note + "\n") << file;
        return read_image(path("out.png"));
    }

    /// Rounding moves an edge's grey a little; a line that is missing or too many is black.
    static void expect_same(const Image& a, const Image& b, const std::string& what) {
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        int different = 0, dark = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            different += std::abs(int{a.pixels[i]} - int{b.pixels[i]}) > 64;
            dark += a.pixels[i] < 128;
        }
        EXPECT_GT(dark, 1000) << what;
        EXPECT_LT(different, 20) << what;
    }

    void write_model(const std::string& name, const Model& model) const {
        for (const MeshType& type : mesh_types())
            if (name.ends_with(type.extension)) return write(name, type.write(model, {}));
    }
};

TEST_F(HostileInputs, AModelFarFromZeroIsDrawnAsNearIt) {
    const std::string view = "--eye 3,2.5,4 --target 0.5,0.5,0.5 --lines crease";
    const std::string far_view = "--eye 10000000.03,-19999999.975,5000000.04 "
                                 "--target 10000000.005,-19999999.995,5000000.005 --lines crease";
    for (const MeshType& type : mesh_types()) {
        if (!type.exact) continue;
        write("near" + type.extension, type.write(block_on_cube(), {}));
        write("far" + type.extension,
              type.write(block_on_cube().moved(0.01, {1e7, -2e7, 5e6}), {}));
        const std::string note =
            "far from zero for its size, drawn about 10000000,-20000000,5000000";
        expect_same(draw("near" + type.extension), draw("far" + type.extension, note), type.name);
        expect_same(draw("near" + type.extension, "", view),
                    draw("far" + type.extension, note, far_view), type.name);
    }
}

/// In the file's coordinates, as the camera.
TEST_F(HostileInputs, AFocusInAModelFarFromZeroIsWhereItIsNearIt) {
    const std::vector<MeshType> types = mesh_types();
    const MeshType& type = *std::ranges::find_if(types, &MeshType::exact);
    write("near" + type.extension, type.write(block_on_cube(), {}));
    write("far" + type.extension, type.write(block_on_cube().moved(0.01, {1e7, -2e7, 5e6}), {}));
    const std::string note = "far from zero for its size, drawn about 10000000,-20000000,5000000";
    const std::string look = "--lines crease --set focus-radius=0.1 --set focus-falloff=0.1 "
                             "--set focus-width=3 --set focus-opacity=1 --focus ";
    const Image far =
        draw("far" + type.extension, note, look + "10000000.01,-19999999.99,5000000.01");
    expect_same(draw("near" + type.extension, "", look + "1,1,1"), far, type.name);
    // The focus is seen: it is not at another corner.
    const Image other = draw("near" + type.extension, "", look + "0,0,1");
    EXPECT_NE(other.pixels, far.pixels);
}

/// By a rotation of few digits that leaves no edge along an axis.
Model tilted(Model model) {
    for (auto& [x, y, z] : model.points)
        std::tie(x, y, z) = std::tuple{(2 * x + 3 * y + 6 * z) / 7, (3 * x - 6 * y + 2 * z) / 7,
                                       (6 * x + 2 * y - 3 * z) / 7};
    return model;
}

/// An open tube stands on a cube: its lower rim lies in the cube's upper face.
Model tube_on_cube() {
    Model model = block_on_cube();
    model.points.resize(8);
    model.faces.resize(6);
    const int sides = 24;
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        const double x = 0.5 + 0.3 * std::cos(angle), z = 0.5 + 0.3 * std::sin(angle);
        model.points.push_back({x, 1, z});
        model.points.push_back({x, 1.25, z});
        const int here = 8 + 2 * side, next = 8 + 2 * ((side + 1) % sides);
        model.faces.push_back({here, here + 1, next + 1, next});
    }
    return model;
}

TEST_F(HostileInputs, PartsThatTouchStillTouchFarFromZero) {
    const Model model = tilted(tube_on_cube());
    for (const MeshType& type : mesh_types()) {
        if (!type.exact) continue;
        write("near" + type.extension, type.write(model, {}));
        write("far" + type.extension, type.write(model.moved(1, {300.3, -250.7, 400.9}), {}));
        expect_same(draw("near" + type.extension, "", "--up y"),
                    draw("far" + type.extension,
                         "far from zero for its size, drawn about 302,-250,402", "--up y"),
                    type.name);
    }
}

TEST_F(HostileInputs, OddFacesChangeNothing) {
    const Model clean = triangles_of(block_on_cube());
    write_model("clean.off", clean);
    const Image picture = draw("clean.off");

    Model twice = clean;
    for (const auto& face : clean.faces) twice.faces.push_back({face[0], face[2], face[1]});
    write_model("twice.off", twice);
    expect_same(picture,
                draw("twice.off", "24 triangles with the same three corners as another left out"),
                "twice");

    Model mixed = clean;
    for (std::size_t i = 0; i < mixed.faces.size(); i += 3)
        std::swap(mixed.faces[i][1], mixed.faces[i][2]);
    write_model("mixed.off", mixed);
    expect_same(picture, draw("mixed.off"), "both windings at once");

    Model flat = clean; // the edge 0-1 has a third point, and a triangle without area along it
    flat.points.push_back({0, 0, 0.5});
    flat.faces[0] = {0, 16, 3};
    flat.faces.push_back({16, 1, 3});
    flat.faces.push_back({0, 1, 16});
    write_model("flat.off", flat);
    expect_same(picture, draw("flat.off", "1 triangle without area seen as part of another"),
                "no area");

    Model equal = clean;
    equal.points.push_back(equal.points[0]);
    equal.faces.push_back({0, 16, 1});
    write_model("equal.off", equal);
    expect_same(picture, draw("equal.off", "1 triangle with corners at one place left out"),
                "equal corners");
}

/// A polygon with `count` corners, every second one of them pulled in.
Model star(int count, double inner) {
    Model model;
    model.faces.emplace_back();
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count, radius = i % 2 == 0 ? 1 : inner;
        model.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
        model.faces[0].push_back(i);
    }
    return model;
}

TEST_F(HostileInputs, LargeAndConcavePolygons) {
    for (const auto& [count, inner] : {std::pair{10'000, 1.0}, {64, 0.3}, {11, 0.2}}) {
        const Model polygon = star(count, inner);
        Model cut = polygon; // a fan about the middle, which sees every corner
        cut.points.push_back({0, 0, 0});
        cut.faces.clear();
        for (int i = 0; i < count; ++i) cut.faces.push_back({count, i, (i + 1) % count});
        write_model("polygon.obj", polygon);
        write_model("cut.obj", cut);
        expect_same(draw("cut.obj"), draw("polygon.obj"), std::to_string(count));
    }
}

TEST_F(HostileInputs, FoldersPipesAndBrokenLinksAreRefused) {
    fs::create_directory(path("folder.obj"));
    ::mkfifo(path("pipe.obj").c_str(), 0600);
    fs::create_symlink("/dev/zero", path("zero.obj"));
    fs::create_symlink("nowhere", path("nowhere.obj"));
    fs::create_symlink("circle.obj", path("circle.obj"));
    write("empty.obj", "");
    for (const auto& [name, cause] : {std::pair{"folder", "it is a folder"},
                                      {"pipe", "no regular file"},
                                      {"zero", "no regular file"},
                                      {"nowhere", "no such file"},
                                      {"circle", "symbolic links"},
                                      {"empty", "the file is empty"}}) {
        for (const char* extension : {"obj", "ply", "toml", "json", "png"}) {
            const std::string file = std::string{name} + "." + extension;
            if (!fs::exists(fs::symlink_status(path(file))))
                fs::create_symlink(std::string{name} + ".obj", path(file));
        }
        const std::string draw = "draw -o " + path("out.%d.png") + " --size 64x48 ";
        expect_one_line("draw " + path(std::string{name} + ".obj") + " -o " + path("o.png"), name,
                        cause);
        expect_one_line("draw " + path(std::string{name} + ".ply") + " -o " + path("o.svg"), name,
                        cause);
        expect_one_line(draw + "--scene clevis --camera-path " + path(std::string{name} + ".json"),
                        name, cause);
        expect_one_line("draw --scene clevis -o " + path("o.png") + " --pen " +
                            path(std::string{name} + ".png"),
                        name, cause);
        if (std::string_view{name} != "empty") // a style of nothing but usual values
            expect_one_line("styles " + path(std::string{name} + ".toml"), name, "cannot read");
    }
}

TEST_F(HostileInputs, FilesWithWrongExtensionsAreNamed) {
    for (const MeshType& type : mesh_types()) {
        for (const char* extension : {".obj", ".off", ".ply", ".om", ".stl", ".gltf", ""}) {
            if (extension == type.extension) continue;
            const std::string name = "wrong_" + type.name + extension;
            write(name, type.write(block_on_cube(), {}));
            expect_one_line("draw " + path(name) + " -o " + path("o.png"), name, "cannot read");
        }
    }
}

TEST_F(HostileInputs, HostileStylesAreRefusedInOneLine) {
    std::string keys = "a";
    for (int i = 0; i < 50'000; ++i) keys += ".a";
    const std::pair<std::string, std::string> styles[] = {
        {keys + " = 1\n", "longer than 4096"},
        {"[" + keys + "]\n", "longer than 4096"},
        {"width = " + std::string(3000, '[') + "\n", "nested"},
        {std::string(2 << 20, '#'), "larger than 1 MiB"},
        {std::string(1000, '\0'), "line 1"},
        {"width = nan", "not nan"},
        {"width = 1e999", "1e999"},
        {"width = -1e308", "width must be"},
        {"width = 99999999999999999999", "64 bits"},
        {"width = \"wide\"", "width must be"},
        {"width = [1, 2]", "width must be"},
        {"width = 1979-05-27", "width"},
        {"pen = 3", "pen"},
        {"color = [1, 2]", "color"},
        {"include = \"style.toml\"", "circle"},
        {"include = \"/dev/zero\"", "/dev/zero"},
        {"\xFF\xFE\x01", "line 1"},
    };
    for (const auto& [text, words] : styles) {
        write("style.toml", text);
        expect_one_line("styles " + path("style.toml"), "style.toml", words);
    }
}

TEST_F(HostileInputs, HostileCameraPathsAreRefusedInOneLine) {
    const std::string good = R"("target": [0, 0, 0], "frame": 0)";
    const std::pair<std::string, std::string> paths[] = {
        {std::string(1 << 20, '['), "nested deeper"},
        {std::string(17 << 20, ' '), "larger than 16 MiB"},
        {std::string(1000, '\0'), "not JSON"},
        {"[]", "must be an object"},
        {R"({"keys": 3})", "at least one"},
        {R"({"keys": [{"eye": [1e999, 0, 0], )" + good + "}]}", "1e999"},
        {R"({"keys": [{"eye": [1e300, 0, 0], )" + good + "}]}", "finite"},
        {R"({"keys": [{"eye": [NaN, 0, 0], )" + good + "}]}", "not JSON"},
        {R"({"keys": [{"eye": "here", )" + good + "}]}", "three finite numbers"},
        {R"({"keys": [{"eye": [1, 2], )" + good + "}]}", "three finite numbers"},
        {R"({"keys": [{"eye": [0, 0, 0], )" + good + "}]}", "two different points"},
        {R"({"keys": [{"eye": [0, 0, 1], "frame": -5, "target": [0, 0, 0]}]})", "frame"},
        {R"({"fps": 1e-300, "keys": [{"eye": [0, 0, 1], )" + good + "}]}", "fps"},
    };
    for (const auto& [text, words] : paths) {
        write("path.json", text);
        expect_one_line("draw --scene clevis -o " + path("o.%d.png") + " --camera-path " +
                            path("path.json"),
                        "path.json", words);
    }
}

} // namespace
} // namespace lineatlas::test
