#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/soup.hpp"

namespace lineatlas::models {

/// A file that a model names, read whole before the model is parsed.
struct NamedFile {
    std::string name; ///< as the model writes it
    std::string bytes;
};

/// The model that a module has to read.
struct Request {
    std::string_view extension;       ///< of the model's file: lower case, with its dot
    std::string_view bytes;           ///< the whole file
    std::span<const NamedFile> named; ///< the files that it names, as far as they may be read
    /// How far a chord may be off a curved face, in the model's units; 0: a quarter of a pixel.
    double deflection = 0;
    double pixels = 1; ///< length of the model's diagonal in the drawing
};

/// The functions of a module for a family of models. Each module links large libraries, which users
/// who never read such a model need not install. A module opens nothing, because it runs confined
/// (io/confinement.hpp). It refuses a model by a std::runtime_error that says the cause in one
/// line.
struct Module {
    /// Called before the process is confined, for libraries that read files when they start.
    void (*prepare)();
    Soup (*read)(const Request& request);
};

// The one symbol of each module. Its number changes with `Module` and the types that it names.
inline constexpr const char* gltf_symbol = "lineatlas_gltf_2";
inline constexpr const char* brep_symbol = "lineatlas_brep_2";
inline constexpr const char* threemf_symbol = "lineatlas_3mf_2";

} // namespace lineatlas::models

extern "C" const lineatlas::models::Module lineatlas_gltf_2;
extern "C" const lineatlas::models::Module lineatlas_brep_2;
extern "C" const lineatlas::models::Module lineatlas_3mf_2;
