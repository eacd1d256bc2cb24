// Sequences of frames: turntables and camera paths, chosen frames, and continuing after a stop.

#include <csignal>
#include <cstdlib>
#include <set>
#include <thread>

#include <OpenImageIO/imageio.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/io.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class Sequence : public Tool {
  protected:
    void draw(const std::string& arguments) {
        const Result result = run("draw " + arguments);
        ASSERT_EQ(result.exit_code, 0) << arguments << "\n" << result.output;
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator{folder_}) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }

    /// The option `name` of the command in a picture's description.
    std::string option(const std::string& file, const std::string& name) const {
        const auto input = OIIO::ImageInput::open(path(file));
        if (!input) return {};
        const std::string text = input->spec().get_string_attribute("ImageDescription");
        const std::size_t begin = text.find(name + " ") + name.size() + 1;
        return text.substr(begin, text.find(' ', begin) - begin);
    }

    glm::vec3 vector(const std::string& file, const std::string& name) const {
        glm::vec3 v{0};
        std::sscanf(option(file, name).c_str(), "%f,%f,%f", &v.x, &v.y, &v.z);
        return v;
    }
};

TEST_F(Sequence, AFrameAloneIsTheFrameOfTheSequence) {
    for (const std::string compute : {"opencl", "cpp"}) {
        const std::string options =
            "--scene clevis --turntable 9 --size 200x150 --compute " + compute;
        draw(options + " -o " + path("all%d.png"));
        draw(options + " --frames 5 -o " + path("one%02d.png"));
        const Image all = read_image(path("all5.png"));
        EXPECT_TRUE(all.pixels == read_image(path("one05.png")).pixels);
        EXPECT_FALSE(all.pixels == read_image(path("all4.png")).pixels);
        EXPECT_TRUE(fs::exists(path("all0.png")) && fs::exists(path("all8.png")));
        EXPECT_FALSE(fs::exists(path("all9.png")));
    }
}

TEST_F(Sequence, ATurntableGoesAroundTheModelAndKeepsItInThePicture) {
    // A long bar off the origin, upright along z.
    write("bar.obj",
          "v 10 0 0\nv 18 0 0\nv 18 1 0\nv 10 1 0\nv 10 0 2\nv 18 0 2\nv 18 1 2\n"
          "v 10 1 2\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    draw(path("bar.obj") + " --up z --turntable 8 --size 160x120 -o " + path("%d.png"));
    const glm::vec3 centre{14, 0.5F, 1};
    const glm::vec3 first = vector("0.png", "--eye") - centre;
    for (int i = 0; i < 8; ++i) {
        const std::string name = std::to_string(i) + ".png";
        const glm::vec3 eye = vector(name, "--eye") - centre;
        EXPECT_NEAR(eye.z, first.z, 1e-4F);
        const double turn = std::atan2(eye.y, eye.x) - std::atan2(first.y, first.x);
        EXPECT_NEAR(std::remainder(turn - i * M_PI / 4, 2 * M_PI), 0, 1e-4) << name;
        EXPECT_NEAR(glm::length(eye), glm::length(first), 1e-3F);

        const Image image = read_image(path(name));
        std::size_t dark = 0, dark_at_border = 0;
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                if (image.pixels[static_cast<std::size_t>(y * 160 + x) * 4] > 128) continue;
                ++dark;
                if (x == 0 || y == 0 || x == 159 || y == 119) ++dark_at_border;
            }
        }
        EXPECT_GT(dark, 100U) << name;
        EXPECT_EQ(dark_at_border, 0U) << name;
    }
}

TEST_F(Sequence, ACameraPathGoesThroughItsKeys) {
    write("path.json", R"({"fps": 10, "keys": [
        {"frame": 2, "eye": [9, 5, 9], "target": [0, 0, 0], "fov": 30},
        {"time": 0.6, "eye": [9, 5, -9], "target": [0, 1, 0], "fov": 50},
        {"frame": 8, "eye": [9, 5, -9], "target": [0, 1, 0]},
        {"frame": 10, "eye": [0, 5, -12], "target": [0, 1, 0], "up": [0, 1, 0.2]}]})");
    draw("--scene clevis --size 64x48 --camera-path " + path("path.json") + " -o " +
         path("%d.png"));
    std::set<std::string> expected{"path.json"};
    for (int i = 2; i <= 10; ++i) expected.insert(std::to_string(i) + ".png");
    EXPECT_EQ(files(), expected);
    const auto near = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) < 1e-4F; };
    EXPECT_TRUE(near(vector("2.png", "--eye"), {9, 5, 9}));
    EXPECT_TRUE(near(vector("6.png", "--eye"), {9, 5, -9}));
    EXPECT_TRUE(near(vector("10.png", "--eye"), {0, 5, -12}));
    // The camera rests between two equal keys.
    EXPECT_TRUE(near(vector("7.png", "--eye"), {9, 5, -9}));
    // It moves smoothly: slower near the rest than in the middle of the way.
    const float early = vector("3.png", "--eye").z - vector("4.png", "--eye").z;
    const float late = vector("5.png", "--eye").z - vector("6.png", "--eye").z;
    EXPECT_GT(early, 1.5F * late);
    EXPECT_EQ(option("2.png", "--fov"), "30");
    EXPECT_EQ(option("10.png", "--fov"), "50");
    const double between = std::stod(option("4.png", "--fov"));
    EXPECT_GT(between, 35);
    EXPECT_LT(between, 50);
}

