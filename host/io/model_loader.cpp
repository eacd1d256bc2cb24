#include "model_loader.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "module_files.hpp"

namespace lineatlas {

namespace {

struct Family {
    const ModuleFile& file;
    const char* symbol;
    bool crashes = false; ///< on damaged files, whatever is done about it here
};

constexpr Family gltf{.file = module_files::gltf, .symbol = models::gltf_symbol};
constexpr Family brep{.file = module_files::brep, .symbol = models::brep_symbol, .crashes = true};
constexpr Family threemf{.file = module_files::threemf, .symbol = models::threemf_symbol};

/// Loaded once: when a file is believed, nothing can be opened any more.
template <const Family& family>
const models::Module& module_of() {
    static const auto& module =
        *static_cast<const models::Module*>(load_module(family.file, family.symbol));
    return module;
}

struct Extension {
    std::string_view name;
    const Family* family;
    const models::Module& (*module)();
};
template <const Family& family>
constexpr Extension extension_of(std::string_view name) {
    return {name, &family, module_of<family>};
}
constexpr std::array extensions{
    extension_of<gltf>(".gltf"), extension_of<gltf>(".glb"),  extension_of<brep>(".step"),
    extension_of<brep>(".stp"),  extension_of<brep>(".iges"), extension_of<brep>(".igs"),
    extension_of<brep>(".brep"), extension_of<brep>(".brp"),  extension_of<threemf>(".3mf")};

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
    Other{".fcstd", "a FreeCAD document", "export it from FreeCAD as STEP"},
    Other{".sldprt", "a SolidWorks part", "export it from SolidWorks as STEP"},
    Other{".dwg", "a DWG drawing", "export its solids as STEP"},
    Other{".dxf", "a DXF drawing", "export its solids as STEP"},
    Other{".skp", "a SketchUp model", "export it from SketchUp as GLB or OBJ"},
};

const Extension* find(std::string_view extension) {
    const auto* const found = std::ranges::find(extensions, extension, &Extension::name);
    return found == extensions.end() ? nullptr : found;
}

/// What a library says, as one line of moderate length.
std::string one_line(std::string_view message) {
    constexpr std::size_t longest = 300;
    return printable(message.substr(0, message.find_first_of("\r\n")), longest);
}

} // namespace

bool is_read_by_module(std::string_view extension) {
    return find(extension) != nullptr;
}

bool may_crash(std::string_view extension) {
    const Extension* const found = find(extension);
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
