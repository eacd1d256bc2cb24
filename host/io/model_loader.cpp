#include "model_loader.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "model_types.hpp"
#include "module_files.hpp"

namespace lineatlas {

namespace {

struct Family {
    const ModuleFile& file;
    const char* symbol;
    bool crashes = false; ///< on damaged files, in spite of all checks
};

constexpr Family gltf{.file = module_files::gltf, .symbol = models::gltf_symbol};
constexpr Family brep{.file = module_files::brep, .symbol = models::brep_symbol, .crashes = true};
constexpr Family threemf{.file = module_files::threemf, .symbol = models::threemf_symbol};

/// The module of a family, loaded once. After that the process is confined and can open nothing.
template <const Family& family>
const models::Module& module_of() {
    static const auto& module =
        *static_cast<const models::Module*>(load_module(family.file, family.symbol));
    return module;
}

struct Reader {
    ModelReader reader;
    const Family* family;
    const models::Module& (*module)();
};
constexpr std::array readers{Reader{ModelReader::gltf, &gltf, module_of<gltf>},
                             Reader{ModelReader::threemf, &threemf, module_of<threemf>},
                             Reader{ModelReader::brep, &brep, module_of<brep>}};

struct Other {
    std::string_view extension, what, convert;
};
constexpr std::array others{
    Other{".fbx", "an FBX model", "convert it to GLB, with Blender for one"},
    Other{".dae", "a Collada model", "convert it to GLB, with Blender for one"},
    Other{".blend", "a Blender file", "export it from Blender as GLB"},
    Other{".3ds", "a 3D Studio model", "convert it to GLB, with Blender for one"},
    Other{".usd", "a USD scene", "convert it to GLB, with Blender for one"},
    Other{".usda", "a USD scene", "convert it to GLB, with Blender for one"},
    Other{".usdc", "a USD scene", "convert it to GLB, with Blender for one"},
    Other{".usdz", "a USD scene", "convert it to GLB, with Blender for one"},
    Other{".ifc", "an IFC building", "convert it to GLB, with IfcConvert for one"},
    Other{".x_t", "a Parasolid model", "export it as STEP"},
    Other{".x_b", "a Parasolid model", "export it as STEP"},
    Other{".jt", "a JT model", "export it as STEP"},
    Other{".sat", "an ACIS model", "export it as STEP"},
    Other{".sab", "an ACIS model", "export it as STEP"},
    Other{".3dm", "a Rhino model", "export it from Rhino as STEP or OBJ"},
    Other{".ipt", "an Inventor part", "export it from Inventor as STEP"},
    Other{".catpart", "a CATIA part", "export it from CATIA as STEP"},
    Other{".fcstd", "a FreeCAD document", "export it from FreeCAD as STEP"},
    Other{".sldprt", "a SolidWorks part", "export it from SolidWorks as STEP"},
    Other{".dwg", "a DWG drawing", "export its solids as STEP"},
    Other{".dxf", "a DXF drawing", "export its solids as STEP"},
    Other{".skp", "a SketchUp model", "export it from SketchUp as GLB or OBJ"},
};

const Reader* find(std::string_view extension) {
    const ModelType* const type = find_model_type(extension);
    if (type == nullptr) return nullptr;
    const auto* const found = std::ranges::find(readers, type->reader, &Reader::reader);
    return found == readers.end() ? nullptr : found;
}

/// A library's message as one line of moderate length.
std::string one_line(std::string_view message) {
    constexpr std::size_t longest = 300;
    return printable(message.substr(0, message.find_first_of("\r\n")), longest);
}

} // namespace

bool is_read_by_module(std::string_view extension) {
    return find(extension) != nullptr;
}

bool may_crash(std::string_view extension) {
    const Reader* const found = find(extension);
    return found != nullptr && found->family->crashes;
}

std::filesystem::path reader_program(std::string_view extension) {
    const ModuleFile& module = find(extension)->family->file;
    std::filesystem::path program = find_module(module).parent_path() / "lineatlas-reader";
    std::error_code error;
    if (!std::filesystem::exists(program, error)) {
        throw FileError("cannot run " + quoted(program) + ", " + module.purpose +
                        ": no such file; install the package " + module.own_package +
                        " anew, or build the target lineatlas-reader");
    }
    return program;
}

void refuse_other_models(const SourceFile& model, std::string_view extension) {
    const auto* const other = std::ranges::find(others, extension, &Other::extension);
    if (other != others.end())
        throw read_error(model.path,
                         "it is " + std::string(other->what) + "; " + std::string(other->convert));
}

void prepare_module(std::string_view extension) {
    find(extension)->module().prepare();
}

Soup read_by_module(const SourceFile& model, std::string_view extension,
                    const std::vector<models::NamedFile>& named, const LoadOptions& options) {
    const models::Request request{.extension = extension,
                                  .bytes = model.bytes,
                                  .named = named,
                                  .deflection = options.deflection,
                                  .pixels = options.pixels};
    try {
        return find(extension)->module().read(request);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw read_error(model.path, one_line(error.what()));
    }
}

} // namespace lineatlas
