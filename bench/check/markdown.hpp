#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// Writes the report as Markdown tables for people. The report may be unfinished.
void write_markdown(const std::filesystem::path& path, const nlohmann::ordered_json& report);

} // namespace lineatlas::bench
