#include "lineatlas/explode.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "model.hpp"
#include "process.hpp"

namespace lineatlas::python {
namespace {

using Moves = std::map<std::string, std::array<double, 3>>;
using MovesArgument =
    Argument<Moves, "moves", "a dictionary of names of parts and three numbers each">;

std::shared_ptr<Model> exploded(const Model& model, Real<"factor"> factor,
                                const MovesArgument& moves, Flag<"trails"> trails) {
    const Released released;
    Explosion explosion{.factor = static_cast<double>(*factor), .trails = trails};
    for (const auto& [part, by] : *moves)
        explosion.moves.push_back({.part = part, .by = {by[0], by[1], by[2]}});
    LoadedMesh loaded{.mesh = model.mesh, .notes = {}, .parts = model.parts};
    explode(loaded, explosion);
    return std::make_shared<Model>(Model{.mesh = std::move(loaded.mesh),
                                         .notes = model.notes,
                                         .origin = model.origin,
                                         .parts = model.parts});
}

} // namespace

void bind_explode(py::class_<Model, std::shared_ptr<Model>>& mesh) {
    mesh.def(
        "exploded", &exploded, py::arg("factor") = 1.5F, py::kw_only(), py::arg("moves") = Moves{},
        py::arg("trails") = true,
        "The mesh with its parts apart: each stands `factor` times (1 to 100) as far from the\n"
        "middle of its assembly. moves: distances in the model's unit by which parts of a name\n"
        "such as \"Bolt*\" move instead. trails: lines from where parts belong to where they\n"
        "are, LineKind.trail.");
}

} // namespace lineatlas::python
