// A drawing without a line is written, and a message of one line tells why it is empty.
#include "lineatlas/io.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class EmptyDrawings : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                       "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
        // A line behind a wall.
        write("wall.obj", "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nv -1 0 -2\nv 1 0 -2\nf 1 2 3\nl 4 5\n");
    }

    /// The message of `draw`. Expects that the picture exists.
    std::string say(const std::string& arguments, const std::string& output) {
        const Result result = run("draw " + arguments + " --size 64x48 -o " + path(output));
        EXPECT_EQ(result.exit_code, 0) << arguments << "\n" << result.output;
        EXPECT_LE(std::ranges::count(result.output, '\n'), 1) << result.output;
        return result.output;
    }
    void expect_empty(const std::string& arguments, const std::string& cause) {
        for (const char* output : {"x.png", "x.svg", "x.json"}) {
            fs::remove(path(output));
            EXPECT_EQ(say(arguments, output), "lineatlas: no line is drawn: " + cause + "\n");
            EXPECT_TRUE(fs::exists(path(output))) << arguments;
        }
        const Image image = read_image(path("x.png"));
        EXPECT_TRUE(std::ranges::all_of(image.pixels, [](auto value) { return value == 255; }));
    }
};

const std::string wall_from_the_front = "wall.obj --eye 0,0,9 --target 0,0,0 --fov 20 --lines file";

TEST_F(EmptyDrawings, NamesKindsThatTheModelDoesNotHave) {
    expect_empty(path("t.obj") + " --lines boundary", "the model has none of the kinds boundary");
    expect_empty(path("t.obj") + " --lines crease,file --crease 180",
                 "the model has none of the kinds crease, file; a smaller crease angle finds more");
}

TEST_F(EmptyDrawings, SaysThatTheCameraLooksElsewhere) {
    expect_empty(path("t.obj") + " --eye 3,3,3 --target 9,9,9",
                 "the model lies behind the camera, which looks away from it");
    const std::string beside = "none lies in the part of the model that the camera sees";
    expect_empty(path("t.obj") + " --eye 0,0,9 --target 9,0,0 --fov 1", beside);
    // A view from within onto the middle of a face.
    expect_empty(path("t.obj") + " --eye 0.2,0.2,0.2 --target 0.25,0.2,0.2 --fov 1", beside);
}

TEST_F(EmptyDrawings, SaysThatAllLinesAreHidden) {
    expect_empty(path(wall_from_the_front),
                 "surfaces hide those in the picture, or the style leaves them out");
}

TEST_F(EmptyDrawings, AreToldByEveryMethod) {
    for (const char* method : {"atlas", "item-buffer", "spine", "opengl"}) {
        const std::string option = std::string{" --style technical --method "} + method;
        EXPECT_NE(
            say(path("t.obj") + " --eye 3,3,3 --target 9,9,9" + option, "m.png").find("behind"),
            std::string::npos)
            << method;
        EXPECT_EQ(say(path("t.obj") + option, "m.png"), "") << method;
    }
}

TEST_F(EmptyDrawings, ASequenceNamesItsFirstEmptyFrame) {
    const Result result = run("draw " + path("t.obj") + " --size 64x48 --turntable 2 -o " +
                              path("%d.svg") + " --lines boundary");
    EXPECT_EQ(result.exit_code, 0);
    const std::string wanted = "lineatlas: no line is drawn in 2 of 2 frames; first \"" +
                               path("0.svg") + "\": the model has none of the kinds boundary\n";
    EXPECT_NE(result.output.find(wanted), std::string::npos) << result.output;
}

TEST_F(EmptyDrawings, ADrawingWithALineIsNotEmpty) {
    EXPECT_EQ(say(path("t.obj"), "full.png"), "");
    EXPECT_EQ(say(path("t.obj"), "full.svg"), "");
    for (const char* output : {"hidden.png", "hidden.svg"})
        EXPECT_EQ(say(path(wall_from_the_front) + " --hidden", output), "") << output;
    // A line passes through the picture, and its ends lie beside the picture.
    EXPECT_EQ(say(path("t.obj") + " --eye 0.5,0.02,9 --target 0.5,0.02,0 --fov 1", "zoom.png"), "");
    EXPECT_EQ(say(path("t.obj") + " --tile 16", "tiles.png"), "");
}

} // namespace
} // namespace lineatlas::test
