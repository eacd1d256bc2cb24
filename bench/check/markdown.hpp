#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// The report as tables for people, in Markdown, as far as it has come.
void write_markdown(const std::filesystem::path& path, const nlohmann::ordered_json& report);

} // namespace lineatlas::bench
