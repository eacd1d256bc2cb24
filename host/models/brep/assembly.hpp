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
    TopoDS_Shape shape; ///< without its location; the same for all instances of a shape
    TopLoc_Location location;
    std::optional<glm::vec3> color; ///< colour of faces without one
};

/// The colours of single faces, as the file has them.
class FaceColors {
  public:
    virtual ~FaceColors() = default;
    virtual std::optional<glm::vec3> color(const TopoDS_Shape& face) const = 0;
};

/// The numbers of faces and edges in the file, such as #12 of STEP, by their shapes without a
/// location.
using Entities = NCollection_DataMap<TopoDS_Shape, std::uint32_t, TopTools_ShapeMapHasher>;

/// The contents of a file, before anything is meshed.
struct Assembly {
    std::vector<ModelPart> parts;
    std::vector<Instance> instances;
    std::unique_ptr<FaceColors> colors; ///< null without colours
    std::string format;
    std::optional<double> unit; ///< millimetres of one unit of `instances`
    std::vector<std::string> notes;
    Entities entities;
};

} // namespace lineatlas::brep
