// Models with sections, drawn by the tool.
#include <cmath>
#include <iomanip>
#include <numbers>
#include <regex>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

class SectionDrawings : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("rod.obj", ring(64, {{0, 50}}));              // 50 high, radius 40
        write("sleeve.obj", "o rod\n" + ring(48, {{0, 20}}) // two parts, one around the other
                                + "o sleeve\n" + ring(48, {{20, 40}}, 96));
    }

    /// Bodies around the y axis, 50 high. Each wall goes from one radius to another.
    static std::string ring(int sides, const std::vector<std::pair<double, double>>& walls,
                            int first = 0) {
        std::ostringstream text;
        for (const auto& [inner, outer] : walls) {
            const bool hollow = inner > 0;
            for (const double radius : {outer, inner}) {
                if (radius == 0) continue;
                for (const int y : {0, 50}) {
                    for (int i = 0; i < sides; ++i) {
                        const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
                        text << std::setprecision(9) << "v " << radius * std::cos(angle) << ' ' << y
                             << ' ' << radius * std::sin(angle) << '\n';
                    }
                }
            }
            std::ostringstream low, high;
            const auto face = [&](std::initializer_list<int> corners) {
                text << 'f';
                for (const int corner : corners) text << ' ' << first + corner + 1;
                text << '\n';
            };
            for (int i = 0; i < sides; ++i) {
                const int j = (i + 1) % sides;
                face({i, sides + i, sides + j, j});
                low << ' ' << first + i + 1;
                high << ' ' << first + 2 * sides - i;
                if (!hollow) continue;
                const int in = 2 * sides;
                face({in + j, in + sides + j, in + sides + i, in + i});
                face({j, in + j, in + i, i});
                face({sides + i, in + sides + i, in + sides + j, sides + j});
            }
            if (!hollow) text << 'f' << low.str() << "\nf" << high.str() << '\n';
        }
        return text.str();
    }

    /// The text of the group of one kind in a drawing.
    static std::string group(const std::string& svg, const std::string& kind) {
        const std::size_t start = svg.find("<g id=\"" + kind + "\"");
        return start == std::string::npos ? "" : svg.substr(start, svg.find("</g>", start) - start);
    }

    static std::ptrdiff_t paths_in(const std::string& text) {
        const std::regex path{"<path "};
        return std::distance(std::sregex_iterator{text.begin(), text.end(), path},
                             std::sregex_iterator{});
    }

    /// The widths and heights of straight paths.
    static std::vector<std::pair<double, double>> steps_of(const std::string& text) {
        std::vector<std::pair<double, double>> steps;
        const std::regex data{" d=\"([^\"]*)\""}, number{"-?[0-9]*\\.?[0-9]+"};
        for (std::sregex_iterator at{text.begin(), text.end(), data}; at != std::sregex_iterator{};
             ++at) {
            const std::string d = (*at)[1];
            std::vector<double> values;
            for (std::sregex_iterator n{d.begin(), d.end(), number}; n != std::sregex_iterator{};
                 ++n)
                values.push_back(std::stod(n->str()));
            if (values.size() == 4) steps.emplace_back(values[2], values[3]);
        }
        return steps;
    }

    std::string drawn(const std::string& model, const std::string& options) {
        const Result result = run("draw " + path(model) + " -o " + path("x.svg") +
                                  " --up y --compute cpp " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return read(path("x.svg"));
    }
};

TEST_F(SectionDrawings, ARodAcrossIsACircle) {
    const std::string svg = drawn("rod.obj", "--view top --section y=30 --scale 1:1 --page a4 "
                                             "--hatching none");
    const std::string section = group(svg, "section");
    const std::regex arc{"a([0-9.]+) "};
    std::smatch found;
    ASSERT_TRUE(std::regex_search(section, found, arc)) << section;
    EXPECT_NEAR(std::stod(found[1]), 50, 0.01);
    EXPECT_EQ(paths_in(section), 1);
    EXPECT_EQ(group(svg, "hatching"), "");
}

TEST_F(SectionDrawings, HatchingAcrossIsASpacingApart) {
    for (const char* method : {"atlas", "exact"}) {
        SCOPED_TRACE(method);
        // The rod from the front: a rectangle of 100 by 50, cut in its middle.
        const std::string svg =
            drawn("rod.obj", std::string{"--view front --section z=0 --scale 1:1 --page a4 "
                                         "--hatching 5,45 --method "} +
                                 method);
        const std::string hatching = group(svg, "hatching");
        EXPECT_NEAR(static_cast<double>(paths_in(hatching)), 150 / (5 * std::numbers::sqrt2), 1.5);
        // Each line of hatching goes from outline to outline. Long ones are 50 high.
        int whole = 0;
        for (const auto& [x, y] : steps_of(hatching)) {
            EXPECT_NEAR(std::abs(x), std::abs(y), 0.003);
            if (std::abs(std::abs(y) - 50) < 0.02) ++whole;
        }
        EXPECT_GE(whole, 6) << hatching;
        EXPECT_EQ(paths_in(group(svg, "section")), 1);
        EXPECT_NE(group(svg, "section").find("z\""), std::string::npos);
        EXPECT_EQ(group(svg, "crease"), "") << "what the cut took away, or what lies behind it";
    }
}

