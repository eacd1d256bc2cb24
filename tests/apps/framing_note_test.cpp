// A camera that frames a whole model says where a small part far away makes the rest small.
#include <sstream>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

/// A wavy sheet of 2 x 20 x 20 triangles from `at`, `size` wide.
std::string sheet(double at, double size, int first) {
    constexpr int side = 21;
    std::ostringstream text;
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

class FramingNote : public Tool {
  protected:
    std::string say(const std::string& model, const std::string& options = "") {
        write("m.obj", model);
        const Result result =
            run("draw " + path("m.obj") + " --size 64x48 -o " + path("x.svg") + " " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return result.output;
    }
};

TEST_F(FramingNote, AStrayLineFarAway) {
    const std::string line = "v 22 0 0\nv 22.1 0 0\nl 442 443\n";
    const std::string said = say(sheet(0, 1, 1) + line);
    EXPECT_NE(said.find("1 of "), std::string::npos) << said;
    EXPECT_NE(said.find("the picture is 15."), std::string::npos) << said; // 22.1 over 1.42
    EXPECT_NE(said.find("about 0.5,0.5,0.05"), std::string::npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    // Not where the camera is placed by hand.
    EXPECT_EQ(say(sheet(0, 1, 1) + line, "--eye 0,0,5 --target 0,0,0"), "");
    // The same coordinates as in the file, far from zero too.
    const std::string far = say(sheet(1e6, 1, 1) + "v 1000022 0 0\nv 1000022.1 0 0\nl 442 443\n");
    EXPECT_NE(far.find("about 1000000,0.5,0.05"), std::string::npos) << far;
}

TEST_F(FramingNote, OnBothSides) {
    const std::string said = say(sheet(0, 1, 1) + "v 30 0 0\nv 30 1 0\nv -30 0 0\nv -30 1 0\n"
                                                  "l 442 443\nl 444 445\n");
    EXPECT_NE(said.find("2 of "), std::string::npos) << said;
}

TEST_F(FramingNote, NothingIsSaidWithoutOne) {
    EXPECT_EQ(say(sheet(0, 1, 1)), "");
    // Two of a size, far apart; a part that reaches there; one that is not far.
    EXPECT_EQ(say(sheet(0, 1, 1) + sheet(22, 1, 442)), "");
    EXPECT_EQ(say(sheet(0, 1, 1) + "v 22 0 0\nl 1 442\n"), "");
    EXPECT_EQ(say(sheet(0, 1, 1) + "v 1.5 0 0\nv 1.6 0 0\nl 442 443\n"), "");
}

} // namespace
} // namespace lineatlas::test
