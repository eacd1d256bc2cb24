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
    LineOptions line_options;      ///< options by which the lines were found
    std::vector<glm::vec3> framed; ///< points that the camera shows unless it is placed by hand
    View view;
    glm::vec3 up{0, 1, 0};               ///< up in the model
    glm::dvec3 origin{0};                ///< origin of mesh and view, in the file's coordinates
    std::optional<double> unit{};        ///< of the file, in millimetres
    std::vector<std::string> sections{}; ///< planes that cut the mesh, with their sides
    double deflection = 0;               ///< of exact surfaces; 0 without them
    std::vector<std::string> notes{};
    nlohmann::ordered_json summary{};   ///< the result of describe_model(), if the sheet wants one
    std::vector<std::uint32_t> items{}; ///< item_numbers(), if the sheet wants them
};

/// The subject, and the pictures to draw of it.
struct Pictures {
    Subject subject;
    std::optional<std::vector<SequenceFrame>> frames; ///< nothing: a single picture
};

/// The subject of a sheet.
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
/// are as fine as the pictures need: the model is read again if a picture turns out to show it from
/// nearer than as a whole.
Pictures find_pictures(const DrawArguments& arguments, LineKindMask kinds, glm::ivec2 size);

/// As find_pictures(), for the sheet that --views asks for.
SheetSubject find_sheet(const DrawArguments& arguments, LineKindMask kinds);

} // namespace lineatlas::apps
