// The module without OpenImageIO: .png with 8 bits per channel, which is all that a bundle needs.

#include <array>
#include <cstdint>
#include <stdexcept>

#include <png.h>

#include "images/image_module.hpp"
#include "images/pixels.hpp"

namespace lineatlas::images {
namespace {

constexpr std::array<png_uint_32, 4> formats{PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB,
                                             PNG_FORMAT_RGBA};

/// A libpng picture; what it holds is freed in any case.
struct Picture {
    Picture() { image.version = PNG_IMAGE_VERSION; }
    ~Picture() { png_image_free(&image); }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    void check(int done) const {
        if (done == 0) throw std::runtime_error(image.message);
    }

    png_image image{};
};

bool can_write(const std::string& extension) {
    return extension == ".png";
}

Image decode(const std::filesystem::path&, std::string_view file) {
    Picture picture;
    picture.check(png_image_begin_read_from_memory(&picture.image, file.data(), file.size()));
    constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28U; // 16384 x 16384
    if (std::uint64_t{picture.image.width} * picture.image.height > most_pixels)
        throw std::runtime_error("it has more than 2^28 pixels");
    const bool alpha = (picture.image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    const bool color = (picture.image.format & PNG_FORMAT_FLAG_COLOR) != 0;
    const int channels = (color ? 3 : 1) + (alpha ? 1 : 0);
    picture.image.format = formats[static_cast<std::size_t>(channels - 1)];
    Image image{
        .size = {picture.image.width, picture.image.height}, .channels = channels, .pixels = {}};
    image.pixels.resize(PNG_IMAGE_SIZE(picture.image));
    picture.check(png_image_finish_read(&picture.image, nullptr, image.pixels.data(), 0, nullptr));
    return image;
}

std::vector<unsigned char> encode(const std::filesystem::path& path, const Pixels& pixels,
                                  const ImageSettings& settings) {
    if (!can_write(path.extension().string()))
        throw std::runtime_error("this build has no OpenImageIO and writes .png alone");
    if (pixels.bits != 8 || (settings.bits != 0 && settings.bits != 8))
        throw std::runtime_error("this build has no OpenImageIO and writes 8 bits per channel");
    std::vector<std::byte> values(pixels.values.begin(), pixels.values.end());
    if (pixels.premultiplied) values = straight(pixels);
    Picture picture;
    picture.image.width = static_cast<png_uint_32>(pixels.size.x);
    picture.image.height = static_cast<png_uint_32>(pixels.size.y);
    picture.image.format = formats[static_cast<std::size_t>(pixels.channels - 1)];
    picture.image.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(picture.image);
    std::vector<unsigned char> encoded(size);
    picture.check(png_image_write_to_memory(&picture.image, encoded.data(), &size, 0, values.data(),
                                            0, nullptr));
    encoded.resize(size);
    return encoded;
}

} // namespace
} // namespace lineatlas::images

extern "C" const lineatlas::images::Module lineatlas_images_3{.can_write =
                                                                  lineatlas::images::can_write,
                                                              .decode = lineatlas::images::decode,
                                                              .encode = lineatlas::images::encode};
