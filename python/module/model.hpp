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

/// A mesh as Python has it: never changed once it is made, so that arrays may show it and renderers
/// share it.
struct Model {
    Mesh mesh;
    std::vector<std::string> notes{}; ///< what was repaired when it was read
    std::array<double, 3> origin{};   ///< LoadedMesh::origin
    std::vector<ModelPart> parts{};   ///< LoadedMesh::parts
};

/// Where a mesh or the name of its file will do.
using ModelOrPath = std::variant<std::shared_ptr<Model>, std::filesystem::path>;

using ModelArgument = Argument<ModelOrPath, "model", "a Mesh or the path of a file">;

/// Mesh.exploded().
void bind_explode(py::class_<Model, std::shared_ptr<Model>>& mesh);
/// Mesh.cut().
void bind_section(py::class_<Model, std::shared_ptr<Model>>& mesh);

std::shared_ptr<const Model> model_of(const ModelOrPath& given);

} // namespace lineatlas::python
