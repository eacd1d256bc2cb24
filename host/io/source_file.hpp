#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/printable.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

/// One whole file in memory. Every mesh format is checked here before a library parses it.
struct SourceFile {
    std::string path;
    std::string bytes;
};

/// The size of a file that must exist, be a regular one, be readable and not be empty. Throws
/// FileError.
std::uintmax_t check_source(const std::string& path);

/// Reads what check_source() accepts. Throws FileError.
SourceFile read_source(const std::string& path);

/// The text without the three bytes that some programs put before UTF-8.
std::string_view without_utf8_mark(std::string_view text);

/// Throws FileError if the first bytes are those of a file that is no mesh, or of a mesh of another
/// type than `extension` (lower case, with its dot).
void refuse_other_types(const SourceFile& source, std::string_view extension);

/// `path` in double quotes, fit for a one-line message; of a long one the end.
std::string quoted(const std::string& path);

/// `cannot read "path": cause`
FileError read_error(const std::string& path, std::string_view cause);

/// `cannot write "path": cause`
FileError write_error(const std::string& path, std::string_view cause);
/// The message of a failed write(). If a limit of file sizes was the cause, it names the limit and
/// the way out.
std::string write_cause(int error);

/// "1 face", "12 faces"
std::string counted(std::size_t count, std::string_view singular, std::string_view plural);

} // namespace lineatlas
