#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/up_axis.hpp"

namespace lineatlas {

/// The reader of a type of model files: this library, or a module of it.
enum class ModelReader { obj, ply, stl, off, om, gltf, threemf, brep };

struct ModelType {
    std::string_view extension; ///< lower case, with its dot
    std::string_view name;      ///< in lists for people; several extensions may have one name
    ModelReader reader;
    UsualUp up = UsualUp::y; ///< the direction that is up in most models of the type
};

/// All types of models that are read. In types for machines z is up, as on a table.
inline constexpr std::array model_types{
    ModelType{".obj", "OBJ", ModelReader::obj},
    ModelType{".ply", "PLY", ModelReader::ply},
    ModelType{".stl", "STL", ModelReader::stl, UsualUp::z},
    ModelType{".off", "OFF", ModelReader::off},
    ModelType{".om", "OM", ModelReader::om},
    ModelType{".gltf", "glTF", ModelReader::gltf},
    ModelType{".glb", "GLB", ModelReader::gltf},
    ModelType{".3mf", "3MF", ModelReader::threemf},
    ModelType{".step", "STEP", ModelReader::brep, UsualUp::z},
    ModelType{".stp", "STEP", ModelReader::brep, UsualUp::z},
    ModelType{".iges", "IGES", ModelReader::brep, UsualUp::z},
    ModelType{".igs", "IGES", ModelReader::brep, UsualUp::z},
    ModelType{".brep", "BREP", ModelReader::brep, UsualUp::z},
    ModelType{".brp", "BREP", ModelReader::brep, UsualUp::z},
};

/// The type of an extension, or null.
const ModelType* find_model_type(std::string_view extension);

/// ".obj, .ply ... and .brp", for messages.
std::string model_extensions();

/// "OBJ, PLY ... or BREP", for help. `last` stands before the last name.
std::string model_type_names(std::string_view last = " or ");

/// The direction that is up in most models of a file's type.
UsualUp usual_up(const std::filesystem::path& model);

} // namespace lineatlas
