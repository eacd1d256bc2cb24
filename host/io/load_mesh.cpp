#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "checked.hpp"
#include "extension.hpp"
#include "lineatlas/io.hpp"
#include "obj.hpp"
#include "openmesh_import.hpp"
#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

Soup read_soup(SourceFile source, const std::string& extension) {
    if (extension == ".stl") return import_by_openmesh(check_stl(source), extension, source.path);

    refuse_other_types(source, extension);
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    if (source.bytes.starts_with(utf8_mark)) source.bytes.erase(0, utf8_mark.size());
    if (extension == ".obj") return read_obj(std::move(source));
    if (extension == ".ply") return import_by_openmesh(check_ply(source), extension, source.path);
    if (extension == ".off") return import_by_openmesh(check_off(source), extension, source.path);
    return import_by_openmesh(check_om(source), extension, source.path);
}

} // namespace

LoadedMesh load_mesh(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    constexpr std::string_view known[] = {".obj", ".ply", ".stl", ".off", ".om"};
    SourceFile source = read_source(path);
    if (std::find(std::begin(known), std::end(known), extension) == std::end(known)) {
        refuse_other_types(source, extension);
        throw read_error(path, "unknown mesh type \"" + printable(extension) +
                                   "\"; known are .obj, .ply, .stl, .off and .om");
    }
    try {
        return finish(read_soup(std::move(source), extension), path);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw read_error(path, "not enough memory");
    } catch (const std::exception& error) {
        throw read_error(path, printable(error.what()));
    }
}

} // namespace lineatlas
