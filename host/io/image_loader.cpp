#include "image_loader.hpp"

#include "module_file.hpp"

namespace lineatlas {

namespace {

constexpr ModuleFile module_file{.name = "lineatlas-images",
                                 .purpose = "which reads and writes pictures",
                                 .library = "OpenImageIO",
                                 .package = "libopenimageio-dev"};

} // namespace

const images::Module& image_module() {
    static const auto& module =
        *static_cast<const images::Module*>(load_module(module_file, images::module_symbol));
    return module;
}

void check_image_module() {
    find_module(module_file);
}

} // namespace lineatlas
