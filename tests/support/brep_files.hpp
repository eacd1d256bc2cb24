#pragma once

#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

namespace lineatlas::test {

/// A shape in an assembly, once or several times.
struct NamedShape {
    std::string name;
    TopoDS_Shape shape;
    std::vector<gp_Trsf> places;
    double red = 0, green = 0, blue = 0; ///< as on the screen
};

/// An assembly as a STEP file, written by Open CASCADE.
std::string to_step(const std::vector<NamedShape>& shapes);

/// The file of the assembly alone. Its parts are in other files, whose names begin with `prefix`.
std::string to_step_apart(const std::vector<NamedShape>& shapes, const char* prefix);

/// The same file with lengths in inches. (Versions of Open CASCADE write inches in several ways.)
std::string in_inches(std::string step);

/// The same as an IGES file, of surfaces that share no edges (`solids` false) or of solids.
std::string to_iges(const std::vector<NamedShape>& shapes, bool solids, const char* unit = "MM");

std::string to_brep(const TopoDS_Shape& shape);

/// A square plate, 1 thick, with `side` times `side` round through holes of radius 0.3, one in
/// every unit of its area.
TopoDS_Shape perforated_plate(int side);

} // namespace lineatlas::test
