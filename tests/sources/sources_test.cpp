#include "sources/kernel_folder.hpp"
#include "sources/sources.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <unistd.h>

#include <gtest/gtest.h>

#include "environment_variable.hpp"
#include "lineatlas/error.hpp"

namespace fs = std::filesystem;

namespace lineatlas {
namespace {

std::size_t occurrences(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

/// Unsets both variables and makes a folder that they may name.
class Sources : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_sources_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    void use_folder() const { ::setenv("LINEATLAS_KERNEL_DIR", folder_.c_str(), 1); }
    void file(const std::string& name, std::string_view text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }

    fs::path folder_;
    test::EnvironmentVariable kernels_{"LINEATLAS_KERNEL_DIR", std::nullopt};
    test::EnvironmentVariable shaders_{"LINEATLAS_SHADER_DIR", std::nullopt};
};

TEST_F(Sources, EveryEmbeddedFileResolves) {
    EXPECT_GE(embedded_kernels().size(), 6U);
    EXPECT_GE(embedded_shaders().size(), 8U);
    for (const EmbeddedSource& source : embedded_kernels()) {
        const std::string text = kernel_source(source.name);
        EXPECT_FALSE(text.empty()) << source.name;
        EXPECT_EQ(text.find("\n#include \""), std::string::npos) << source.name;
    }
    for (const EmbeddedSource& source : embedded_shaders()) {
        const std::string text = shader_source(source.name);
        EXPECT_FALSE(text.empty()) << source.name;
        EXPECT_EQ(text.find("\n#include \""), std::string::npos) << source.name;
    }
}

TEST_F(Sources, AFileWithoutIncludesIsUnchanged) {
    const auto flags = std::ranges::find(embedded_kernels(), "flags.h", &EmbeddedSource::name);
    ASSERT_NE(flags, embedded_kernels().end());
    EXPECT_EQ(kernel_source("flags.h"), flags->text);
    EXPECT_NE(flags->text.find("#define LA_KIND_CREASE 0u"), std::string_view::npos);
}

TEST_F(Sources, IncludesArePastedIn) {
    const std::string text = kernel_source("project_clip.cl");
    EXPECT_EQ(occurrences(text, "typedef struct Segment {"), 1U);
    EXPECT_LT(text.find("typedef struct Segment {"), text.find("KERNEL(project_clip,"));
}

TEST_F(Sources, AnUnknownNameIsRefused) {
    for (const std::string_view name : {"nothing.cl", "", "facing", "strokes.vert"}) {
        EXPECT_THROW(kernel_source(name), FileError) << name;
    }
    EXPECT_THROW(shader_source("facing.cl"), FileError);
}

TEST_F(Sources, AFolderTakesThePlaceOfTheBuiltInFiles) {
    file("facing.cl", "first\n#include \"part.h\"\nlast"); // no line end at the end
    file("part.h", "part\n");
    use_folder();
    EXPECT_EQ(kernel_source("facing.cl"), "first\n"
                                          "#line 1 \"part.h\"\n"
                                          "part\n"
                                          "#line 3 \"facing.cl\"\n"
                                          "last\n");
    EXPECT_THROW(kernel_source("project_clip.cl"), FileError) << "mixed with built-in files";
    EXPECT_NO_THROW(shader_source("strokes.vert")) << "shaders have their own variable";
    ::unsetenv("LINEATLAS_KERNEL_DIR");
    EXPECT_NE(kernel_source("facing.cl").find("KERNEL(facing"), std::string::npos);
}

TEST_F(Sources, FilesWrittenInTheFolderAreSeenWhenTheyRest) {
    file("facing.cl", "first\n");
    EXPECT_FALSE(KernelFolder{}.is_set());
    use_folder();
    KernelFolder folder;
    EXPECT_FALSE(folder.has_changed());
    file("part.h", "part\n");
    EXPECT_FALSE(folder.has_changed()) << "it may still be written";
    EXPECT_TRUE(folder.has_changed());
    EXPECT_FALSE(folder.has_changed());
    std::filesystem::remove(folder.path() / "part.h");
    EXPECT_FALSE(folder.has_changed());
    EXPECT_TRUE(folder.has_changed());
}

TEST_F(Sources, ShadersAreReadFromTheirOwnFolder) {
    file("strokes.vert", "#version 450\n");
    ::setenv("LINEATLAS_SHADER_DIR", folder_.c_str(), 1);
    EXPECT_EQ(shader_source("strokes.vert"), "#version 450\n");
    EXPECT_NE(kernel_source("facing.cl").find("KERNEL(facing"), std::string::npos);
}

TEST_F(Sources, AFileIsPastedOnce) {
    file("a.cl", "#include \"b.h\"\n#include \"c.h\"\n#include \"b.h\"\na\n");
    file("b.h", "#include \"c.h\"\nb\n");
    file("c.h", "#include \"a.cl\"\n#include \"c.h\"\nc\n"); // the file includes itself
    use_folder();
    std::string text = kernel_source("a.cl");
    for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#')) {
        text.erase(at, text.find('\n', at) + 1 - at); // the line that names its file
    }
    EXPECT_EQ(text, "c\nb\na\n");
}

TEST_F(Sources, OnlyTheDirectiveIsReplaced) {
    const std::string text = "// #include \"part.h\"\n#include <cstddef>\n#define x \"part.h\"\n";
    file("a.cl", text);
    use_folder();
    EXPECT_EQ(kernel_source("a.cl"), text);
}

TEST_F(Sources, AMissingFileIsNamedWithTheVariable) {
    file("a.cl", "#include \"gone.h\"\n");
    use_folder();
    try {
        kernel_source("a.cl");
        ADD_FAILURE() << "a missing include was taken";
    } catch (const FileError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("gone.h"), std::string::npos) << message;
        EXPECT_NE(message.find("LINEATLAS_KERNEL_DIR"), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST_F(Sources, AnEmptyFileIsEmptyAndAFolderIsNoFile) {
    file("empty.cl", "");
    fs::create_directories(folder_ / "folder.cl");
    use_folder();
    EXPECT_EQ(kernel_source("empty.cl"), "");
    EXPECT_THROW(kernel_source("folder.cl"), FileError);
}

TEST_F(Sources, AVariableIsGivenBackAsItWasFound) {
    const char* name = "LINEATLAS_KERNEL_DIR";
    use_folder();
    {
        const test::EnvironmentVariable other{name, "/elsewhere"};
        EXPECT_STREQ(std::getenv(name), "/elsewhere");
        const test::EnvironmentVariable none{name, std::nullopt};
        EXPECT_EQ(std::getenv(name), nullptr);
    }
    EXPECT_EQ(std::getenv(name), folder_.string());
    ::unsetenv(name);
    { const test::EnvironmentVariable other{name, "/elsewhere"}; }
    EXPECT_EQ(std::getenv(name), nullptr);
}

} // namespace
} // namespace lineatlas
