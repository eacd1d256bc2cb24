// Wrong mesh files of every type, made here and read as by the tool. Each gives a sound mesh with
// lines, or is refused in one line that names the error. None reaches a limit or ends its reader.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "mesh_files.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

class HostileMeshes : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_hostile_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override {
        fs::remove_all(folder_);
        std::cout << drawn_ << " meshes, " << refused_ << " refused\n";
        EXPECT_GT(drawn_ + refused_, 0);
    }

    /// The mesh, or nothing if it was refused.
    std::optional<LoadedMesh> load(const MeshType& type, std::string_view bytes) {
        const fs::path path = folder_ / (type.name + type.extension);
        std::ofstream{path, std::ios::binary} << bytes;
        try {
            LoadedMesh loaded = load_mesh_isolated(path);
            EXPECT_FALSE(extract_lines(loaded.mesh).segments.empty());
            ++drawn_;
            return loaded;
        } catch (const FileError& error) {
            expect_good(error.what(), path);
            ++refused_;
            return std::nullopt;
        }
    }

    static void expect_good(const std::string& message, const fs::path& path) {
        EXPECT_EQ(message.find("cannot read \"" + path.string() + "\": "), 0U) << message;
        EXPECT_EQ(message.find('\n'), message.npos) << message;
        for (const char* of_the_process : {"its reader", "LoadOptions::read_"})
            EXPECT_EQ(message.find(of_the_process), message.npos) << message;
    }

    fs::path folder_;
    int drawn_ = 0, refused_ = 0;
};

TEST_F(HostileMeshes, SoundOnesAreRead) {
    for (const MeshType& type : mesh_types()) {
        const auto loaded = load(type, type.write(block_on_cube(), {}));
        ASSERT_TRUE(loaded) << type.name;
        EXPECT_EQ(loaded->mesh.triangles.size(), 24U) << type.name;
        EXPECT_TRUE(loaded->notes.empty()) << type.name << ": " << loaded->notes.front();
    }
}

TEST_F(HostileMeshes, CutAnywhere) {
    for (const MeshType& type : mesh_types()) {
        const std::string whole = type.write(block_on_cube(), {});
        const std::size_t step = 1 + whole.size() / 50;
        for (std::size_t size = 0; size < whole.size(); size += step) {
            const auto loaded = load(type, std::string_view{whole}.substr(0, size));
            // Lines of OBJ are independent. If a file is cut between two lines, nothing tells that
            // there were more.
            EXPECT_TRUE(!loaded || type.name == "obj") << type.name << " cut at " << size;
        }
    }
}

TEST_F(HostileMeshes, CountsThatAreWrong) {
    for (const MeshType& type : mesh_types()) {
        if (!type.counts) continue;
        const bool counts_vertices = type.name != "stl_binary";
        for (const char* count : {"-1", "0", "1", "1000", "2147483647", "2147483648", "4294967295",
                                  "4000000000", "99999999999999999999", "1e9", "x"}) {
            const auto faces = load(type, type.write(block_on_cube(), {.faces = count}));
            // With a count of 1 the file only has bytes after its end, so it is not broken.
            EXPECT_TRUE(!faces || std::string_view{count} == "1" ||
                        std::string_view{count} == "1e9")
                << type.name << ": faces " << count;
            if (!counts_vertices) continue;
            const auto vertices = load(type, type.write(block_on_cube(), {.vertices = count}));
            EXPECT_FALSE(vertices) << type.name << ": vertices " << count;
        }
    }
}

TEST_F(HostileMeshes, IndicesThatAreWrong) {
    for (const MeshType& type : mesh_types()) {
        if (type.extension == ".stl") continue;
        for (const char* index : {"17", "-17", "2147483647", "4294967295", "-2147483648"})
            EXPECT_FALSE(load(type, type.write(block_on_cube(), {.index = index})))
                << type.name << ": " << index;
        if (type.binary) continue;
        for (const char* index : {"99999999999999999999", "x", "1e3", "nan"})
            EXPECT_FALSE(load(type, type.write(block_on_cube(), {.index = index})))
                << type.name << ": " << index;
    }
}

TEST_F(HostileMeshes, CoordinatesThatAreWrong) {
    for (const MeshType& type : mesh_types()) {
        for (const char* coordinate : {"nan", "inf", "-inf", "1e38", "-3e38"}) {
            const auto loaded = load(type, type.write(block_on_cube(), {.coordinate = coordinate}));
            ASSERT_TRUE(loaded) << type.name << ": " << coordinate;
            EXPECT_EQ(loaded->notes.size(), 1U) << type.name << ": " << coordinate;
            EXPECT_LT(loaded->mesh.triangles.size(), 24U);
        }
        if (type.binary) continue;
        for (const char* coordinate : {"x", "1e", "--1", "0x10", "1,5"})
            EXPECT_FALSE(load(type, type.write(block_on_cube(), {.coordinate = coordinate})))
                << type.name << ": " << coordinate;
    }
}

TEST_F(HostileMeshes, ExtentsThatAreWrong) {
    for (const MeshType& type : mesh_types()) {
        for (const double scale : {1e38, 1e30, 1e16, 1e-25, 1e-38, 0.0})
            EXPECT_FALSE(load(type, type.write(block_on_cube().moved(scale, {0, 0, 0}), {})))
                << type.name << ": " << scale;
        for (const double scale : {1e14, 1e-18})
            EXPECT_TRUE(load(type, type.write(block_on_cube().moved(scale, {0, 0, 0}), {})))
                << type.name << ": " << scale;
    }
}

TEST_F(HostileMeshes, FarFromZero) {
    const Model model = block_on_cube();
    for (const MeshType& type : mesh_types()) {
        const Model far = model.moved(0.01, {1e7, -2e7, 5e6});
        const auto loaded = load(type, type.write(far, {}));
        ASSERT_EQ(loaded.has_value(), type.exact) << type.name << ": floats are all one there";
        if (!loaded) continue;
        EXPECT_EQ(loaded->origin, glm::dvec3(1e7, -2e7, 5e6)) << type.name;
        ASSERT_EQ(loaded->mesh.positions.size(), model.points.size()) << type.name;
        if (type.extension == ".stl") continue; // STL has another order
        for (std::size_t i = 0; i < model.points.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(loaded->mesh.positions[i][axis],
                            0.01 * model.points[i][static_cast<std::size_t>(axis)], 4e-9);
    }
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
