// Runs the tool like a user, with bad input. The result must be one clear line that names the
// cause, exit code 1 or 2, and no new file.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "lineatlas/io.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

TEST_F(Tool, DrawsAScene) {
    const auto expect_stages = [&](const std::string& options,
                                   std::initializer_list<const char*> stages) {
        const Result result = run("draw --scene clevis --size 200x150 -o " + path("clevis.png") +
                                  " --stats" + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        EXPECT_GT(fs::file_size(path("clevis.png")), 500U);
        for (const char* word : {"triangles", "segments", "samples", "visible runs",
                                 "bytes per segment", "project_clip", "scan", "strokes"}) {
            EXPECT_NE(result.output.find(word), std::string::npos) << word;
        }
        for (const char* word : stages) {
            EXPECT_NE(result.output.find(word), std::string::npos) << word << result.output;
        }
    };
    expect_stages("", {"surfaces", "tile_lists", "visible "});
    for (const char* options : {" --method atlas", " --probes 4", " --step 3"})
        expect_stages(options, {"depth", "atlas", "compact"});
}

/// Names from files reach a terminal as letters only, and are no longer than a line.
TEST_F(Tool, NamesCannotControlTheTerminal) {
    const std::string hostile = "\x1b]0;title\x07\x1b[2Jred\x7f\xc2\x9b\xff";
    const std::string cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    write("names.obj", "mtllib " + hostile + ".mtl\n" + cube + "o " + hostile + "\nusemtl " +
                           hostile + "\nf 1 3 2\nf 1 2 4\no " + std::string(3'000'000, 'N') +
                           "\nf 2 3 4\nf 1 4 3\n");
    const auto toml_text = [](const std::string& text) { return "\"" + text + "\""; };
    const std::string escaped = "\\u001b[31m\\u0007\\u009b";
    write("key.toml", "session = 1\nmodel = \"names.obj\"\n" + toml_text(escaped) + " = 1\n");
    write("scene.toml", "session = 1\nscene = " + toml_text(escaped) + "\n");
    write("style.toml", "[pen]\n" + toml_text(escaped) + " = 1\n");
    const std::string model = path("names.obj"), picture = " -o " + path("a.svg");
    for (const std::string& arguments :
         {"info " + model, "info --json " + model, "draw " + model + picture,
          "draw " + model + picture + " --stats", "draw " + model + " --only none" + picture,
          "draw " + path("key.toml") + picture, "draw " + path("scene.toml") + picture,
          "draw " + model + " --style " + path("style.toml") + picture,
          "draw '" + path(hostile) + ".obj'" + picture}) {
        const std::string output = run(arguments).output;
        EXPECT_FALSE(output.empty() && arguments.starts_with("info"));
        for (const unsigned char c : output)
            ASSERT_TRUE(c == '\n' || c == '\t' || (c >= ' ' && c != 0x7F)) << arguments;
        EXPECT_EQ(output.find("\xc2\x9b"), output.npos) << arguments;
        EXPECT_EQ(output.find('\xff'), output.npos) << arguments;
        if (arguments.starts_with("info --json")) continue; // names are whole there
        EXPECT_LT(output.size(), 20'000U) << arguments;
    }
}

TEST_F(Tool, PathsAreTheSameWithGlAndWithout) {
    for (const char* extension : {".svg", ".json"}) {
        const auto draw = [&](const std::string& options) {
            const std::string file = path("drawn" + std::string{extension});
            const Result result =
                run("draw --scene house --hidden --size 300x200 -o " + file + options);
            EXPECT_EQ(result.exit_code, 0) << result.output;
            std::ifstream in{file};
            std::string text, line;
            while (std::getline(in, line)) {
                if (line.find("draw --scene") == std::string::npos) text += line + '\n';
            }
            return text;
        };
        const std::string without = draw("");
        EXPECT_GT(without.size(), 10'000U);
        // Options for measuring and for shared buffers use the renderer of pictures.
        for (const char* options : {" --interop copy", " --stats", " --compute cpp"})
            EXPECT_EQ(draw(options), without) << options;
        EXPECT_NE(draw(" --method atlas"), without);
    }
}

TEST_F(Tool, DrawsAModelWithEveryOption) {
    write("tetrahedron.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
          "l 1 2\n");
    const Result result =
        run("draw " + path("tetrahedron.obj") + " -o " + path("t.png") +
            " --size 120x90 --eye -2,1.5,-3 --target 0.2,0.2,0.2 --up z --fov 50 "
            "--lines crease,boundary,material,silhouette,file,section,hatching --crease 20 "
            "--method atlas "
            "--quality low --probes 4 --depth-scale 3 --step 1 --atlas raster "
            "--strokes compute --width 2.5 --pen pencil "
            "--style ink --set halo=3 --hidden --hidden-width 0.5 --color 0.1,0.2,0.3 "
            "--light -1,2,1 --focus 0.5,0.5 "
            "--compute cpp --interop copy --stats --repeat 2");
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_TRUE(fs::exists(path("t.png")));
}

TEST_F(Tool, SaysHowManyFramesOfEachKindItMeasures) {
    const auto expect_kinds = [&](const std::string& repeat, const std::string& whole,
                                  const std::string& by_stages) {
        const Result result =
            run("draw --scene clevis --size 60x40 -o " + path("a.png") + " --stats" + repeat);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        const auto median_of = [&](const std::string& kind) -> std::string {
            const std::size_t line = result.output.find('\n' + kind);
            if (line == std::string::npos) return "";
            const std::size_t from = result.output.find("median of ", line) + 10;
            return result.output.substr(from, result.output.find(')', from) - from);
        };
        EXPECT_EQ(median_of("whole frames"), whole) << result.output;
        EXPECT_EQ(median_of("by stages"), by_stages) << result.output;
    };
    expect_kinds("", "1", "1");
    expect_kinds(" --repeat 1", "", "1");
    expect_kinds(" --repeat 5", "2", "3");
}

TEST_F(Tool, ListsDevicesAndHelps) {
    const Result devices = run("devices");
    EXPECT_EQ(devices.exit_code, 0);
    for (const char* word :
         {"gl-sharing", "external-memory", "host-pointer", "copy", "forms", "cpp", "* opencl:"}) {
        EXPECT_NE(devices.output.find(word), std::string::npos) << word << "\n" << devices.output;
    }
    const Result help = run("draw --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.output.find("Examples:"), std::string::npos);
}

TEST_F(Tool, TellsItsVersionAndTheStateOfItsParts) {
    const auto state_of = [&](const std::string& part) {
        const Result version = run("--version");
        EXPECT_EQ(version.exit_code, 0);
        EXPECT_TRUE(version.output.starts_with("lineatlas 0.")) << version.output;
        const std::size_t line = version.output.find("  " + part + ' ');
        if (line == std::string::npos) return "no line of " + part;
        const std::size_t state = version.output.find_first_not_of(' ', line + 2 + part.size());
        return version.output.substr(state, version.output.find('\n', state) - state);
    };
    EXPECT_EQ(state_of("lineatlas-png"), "here");
    EXPECT_EQ(state_of("lineatlas-images"), "here");
    ::setenv("LINEATLAS_MODULE_DIR", path("nowhere").c_str(), 1);
    EXPECT_EQ(state_of("lineatlas-png"), "not installed");
    EXPECT_EQ(state_of("lineatlas-images"), "not installed: package lineatlas-images");
    ::unsetenv("LINEATLAS_MODULE_DIR");
}

TEST_F(Tool, DrawsWithoutAnyOpenClDriver) {
    ::setenv("OCL_ICD_VENDORS", "/nonexistent", 1);
    const std::string draw = "draw --scene clevis --size 200x150 -o ";
    const Result picture = run(draw + path("without%d.png") + " --turntable 1");
    EXPECT_EQ(picture.exit_code, 0) << picture.output;
    EXPECT_TRUE(picture.output.starts_with("lineatlas: no OpenCL device was found"))
        << picture.output;
    EXPECT_EQ(std::ranges::count(picture.output, '\n'), 2)
        << "that, and the time" << picture.output;
    for (const char* name : {"without.svg", "without.png"}) {
        const Result one = run(draw + path(name));
        EXPECT_EQ(one.exit_code, 0);
        EXPECT_EQ(one.output, "") << name << " needs none";
    }
    const Result asked = run(draw + path("asked.png") + " --compute cpp");
    EXPECT_EQ(asked.exit_code, 0);
    EXPECT_EQ(asked.output, "") << "it is what was asked for";
    EXPECT_TRUE(read_image(path("asked.png")).pixels == read_image(path("without.png")).pixels);
    for (const std::string option : {"--compute opencl", "--device opencl:pocl"}) {
        expect_refused(draw + path("x.png") + " " + option, 1,
                       "no OpenCL device was found (on Debian and Ubuntu: apt install "
                       "pocl-opencl-icd); --compute cpp does without");
    }
    ::unsetenv("OCL_ICD_VENDORS");
}

TEST_F(Tool, ListsAndPrintsStyles) {
    const Result list = run("styles");
    EXPECT_EQ(list.exit_code, 0) << list.output;
    for (const char* name :
         {"technical", "ink", "pencil", "charcoal", "blueprint", "haloed", "Pencil sketch"}) {
        EXPECT_NE(list.output.find(name), std::string::npos) << name << "\n" << list.output;
    }
    const Result style = run("styles blueprint");
    EXPECT_EQ(style.exit_code, 0) << style.output;
    for (const char* line : {"description = \"Blueprint", "\npaper = \"#1d4785\"",
                             "\nhidden = true", "\nmitre-limit = 4", "\nfocus = \"none\""}) {
        EXPECT_NE(style.output.find(line), std::string::npos) << line << "\n" << style.output;
    }
    const Result keys = run("styles --keys");
    EXPECT_EQ(keys.exit_code, 0);
    EXPECT_NE(keys.output.find("| `focus-pen` |"), std::string::npos) << keys.output;

    // The printed text is a style.
    write("mine.toml", style.output);
    const Result again = run("styles " + path("mine.toml"));
    EXPECT_EQ(again.output.substr(again.output.find("\n\n")),
              style.output.substr(style.output.find("\n\n")));
    expect_refused("styles pencl", 2, "\"pencil\"?");
    expect_refused("styles " + path("missing.toml"), 1, "missing.toml");
}

TEST_F(Tool, WritesThePensAsPictures) {
    const Result result = run("styles --write-pens " + folder_.string());
    EXPECT_EQ(result.exit_code, 0) << result.output;
    for (const char* pen : {"solid", "fine", "pencil", "charcoal", "brush", "dashed", "dotted"}) {
        EXPECT_TRUE(fs::exists(path(std::string{pen} + ".png"))) << pen;
    }
    expect_refused("styles --write-pens " + path("no/such/folder"), 1, "solid.png");
}

TEST_F(Tool, DrawsWithAStyle) {
    write("thick.toml", "include = \"blueprint\"\nwidth = 9\n");
    const std::string scene = "draw --scene clevis --size 200x150 -o ";
    const auto draws = [&](const std::string& name, const std::string& options) {
        const Result result = run(scene + path(name) + " " + options);
        EXPECT_EQ(result.exit_code, 0) << options << "\n" << result.output;
        return read_image(path(name)).pixels;
    };
    const auto plain = draws("plain.png", "");
    const auto blueprint = draws("blueprint.png", "--style blueprint");
    EXPECT_FALSE(plain == blueprint);
    const auto thick = draws("thick.png", "--style " + path("thick.toml"));
    EXPECT_FALSE(blueprint == thick);
    EXPECT_TRUE(thick == draws("set.png", "--style blueprint --set width=9"));
    // The file comes first, then --set in order, then other options.
    EXPECT_TRUE(thick ==
                draws("option.png", "--width 9 --set width=3 --set width=4 --style blueprint"));
    EXPECT_TRUE(thick == draws("last.png", "--style blueprint --set width=4 --set width=9"));
}

TEST_F(Tool, RefusesBadModels) {
    const std::string out = " -o " + path("x.png");
    expect_refused("draw " + path("missing.obj") + out, 1, "missing.obj");
    write("empty.obj", "");
    expect_refused("draw " + path("empty.obj") + out, 1, "empty.obj");
    write("truncated.stl", std::string(84, '\0') + "x");
    expect_refused("draw " + path("truncated.stl") + out, 1, "truncated.stl");
    write("picture.obj", "\x89PNG\r\n\x1a\n" + std::string(100, 'x'));
    expect_refused("draw " + path("picture.obj") + out, 1, "picture.obj");
    write("model.xyz", "1 2 3\n");
    expect_refused("draw " + path("model.xyz") + out, 1, "model.xyz");
    expect_refused("draw " + folder_.string() + out, 1, folder_.filename().string());
}

TEST_F(Tool, RefusesBadOutputs) {
    expect_refused("draw --scene clevis -o " + path("no/such/folder/x.png"), 1, "x.png");
    expect_refused("draw --scene clevis -o " + path("x.doc"), 1, "x.doc");
    expect_refused("draw --scene clevis -o " + folder_.string(), 1, folder_.filename().string());
    expect_refused("draw --scene clevis", 2, "--output");
    expect_refused("draw --scene clevis -o " + path("x.EPS"), 1,
                   "paths are .svg, .pdf, .dxf or .json");
}

TEST_F(Tool, RefusesBadOptions) {
    const std::string draw = "draw --scene clevis -o " + path("x.png") + " ";
    expect_refused(draw + "--size 0x100", 2, "--size");
    expect_refused(draw + "--size 100", 2, "--size");
    expect_refused(draw + "--size 99999999999x10", 2, "--size");
    expect_refused(draw + "--size 1000000x10", 2, "1000000x10");
    expect_refused(draw + "--eye nan,0,0", 2, "--eye");
    expect_refused(draw + "--eye 1,2", 2, "--eye");
    expect_refused(draw + "--eye 1,1,1 --target 1,1,1", 2, "eye and target");
    expect_refused(draw + "--fov 0", 2, "field of view");
    expect_refused(draw + "--fov 180", 2, "field of view");
    for (const char* angle : {"nan", "inf", "-1", "181", "1e308", "30x"})
        expect_refused(draw + "--crease " + angle, 2, "--crease");
    expect_refused(draw + "--crease sharp", 2, "--crease must be auto or from 0 to 180 degrees");
    for (const char* place : {"nan", "-0.1", "1.1"})
        expect_refused(draw + "--at " + place, 2, "--at");
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    // The framing camera refuses the angle before it is placed.
    for (const char* angle : {"0", "-40", "nan"}) {
        expect_refused("draw " + path("m.obj") + " -o " + path("x.png") + " --fov " + angle, 2,
                       "field of view must lie between 0 and 180");
    }
    expect_refused(draw + "--up 0,0,0", 2, "--up");
    expect_refused(draw + "--pen crayon", 2, "crayon");
    expect_refused(draw + "--lines crease,edges", 2, "edges");
    expect_refused(draw + "--device opencl:nonesuch", 2, "nonesuch");
    expect_refused(draw + "--device vulkan", 2, "vulkan");
    ::unsetenv("RUSTICL_ENABLE");
    expect_refused(draw + "--device opencl:rusticl", 2, "RUSTICL_ENABLE=llvmpipe");
    expect_refused(draw + "--read-memory 1e-320", 2, "--read-memory must be from 0.001");
    expect_refused(draw + "--read-seconds nan", 2, "--read-seconds must be from 0.001");
    for (const char* option : {"--style", "--eye", "--device", "--lines", "--profile"})
        expect_refused(draw + option + " ''", 2, std::string{option} + ": has an empty value");
    expect_refused(draw + "--compute cuda", 2, "cuda");
    expect_refused(draw + "--interop magic", 2, "magic");
    expect_refused(draw + "--interop gl-sharing", 1, "gl-sharing");
    expect_refused(draw + "--atlas sometimes", 2, "sometimes");
    expect_refused(draw + "--quality best", 2, "best");
    expect_refused(draw + "--probes 5", 2, "probes");
    expect_refused(draw + "--depth-scale 9", 2, "depth-scale");
    expect_refused(draw + "--step 0", 2, "step");
    expect_refused(draw + "--step nan", 2, "step");
    expect_refused(draw + "--width 0", 2, "width");
    expect_refused(draw + "--width two", 2, "--width");
    expect_refused(draw + "--repeat 0", 2, "--repeat");
    expect_refused(draw + "--no-such-option", 2, "--no-such-option");
    expect_refused(draw + "--style crayon", 2, "crayon");
    expect_refused(draw + "--style " + path("missing.toml"), 1, "missing.toml");
    expect_refused(draw + "--set width", 2, "key=value");
    expect_refused(draw + "--set widht=2", 2, "\"width\"?");
    expect_refused(draw + "--set halo=-1", 2, "halo");
    expect_refused(draw + "--color blurple", 2, "--color");
    expect_refused(draw + "--cap rond", 2, "\"round\"?");
    expect_refused(draw + "--hidden=perhaps", 2, "--hidden");
    expect_refused(draw + "--pen " + path("missing.png"), 1, "missing.png");
    expect_refused("draw --scene barn -o " + path("x.png"), 2, "barn");
    expect_refused("draw -o " + path("x.png"), 2, "MODEL");
    expect_refused("paint", 2, "paint");
}

TEST_F(Tool, WritesEveryTypeOfPicture) {
    for (const char* name : {"a.jpg", "a.TIF", "a.exr", "a.bmp"}) {
        const Result result = run("draw --scene clevis --size 64x48 -o " + path(name));
        EXPECT_EQ(result.exit_code, 0) << result.output;
        EXPECT_GT(fs::file_size(path(name)), 100U) << name;
    }
}

TEST_F(Tool, DrawsBigPicturesByTiles) {
    const std::string scene = "draw --scene clevis --quality low ";
    const auto draws = [&](const std::string& name, const std::string& options) {
        const Result result = run(scene + "-o " + path(name) + " " + options);
        EXPECT_EQ(result.exit_code, 0) << options << "\n" << result.output;
        return read_image(path(name));
    };
    const Image big = draws("big.png", "--size 20000x60");
    EXPECT_EQ(big.size, glm::ivec2(20000, 60));
    EXPECT_GT(std::ranges::count(big.pixels, std::uint8_t{0}), 1000);
    for (const std::string options : {"", " --transparent", " --bits 16"}) {
        const std::string size = "--size 150x100 --style blueprint --atlas compute" + options;
        const Image tiled = draws("tiled.png", size + " --tile 40");
        const Image whole = draws("whole.png", size);
        ASSERT_EQ(tiled.pixels.size(), whole.pixels.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            if (std::abs(int{tiled.pixels[i]} - int{whole.pixels[i]}) > 1) ++different;
        }
        EXPECT_LE(different, whole.pixels.size() / 10'000) << options;
    }
    expect_refused(scene + "-o " + path("x.png") + " --size 20000x60 --method spine", 2,
                   "use --method atlas");
    expect_refused(scene + "-o " + path("x.png") + " --size 70000x60", 2, "65536");
    expect_refused(scene + "-o " + path("x.png") + " --tile 5", 2, "--tile");
}

TEST_F(Tool, NamesMethodsThatDoNotFindOutlines) {
    const std::string draw = "draw --scene clevis --size 64x48 -o " + path("x.png");
    const auto says = [&](const std::string& options) {
        const Result result = run(draw + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return result.output.find("outlines are drawn as other lines") != std::string::npos;
    };
    for (const char* method : {"spine", "opengl", "item-buffer"}) {
        EXPECT_TRUE(says(std::string{" --method "} + method)) << method;
        EXPECT_FALSE(says(std::string{" --style technical --method "} + method)) << method;
    }
    EXPECT_TRUE(says(" --method atlas --tile 40"));
    EXPECT_FALSE(says(" --method atlas"));
    EXPECT_FALSE(says(" --method exact --tile 40"));
}

TEST_F(Tool, SaysWhichModuleIsMissing) {
    const std::string draw = "draw --scene clevis --size 64x48 -o " + path("x.png");
    ::setenv("LINEATLAS_MODULE_DIR", path("nowhere").c_str(), 1);
    expect_refused(draw, 1, "nowhere/lineatlas-png.so");
    EXPECT_EQ(run("draw --help").exit_code, 0) << "it is needed for pictures alone";
    write("lineatlas-images.so", "no library");
    ::setenv("LINEATLAS_MODULE_DIR", folder_.c_str(), 1);
    const std::string jpeg = "draw --scene clevis --size 64x48 -o " + path("x.jpg");
    expect_refused(jpeg, 1, "lineatlas-images.so\", which reads and writes pictures");
    ::unsetenv("LINEATLAS_MODULE_DIR");
}

TEST_F(Tool, LoadsNothingForPicturesWherePathsAreDrawn) {
    fs::create_symlink(LINEATLAS_LOADING_TRACE, path("lineatlas-png.so"));
    ::setenv("LINEATLAS_MODULE_DIR", folder_.c_str(), 1);
    write("loaded", "");
    const auto is_loaded = [&] {
        return (fs::status(path("loaded")).permissions() & fs::perms::owner_exec) !=
               fs::perms::none;
    };
    const std::string draw = "draw --scene clevis --size 64x48 -o ";
    EXPECT_EQ(run(draw + path("x.svg")).exit_code, 0);
    EXPECT_FALSE(is_loaded());
    run(draw + path("x.png"));
    EXPECT_TRUE(is_loaded());
    ::unsetenv("LINEATLAS_MODULE_DIR");
}

TEST_F(Tool, RefusesBadStyleFiles) {
    const std::string draw = "draw --scene clevis -o " + path("x.png") + " --style ";
    write("bad.toml", "width = 2\ncollor = \"red\"\n");
    expect_refused(draw + path("bad.toml"), 1,
                   "bad.toml\" line 2: there is no setting \"collor\"; "
                   "did you mean \"color\"?");
    write("picture.toml", "\x89PNG\r\n\x1a\n" + std::string(100, 'x'));
    expect_refused(draw + path("picture.toml"), 1, "picture.toml");
    write("noise.png", "no picture");
    write("pen.toml", "pen = \"noise.png\"\n");
    expect_refused(draw + path("pen.toml"), 1, "noise.png");
}

TEST_F(Tool, WritesOverNothingThatItReadsOrWrites) {
    const std::string model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string walk =
        "{\"keys\": [{\"frame\": 0, \"eye\": [3, 3, 3], \"target\": [0, 0, 0]},"
        "{\"frame\": 4, \"eye\": [3, 3, 4], \"target\": [0, 0, 0]}]}";
    write("m.obj", model);
    write("walk.json", walk);
    write("s.toml", "width = 2\n");
    fs::create_symlink("m.obj", path("to_model.svg"));
    fs::create_symlink(path("s.toml"), path("to_style.csv"));
    fs::create_directory(path("sub"));
    ASSERT_EQ(run("styles --write-pens " + path("sub")).exit_code, 0);
    const std::string draw = "draw " + path("m.obj") + " --size 32x24 ";
    expect_refused(draw + "-o " + path("to_model.svg"), 2, "m.obj\", which is read");
    expect_refused(draw + "-o " + path("x.png") + " --style " + path("s.toml") + " --profile " +
                       path("to_style.csv"),
                   2, "s.toml\", which is read");
    expect_refused(draw + "-o " + path("sub/brush.png") + " --pen " + path("sub/brush.png"), 2,
                   "brush.png\", which is read");
    expect_refused(draw + "-o " + path("x.json") + " --profile " + path("sub/../x.json"), 2,
                   "what --output writes");
    expect_refused(draw + "-o " + path("x.png") + " --profile " + path("a.csv") + " --profile " +
                       path("a.csv"),
                   2, "what --profile writes");
    const std::string sequence = draw + "--camera-path " + path("walk.json") + " -o ";
    expect_refused(sequence + path("%d.json") + " --profile " + path("3.json"), 2,
                   "what --profile writes");
    expect_refused(sequence + path("%d.png") + " --profile " + path("walk.json"), 2,
                   "walk.json\", which is read");
    EXPECT_EQ(read(path("m.obj")), model);
    EXPECT_EQ(read(path("walk.json")), walk);
    EXPECT_EQ(run(draw + "-o " + path("y.json") + " --profile " + path("y.csv")).exit_code, 0);
}

TEST_F(Tool, KeepsTheOldPictureWhenItFails) {
    write("old.png", "kept");
    const Result result = run("draw " + path("missing.obj") + " -o " + path("old.png"));
    EXPECT_EQ(result.exit_code, 1);
    std::ifstream file{path("old.png")};
    std::string content;
    file >> content;
    EXPECT_EQ(content, "kept");
}

} // namespace
} // namespace lineatlas::test