TEST_F(SectionDrawings, PartsAreHatchedAgainstEachOther) {
    const std::string svg = drawn("sleeve.obj", "--view front --section z=0 --scale 1:1 --page a4 "
                                                "--hatching 4");
    int up = 0, down = 0;
    for (const auto& [x, y] : steps_of(group(svg, "hatching"))) ++(x * y < 0 ? up : down);
    EXPECT_GT(up, 8);
    EXPECT_GT(down, 8);
}

TEST_F(SectionDrawings, UncutPartsHaveNoHatching) {
    const std::string options = "--view front --section z=0 --scale 1:1 --page a4 --hatching 4";
    const std::string svg = drawn("sleeve.obj", options + " --uncut \"r?d\"");
    const auto lines = steps_of(group(svg, "hatching"));
    EXPECT_GT(lines.size(), 8U);
    for (const auto& [x, y] : lines) EXPECT_LT(x * y, 0);
    EXPECT_NE(group(svg, "silhouette"), "") << "the rod's sides, before the cut";
    const Result checked = run("check " + path("x.svg") + " " + path("sleeve.obj"));
    EXPECT_EQ(checked.exit_code, 0) << checked.output;
    EXPECT_TRUE(std::regex_search(checked.output, std::regex{"missed within 0.5 px +0[.]0"}))
        << checked.output;
    // On a sheet, too.
    drawn("sleeve.obj", "--views top,section:z=0 --hatching 4 --uncut rod");
    EXPECT_NE(read(path("x.svg")).find("section_A-hatching"), std::string::npos);
}

TEST_F(SectionDrawings, TheSideOfTheEyeIsGone) {
    // Views from both sides show the cut.
    for (const char* view : {"front", "back"}) {
        SCOPED_TRACE(view);
        EXPECT_NE(group(drawn("rod.obj", std::string{"--section z=0 --view "} + view), "hatching"),
                  "");
    }
    EXPECT_EQ(group(drawn("rod.obj", "--section -z=0 --view front"), "hatching"), "");
}

TEST_F(SectionDrawings, RaysSayTheSame) {
    for (const char* options :
         {"--section x=40%", "--section x=40% --section z=5 --method exact"}) {
        const Result result = run("draw " + path("sleeve.obj") + " --up y --compute cpp -o " +
                                  path("x.svg") + " --certify " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        std::smatch found;
        const std::regex words{"missed ([0-9.]+) % within .*false ([0-9.]+) %"};
        ASSERT_TRUE(std::regex_search(result.output, found, words)) << result.output;
        EXPECT_LE(std::stod(found[1]), 0.05) << result.output;
        EXPECT_LE(std::stod(found[2]), 0.01) << result.output;
    }
    const Result checked = run("check " + path("x.svg") + " " + path("sleeve.obj"));
    EXPECT_EQ(checked.exit_code, 0) << checked.output;
    EXPECT_TRUE(std::regex_search(checked.output, std::regex{"missed within 0.5 px +0[.]0"}))
        << checked.output;
}

TEST_F(SectionDrawings, WhatIsWrongIsSaidInALine) {
    const std::string draw =
        "draw " + path("rod.obj") + " --up y --compute cpp -o " + path("y.svg");
    expect_refused(draw + " --section y=70", 2, "section y=70 misses the model");
    expect_refused(draw + " --section w=1", 2, "as in z=0.3");
    expect_refused(draw + " --section y=1 --hatching thick", 2, "\"thick\"");
    expect_refused(draw + " --section y=1 --hatching 1e-9", 2, "too near");
    expect_refused(draw + " --hatching 1", 2, "--hatching needs --section");
    expect_refused(draw + " --uncut rod", 2, "--uncut needs --section");
    expect_refused(draw + " --section y=1 --uncut nut", 2, "no part is called \"nut\"");
    // An open mesh is drawn, and a message tells that it is open.
    write("open.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
    const Result open = run("draw " + path("open.obj") + " --up y --compute cpp -o " +
                            path("y.svg") + " --section y=1");
    EXPECT_EQ(open.exit_code, 0);
    EXPECT_NE(open.output.find("section y=1: the cut does not close, at "), std::string::npos)
        << open.output;
    EXPECT_EQ(std::ranges::count(open.output, '\n'), 1);
}

} // namespace
} // namespace lineatlas::test
