#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace lineatlas::bench {

/// The result of a part: the answer of `lineatlas devices`, figures of a benchmark, of the kernels
/// of a frame (`draw --kernels`), results of tests, or only the text that the part prints.
enum class PartKind { devices, figures, kernels, tests, output };

/// One program that a check runs.
struct Part {
    std::string name;
    PartKind kind;
    std::string program; ///< path in the bundle's folder
    std::vector<std::string> arguments;
    std::chrono::seconds limit;
    std::string picture{}; ///< that the part writes to Places::pictures; "": none
    /// Pictures that are compared with it, by what they are: "the device's".
    std::vector<std::pair<std::string, std::filesystem::path>> others{};
};

/// Absolute paths that parts use.
struct Places {
    std::filesystem::path scratch;  ///< a folder that is removed when the check ends
    std::filesystem::path pictures; ///< the folder of the report's pictures
    std::filesystem::path shipped;  ///< the folder of the bundle's own pictures
    std::filesystem::path scan;     ///< the model that write_scan() wrote
};

/// The option that makes a part write its figures as JSON, or the results of its tests as XML.
/// GoogleTest's JSON does not say why a test was skipped.
std::string output_option(PartKind kind, const std::filesystem::path& file);

/// All parts, the most important first. If time runs out, the last ones are left out.
std::vector<Part> all_parts(const Places& places);

} // namespace lineatlas::bench
