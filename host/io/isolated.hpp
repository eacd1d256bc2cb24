#pragma once

#include "lineatlas/io.hpp"
#include "reader_process.hpp"

namespace lineatlas {

// load_mesh() and read_image() by a ReaderProcess, in programs that call serve_as_reader(): the
// tool and the viewer, which open their users' files. Other programs read in their own process,
// except formats whose libraries crash on damaged files. Messages are the same.

/// To be called first in main(), with its arguments: if it returns a code, main() ends with that.
std::optional<int> serve_as_reader(int argc, char** argv);

/// `limits` with its zeros filled in, for a picture of a pen.
ReadLimits limits_for_picture(const ReadLimits& limits);

LoadedMesh load_mesh_isolated(const std::filesystem::path& path, const ReadLimits& limits = {},
                              const LoadOptions& options = {});
/// As load_mesh() here, by another program that calls serve_as_reader().
LoadedMesh load_mesh_by(const std::filesystem::path& program, const std::filesystem::path& path,
                        const ReadLimits& limits, const LoadOptions& options);
Image read_image_isolated(const std::filesystem::path& path, const ReadLimits& limits = {});

} // namespace lineatlas
