#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "draw_arguments.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::apps {

/// The model or scene that is drawn, and its view unless the command line gives another one.
struct Subject {
    std::string name;
    Mesh mesh;
    LineSet lines;
    LineOptions line_options;      ///< by which they were found
    std::vector<glm::vec3> framed; ///< points that the camera shows unless it is placed by hand
    View view;
    glm::vec3 up{0, 1, 0};               ///< of the model
    glm::dvec3 origin{0};                ///< of the mesh and the view, in the file's coordinates
    std::optional<double> unit{};        ///< of the file, in millimetres
    std::vector<std::string> sections{}; ///< that the mesh was cut by, with their sides
    double deflection = 0;               ///< of exact surfaces; else 0
    std::vector<std::string> notes{};
    nlohmann::ordered_json summary{};   ///< as describe_model() has it, if the sheet wants one
    std::vector<std::uint32_t> items{}; ///< then item_numbers()
};

/// What is drawn, and the pictures of it.
struct Pictures {
    Subject subject;
    std::optional<std::vector<SequenceFrame>> frames; ///< nothing: a single one
};

/// What is drawn on a sheet.
struct SheetSubject {
    Subject subject;
    SheetLayout layout;
};

/// Millimetres of paper that a pixel of the picture takes. Throws UsageError when nothing says so.
double millimetres_per_pixel(const DrawArguments& arguments, glm::ivec2 size);

/// The picture's size in pixels. Unless it is given, a drawing to scale has more where they would
/// be coarse on paper: lines a quarter of a pixel from each other are drawn as one.
glm::ivec2 picture_size(const DrawArguments& arguments);

/// Reads the model or makes the scene, cuts it, finds its lines and places the camera. Curved faces
/// are as fine as the pictures show them: the model is read again where it turns out to be seen
/// from nearer than as a whole.
Pictures find_pictures(const DrawArguments& arguments, LineKindMask kinds, glm::ivec2 size);

/// The same for the sheet that --views asks for.
SheetSubject find_sheet(const DrawArguments& arguments, LineKindMask kinds);

} // namespace lineatlas::apps
