#include "image_loader.hpp"

#include "extension.hpp"
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
const ModuleFile& installed(PictureType type) {
    if (type == PictureType::any && has_module(all_types)) return all_types;
    find_module(png_alone);
    return png_alone;
}

const images::Module& load(PictureType type) {
    return *static_cast<const images::Module*>(load_module(installed(type), images::module_symbol));
}

} // namespace

PictureType type_by_name(const std::filesystem::path& path) {
    return lower_extension(path) == ".png" ? PictureType::png : PictureType::any;
}

PictureType type_by_content(std::string_view file) {
    return file.starts_with("\x89PNG\r\n\x1a\n") ? PictureType::png : PictureType::any;
}

const images::Module& image_module(PictureType type) {
    if (type == PictureType::png) {
        static const images::Module& png = load(PictureType::png);
        return png;
    }
    static const images::Module& any = load(PictureType::any);
    return any;
}

void check_image_module(PictureType type) {
    installed(type);
}

} // namespace lineatlas
