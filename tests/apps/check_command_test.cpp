// `lineatlas check`, `draw --certify` and `scene`, run as by a user.

#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "lineatlas/io.hpp"
#include "lineatlas/scenes.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

/// A drawing that draws nothing.
std::string without_paths(std::string svg) {
    for (std::size_t at; (at = svg.find("<path")) != std::string::npos;)
        svg.erase(at, svg.find("</path>", at) + 7 - at);
    return svg;
}

class CheckCommand : public Tool {
  protected:
    std::string content(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream{path(name)}.rdbuf();
        return text.str();
    }

    /// A bar before a box, some units apart.
    void write_model() const {
        std::string text;
        int first = 1;
        for (const char* corners : {"-1 1 -1 1 -1 1", "-3 3 -0.2 0.2 1.4 1.6"}) {
            double x[2], y[2], z[2];
            std::istringstream{corners} >> x[0] >> x[1] >> y[0] >> y[1] >> z[0] >> z[1];
            for (int i = 0; i < 8; ++i) {
                std::ostringstream vertex;
                vertex << "v " << x[i & 1] << ' ' << y[i >> 1 & 1] << ' ' << z[i >> 2] << '\n';
                text += vertex.str();
            }
            for (const auto& q :
                 {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                  std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
                text += "f";
                for (const int corner : q) {
                    text += ' ';
                    text += std::to_string(first + corner);
                }
                text += '\n';
            }
            first += 8;
        }
        write("model.obj", text);
    }

    /// The same model far from zero, where floats are too coarse for it.
    void write_far_model() const {
        write_model();
        std::istringstream lines{content("model.obj")};
        std::string text, line;
        while (std::getline(lines, line)) {
            double x, y, z;
            if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) {
                std::ostringstream vertex;
                vertex << std::setprecision(12) << "v " << x + 4e6 << ' ' << y - 2e6 << ' ' << z;
                line = vertex.str();
            }
            text += line + '\n';
        }
        write("model.obj", text);
    }

    /// The figure of a row of the table, in per cent.
    static double figure(const std::string& table, const std::string& row) {
        const std::size_t at = table.find(row);
        EXPECT_NE(at, std::string::npos) << row << " in\n" << table;
        return at == std::string::npos ? -1 : std::stod(table.substr(at + row.size()));
    }

    std::string check(const std::string& drawing, const std::string& more = "") const {
        const Result result = run("check " + path(drawing) + " " + path("model.obj") + more);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return result.output;
    }
};

TEST_F(CheckCommand, FindsLinesThatAreMissingAndLinesThatAreFalse) {
    write_model();
    const std::string draw = "draw " + path("model.obj") + " --size 400x300 -o ";
    ASSERT_EQ(run(draw + path("a.svg")).exit_code, 0);
    const std::string good = check("a.svg");
    EXPECT_LT(figure(good, "missed within 0.5 px"), 0.5);
    EXPECT_LT(figure(good, "false within 1.5 px"), 0.5);

    std::string svg = content("a.svg");
    const std::size_t last = svg.rfind("</g>");
    write("false.svg", svg.substr(0, last) + "<path d=\"m10 10 90 0\"/>" + svg.substr(last));
    const std::string with_false = check("false.svg", " -o " + path("errors.png"));
    EXPECT_GT(figure(with_false, "false within 1.5 px"), 4);
    EXPECT_NE(with_false.find("12.00 px at 12.1,10.0"), std::string::npos) << with_false;
    EXPECT_EQ(figure(with_false, "missed within 0.5 px"), figure(good, "missed within 0.5 px"));
    const Image picture = read_image(path("errors.png"));
    ASSERT_EQ(picture.size, (glm::ivec2{800, 600}));
    const std::uint8_t* pixel =
        &picture.pixels[static_cast<std::size_t>((20 * 800 + 100) * picture.channels)];
    EXPECT_EQ((std::array<int, 3>{pixel[0], pixel[1], pixel[2]}), (std::array{230, 0, 0}));

    write("missed.svg", without_paths(svg));
    EXPECT_EQ(figure(check("missed.svg"), "missed within 1.5 px"), 100);

    const std::string model = " " + path("model.obj") + " --at-most 1";
    EXPECT_EQ(run("check " + path("a.svg") + model).exit_code, 0);
    const auto expect_failed = [&](const char* drawing, const char* why) {
        const Result result = run("check " + path(drawing) + model);
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_NE(result.output.find(why), std::string::npos) << result.output;
    };
    expect_failed("false.svg", "% is false within 0.5 pixels, more than --at-most 1");
    expect_failed("missed.svg", "100.0000 % is missed");
    expect_refused("check " + path("a.svg") + " " + path("model.obj") + " --at-most -1", 2,
                   "--at-most");
}

