// The tool on devices that are too small: its pictures and its messages.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lineatlas::test {
namespace {

struct ToolRun {
    int code;
    std::string said, file;
};

/// Runs the tool with limits of the layer as variables. Returns its messages and its drawing.
ToolRun run_tool(const std::string& limits, const std::string& arguments,
                 const std::string& extension = ".png") {
    const std::string picture = std::filesystem::temp_directory_path() /
                                ("lineatlas_limits_" + std::to_string(::getpid()) + extension);
    const std::string command = "OPENCL_LAYERS=" LINEATLAS_FAULT_LAYER " " + limits +
                                " " LINEATLAS_TOOL " draw --compute opencl -o " + picture + " " +
                                arguments + " 2>&1";
    FILE* tool = popen(command.c_str(), "r");
    std::string said;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), tool) != nullptr) said += part.data();
    const int status = pclose(tool);
    std::ostringstream file;
    file << std::ifstream{picture}.rdbuf();
    EXPECT_EQ(std::filesystem::remove(picture), status == 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said, file.str()};
}

TEST(LimitsOfTheTool, AreWorkedAroundByTilesOrNamedInOneLine) {
    for (const char* method : {" --method atlas", ""}) { // whose depth would take 31 MB; exact
        const ToolRun drawn = run_tool("LINEATLAS_TEST_BUFFER=2000000",
                                       std::string{"--scene clevis --size 1600x1200"} + method);
        EXPECT_EQ(drawn.code, 0) << drawn.said;
    }
    const auto [code, said, file] =
        run_tool("LINEATLAS_TEST_BUFFER=10000", "--scene clevis --size 400x300");
    EXPECT_EQ(code, 1);
    EXPECT_NE(said.find("lineatlas: the model's vertices and triangles needs "), said.npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

TEST(LimitsOfTheTool, AreWorkedAroundByChunksOfSegments) {
    for (const std::string extension : {".png", ".svg"}) {
        const std::string house = "--scene house --size 160x120 --method atlas --depth-scale 1";
        const ToolRun whole = run_tool("", house, extension);
        const ToolRun cut = run_tool("LINEATLAS_TEST_BUFFER=300000", house, extension);
        EXPECT_EQ(cut.code, 0) << cut.said;
        EXPECT_EQ(cut.said, whole.said);
        EXPECT_TRUE(cut.file == whole.file) << extension;
    }
}

/// Rings around a post: 40,000 segments, and few triangles.
std::string write_rings() {
    const std::string name = std::filesystem::temp_directory_path() /
                             ("lineatlas_rings_" + std::to_string(::getpid()) + ".obj");
    std::ofstream file{name};
    file << "v -1 -2 0\nv 1 -2 0\nv 1 2 0\nv -1 2 0\nf 1 2 3 4\n";
    constexpr int rings = 200, points = 201;
    for (int ring = 0; ring < rings; ++ring) {
        for (int point = 0; point < points; ++point) {
            const double angle = 0.01 * std::numbers::pi * point;
            file << "v " << 1.6 * std::cos(angle) << ' ' << 0.015 * ring - 1.5 << ' '
                 << 1.6 * std::sin(angle) << '\n';
        }
        file << 'l';
        for (int point = 0; point < points; ++point) file << ' ' << 5 + ring * points + point;
        file << '\n';
    }
    return name;
}

TEST(LimitsOfTheTool, AreWorkedAroundByChunksWithoutGl) {
    const std::string rings = write_rings(), drawing = rings + " --size 400x300";
    const ToolRun whole = run_tool("", drawing, ".svg");
    const ToolRun cut = run_tool("LINEATLAS_TEST_BUFFER=1000000", drawing, ".svg"); // 13 chunks
    EXPECT_EQ(cut.code, 0) << cut.said;
    EXPECT_GT(std::ranges::count(whole.file, '\n'), 200);
    EXPECT_TRUE(cut.file == whole.file);
    std::filesystem::remove(rings);
}

/// The device has no room for 31 MB of depth, in one buffer or in several.
TEST(LimitsOfTheTool, OfMemoryLeadToTilesByThemselves) {
    const std::string exact = "--scene clevis --size 1600x1200", atlas = exact + " --method atlas";
    for (const auto& [bytes, large] :
         {std::pair{"24000000", atlas}, std::pair{"8000000", atlas + " --density 0"}}) {
        const ToolRun tiles = run_tool(std::string{"LINEATLAS_TEST_MEMORY="} + bytes, large);
        EXPECT_EQ(tiles.code, 0);
        const std::string begin = "lineatlas: drawn in tiles of ";
        ASSERT_TRUE(tiles.said.starts_with(begin)) << tiles.said;
        const std::string side =
            tiles.said.substr(begin.size(), tiles.said.find('x', begin.size()) - begin.size());
        EXPECT_NE(tiles.said.find(": in one piece the depth buffer needs 29.3 MiB, and of the "),
                  std::string::npos)
            << tiles.said;
        EXPECT_NE(tiles.said.find("outlines are drawn as other lines"), std::string::npos);
        EXPECT_EQ(std::ranges::count(tiles.said, '\n'), 2) << tiles.said;
        EXPECT_TRUE(tiles.file == run_tool("", large + " --tile " + side).file);
    }
    // Without depth there is room, for paths too. By the atlas, the ends of paths need the depth of
    // the whole picture.
    EXPECT_EQ(run_tool("LINEATLAS_TEST_MEMORY=9000000", exact + " --density 0").said, "");
    EXPECT_EQ(run_tool("LINEATLAS_TEST_MEMORY=9000000", exact, ".svg").said, "");
    const ToolRun path = run_tool("LINEATLAS_TEST_MEMORY=2000000", atlas, ".svg");
    EXPECT_EQ(path.code, 1);
    EXPECT_EQ(std::ranges::count(path.said, '\n'), 1) << path.said;
}

} // namespace
} // namespace lineatlas::test
