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

// `extension`: of ModelType, in lower case.

/// Whether a module reads such files.
bool is_read_by_module(std::string_view extension);

/// Whether what reads them crashes on damaged ones: then a process of its own must do it.
bool may_crash(std::string_view extension);

/// The program that does so for programs that embed the library; beside the module. For extensions
/// that may_crash(). Throws FileError where it is missing.
std::filesystem::path reader_program(std::string_view extension);

/// Throws FileError, one line that says how to convert, for models that nothing here reads but
/// that are known: FBX, Collada, IFC and others.
void refuse_other_models(const SourceFile& model, std::string_view extension);

/// Loads what read_by_module() will need; that opens nothing. Throws FileError.
void prepare_module(std::string_view extension);

Soup read_by_module(const SourceFile& model, std::string_view extension,
                    const std::vector<models::NamedFile>& named, const LoadOptions& options);

} // namespace lineatlas