TEST_F(CheckCommand, ADrawingHasAsManyPathsAsExpected) {
    write_model();
    run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.svg"));
    const auto found = static_cast<int>(figure(check("a.svg"), "visible paths"));
    ASSERT_GT(found, 1);
    check("a.svg", " --paths " + std::to_string(found));
    const std::string few = std::to_string(found - 1);
    const Result result =
        run("check " + path("a.svg") + " " + path("model.obj") + " --paths " + few);
    EXPECT_EQ(result.exit_code, 1);
    const std::string why =
        "it has " + std::to_string(found) + " visible paths, not the " + few + " of --paths";
    EXPECT_NE(result.output.find(why), std::string::npos) << result.output;
    write("empty.svg", without_paths(content("a.svg")));
    const Result both =
        run("check " + path("empty.svg") + " " + path("model.obj") + " --at-most 1 --paths " + few);
    EXPECT_EQ(both.exit_code, 1);
    EXPECT_NE(both.output.find("100.0000 % is missed within 0.5 pixels, more than --at-most 1; "
                               "it has 0 visible paths, not the " +
                               few + " of --paths"),
              std::string::npos)
        << both.output;
    expect_refused("check " + path("a.svg") + " " + path("model.obj") + " --paths -1", 2,
                   "--paths");
}

TEST_F(CheckCommand, DrawingsOfOtherLinesAnglesAndPagesAreCheckedAsTheyWereMade) {
    write_model();
    for (const char* options :
         {" --lines crease", " --crease 95", " --page a5 --margin 12mm", " --units in",
          " --eye 5,3,6 --target 0.2,0,0 --fov 33", " --up z", " --hidden --plotter"}) {
        ASSERT_EQ(run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.svg") + options)
                      .exit_code,
                  0);
        const std::string table = check("a.svg");
        EXPECT_LT(figure(table, "missed within 1.5 px"), 0.5) << options;
        EXPECT_LT(figure(table, "false within 1.5 px"), 0.5) << options;
    }
}

TEST_F(CheckCommand, CutAndFlatDrawingsAreCheckedAsTheyWereMade) {
    write_model();
    const char* const cut = " --section x=50% --section +y=0.15 --hatching 0.2,30";
    for (const std::string options :
         {" --view isometric", " --view front --scale 10:1 --page a4", " --section x=50%",
          " --view 30,20 --section -x=0.3 --section 0,0.1,0/0.2,1,0",
          " --view isometric --section z=1.5 --hatching none", cut,
          // The eye lies in the plane before the cut, and on a side of it afterwards.
          " --view front --projection perspective --section x=50%"}) {
        for (const std::string drawing : {"a.svg", "a.json"}) {
            if (drawing == "a.json" && options.find("--page") != options.npos) continue;
            ASSERT_EQ(
                run("draw " + path("model.obj") + " --size 400x300 -o " + path(drawing) + options)
                    .exit_code,
                0);
            const std::string table = check(drawing);
            EXPECT_GT(figure(table, "truly visible"), 300) << options;
            EXPECT_LT(figure(table, "missed within 0.5 px"), 0.2) << options;
            EXPECT_LT(figure(table, "false within 0.5 px"), 0.2) << options;
        }
    }
    // The same drawing of the whole model is wrong.
    ASSERT_EQ(
        run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.svg") + cut).exit_code,
        0);
    std::string other = content("a.svg");
    for (std::size_t at = other.find(" --section="); at != other.npos;
         at = other.find(" --section="))
        other.replace(at, 11, " --secti0n=");
    write("a.svg", other);
    EXPECT_GT(figure(check("a.svg"), "missed within 0.5 px"), 5);
}

TEST_F(CheckCommand, AModelFarFromZeroIsCheckedWhereItIs) {
    write_far_model();
    const std::string draw = "draw " + path("model.obj") + " --size 400x300 -o ";
    for (const char* camera : {"", " --eye 4000005,-1999997,6 --target 4000000,-2000000,0"}) {
        ASSERT_EQ(run(draw + path("a.svg") + camera).exit_code, 0);
        EXPECT_NE(content("a.svg").find("--eye 40000"), std::string::npos);
        const std::string table = check("a.svg");
        EXPECT_GT(figure(table, "truly visible"), 500);
        EXPECT_LT(figure(table, "missed within 1.5 px"), 0.5);
        EXPECT_LT(figure(table, "false within 1.5 px"), 0.5);
    }
}

TEST_F(CheckCommand, AVertexAMillionTimesAsFarIsCheckedToo) {
    // The camera is as far away as the far vertex. There a place one unit before it is the same
    // float.
    write("model.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1e12 1e12 1e12\n"
                       "f 1 2 3\nf 1 3 4\nf 1 5 2\n");
    ASSERT_EQ(run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.svg")).exit_code,
              0);
    const std::string table = check("a.svg");
    EXPECT_GT(figure(table, "truly visible"), 100);
    EXPECT_LT(figure(table, "missed within 1.5 px"), 0.5);
    EXPECT_LT(figure(table, "false within 1.5 px"), 0.5);
}

