#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "command_line/child_process.hpp"
#include "parts.hpp"

namespace lineatlas::bench {

/// How a part ended, and what it has written to `file`.
nlohmann::ordered_json describe_part(const Part& part, const ChildResult& result,
                                     const std::filesystem::path& file);

/// In a word or a few: "ok", "failed with 1", "crashed (...)", "not done in 60 s".
std::string outcome(const Part& part, const ChildResult& result);

void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& report);

} // namespace lineatlas::bench
