#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/error.hpp"

namespace lineatlas::fuzz {

/// Writes an input to a file of this process, which lies in memory if the system has such a folder.
/// So an input takes the same way as a user's file, including its way from the disk.
std::filesystem::path put_file(std::string_view extension, std::span<const std::uint8_t> bytes);

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
std::vector<unsigned char> read_file(const std::filesystem::path& path);

/// Ends the program with a finding. Not assert(): findings count in every build.
inline void expect(bool condition, std::string_view what) {
    if (condition) return;
    std::cerr << "FINDING: " << what << '\n';
    std::abort();
}

/// Expects that a refusal is one line that names the file.
inline void expect_good_refusal(const Error& error, const std::filesystem::path& path) {
    const std::string message = error.what();
    expect(message.find('\n') == std::string::npos, "a message of several lines: " + message);
    expect(message.find(path.filename().string()) != std::string::npos,
           "a message that does not name the file: " + message);
}

} // namespace lineatlas::fuzz

/// libFuzzer and tests/fuzz/replay_main.cpp call this function. Every exception that leaves it is a
/// finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
