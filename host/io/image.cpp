#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

#include "atomic_file.hpp"
#include "extension.hpp"
#include "image_codec.hpp"
#include "image_loader.hpp"
#include "lineatlas/io.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

/// A type that every OpenImageIO writes, so its limits are known without loading it.
struct Format {
    std::string_view extension;
    std::array<int, 3> bits; ///< allowed bits per channel, the usual number first; 0: no more
    bool alpha;
};
constexpr std::array formats{
    Format{".png", {8, 16}, true}, Format{".jpg", {8}, false},     Format{".jpeg", {8}, false},
    Format{".tif", {8, 16}, true}, Format{".tiff", {8, 16}, true}, Format{".exr", {16, 32}, true},
};

/// The format of a path's type; null for other types.
const Format* common_format(const std::filesystem::path& path) {
    const auto found = std::ranges::find(formats, lower_extension(path), &Format::extension);
    return found == formats.end() ? nullptr : &*found;
}

void check_type(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension.empty())
        throw write_error(path, "its name has no extension; try .png, .jpg, .tif or .exr");
    if (common_format(path) != nullptr) return;
    if (!image_module(PictureType::any).can_write(extension))
        throw write_error(path, "unknown picture type \"" + printable(extension) +
                                    "\"; try .png, .jpg, .tif or .exr");
}

void check_pixels(const std::filesystem::path& path, const Pixels& pixels) {
    const glm::ivec2 size = pixels.size;
    const bool possible = size.x > 0 && size.y > 0 && pixels.channels >= 1 &&
                          pixels.channels <= 4 && (pixels.bits == 8 || pixels.bits == 16);
    if (!possible || pixels.values.size() != static_cast<std::size_t>(size.x) *
                                                 static_cast<std::size_t>(size.y) *
                                                 static_cast<std::size_t>(pixels.channels) *
                                                 static_cast<std::size_t>(pixels.bits / 8))
        throw write_error(path, "a picture of " + std::to_string(size.x) + " x " +
                                    std::to_string(size.y) + " pixels with " +
                                    std::to_string(pixels.channels) + " channels and " +
                                    std::to_string(pixels.values.size()) + " bytes makes no sense");
}

/// Calls the module and turns its refusals into `error`.
template <class Call>
auto guarded(FileError (*error)(const std::string&, std::string_view), const std::string& path,
             Call call) {
    try {
        return call();
    } catch (const std::bad_alloc&) {
        throw error(path, "not enough memory");
    } catch (const std::runtime_error& refusal) {
        throw error(path, refusal.what());
    }
}

} // namespace

Image decode_image(const SourceFile& file) {
    const images::Module& module = image_module(type_by_content(file.bytes));
    return guarded(read_error, file.path, [&] { return module.decode(file.path, file.bytes); });
}

std::vector<unsigned char> encode_image(const std::filesystem::path& path, const Pixels& pixels,
                                        const ImageSettings& settings) {
    check_pixels(path, pixels);
    check_type(path);
    check_image_settings(path, settings, false);
    const images::Module& module = image_module(type_by_name(path));
    return guarded(write_error, path, [&] { return module.encode(path, pixels, settings); });
}

Image read_image(const std::filesystem::path& path) {
    return decode_image(read_source(path));
}

void write_image(const std::filesystem::path& path, const Pixels& pixels,
                 const ImageSettings& settings) {
    check_type(path);
    AtomicFile file(path); // opened before the work of encoding
    file.commit(encode_image(path, pixels, settings));
}

void write_image(const std::filesystem::path& path, const Image& image) {
    write_image(path, {.size = image.size,
                       .channels = image.channels,
                       .bits = 8,
                       .premultiplied = false,
                       .values = std::as_bytes(std::span{image.pixels})});
}

void check_image_settings(const std::filesystem::path& path, const ImageSettings& settings,
                          bool transparent) {
    const Format* format = common_format(path);
    const std::string type = printable(path.extension().string());
    if (transparent && (format == nullptr || !format->alpha))
        throw write_error(path, "transparency in " + type +
                                    " files is not supported; use .png, .tif or .exr");
    const auto has = [&](int bits) {
        return std::ranges::find(format->bits, bits) != format->bits.end();
    };
    if (settings.bits == 0 || (format == nullptr ? settings.bits == 8 : has(settings.bits))) return;
    throw write_error(path, type + " files with " + std::to_string(settings.bits) +
                                " bits per channel are not supported; .png and .tif have 8 or "
                                "16, .exr has 16 or 32, others 8");
}

void check_image_path(const std::filesystem::path& path) {
    check_type(path);
    const AtomicFile probe(path);
    check_image_module(type_by_name(path));
}

} // namespace lineatlas
