#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare.hpp"

// What `lineatlas-bench-quality` says: tables for people, JSON for programs.
namespace lineatlas::bench {

/// One measured view.
struct ViewReport {
    std::string name; ///< e.g. "at 0.250"
    KindFigures figures;
};

void print_header();
/// A row for all samples, and one for each kind that has any.
void print_figures(const std::string& name, const KindFigures& figures);
/// The segments that went wrong the most, with what may have caused it.
void print_worst(const Oracle& oracle, const ViewSamples& view, const Camera& camera,
                 std::size_t count);

/// Throws FileError.
void write_json(const std::filesystem::path& path, const std::string& subject,
                const std::vector<ViewReport>& views, const KindFigures& total);

} // namespace lineatlas::bench
