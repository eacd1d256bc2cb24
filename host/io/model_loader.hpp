#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "io/model_module.hpp"
#include "lineatlas/io.hpp"
#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

// Models that modules read: scenes (glTF, 3MF) and exact surfaces (STEP, IGES, BREP).

// `extension`: as in ModelType, in lower case.

/// Whether a module reads such files.
bool is_read_by_module(std::string_view extension);

/// Whether the library that reads such files crashes on damaged ones. Then a process of its own
/// must read them.
bool may_crash(std::string_view extension);

/// The program that reads such files for programs that embed the library. It stands beside the
/// module. For extensions that may_crash(). Throws FileError if the program is missing.
std::filesystem::path reader_program(std::string_view extension);

/// Throws FileError for types that are known but not read: FBX, Collada, IFC and others. The
/// message is one line that says how to convert the model.
void refuse_other_models(const SourceFile& model, std::string_view extension);

/// Loads the module that read_by_module() needs, which then opens nothing. Throws FileError.
void prepare_module(std::string_view extension);

Soup read_by_module(const SourceFile& model, std::string_view extension,
                    const std::vector<models::NamedFile>& named, const LoadOptions& options);

} // namespace lineatlas