TEST_F(Sequence, DrawsTheFramesThatAreAskedFor) {
    draw("--scene clevis --size 32x24 --turntable 30 --frames 3,10-20x4,18,28-29 -o " +
         path("f%03d.png"));
    EXPECT_EQ(files(), (std::set<std::string>{"f003.png", "f010.png", "f014.png", "f018.png",
                                              "f028.png", "f029.png"}));
}

TEST_F(Sequence, SharesOfASequenceAreAllOfIt) {
    const std::string options = "--scene clevis --size 32x24 --turntable 5 -o " + path("s%d.png");
    const std::vector<std::set<std::string>> with_each_share{
        {"s0.png", "s3.png"},
        {"s0.png", "s1.png", "s3.png", "s4.png"},
        {"s0.png", "s1.png", "s2.png", "s3.png", "s4.png"}};
    for (std::size_t share = 0; share < 3; ++share) {
        draw(options + " --frames " + std::to_string(share) + "-x3");
        EXPECT_EQ(files(), with_each_share[share]);
    }
    draw(options + " --frames 7-x8"); // more shares than frames, so this share has no frame
    EXPECT_EQ(files(), with_each_share[2]);
}

TEST_F(Sequence, ResumeDrawsOnlyWhatIsMissing) {
    const std::string options = "--scene clevis --size 48x32 --turntable 5 -o " + path("%d%%.png");
    draw(options);
    const Image second = read_image(path("1%.png"));
    fs::remove(path("0%.png"));
    fs::copy_file(path("4%.png"), path("1%.png"), fs::copy_options::overwrite_existing);
    fs::resize_file(path("2%.png"), fs::file_size(path("2%.png")) / 2);
    write_image(path("3%.png"),
                Image{.size = {4, 4}, .channels = 1, .pixels = std::vector<std::uint8_t>(16)});
    const Result result = run("draw " + options + " --resume");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.output.find("3 frames drawn"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("2 were there already"), std::string::npos) << result.output;
    EXPECT_TRUE(read_image(path("1%.png")).pixels == read_image(path("4%.png")).pixels);
    EXPECT_FALSE(read_image(path("1%.png")).pixels == second.pixels);
    for (const char* name : {"0%.png", "2%.png", "3%.png"}) {
        EXPECT_EQ(read_image(path(name)).size, glm::ivec2(48, 32)) << name;
    }
}

TEST_F(Sequence, ASignalStopsItBetweenTwoFrames) {
    constexpr int frames = 20'000; // minutes
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string pattern = path(std::to_string(signal) + ".%d.png");
        const pid_t process = ::fork();
        if (process == 0) {
            // As in a terminal, so that the signal reaches all processes that the tool started.
            ::setpgid(0, 0);
            const std::string count = std::to_string(frames);
            if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(9);
            ::execl(LINEATLAS_TOOL, LINEATLAS_TOOL, "draw", "--scene", "clevis", "--turntable",
                    count.c_str(), "--size", "320x240", "-o", pattern.c_str(), nullptr);
            ::_exit(9);
        }
        while (files().size() < 4 && ::kill(process, 0) == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ::kill(-process, signal);
        int status = 0;
        ::waitpid(process, &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 128 + signal);
        const std::set<std::string> drawn = files();
        EXPECT_GE(drawn.size(), 4U);
        EXPECT_LT(drawn.size(), 2000U);
        for (const std::string& name : drawn) {
            EXPECT_EQ(read_image(path(name)).size, glm::ivec2(320, 240)) << name;
            fs::remove(path(name));
        }
    }
}

