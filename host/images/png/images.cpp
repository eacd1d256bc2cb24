// The module for .png files, with libpng alone. Without OpenImageIO it is the only module for
// pictures.

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

#include <png.h>

#include "images/pixels.hpp"
#include "io/image_module.hpp"

namespace lineatlas::images {
namespace {

constexpr std::array<png_uint_32, 4> formats{PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB,
                                             PNG_FORMAT_RGBA};

/// A libpng picture that frees its memory in any case.
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
    constexpr std::string_view type = ".png";
    return std::ranges::equal(extension, type, {}, [](unsigned char c) { return std::tolower(c); });
}

Image decode(const std::filesystem::path&, std::string_view file) {
    Picture picture;
    picture.check(png_image_begin_read_from_memory(&picture.image, file.data(), file.size()));
    check_pixel_count(picture.image.width, picture.image.height);
    picture.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; // unless the file says otherwise
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

/// libpng's writer, into memory. Its errors are thrown.
class Writer {
  public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) throw std::bad_alloc();
        png_set_write_fn(png_, this, append, [](png_structp) {});
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void describe(const Pixels& pixels, int bits, const ImageSettings& settings) {
        constexpr std::array<int, 4> types{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                           PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(pixels.size.x),
                     static_cast<png_uint_32>(pixels.size.y), bits,
                     types[static_cast<std::size_t>(pixels.channels - 1)], PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        // Lines on paper: more effort and filters of neighbours take longer and save little.
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
        png_set_compression_level(png_, 2);
        if (settings.dpi > 0) {
            constexpr double metre = 1 / 0.0254; // in inches
            const auto per_metre = static_cast<png_uint_32>(std::lround(settings.dpi * metre));
            png_set_pHYs(png_, info_, per_metre, per_metre, PNG_RESOLUTION_METER);
        }
        if (!settings.description.empty()) {
            say("Description", settings.description);
            say("Software", "lineatlas " LINEATLAS_VERSION);
        }
    }

    /// `values`: row by row, with the described number of bits.
    std::vector<unsigned char> write(std::span<const std::byte> values, int rows) {
        png_write_info(png_, info_);
        if (std::endian::native == std::endian::little) png_set_swap(png_); // of 16 bits
        const std::size_t length = values.size() / static_cast<std::size_t>(rows);
        for (std::size_t at = 0; at < values.size(); at += length)
            png_write_row(png_, reinterpret_cast<png_const_bytep>(values.data() + at));
        png_write_end(png_, nullptr);
        return std::move(encoded_);
    }

  private:
    [[noreturn]] static void refuse(png_structp, png_const_charp cause) {
        throw std::runtime_error(cause);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void append(png_structp png, png_bytep bytes, std::size_t count) {
        auto& encoded = static_cast<Writer*>(png_get_io_ptr(png))->encoded_;
        encoded.insert(encoded.end(), bytes, bytes + count);
    }
    void say(std::string key, std::string text) {
        png_text entry{};
        entry.compression = PNG_TEXT_COMPRESSION_NONE;
        entry.key = key.data();
        entry.text = text.data();
        entry.text_length = text.size();
        png_set_text(png_, info_, &entry, 1);
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::vector<unsigned char> encoded_;
};

/// The same values with 16 bits each in place of 8, or the other way.
std::vector<std::byte> with_other_bits(std::span<const std::byte> values, int bits) {
    std::vector<std::byte> result(bits == 16 ? 2 * values.size() : values.size() / 2);
    for (std::size_t i = 0; i < result.size() / static_cast<std::size_t>(bits / 8); ++i) {
        std::uint16_t wide = 0;
        if (bits == 16) {
            wide = static_cast<std::uint16_t>(257 * std::to_integer<unsigned>(values[i]));
            std::memcpy(&result[2 * i], &wide, sizeof(wide));
        } else {
            std::memcpy(&wide, &values[2 * i], sizeof(wide));
            result[i] = static_cast<std::byte>((wide + 128U) / 257U);
        }
    }
    return result;
}

std::vector<unsigned char> encode(const std::filesystem::path& path, const Pixels& pixels,
                                  const ImageSettings& settings) {
    if (!can_write(path.extension().string()))
        throw std::runtime_error("without the package lineatlas-images, which brings OpenImageIO, "
                                 "pictures are written as .png");
    const int bits = settings.bits == 16 ? 16 : 8;
    std::vector<std::byte> values(pixels.values.begin(), pixels.values.end());
    if (pixels.premultiplied) values = straight(pixels);
    if (pixels.bits != bits) values = with_other_bits(values, bits);
    Writer writer;
    writer.describe(pixels, bits, settings);
    return writer.write(values, pixels.size.y);
}

} // namespace
} // namespace lineatlas::images

extern "C" const lineatlas::images::Module lineatlas_images_3{.can_write =
                                                                  lineatlas::images::can_write,
                                                              .decode = lineatlas::images::decode,
                                                              .encode = lineatlas::images::encode};
