#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <NCollection_DataMap.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>
#include <glm/vec3.hpp>

#include "lineatlas/io.hpp"

namespace lineatlas::brep {

/// A shape somewhere in an assembly.
struct Instance {
    std::uint32_t part; ///< index into Assembly::parts
    TopoDS_Shape shape; ///< without its location; of several instances the same
    TopLoc_Location location;
    std::optional<glm::vec3> color; ///< of faces that have none
};

/// The colours of single faces, as the file has them.
class FaceColors {
  public:
    virtual ~FaceColors() = default;
    virtual std::optional<glm::vec3> color(const TopoDS_Shape& face) const = 0;
};

/// What the file calls faces and edges, as #12 of STEP, by the shapes without a location.
using Entities = NCollection_DataMap<TopoDS_Shape, std::uint32_t, TopTools_ShapeMapHasher>;

/// What a file holds, before anything is meshed.
struct Assembly {
    std::vector<ModelPart> parts;
    std::vector<Instance> instances;
    std::unique_ptr<FaceColors> colors; ///< null where there are none
    std::string format;
    std::optional<double> unit; ///< millimetres of one unit of `instances`
    std::vector<std::string> notes;
    Entities entities;
};

} // namespace lineatlas::brep