TEST_F(Sequence, RefusesWhatMakesNoSense) {
    const std::string turn = "draw --scene clevis --size 32x24 --turntable 5 -o ";
    expect_refused(turn + path("x.png"), 2, "one file");
    expect_refused(turn + path("x%d-%d.png"), 2, "more than one");
    expect_refused(turn + path("x%s.png"), 2, "\"%s.p\"");
    expect_refused(turn + path("x%4d.png"), 2, "\"%4d.\"");
    expect_refused(turn + path("x%00d.png"), 2, "%04d");
    expect_refused(turn + path("x.png%"), 2, "%");
    expect_refused(turn + path("none/x%d.png"), 1, "folder does not exist");
    const std::string good = turn + path("x%d.png");
    expect_refused(good + " --frames 5", 2, "the frames 0 to 4");
    expect_refused(good + " --frames 0-99999999999", 2, "--frames");
    for (const char* frames :
         {"", "3-1", "1-3x0", "a", "-1", "-", "-x2", "1-x", "1-x0", "1,,2", "1-3y2"}) {
        expect_refused(good + " --frames=" + frames, 2, "--frames");
    }
    expect_refused(good + " --stats", 2, "--stats");
    expect_refused(good + " --eye 0,99,0 --target 0,0,0", 2, "frame 0: camera: up");
    expect_refused("draw --scene clevis --turntable 0 -o " + path("x%d.png"), 2, "--turntable");
    const std::string one = "draw --scene clevis --size 32x24 -o " + path("x.png");
    expect_refused(one + " --resume", 2, "--turntable");
    expect_refused(one + " --frames 1", 2, "--turntable");
}

TEST_F(Sequence, RefusesBadCameraPaths) {
    const auto refused = [&](const std::string& text, const std::string& words) {
        write("p.json", text);
        expect_refused("draw --scene clevis --size 32x24 -o " + path("x%d.png") +
                           " --camera-path " + path("p.json"),
                       1, words);
    };
    const auto key = [](const std::string& more) {
        return R"({"keys": [{"frame": 0, "eye": [9, 5, 9], "target": [0, 0, 0])" + more + "}]}";
    };
    const std::string good = R"({"frame": 3, "eye": [9, 5, 9], "target": [0, 0, 0]})";
    refused("", "empty");
    refused("{\"keys\": [", "p.json\": it is not JSON: parse error at line 1");
    refused("[1]", "the file must be an object");
    refused("{}", "\"keys\" must be a list");
    refused("{\"keys\": []}", "at least one");
    refused("{\"kyes\": []}", "\"kyes\"; did you mean \"keys\"?");
    refused("{\"keys\": [3]}", "keys[0] must be an object");
    refused(key(", \"fow\": 3"), "keys[0] has an unknown member \"fow\"; did you mean \"fov\"?");
    refused(key(", \"fov\": \"wide\""), "keys[0].fov must be a number");
    refused(key(", \"fov\": 180"), "keys[0].fov must be a number from 0.01 to 179.9, not 180");
    refused(key(", \"fov\": 1e999"), "number overflow");
    refused(key(", \"up\": [0, 0, 0]"), "keys[0].up must not be the zero vector");
    refused(key(", \"up\": [0, 1]"), "keys[0].up must be three finite numbers");
    refused(key(", \"up\": [0, 1e300, 0]"), "keys[0].up must be three finite numbers");
    refused(key(", \"time\": 1"), "either a \"frame\" or a \"time\"");
    refused(R"({"keys": [{"eye": [1, 2, 3], "target": [0, 0, 0]}]})", "either a \"frame\"");
    refused(R"({"keys": [{"frame": 0, "eye": [1, 2, 3]}]})", "keys[0] needs \"target\"");
    refused(R"({"keys": [{"frame": 0, "eye": [1, 2, 3], "target": [1, 2, 3]}]})", "two different");
    refused(R"({"keys": [{"frame": -1, "eye": [1, 2, 3], "target": [0, 0, 0]}]})",
            "keys[0].frame must be a number from 0");
    refused("{\"keys\": [" + good + ", " + good + "]}", "keys[1] must come later");
    refused("{\"fps\": 0, \"keys\": [" + good + "]}", "fps must be a number");
    refused(R"({"keys": [{"frame": 0.5, "eye": [1, 2, 3], "target": [0, 0, 0]}]})",
            "no whole frame");
    expect_refused("draw --scene clevis -o " + path("x%d.png") + " --camera-path " +
                       path("none.json"),
                   1, "none.json");
    expect_refused("draw --scene clevis --turntable 4 -o " + path("x%d.png") + " --camera-path " +
                       path("p.json"),
                   2, "--turntable and --camera-path exclude each other");
}

} // namespace
} // namespace lineatlas::test
