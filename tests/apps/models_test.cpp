// Models of several parts: the output of `lineatlas info`, and the parts that --only and --hide
// leave.

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <nlohmann/json.hpp>

#include "gltf_files.hpp"
#include "threemf_files.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class Models : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("hall.glb",
              to_glb(cube_json(R"([{"name":"hall","children":[1,2,3]},)"
                               R"({"name":"Bolt, left","mesh":0},)"
                               R"({"name":"Bolt, right","mesh":0,"translation":[3,0,0]},)"
                               R"({"name":"door","mesh":0,"translation":[0,0,-4]}])"),
                     cube_bytes()));
        write("groups.obj", "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                            "o second\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\n");
    }

    std::string said(const std::string& arguments, int code = 0) const {
        const Result result = run(arguments);
        EXPECT_EQ(result.exit_code, code) << result.output;
        return result.output;
    }

    /// The numbers of paths by kind in the drawing of a model, including hidden ones.
    nlohmann::json drawn(const std::string& model, const std::string& options) const {
        said("draw " + path(model) + " -o " + path("a.json") + " --lines crease,boundary " +
             options);
        return nlohmann::json::parse(std::ifstream{path("a.json")});
    }
};

TEST_F(Models, InfoNamesThePartsForPeople) {
    EXPECT_EQ(said("info " + path("hall.glb")),
              path("hall.glb") + ": glTF 2.0, 36 triangles, unit 1000 mm, up 0,1,0\n"
                                 "box 0,0,-4 to 4,1,1, volume 3\n"
                                 "segments: 36 crease\n"
                                 "  hall\n"
                                 "    Bolt, left: 12 triangles\n"
                                 "    Bolt, right: 12 triangles\n"
                                 "    door: 12 triangles\n");
}

TEST_F(Models, PartsApartHaveTrailsThatRaysFind) {
    const std::string apart = path("apart.svg");
    said("draw " + path("hall.glb") + " -o " + apart + " --view isometric --explode 2 --explode " +
         "'Bolt, left=0,2,0' --method exact");
    const std::string svg = read(apart);
    EXPECT_NE(svg.find("id=\"trail\""), std::string::npos);
    said("check " + apart + " " + path("hall.glb") + " --at-most 0.01");
    expect_refused("draw " + path("hall.glb") + " -o " + path("b.svg") + " --explode 0.5", 2,
                   "the factor must be from 1 to 100");
    expect_refused("draw " + path("hall.glb") + " -o " + path("b.svg") + " --explode nut=1,0,0", 2,
                   "no part is called \"nut\"");
    expect_refused("draw " + path("hall.glb") + " -o " + path("b.svg") + " --explode nut", 2,
                   "neither a factor");
}

TEST_F(Models, InfoNamesThePartsForScripts) {
    const auto info = nlohmann::json::parse(said("info --json " + path("hall.glb")));
    EXPECT_EQ(info["format"], "glTF 2.0");
    EXPECT_EQ(info["unit_mm"], 1000);
    EXPECT_EQ(info["up"], (nlohmann::json{0, 1, 0}));
    EXPECT_EQ(info["up_is_guessed"], false);
    EXPECT_EQ(info["triangles"], 36);
    EXPECT_EQ(info["segments"]["crease"], 36);
    EXPECT_EQ(info["box"]["max"], (nlohmann::json{4, 1, 1}));
    ASSERT_EQ(info["parts"].size(), 4U);
    EXPECT_EQ(info["parts"][0]["parent"], nullptr);
    EXPECT_EQ(info["parts"][2]["name"], "Bolt, right");
    EXPECT_EQ(info["parts"][2]["parent"], 0);
    EXPECT_EQ(info["parts"][2]["triangles"], 12);
    EXPECT_EQ(info["parts"][2]["shape"], info["parts"][1]["shape"]);
    EXPECT_EQ(info["parts"][0].count("item"), 0U) << "it only holds others";
    EXPECT_EQ(info["parts"][1]["item"], 1);
    EXPECT_EQ(info["parts"][2]["item"], 1) << "of the same shape";
    EXPECT_EQ(info["parts"][3]["item"], 1) << "whatever its name";
    EXPECT_EQ(info["volume"], 3);
    EXPECT_EQ(info["parts"][2]["volume"], 1);
    EXPECT_EQ(info["parts"][2]["box"]["max"][0].get<double>() -
                  info["parts"][2]["box"]["min"][0].get<double>(),
              1);
    EXPECT_EQ(info["notes"].size(), 0U);

    const auto groups = nlohmann::json::parse(said("info --json " + path("groups.obj")));
    EXPECT_EQ(groups["format"], "OBJ");
    EXPECT_EQ(groups["unit_mm"], nullptr);
    ASSERT_EQ(groups["parts"].size(), 2U);
    EXPECT_EQ(groups["parts"][1]["name"], "second");
    EXPECT_EQ(groups["volume"], nullptr);
    EXPECT_EQ(groups["notes"].back(), "the surface is not closed, so it has no volume");
}

