#include "image_loader.hpp"

#include "module_file.hpp"

namespace lineatlas {

namespace {

constexpr ModuleFile all_types{.name = "lineatlas-images",
                               .purpose = "which reads and writes pictures",
                               .library = "OpenImageIO",
                               .package = "libopenimageio-dev",
                               .own_package = "lineatlas-images"};
constexpr ModuleFile png_alone{.name = "lineatlas-png",
                               .purpose = "which reads and writes pictures",
                               .library = "libpng",
                               .package = "libpng-dev"};

/// The one for all types where it is installed: then it has to load.
const ModuleFile& installed() {
    if (has_module(all_types)) return all_types;
    find_module(png_alone);
    return png_alone;
}

} // namespace

const images::Module& image_module() {
    static const auto& module =
        *static_cast<const images::Module*>(load_module(installed(), images::module_symbol));
    return module;
}

void check_image_module() {
    installed();
}

} // namespace lineatlas
