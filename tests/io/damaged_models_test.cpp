// Damaged STEP, IGES and BREP files in a program that only calls load_mesh(), like Python and
// programs that embed the library. A crash must not end this program.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "io/reader_protocol.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> sound_models() {
    const fs::path inputs = fs::path(LINEATLAS_SOURCE_DIR) / "tests/fuzz/inputs";
    return {inputs / "step/pin.step", inputs / "iges/pin.iges", inputs / "iges/solid.iges",
            inputs / "brep/pin.brep"};
}

/// `text` without its line number `left_out`.
std::string without_line(std::string_view text, std::size_t left_out) {
    std::string rest;
    for (std::size_t at = 0, line = 0; at < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        if (line != left_out) rest += text.substr(at, end - at);
        at = end;
    }
    return rest;
}

class DamagedModels : public testing::Test {
  protected:
    /// The message of load_mesh(); empty if it reads the file.
    std::string message(const fs::path& path, const LoadOptions& options = {}) const {
        try {
            load_mesh(path, options);
            return {};
        } catch (const FileError& error) {
            return error.what();
        }
    }

    TemporaryFolder folder_;
};

TEST_F(DamagedModels, TheyAreReadOrRefusedInOneLine) {
    constexpr std::size_t tries = 12; // tries of each format
    std::size_t crashes = 0;
    for (const fs::path& sound : sound_models()) {
        EXPECT_EQ(message(sound), "");
        const std::string text = content_of(sound);
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
        const fs::path path = folder_.path() / ("damaged" + sound.extension().string());
        for (std::size_t i = 0; i < tries; ++i) {
            std::ofstream(path, std::ios::binary) << without_line(text, lines * i / tries);
            const std::string said = message(path);
            if (said.empty()) continue;
            EXPECT_EQ(said.find('\n'), said.npos) << said;
            EXPECT_EQ(said.find("cannot read \"" + path.string() + "\": "), 0U) << said;
            if (said.find("its reader crashed") != said.npos) ++crashes;
        }
    }
    // Without a crash this test shows nothing. Open CASCADE 7.6 crashes on several files. A
    // sanitizer handles crashes itself.
    EXPECT_TRUE(crashes > 0 || reader::sanitized);
}

TEST_F(DamagedModels, OptionsLimitTimeAndMemory) {
    const fs::path pin = sound_models().front();
    EXPECT_NE(message(pin, {.read_seconds = 0.001}).find("LoadOptions::read_seconds allows more"),
              std::string::npos);
    // With ever less memory the result is the whole model or a message of one line, never a part of
    // the model. Open CASCADE itself goes on without faces that it had no memory for.
    const std::size_t whole = load_mesh(pin).mesh.triangles.size();
    for (const double memory : {1e-6, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 7e-3, 8e-3, 0.1}) {
        const std::string said = message(pin, {.read_memory = memory});
        if (said.empty())
            EXPECT_EQ(load_mesh(pin, {.read_memory = memory}).mesh.triangles.size(), whole)
                << memory;
        else
            EXPECT_NE(said.find("LoadOptions::read_memory allows more"), said.npos) << said;
        EXPECT_TRUE(said.empty() || memory < 0.1) << said;
    }
    EXPECT_THROW(load_mesh(pin, {.read_seconds = -1}), UsageError);
    EXPECT_THROW(load_mesh(pin, {.read_memory = std::numeric_limits<double>::quiet_NaN()}),
                 UsageError);
}

TEST_F(DamagedModels, WithoutTheProgramThatReadsALineSaysSo) {
    const fs::path module = fs::path(LINEATLAS_READER).parent_path() / "lineatlas-brep.so";
    fs::create_symlink(module, folder_.path() / module.filename());
    ::setenv("LINEATLAS_MODULE_DIR", folder_.path().c_str(), 1);
    const std::string said = message(sound_models().front());
    ::unsetenv("LINEATLAS_MODULE_DIR");
    EXPECT_EQ(said.find("cannot run \"" + (folder_.path() / "lineatlas-reader").string() + "\""),
              0U)
        << said;
    EXPECT_NE(said.find("install the package lineatlas-brep anew"), std::string::npos) << said;
}

} // namespace
} // namespace lineatlas::test
