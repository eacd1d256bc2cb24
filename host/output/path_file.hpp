#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Types of files that hold a drawing as paths.
enum class PathFile { svg, json, dxf, pdf };

/// The type of a path, by its extension; nothing for other extensions.
std::optional<PathFile> path_file_type(const std::filesystem::path& path);

inline bool is_path_file(const std::filesystem::path& path) {
    return path_file_type(path).has_value();
}

/// How a drawing is written, whatever its type: DXF and PDF take page, margin, arcs, background and
/// title from `svg`.
struct PathFileOptions {
    SvgOptions svg;
    JsonOptions json;
    std::string description, certificate;
};

/// The content of the file. Throws UsageError and FileError.
std::string path_file_text(PathFile type, const VectorDrawing& drawing,
                           const PathFileOptions& options);

/// Whether `path` holds a whole file of this type.
bool is_whole_path_file(PathFile type, const std::filesystem::path& path);

} // namespace lineatlas
