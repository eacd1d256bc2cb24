#include "obj_writer.hpp"

#include <charconv>
#include <cstdint>

namespace lineatlas {
namespace {

template <class T>
void add_number(std::string& text, T value) {
    char digits[32];
    text += ' ';
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

} // namespace

std::string to_obj(const Mesh& mesh) {
    std::string text;
    for (const glm::vec3& position : mesh.positions) {
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) add_number(text, position[axis]);
        text += '\n';
    }
    const MeshGroup* last = nullptr;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i < mesh.triangle_group.size()) {
            const MeshGroup& group = mesh.groups[mesh.triangle_group[i]];
            if (last == nullptr || last->object != group.object) text += "o " + group.object + "\n";
            if (last == nullptr || last->material != group.material)
                text += "usemtl " + group.material + "\n";
            last = &group;
        }
        text += 'f';
        for (int corner = 0; corner < 3; ++corner) add_number(text, mesh.triangles[i][corner] + 1);
        text += '\n';
    }
    for (const std::vector<std::uint32_t>& polyline : mesh.polylines) {
        text += 'l';
        for (const std::uint32_t position : polyline) add_number(text, position + 1);
        text += '\n';
    }
    return text;
}

} // namespace lineatlas
