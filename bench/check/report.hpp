#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "command_line/child_process.hpp"
#include "parts.hpp"

namespace lineatlas::bench {

/// Describes how a part ended, with what the part wrote to `file`.
nlohmann::ordered_json describe_part(const Part& part, const ChildResult& result,
                                     const std::filesystem::path& file);

/// The outcome in a few words: "ok", "failed with 1", "crashed (...)", "not done in 60 s".
std::string outcome(const Part& part, const ChildResult& result);

void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& report);

} // namespace lineatlas::bench
