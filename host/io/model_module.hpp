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

/// What a module reads.
struct Request {
    std::string_view extension;       ///< of the model's file: lower case, with its dot
    std::string_view bytes;           ///< all of it
    std::span<const NamedFile> named; ///< those of the files it names that may be read
    /// How far a chord may be off a curved face, in the model's units; 0: a quarter of a pixel.
    double deflection = 0;
    double pixels = 1; ///< that the model's diagonal is drawn over
};

/// What a module for a family of models offers. Each links libraries that who never reads such a
/// model need not have. It opens nothing, since it runs confined (io/confinement.hpp). Whatever is
/// refused ends in a std::runtime_error that says the cause in one line.
struct Module {
    /// Called before the process is confined: for libraries that look around when they start.
    void (*prepare)();
    Soup (*read)(const Request& request);
};

// The modules' one symbol each. Their numbers change with `Module` and all that it names.
inline constexpr const char* gltf_symbol = "lineatlas_gltf_2";
inline constexpr const char* brep_symbol = "lineatlas_brep_2";
inline constexpr const char* threemf_symbol = "lineatlas_3mf_2";

} // namespace lineatlas::models

extern "C" const lineatlas::models::Module lineatlas_gltf_2;
extern "C" const lineatlas::models::Module lineatlas_brep_2;
extern "C" const lineatlas::models::Module lineatlas_3mf_2;
