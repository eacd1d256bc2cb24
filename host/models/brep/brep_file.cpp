#include "brep_file.hpp"

#include <stdexcept>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include "bodies.hpp"
#include "memory_stream.hpp"

namespace lineatlas::brep {

Assembly read_brep(std::string_view file) {
    if (file.substr(0, 4096).find("CASCADE Topology") == file.npos)
        throw std::runtime_error(
            "it is no BREP file: \"CASCADE Topology\" is missing at its begin");
    MemoryBuffer buffer{file};
    std::istream stream{&buffer};
    // Open CASCADE does not check whether a number was read, and would count on endlessly without
    // one.
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    TopoDS_Shape shape;
    try {
        BRepTools::Read(shape, stream, BRep_Builder());
    } catch (const std::ios_base::failure&) {
        throw std::runtime_error("it is damaged or cut off: a number is missing");
    }
    if (shape.IsNull())
        throw std::runtime_error("it is damaged or cut off: Open CASCADE cannot read it");
    Assembly assembly;
    assembly.format = "BREP";
    assembly.parts.push_back({.name = "shape"});
    assembly.instances.push_back({.part = 0,
                                  .shape = shape.Located(TopLoc_Location()),
                                  .location = shape.Location(),
                                  .color = std::nullopt});
    part_bodies(assembly, {});
    return assembly;
}

} // namespace lineatlas::brep
