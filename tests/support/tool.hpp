#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

// Runs the tool as a user does.
namespace lineatlas::test {

namespace fs = std::filesystem;

struct Result {
    int exit_code;
    std::string output; ///< stdout and stderr together
};

/// Runs the tool in a folder of its own.
class Tool : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_tool_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    static Result run(const std::string& arguments) {
        return shell(LINEATLAS_TOOL " " + arguments + " 2>&1");
    }

    /// The output and the exit status of a shell command.
    static Result shell(const std::string& command) {
        FILE* pipe = ::popen(command.c_str(), "r");
        Result result{-1, {}};
        std::array<char, 512> part{};
        while (std::fgets(part.data(), part.size(), pipe) != nullptr) result.output += part.data();
        const int status = ::pclose(pipe);
        if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
        return result;
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream{path(name), std::ios::binary} << text;
    }

    static std::string read(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream{file, std::ios::binary}.rdbuf();
        return text.str();
    }

    /// Expects that the command fails with `code`, prints `words` in at most two lines and leaves
    /// no new file.
    void expect_refused(const std::string& arguments, int code, const std::string& words) {
        const auto files = [&] {
            return std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{});
        };
        const auto before = files();
        const Result result = run(arguments);
        EXPECT_EQ(result.exit_code, code) << arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(words), std::string::npos) << arguments << "\n"
                                                                << result.output;
        EXPECT_LE(std::ranges::count(result.output, '\n'), 2) << result.output;
        EXPECT_EQ(files(), before) << "a file was left behind by: " << arguments;
    }

    fs::path folder_;
};

} // namespace lineatlas::test
