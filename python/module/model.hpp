#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "arguments.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::python {

/// The mesh behind Python's Mesh. It never changes, so arrays may refer to it and renderers share
/// it.
struct Model {
    Mesh mesh;
    std::vector<std::string> notes{}; ///< repairs made while reading
    std::array<double, 3> origin{};   ///< LoadedMesh::origin
    std::vector<ModelPart> parts{};   ///< LoadedMesh::parts
};

/// A mesh, or the path of its file.
using ModelOrPath = std::variant<std::shared_ptr<Model>, std::filesystem::path>;

using ModelArgument = Argument<ModelOrPath, "model", "a Mesh or the path of a file">;

/// Mesh.exploded().
void bind_explode(py::class_<Model, std::shared_ptr<Model>>& mesh);
/// Mesh.cut().
void bind_section(py::class_<Model, std::shared_ptr<Model>>& mesh);

std::shared_ptr<const Model> model_of(const ModelOrPath& given);

} // namespace lineatlas::python
