#include "image_loader.hpp"

#include "extension.hpp"
#include "module_files.hpp"

namespace lineatlas {

namespace {

/// The module for all types if it is installed; then that one must load.
const ModuleFile& installed(PictureType type) {
    if (type == PictureType::any && has_module(module_files::images)) return module_files::images;
    find_module(module_files::png);
    return module_files::png;
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