TEST_F(Models, InfoNamesMaterials) {
    write("paint.mtl", "newmtl red\nKd 1 0 0\nnewmtl plain\nNs 10\n");
    write("painted.obj", "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                         "o first\nusemtl red\nf 1 3 2\nf 1 2 4\n"
                         "o second\nusemtl plain\nf 2 3 4\nusemtl red\nf 3 1 4\n");
    const auto info = nlohmann::json::parse(said("info --json " + path("painted.obj")));
    EXPECT_EQ(info["materials"],
              nlohmann::json::parse(R"([{"name": "red", "color": "#ff0000", "triangles": 3},
                                        {"name": "plain", "color": null, "triangles": 1}])"));
    EXPECT_EQ(info["parts"][0]["materials"], nlohmann::json({0}));
    EXPECT_EQ(info["parts"][1]["materials"], nlohmann::json({0, 1}));
    const std::string text = said("info " + path("painted.obj"));
    EXPECT_NE(text.find("\nmaterial red: #ff0000, 3 triangles\nmaterial plain: no colour, 1 tri"),
              std::string::npos)
        << text;
}

TEST_F(Models, InfoRefusesAsDrawDoes) {
    write("a.glb", "glTF");
    EXPECT_EQ(said("info " + path("a.glb"), 1),
              "lineatlas: cannot read \"" + path("a.glb") + "\": it ends within its header\n");
}

TEST_F(Models, PartsAreChosenByName) {
    const auto crease_count = [&](const std::string& options) {
        std::size_t count = 0;
        const nlohmann::json drawing = drawn("hall.glb", "--hidden " + options);
        for (const auto& line : drawing["paths"]) count += line["points"].size();
        return count;
    };
    const std::size_t all = crease_count(""), bolts = crease_count("--only 'Bolt*'");
    EXPECT_GT(bolts, 0U);
    EXPECT_GT(all, bolts);
    EXPECT_EQ(said("draw " + path("hall.glb") + " -o " + path("a.svg") + " --only 'bolt*'", 2),
              "lineatlas: --only: no part is called \"bolt*\"; there is \"Bolt, left\", "
              "\"Bolt, right\", \"door\"\n");
    EXPECT_EQ(
        said("draw " + path("hall.glb") + " -o " + path("a.svg") + " --hide hall", 2),
        "lineatlas: --only and --hide leave nothing to draw; `lineatlas info` lists the parts\n");
    EXPECT_EQ(said("draw --scene clevis -o " + path("a.svg") + " --hide hall", 2),
              "lineatlas: --only and --hide need a MODEL file; `lineatlas scene` writes one\n");
    // Two ways to ask for the same.
    const auto points = [&](const std::string& options) {
        return drawn("hall.glb", options)["paths"];
    };
    EXPECT_EQ(points("--only hall/door"), points("--hide 'Bolt*'"));
    EXPECT_EQ(points("--only '*left' --only door"), points("--hide 'Bolt, right'"));
}

TEST_F(Models, GroupsOfObjFilesAreParts) {
    EXPECT_NE(drawn("groups.obj", "")["paths"], drawn("groups.obj", "--only second")["paths"]);
}

#ifdef LINEATLAS_HAS_3MF

