// A camera that frames a whole model leaves out a tiny part far away. If a small part makes the
// rest small, a message tells where it is.
#include <iomanip>
#include <sstream>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

/// A wavy sheet of 2 x 20 x 20 triangles from `at`, `size` wide.
std::string sheet(double at, double size, int first) {
    constexpr int side = 21;
    std::ostringstream text;
    text << std::setprecision(10);
    for (int i = 0; i < side * side; ++i) {
        const int x = i % side, y = i / side;
        text << "v " << at + size * x / 20 << ' ' << size * y / 20 << ' ' << size * (i % 3) / 20
             << '\n';
    }
    for (int y = 0; y + 1 < side; ++y) {
        for (int x = 0; x + 1 < side; ++x) {
            const int v = first + y * side + x;
            text << "f " << v << ' ' << v + 1 << ' ' << v + side << "\nf " << v + 1 << ' '
                 << v + side + 1 << ' ' << v + side << '\n';
        }
    }
    return text.str();
}

class Framing : public Tool {
  protected:
    std::string say(const std::string& model, const std::string& options = "") {
        write("m.obj", model);
        const Result result =
            run("draw " + path("m.obj") + " --size 64x48 -o " + path("x.svg") + " " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return result.output;
    }

    /// The drawing without the camera in its description.
    std::string paths() const {
        const std::string svg = read(path("x.svg"));
        return svg.substr(std::min(svg.size(), svg.find("<path")));
    }
};

/// `count` lines, beginning at x = `from`.
std::string stray_lines(int count, double from = 22) {
    std::ostringstream text;
    text << std::setprecision(10);
    for (int i = 0; i < count; ++i) {
        text << "v " << from << ' ' << i << " 0\nv " << from + 0.1 << ' ' << i << " 0\nl "
             << 442 + 2 * i << ' ' << 443 + 2 * i << '\n';
    }
    return text.str();
}

TEST_F(Framing, LeavesOutAStrayLineFarAway) {
    const std::string said = say(sheet(0, 1, 1) + stray_lines(1));
    EXPECT_NE(said.find("1 of "), std::string::npos) << said;
    EXPECT_NE(said.find("not framed"), std::string::npos) << said;
    EXPECT_NE(said.find("15."), std::string::npos) << said; // 22.1 over 1.42
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    const std::string with = paths();
    EXPECT_FALSE(with.empty());
    EXPECT_EQ(say(sheet(0, 1, 1)), "");
    EXPECT_EQ(with, paths());
    // No message if the camera is placed by hand.
    EXPECT_EQ(say(sheet(0, 1, 1) + stray_lines(1), "--eye 0,0,5 --target 0,0,0"), "");
}

TEST_F(Framing, TellsCountAndPlaceOfSeveralStrayLines) {
    const std::string said = say(sheet(0, 1, 1) + stray_lines(10));
    EXPECT_NE(said.find("10 of "), std::string::npos) << said;
    EXPECT_NE(said.find("the picture is 16."), std::string::npos) << said; // 23.9 over 1.42
    EXPECT_NE(said.find("about 0.5,0.5,0.05"), std::string::npos) << said;
    // The message has the coordinates of the file, also far from zero.
    const std::string far = say(sheet(1e6, 1, 1) + stray_lines(10, 1000022));
    EXPECT_NE(far.find("about 1000000,0.5,0.05"), std::string::npos) << far;
}

TEST_F(Framing, LeavesOutStrayLinesOnBothSides) {
    const std::string said = say(sheet(0, 1, 1) + "v 30 0 0\nv 30 1 0\nv -30 0 0\nv -30 1 0\n"
                                                  "l 442 443\nl 444 445\n");
    EXPECT_NE(said.find("2 of "), std::string::npos) << said;
}

TEST_F(Framing, SaysNothingWithoutStrayLines) {
    EXPECT_EQ(say(sheet(0, 1, 1)), "");
    // Two parts of one size far apart, a part that reaches from one to the other, and one that is
    // not far.
    EXPECT_EQ(say(sheet(0, 1, 1) + sheet(22, 1, 442)), "");
    EXPECT_EQ(say(sheet(0, 1, 1) + "v 22 0 0\nl 1 442\n"), "");
    EXPECT_EQ(say(sheet(0, 1, 1) + "v 1.5 0 0\nv 1.6 0 0\nl 442 443\n"), "");
}

} // namespace
} // namespace lineatlas::test
