#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace lineatlas::bench {

/// What a part leaves: answers of `lineatlas devices`, figures of a benchmark, results of tests, or
/// nothing but what it prints.
enum class PartKind { devices, figures, tests, output };

/// One program that a check runs.
struct Part {
    std::string name;
    PartKind kind;
    std::string program; ///< seen from the bundle
    std::vector<std::string> arguments;
    std::chrono::seconds limit;
};

/// The option that makes the part write its figures as JSON, or its tests' results as XML: the JSON
/// of Google Test does not say why a test was skipped.
std::string output_option(PartKind kind, const std::filesystem::path& file);

/// All parts, what is needed most first: the last ones are left out if time runs out.
std::vector<Part> all_parts(const std::filesystem::path& scratch);

} // namespace lineatlas::bench