TEST_F(CheckCommand, JsonIsHeldToItsOwnEdges) {
    write_model();
    ASSERT_EQ(run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.json")).exit_code,
              0);
    EXPECT_LT(figure(check("a.json"), "hidden by their own edges"), 2);
    // Hidden lines that claim to be visible.
    ASSERT_EQ(run("draw " + path("model.obj") + " --hidden --size 400x300 -o " + path("b.json"))
                  .exit_code,
              0);
    std::string json = content("b.json");
    for (std::size_t at = 0; (at = json.find("\"visible\":false", at)) != std::string::npos;)
        json.replace(at, 15, "\"visible\":true");
    write("b.json", json);
    const std::string table = check("b.json");
    EXPECT_GT(figure(table, "hidden by their own edges"), 20);
    EXPECT_GT(figure(table, "surely wrong "), 100);
}

TEST_F(CheckCommand, ACertificateIsWrittenWhenAskedFor) {
    write_model();
    const std::string draw = "draw " + path("model.obj") + " --size 400x300 -o ";
    const Result result = run(draw + path("a.svg") + " --certify");
    ASSERT_EQ(result.exit_code, 0);
    EXPECT_NE(result.output.find("a.svg: checked by rays: "), std::string::npos) << result.output;
    const std::string svg = content("a.svg");
    const std::size_t begin = svg.find("<metadata>checked by rays: ");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_NE(svg.find("pixels surely wrong</metadata>", begin), std::string::npos);
    // The drawing's figures are those of a check of the file.
    const std::string table = check("a.svg");
    EXPECT_NEAR(std::stod(svg.substr(begin + 27)), figure(table, "truly visible"), 0.1);

    ASSERT_EQ(run(draw + path("b.svg")).exit_code, 0);
    EXPECT_EQ(content("b.svg").find("metadata"), std::string::npos);
    ASSERT_EQ(run(draw + path("a.json") + " --certify").exit_code, 0);
    EXPECT_NE(content("a.json").find("\"certificate\":\"checked by rays: "), std::string::npos);
    expect_refused(draw + path("a.png") + " --certify", 2, "--certify is for paths");
}

TEST_F(CheckCommand, SaysWhatIsMissing) {
    write_model();
    ASSERT_EQ(run("draw " + path("model.obj") + " --size 400x300 -o " + path("a.svg")).exit_code,
              0);
    const std::string both = " " + path("a.svg") + " " + path("model.obj");
    expect_refused("check", 2, "DRAWING");
    expect_refused("check " + path("none.svg") + " " + path("model.obj"), 1, "none.svg");
    expect_refused("check " + path("model.obj") + " " + path("model.obj"), 1, ".svg or .json");
    write("other.svg", "<svg><desc>draw a.obj; seen at 9x9 pixels</desc></svg>");
    expect_refused("check " + path("other.svg") + " " + path("model.obj"), 1, "--eye");
    // A wrong description in a drawing is an error of the file, not of the command.
    const std::string svg = content("a.svg");
    const std::size_t at = svg.find(" --size");
    for (const char* said : {" --section=bogus", " --only=nothing", " --units=ell"}) {
        write("said.svg", svg.substr(0, at) + said + svg.substr(at));
        expect_refused("check " + path("said.svg") + " " + path("model.obj"), 1, "said.svg");
    }
    ::setenv("LINEATLAS_MODULE_DIR", path("nowhere").c_str(), 1);
    expect_refused("check" + both, 1, "nowhere/lineatlas-rays.so\", which checks drawings by rays");
    expect_refused("draw " + path("model.obj") + " --certify -o " + path("c.svg"), 1,
                   "lineatlas-rays.so");
    ::unsetenv("LINEATLAS_MODULE_DIR");
}

TEST_F(CheckCommand, ScenesAreWrittenAsTheyAre) {
    for (const char* name : {"clevis", "house"}) {
        ASSERT_EQ(run(std::string{"scene "} + name + " -o " + path("scene.obj")).exit_code, 0);
        const Mesh written = load_mesh(path("scene.obj")).mesh;
        const Mesh scene = make_scene(name).mesh;
        EXPECT_EQ(written.positions, scene.positions);
        EXPECT_EQ(written.triangles, scene.triangles);
        EXPECT_EQ(written.polylines, scene.polylines);
        ASSERT_EQ(written.triangle_group.size(), scene.triangle_group.size());
        for (std::size_t i = 0; i < scene.triangle_group.size(); ++i) {
            const MeshGroup& a = written.groups[written.triangle_group[i]];
            const MeshGroup& b = scene.groups[scene.triangle_group[i]];
            ASSERT_EQ(a.object + "/" + a.material, b.object + "/" + b.material) << i;
        }
    }
    expect_refused("scene palace -o " + path("x.obj"), 2, "palace");
    expect_refused("scene house -o " + path("x.ply"), 2, ".obj");
}

} // namespace
} // namespace lineatlas::test
