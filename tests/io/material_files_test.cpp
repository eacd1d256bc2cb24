// Which material files of an OBJ file are read.

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "lineatlas/io.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

class MaterialFiles : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(models_ / "below");
        for (const fs::path& folder : {top_.path(), models_, models_ / "below"})
            std::ofstream{folder / "green.mtl"} << "newmtl paint\nKd 0 1 0\n";
    }

    /// Loads a model with these lines before its only triangle, whose material is "paint".
    LoadedMesh load(const std::string& lines) const {
        const fs::path path = models_ / "a.obj";
        std::ofstream{path} << lines << "\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        return load_mesh(path);
    }

    void expect_read(const std::string& name) const {
        const LoadedMesh loaded = load("mtllib " + name);
        EXPECT_TRUE(loaded.notes.empty()) << name << ": " << loaded.notes.front();
        EXPECT_EQ(loaded.mesh.groups.at(0).color, glm::vec3(0, 1, 0)) << name;
    }

    void expect_note(const std::string& name, const std::string& cause) const {
        const LoadedMesh loaded = load("mtllib " + name);
        ASSERT_EQ(loaded.notes.size(), 1U) << name;
        EXPECT_EQ(loaded.notes[0],
                  "material file \"" + name + "\" " + cause + "; its materials have no colour");
        EXPECT_FALSE(loaded.mesh.groups.at(0).color) << name;
    }

    static constexpr const char* outside = "is not beside the model or below its folder";

    TemporaryFolder top_;
    fs::path models_ = top_.path() / "models";
};

TEST_F(MaterialFiles, BesideTheModelOrBelow) {
    expect_read("green.mtl");
    expect_read("./green.mtl");
    expect_read("below/green.mtl");
    expect_read("below/../green.mtl");
    expect_read("../models/green.mtl");
    expect_read((models_ / "green.mtl").string());
    expect_read("missing.mtl green.mtl");
    fs::create_symlink("below/green.mtl", models_ / "link.mtl");
    expect_read("link.mtl");
    EXPECT_TRUE(load("\xEF\xBB\xBFmtllib green.mtl").notes.empty());
    EXPECT_TRUE(
        load("# mtllib gone.mtl\nmtllibrary gone.mtl\n\t mtllib\tgreen.mtl ").notes.empty());
}

TEST_F(MaterialFiles, NothingIsSaidOfWhatIsElsewhere) {
    for (const std::string name : {"green.mtl", "missing.mtl"}) {
        expect_note("../" + name, outside);
        expect_note("below/../../" + name, outside);
        expect_note((top_.path() / name).string(), outside);
        fs::remove(models_ / "link.mtl");
        fs::create_symlink(top_.path() / "green.mtl", models_ / "link.mtl");
        expect_note("link.mtl", outside);
    }
    expect_note("/etc/passwd", outside);
    expect_note("/proc/kmsg", outside);
}

TEST_F(MaterialFiles, ALinkToAFolderElsewhereIsNotFollowed) {
    fs::create_directory_symlink(top_.path(), models_ / "up");
    expect_note("up/green.mtl", outside);
}

TEST_F(MaterialFiles, OnlyRegularFiles) {
    ASSERT_EQ(::mkfifo((models_ / "pipe.mtl").c_str(), 0600), 0);
    expect_note("pipe.mtl", "cannot be read");
    expect_note("below", "cannot be read");
    expect_note("missing.mtl", "cannot be read");
}

TEST_F(MaterialFiles, AFileNamedOftenIsReadOnce) {
    const std::string line = "mtllib missing.mtl\n";
    EXPECT_EQ(load(line + line + line).notes.size(), 1U);
}

} // namespace
} // namespace lineatlas::test
