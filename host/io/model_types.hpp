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
    ModelReader reader;
    UsualUp up = UsualUp::y; ///< the direction that is up in most models of the type
};

/// All types of models that are read. In types for machines z is up, as on a table.
inline constexpr std::array model_types{
    ModelType{".obj", ModelReader::obj},
    ModelType{".ply", ModelReader::ply},
    ModelType{".stl", ModelReader::stl, UsualUp::z},
    ModelType{".off", ModelReader::off},
    ModelType{".om", ModelReader::om},
    ModelType{".gltf", ModelReader::gltf},
    ModelType{".glb", ModelReader::gltf},
    ModelType{".3mf", ModelReader::threemf},
    ModelType{".step", ModelReader::brep, UsualUp::z},
    ModelType{".stp", ModelReader::brep, UsualUp::z},
    ModelType{".iges", ModelReader::brep, UsualUp::z},
    ModelType{".igs", ModelReader::brep, UsualUp::z},
    ModelType{".brep", ModelReader::brep, UsualUp::z},
    ModelType{".brp", ModelReader::brep, UsualUp::z},
};

/// The type of an extension, or null.
const ModelType* find_model_type(std::string_view extension);

/// ".obj, .ply ... and .brp", for messages.
std::string model_extensions();

/// The direction that is up in most models of a file's type.
UsualUp usual_up(const std::filesystem::path& model);

} // namespace lineatlas
