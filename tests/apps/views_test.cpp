// Views that measure: projections, sides by their names, drawings to scale, which way is up.
#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

class Views : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("cube.obj", box(100, 100, 100));
        write("tower.obj", box(10, 10, 100) + box(60, 60, 1, 8));
    }

    /// `first`: vertices before it; `from`: its lowest corner.
    static std::string box(int x, int y, int z, int first = 0, std::array<int, 3> from = {}) {
        std::string text;
        for (int corner = 0; corner < 8; ++corner) {
            const auto at = [&](int axis, int size) {
                const bool is_far = (corner >> axis & 1) != 0;
                return std::to_string(from.at(axis) + (is_far ? size : 0)).append(" ");
            };
            text.append("v ").append(at(0, x)).append(at(1, y)).append(at(2, z)).append("\n");
        }
        for (const auto& side : {std::array{1, 3, 4, 2},
                                 {5, 6, 8, 7},
                                 {1, 2, 6, 5},
                                 {3, 7, 8, 4},
                                 {1, 5, 7, 3},
                                 {2, 4, 8, 6}}) {
            text += "f";
            for (const int corner : side) text.append(" ").append(std::to_string(corner + first));
            text += "\n";
        }
        return text;
    }

    /// The lengths of steps of the paths of an SVG, in its units.
    std::vector<double> lengths(const std::string& name) const {
        const std::string text = read(path(name));
        const std::regex step{R"( d="m-?[0-9.]+[ ,]?-?[0-9.]+([^"m]*)\")"};
        std::vector<double> found;
        for (std::sregex_iterator at{text.begin(), text.end(), step}; at != std::sregex_iterator{};
             ++at) {
            const std::string d = (*at)[1];
            if (d.starts_with('h') || d.starts_with('v')) {
                found.push_back(std::abs(std::stod(d.substr(1))));
            } else {
                std::size_t end = 0;
                const double x = std::stod(d, &end);
                found.push_back(std::hypot(x, std::stod(d.substr(end))));
            }
        }
        return found;
    }
};

TEST_F(Views, AMillimetreOfTheModelIsAMillimetreOnPaper) {
    EXPECT_EQ(run("draw " + path("cube.obj") + " -o " + path("x.svg") +
                  " --page a4 --view front --scale 1:2 --compute cpp")
                  .exit_code,
              0);
    const std::vector<double> edges = lengths("x.svg");
    ASSERT_EQ(edges.size(), 4U);
    for (const double edge : edges) EXPECT_NEAR(edge, 50, 0.005);
    // The same model in inches.
    EXPECT_EQ(run("draw " + path("cube.obj") + " -o " + path("x.svg") +
                  " --page a4 --view front --scale 1:50 --unit in --compute cpp")
                  .exit_code,
              0);
    for (const double edge : lengths("x.svg")) EXPECT_NEAR(edge, 50.8, 0.005);
}

TEST_F(Views, LinesAFifthOfAMillimetreApartAreTwoOnAnyPage) {
    write("step.obj", box(250, 250, 50) + box(150, 1, 30, 8, {50, 250, 10}));
    std::vector<double> of_first;
    for (const char* page : {"a4", "a2", "a0", "1000x900mm"}) {
        run("draw " + path("step.obj") + " -o " + path("x.svg") +
            " --view front --up y --scale 1:5 --compute cpp --page " + page);
        std::vector<double> found = lengths("x.svg");
        std::ranges::sort(found);
        if (of_first.empty()) of_first = found;
        ASSERT_EQ(found.size(), 9U) << page;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], of_first[i], 0.005) << page;
    }
    EXPECT_NEAR(of_first[0], 0.2, 0.005);
    EXPECT_NEAR(of_first[4], 30, 0.005);
    EXPECT_NEAR(of_first[5], 30, 0.005);
}

TEST_F(Views, IsometricEdgesAreEqual) {
    EXPECT_EQ(run("draw " + path("cube.obj") + " -o " + path("x.svg") +
                  " --page a4 --view isometric --scale 1:2 --compute cpp")
                  .exit_code,
              0);
    const std::vector<double> edges = lengths("x.svg");
    ASSERT_EQ(edges.size(), 9U);
    for (const double edge : edges) EXPECT_NEAR(edge, 50 * std::sqrt(2.0 / 3), 0.005);
}

TEST_F(Views, AScaleThatDoesNotFitNamesOneThatDoes) {
    const std::string draw = "draw " + path("cube.obj") + " --view front -o " + path("y.svg");
    expect_refused(draw + " --page a4 --scale 5:1", 2, "2:1 fits");
    expect_refused(draw + " --page a6 --margin 20mm --scale 1:1", 2, "1:2 fits");
    expect_refused("draw " + path("cube.obj") + " -o " + path("y.png") + " --scale 1:1", 2,
                   "needs --dpi");
}

TEST_F(Views, WhatContradictsItselfIsRefused) {
    const std::string draw = "draw " + path("cube.obj") + " -o " + path("y.svg") + " ";
    expect_refused(draw + "--view frnt", 2, "isometric");
    expect_refused(draw + "--view top --eye 1,2,3", 2, "exclude");
    expect_refused(draw + "--projection flat", 2, "perspective or orthographic");
    expect_refused(draw + "--scale 1:0 --page a4", 2, "as in 1:50");
    expect_refused(draw + "--scale 1:2 --page a4 --projection perspective", 2, "orthographic");
    expect_refused(draw + "--scale 1:2 --page a4 --unit furlong", 2, "mm, cm, m, in or ft");
    expect_refused(draw + "--unit mm", 2, "--scale");
}

TEST_F(Views, SaysWhatIsTakenAsUpwards) {
    const std::string draw = "draw " + path("tower.obj") + " --compute cpp -o " + path("x.svg");
    const Result guessed = run(draw);
    EXPECT_EQ(guessed.exit_code, 0);
    EXPECT_NE(guessed.output.find("z is taken as upwards; --up y takes y"), std::string::npos)
        << guessed.output;
    EXPECT_EQ(run(draw + " --up z").output, "");
    EXPECT_EQ(run(draw + " --up y").output, "");
}

} // namespace
} // namespace lineatlas::test
