#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

#include "atomic_file.hpp"
#include "image_loader.hpp"
#include "lineatlas/io.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

/// Every OpenImageIO writes them: no need to load it to know.
constexpr std::array common_types{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr"};

void check_type(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension.empty())
        throw write_error(path, "its name has no extension; try .png, .jpg, .tif or .exr");
    std::string lower = extension;
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::ranges::find(common_types, lower) != common_types.end()) return;
    if (!image_module().can_write(extension))
        throw write_error(path, "unknown picture type \"" + printable(extension) +
                                    "\"; try .png, .jpg, .tif or .exr");
}

void check_image(const std::filesystem::path& path, const Image& image) {
    const bool sizes =
        image.size.x > 0 && image.size.y > 0 && image.channels >= 1 && image.channels <= 4;
    if (!sizes || image.pixels.size() != static_cast<std::size_t>(image.size.x) *
                                             static_cast<std::size_t>(image.size.y) *
                                             static_cast<std::size_t>(image.channels))
        throw write_error(path, "a picture of " + std::to_string(image.size.x) + " x " +
                                    std::to_string(image.size.y) + " pixels with " +
                                    std::to_string(image.channels) + " channels and " +
                                    std::to_string(image.pixels.size()) + " values makes no sense");
}

/// Calls into the module; what it refuses becomes `error`.
template <class Call>
auto guarded(FileError (*error)(const std::filesystem::path&, std::string_view),
             const std::filesystem::path& path, Call call) {
    try {
        return call();
    } catch (const std::bad_alloc&) {
        throw error(path, "not enough memory");
    } catch (const std::runtime_error& refusal) {
        throw error(path, refusal.what());
    }
}

} // namespace

Image read_image(const std::filesystem::path& path) {
    check_source(path);
    const images::Module& module = image_module();
    return guarded(read_error, path, [&] { return module.read(path); });
}

void write_image(const std::filesystem::path& path, const Image& image) {
    check_image(path, image);
    check_type(path);
    AtomicFile file(path); // before the work of encoding
    const images::Module& module = image_module();
    file.commit(guarded(write_error, path, [&] { return module.encode(path, image); }));
}

void check_image_path(const std::filesystem::path& path) {
    check_type(path);
    const AtomicFile probe(path);
    check_image_module();
}

} // namespace lineatlas
