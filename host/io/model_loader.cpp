#include "model_loader.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string>

#include "module_file.hpp"

namespace lineatlas {

namespace {

struct Family {
    ModuleFile file;
    const char* symbol;
};

constexpr Family gltf{.file = {.name = "lineatlas-gltf",
                               .purpose = "which reads glTF models",
                               .library = "Draco or meshoptimizer",
                               .package = "libdraco-dev libmeshoptimizer-dev"},
                      .symbol = models::gltf_symbol};
constexpr Family brep{.file = {.name = "lineatlas-brep",
                               .purpose = "which reads STEP, IGES and BREP models",
                               .library = "Open CASCADE",
                               .package = "libocct-data-exchange-dev",
                               .own_package = "lineatlas-brep"},
                      .symbol = models::brep_symbol};
constexpr Family threemf{.file = {.name = "lineatlas-3mf",
                                  .purpose = "which reads 3MF models",
                                  .library = "lib3mf",
                                  .package = "lib3mf1 libzip4"},
                         .symbol = models::threemf_symbol};

/// Loaded once: when a file is believed, nothing can be opened any more.
template <const Family& family>
const models::Module& module_of() {
    static const auto& module =
        *static_cast<const models::Module*>(load_module(family.file, family.symbol));
    return module;
}

struct Extension {
    std::string_view name;
    const models::Module& (*module)();
};
constexpr std::array extensions{
    Extension{".gltf", module_of<gltf>},  Extension{".glb", module_of<gltf>},
    Extension{".step", module_of<brep>},  Extension{".stp", module_of<brep>},
    Extension{".iges", module_of<brep>},  Extension{".igs", module_of<brep>},
    Extension{".brep", module_of<brep>},  Extension{".brp", module_of<brep>},
    Extension{".3mf", module_of<threemf>}};

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
    std::string line(message.substr(0, std::min(message.find_first_of("\r\n"), longest)));
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
    return line;
}

} // namespace

bool is_read_by_module(std::string_view extension) {
    return find(extension) != nullptr;
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
                                  .deflection = options.deflection};
    try {
        return find(extension)->module().read(request);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw read_error(model.path, one_line(error.what()));
    }
}

} // namespace lineatlas
