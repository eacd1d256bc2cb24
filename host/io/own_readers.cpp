#include "own_readers.hpp"

#include <algorithm>
#include <array>

#include "mesh_readers.hpp"
#include "obj.hpp"

namespace lineatlas {

Soup read_own(SourceFile model, std::string_view extension, const MaterialFiles& materials,
              const ProgressPart& progress) {
    if (extension == ".stl") return read_stl(model);
    refuse_other_types(model, extension);
    model.bytes.erase(0, model.bytes.size() - without_utf8_mark(model.bytes).size());
    if (extension == ".obj") return read_obj(model, materials, progress);
    return extension == ".ply" ? read_ply(model) : read_off(model);
}

bool has_own_reader(std::string_view extension) {
    constexpr std::array<std::string_view, 4> types{".obj", ".ply", ".stl", ".off"};
    return std::ranges::find(types, extension) != types.end();
}

} // namespace lineatlas
