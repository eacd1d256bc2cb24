#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lineatlas {

/// A kernel, shader or style file, embedded at build time.
struct EmbeddedSource {
    std::string_view name; ///< of the file in its folder, as "shared/run.h" in kernels/
    std::string_view text;
};

const std::vector<EmbeddedSource>& embedded_kernels(); ///< kernels/
const std::vector<EmbeddedSource>& embedded_shaders(); ///< shaders/
const std::vector<EmbeddedSource>& embedded_styles();  ///< styles/

/// The text of a kernel or shader file, with lines `#include "name"` replaced by the files that
/// they name (each once). In kernels, line_directive()s stand around included text; GLSL has none
/// that name a file. Read from the folder in LINEATLAS_KERNEL_DIR or LINEATLAS_SHADER_DIR if that
/// is set, so that sources can be edited and profiled without a build. Headers (`.h`) that shaders
/// include are those of kernels. Throws FileError if there is no such file.
std::string kernel_source(std::string_view name);
std::string shader_source(std::string_view name);

/// A directive that tells C compilers that the next line is line `line` of `file`.
std::string line_directive(std::size_t line, std::string_view file);

} // namespace lineatlas
