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
    std::string picture{}; ///< that it leaves in Places::pictures; "": none
};

/// Absolute paths.
struct Places {
    std::filesystem::path scratch;  ///< a folder that goes when the check ends
    std::filesystem::path pictures; ///< where pictures for the report go
    std::filesystem::path scan;     ///< the model of write_scan()
};

/// The option that makes the part write its figures as JSON, or its tests' results as XML: the JSON
/// of Google Test does not say why a test was skipped.
std::string output_option(PartKind kind, const std::filesystem::path& file);

/// All parts, what is needed most first: the last ones are left out if time runs out.
std::vector<Part> all_parts(const Places& places);

} // namespace lineatlas::bench