TEST_F(Models, ComponentsOf3mfAreParts) {
    write("pair.3mf", to_3mf(threemf_model(
                          cube_object(1, "bolt") + cube_object(2, "nut") +
                              R"(<object id="3" name="pair"><components><component objectid="1"/>)"
                              R"(<component objectid="2" transform="1 0 0 0 1 0 0 0 1 3 0 0"/>)"
                              R"(</components></object>)",
                          R"(<item objectid="3"/>)", R"(unit="inch")")));
    EXPECT_EQ(said("info " + path("pair.3mf")), path("pair.3mf") +
                                                    ": 3MF, 24 triangles, unit 25.4 mm, up 0,0,1\n"
                                                    "box 0,0,0 to 4,1,1, volume 2\n"
                                                    "segments: 24 crease\n"
                                                    "  pair\n"
                                                    "    bolt: 12 triangles\n"
                                                    "    nut: 12 triangles\n");
    EXPECT_EQ(drawn("pair.3mf", "--only pair/nut")["paths"],
              drawn("pair.3mf", "--hide bolt")["paths"]);
    EXPECT_NE(drawn("pair.3mf", "--only nut")["paths"], drawn("pair.3mf", "")["paths"]);
    write("bad.3mf", "PK\3\4");
    const std::string message = said("draw " + path("bad.3mf") + " -o " + path("a.svg"), 1);
    EXPECT_EQ(std::ranges::count(message, '\n'), 1) << message;
}

#endif

struct Piece {
    glm::dvec2 from, to;
};

/// The visible parts of a drawing, in pixels.
std::vector<Piece> visible_pieces(const std::string& file) {
    const nlohmann::json drawing = nlohmann::json::parse(std::ifstream{file});
    std::vector<Piece> pieces;
    for (const nlohmann::json& path : drawing["paths"]) {
        if (!path["visible"].get<bool>()) continue;
        const nlohmann::json& points = path["points"];
        const auto at = [&](std::size_t i) { return glm::dvec2{points[i][0], points[i][1]}; };
        for (std::size_t i = 0; i + 1 < points.size(); ++i) pieces.push_back({at(i), at(i + 1)});
        if (path["closed"].get<bool>()) pieces.push_back({at(points.size() - 1), at(0)});
    }
    return pieces;
}

double distance(glm::dvec2 point, const Piece& piece) {
    const glm::dvec2 along = piece.to - piece.from;
    const double squared = glm::dot(along, along);
    const double share =
        squared > 0 ? std::clamp(glm::dot(point - piece.from, along) / squared, 0.0, 1.0) : 0;
    return glm::distance(point, piece.from + share * along);
}

/// The share of one drawing's length that lies farther than `most` pixels from all of the other.
double length_off(const std::vector<Piece>& one, const std::vector<Piece>& other, double most) {
    double off = 0, all = 0;
    for (const Piece& piece : one) {
        const double length = glm::distance(piece.from, piece.to);
        const int steps = 1 + static_cast<int>(length);
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec2 point = glm::mix(piece.from, piece.to, i / static_cast<double>(steps));
            const bool near = std::ranges::any_of(
                other, [&](const Piece& each) { return distance(point, each) <= most; });
            all += length / (steps + 1);
            if (!near) off += length / (steps + 1);
        }
    }
    return all > 0 ? off / all : 1;
}

TEST_F(Models, AScenesFilesGiveOneDrawing) {
    const char* shared = std::getenv("LINEATLAS_SHARED");
    const fs::path folder =
        (shared != nullptr ? fs::path{shared} : fs::path{LINEATLAS_SOURCE_DIR} / "../shared") /
        "models";
    if (!fs::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
    const auto pieces = [&](const char* file) {
        // The scene's bevels bend by 30 degrees, except for rounding.
        said("draw " + (folder / file).string() + " -o " + path("a.json") +
             " --method exact --crease 25");
        return visible_pieces(path("a.json"));
    };
    const std::vector<Piece> hall = pieces("machine_hall.gltf");
    const std::vector<Piece> z_up = pieces("machine_hall_zup.glb");
    EXPECT_EQ(length_off(hall, z_up, 0.1), 0);
    EXPECT_EQ(length_off(z_up, hall, 0.1), 0);
    // Coordinates are rounded to 1 mm. At a gear that passes through a face at 11 degrees this
    // moves lines by 5 mm. A wall's foot in the floor's plane gets below the floor.
    const std::vector<Piece> packed = pieces("machine_hall_meshopt.glb");
    EXPECT_LT(length_off(hall, packed, 0.2), 0.002);
    EXPECT_LT(length_off(packed, hall, 0.2), 0.002);
}

} // namespace
} // namespace lineatlas::test
