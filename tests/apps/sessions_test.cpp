// Sessions of the viewer, drawn by the tool.
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class Sessions : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("box.obj", "o box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"
                         "v 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
                         "f 4 1 5 8\no roof\nv 0 2 0\nv 1 2 0\nv 0 2 1\nf 9 10 11\n");
    }
    void session(const std::string& text) {
        write("s.toml", "session = 1\nmodel = \"box.obj\"\n" + text);
    }
    /// The drawing by these arguments without its description.
    std::string drawn(const std::string& arguments) {
        const Result result = run("draw " + arguments + " -o " + path("out.svg"));
        EXPECT_EQ(result.exit_code, 0) << arguments << "\n" << result.output;
        const std::string svg = read(path("out.svg"));
        return svg.substr(std::min(svg.size(), svg.find("</desc>")));
    }
};

const char* const all_of_it = "size = \"300x200\"\nhide = \"roof\"\nsection = [\"+x=0.5\"]\n"
                              "lines = \"crease,section\"\n"
                              "[[views]]\neye = [3, 2, 4]\ntarget = [0.5, 0.5, 0.5]\n"
                              "up = [0, 1, 0]\nfov = 30\n"
                              "[style]\nwidth = 5\ncolor = \"#ff0000\"\n";

TEST_F(Sessions, AreDrawnAsTheirOptions) {
    session(all_of_it);
    write("own.toml", "width = 5\ncolor = \"#ff0000\"\n");
    EXPECT_EQ(drawn(path("s.toml")),
              drawn(path("box.obj") +
                    " --size 300x200 --hide roof --section +x=0.5 --lines "
                    "crease,section --eye 3,2,4 --target 0.5,0.5,0.5 --up 0,1,0 "
                    "--projection perspective --fov 30 --style " +
                    path("own.toml")));
}

TEST_F(Sessions, OptionsOfTheCommandLineCountMore) {
    session(all_of_it);
    const std::string usual = drawn(path("s.toml"));
    EXPECT_NE(drawn(path("s.toml") + " --size 400x200"), usual);
    EXPECT_NE(drawn(path("s.toml") + " --section -x=0.5"), usual);
    EXPECT_NE(drawn(path("s.toml") + " --width 1"), usual);
    EXPECT_NE(drawn(path("s.toml") + " --style pencil"), usual);
    EXPECT_NE(drawn(path("s.toml") + " --fov 50"), usual);
    EXPECT_NE(drawn(path("s.toml") + " --view top"), usual);
}

TEST_F(Sessions, ThatAreBadAreRefusedByFileAndLine) {
    const auto refused = [&](const std::string& text, const std::string& words) {
        session(text);
        expect_refused("draw " + path("s.toml") + " -o " + path("out.svg"), 1, words);
    };
    refused("section = \"q=1\"\n", "s.toml\" line 3: section");
    refused("metod = \"exact\"\n", "line 3: metod: a session has no such key");
    refused("method = \"exakt\"\n", "line 3: method");
    refused("output = \"/tmp/x.svg\"\n", "no such key");
    refused("profile = \"/tmp/x\"\n", "no such key");
    refused("size = \"0x0\"\n", "line 3");
    refused("[[views]]\neye = [1, 2, 3]\ntarget = [1, 2, 3]\n", "two different points");
    refused("[[views]]\nneck = [1, 2, 3]\n", "no \"neck\"");
    refused("[style]\nwidht = 1\n", "width");
    refused("views = 3\n", "[[views]]");
    refused("scene = \"house\"\n", "not both");
    write("s.toml", "width = 3\n");
    expect_refused("draw " + path("s.toml") + " -o " + path("out.svg"), 1, "is no session");
    write("s.toml", "session = 7\nmodel = \"box.obj\"\n");
    expect_refused("draw " + path("s.toml") + " -o " + path("out.svg"), 1, "version 1");
    write("s.toml", "session = 1\nmodel = \"gone.obj\"\n");
    expect_refused("draw " + path("s.toml") + " -o " + path("out.svg"), 1, "gone.obj");
    expect_refused("draw " + path("none.toml") + " -o " + path("out.svg"), 1, "no such file");
}

} // namespace
} // namespace lineatlas::test
