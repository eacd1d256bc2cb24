#include "lineatlas/section.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "model.hpp"
#include "process.hpp"

namespace lineatlas::python {
namespace {

using Planes = std::variant<std::string, std::vector<std::string>>;
using PlanesArgument = Argument<Planes, "planes", "text such as \"x=50%\" or a list of such">;
using UncutArgument =
    Argument<std::vector<std::string>, "uncut", "a list of texts, such as [\"Bolt*\"]">;

std::vector<std::string> texts_of(const Planes& planes) {
    if (const auto* one = std::get_if<std::string>(&planes)) return {*one};
    return std::get<std::vector<std::string>>(planes);
}

std::shared_ptr<Model> cut(const Model& model, const PlanesArgument& planes,
                           Real<"spacing"> spacing, Real<"angle"> angle, Flag<"hatching"> hatching,
                           const UncutArgument& uncut) {
    const Released released;
    const Bounds bounds = bounds_of(model.mesh);
    const glm::dvec3 origin{model.origin[0], model.origin[1], model.origin[2]};
    std::vector<SectionPlane> parsed;
    for (const std::string& text : texts_of(planes)) {
        parsed.push_back(parse_section(text, bounds));
        if (!text.ends_with('%')) parsed.back().point -= origin;
    }
    Section section = cut_mesh(model.mesh, parsed,
                               {.spacing = static_cast<double>(*spacing),
                                .angle = static_cast<double>(*angle),
                                .none = !hatching},
                               *uncut);
    auto result = std::make_shared<Model>(Model{.mesh = std::move(section.mesh),
                                                .notes = model.notes,
                                                .origin = model.origin,
                                                .parts = model.parts});
    result->notes.insert(result->notes.end(), section.notes.begin(), section.notes.end());
    return result;
}

} // namespace

void bind_section(py::class_<Model, std::shared_ptr<Model>>& mesh) {
    mesh.def(
        "cut", &cut, py::arg("planes"), py::kw_only(), py::arg("spacing") = 0.0F,
        py::arg("angle") = 45.0F, py::arg("hatching") = true, py::arg("uncut") = py::list{},
        "The mesh cut by planes, with closed and hatched cuts. planes: one or a list of up to\n"
        "six, such as \"x=0.3\", \"-x=50%\" (of the model; - cuts away smaller coordinates) or\n"
        "\"1,2,3/0,0,1\" (a point and a normal that points to the removed side). spacing: of\n"
        "the hatching lines, in the model's unit; 0: a fortieth of the size of the cut. angle:\n"
        "of these lines in degrees, turned from part to part. uncut: a list of names of parts "
        "that\n"
        "stay whole, such as [\"Bolt*\"]. Notes name cuts that do not close.");
}

} // namespace lineatlas::python
