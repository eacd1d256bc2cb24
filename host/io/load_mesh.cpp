#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "checked.hpp"
#include "extension.hpp"
#include "mesh_source.hpp"
#include "obj.hpp"
#include "openmesh_import.hpp"
#include "soup.hpp"

namespace lineatlas {

namespace {

Soup read_soup(MeshSource source, const std::string& extension) {
    SourceFile& model = source.model;
    if (extension == ".stl") return import_by_openmesh(check_stl(model), extension, model.path);

    refuse_other_types(model, extension);
    model.bytes.erase(0, model.bytes.size() - without_utf8_mark(model.bytes).size());
    if (extension == ".obj") return read_obj(std::move(model), source.materials);
    if (extension == ".ply") return import_by_openmesh(check_ply(model), extension, model.path);
    if (extension == ".off") return import_by_openmesh(check_off(model), extension, model.path);
    return import_by_openmesh(check_om(model), extension, model.path);
}

} // namespace

MeshSource read_mesh_source(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    constexpr std::string_view known[] = {".obj", ".ply", ".stl", ".off", ".om"};
    MeshSource source{.model = read_source(path), .materials = {}};
    if (std::find(std::begin(known), std::end(known), extension) == std::end(known)) {
        refuse_other_types(source.model, extension);
        throw read_error(path, "unknown mesh type \"" + printable(extension) +
                                   "\"; known are .obj, .ply, .stl, .off and .om");
    }
    if (extension == ".obj") source.materials = read_material_files(source.model);
    return source;
}

LoadedMesh parse_mesh(MeshSource source) {
    const std::filesystem::path path = source.model.path;
    try {
        return finish(read_soup(std::move(source), lower_extension(path)), path);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw read_error(path, "not enough memory");
    } catch (const std::exception& error) {
        throw read_error(path, printable(error.what()));
    }
}

LoadedMesh load_mesh(const std::filesystem::path& path) {
    return parse_mesh(read_mesh_source(path));
}

} // namespace lineatlas
