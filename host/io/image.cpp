#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "atomic_file.hpp"
#include "lineatlas/io.hpp"
#include "pixels.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

constexpr const char* straight_alpha = "oiio:UnassociatedAlpha";

/// OpenImageIO's messages may have several lines and trailing ends of line.
std::string first_line(const std::string& message, const char* otherwise) {
    const std::string line = message.substr(0, message.find_first_of("\r\n"));
    return line.empty() ? otherwise : line;
}

bool is_linear(const OIIO::ImageSpec& spec) {
    return spec.format == OIIO::TypeDesc::HALF || spec.format == OIIO::TypeDesc::FLOAT ||
           spec.format == OIIO::TypeDesc::DOUBLE;
}

std::unique_ptr<OIIO::ImageOutput> output_for(const std::filesystem::path& path) {
    if (path.extension().empty())
        throw write_error(path, "its name has no extension; try .png, .jpg, .tif or .exr");
    // By extension alone: a whole name could be taken for a plugin's own address.
    auto output = OIIO::ImageOutput::create("picture" + path.extension().string());
    if (output && output->supports("ioproxy")) return output;
    OIIO::geterror(); // otherwise it is printed when the program ends
    throw write_error(path, "unknown picture type \"" + printable(path.extension().string()) +
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

OIIO::ImageSpec spec_of(const Image& image, bool linear) {
    OIIO::ImageSpec spec(image.size.x, image.size.y, image.channels,
                         linear ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    if (image.channels == 2) spec.alpha_channel = 1;
    if (!linear) spec.attribute(straight_alpha, 1);
    // Level 6, the default, takes 1.6 times as long for line drawings and saves a sixth.
    spec.attribute("png:compressionLevel", 2);
    spec.attribute("tiff:zipquality", 2);
    spec.attribute("CompressionQuality", 95); // JPEG: lower ones put rings around strokes
    return spec;
}

/// Into memory: several of OpenImageIO's writers do not notice a full disk, and the one of JPEG
/// ends the program.
std::vector<unsigned char> encode(OIIO::ImageOutput& output, const std::filesystem::path& path,
                                  const Image& image) {
    const std::string_view format = output.format_name();
    const bool linear = format == "openexr" || format == "hdr";
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory(encoded);
    const auto check = [&](bool done) {
        if (!done) throw write_error(path, first_line(output.geterror(), "OpenImageIO refuses it"));
    };
    check(output.set_ioproxy(&memory));
    check(output.open(path.filename().string(), spec_of(image, linear)));
    if (linear)
        check(output.write_image(OIIO::TypeDesc::FLOAT, to_linear(image).data()));
    else
        check(output.write_image(OIIO::TypeDesc::UINT8, image.pixels.data()));
    check(output.close());
    return encoded;
}

/// Rejects what would not fit into an Image or into memory.
void check_spec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
    constexpr std::int64_t most_pixels = std::int64_t{1} << 28; // 16384 x 16384
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0)
        throw read_error(path, "it holds no pixels");
    if (spec.depth > 1) throw read_error(path, "it is a volume, not a picture");
    if (static_cast<std::int64_t>(spec.width) * spec.height > most_pixels)
        throw read_error(path, "its " + std::to_string(spec.width) + " x " +
                                   std::to_string(spec.height) + " pixels are more than 2^28");
}

} // namespace

Image read_image(const std::filesystem::path& path) {
    check_source(path);
    OIIO::ImageSpec hints;
    hints.attribute(straight_alpha, 1);
    const auto input = OIIO::ImageInput::open(path.string(), &hints);
    if (!input)
        throw read_error(path, first_line(OIIO::geterror(), "no picture that OpenImageIO knows"));
    const OIIO::ImageSpec spec = input->spec();
    check_spec(path, spec);

    Image image{
        .size = {spec.width, spec.height}, .channels = std::min(spec.nchannels, 4), .pixels = {}};
    const std::size_t values = static_cast<std::size_t>(spec.width) *
                               static_cast<std::size_t>(spec.height) *
                               static_cast<std::size_t>(image.channels);
    // The reader of TIFF marks straight alpha; those of other 8-bit formats obey the hint or have
    // no other.
    const bool multiplied = spec.get_int_attribute(straight_alpha) == 0 &&
                            (is_linear(spec) || std::string_view(input->format_name()) == "tiff");
    const auto read = [&](OIIO::TypeDesc type, void* data) {
        if (!input->read_image(0, 0, 0, image.channels, type, data))
            throw read_error(path, first_line(input->geterror(), "it is damaged or truncated"));
    };
    try {
        if (is_linear(spec)) {
            std::vector<float> linear(values);
            read(OIIO::TypeDesc::FLOAT, linear.data());
            image.pixels = from_linear(linear, image.channels, multiplied);
        } else {
            image.pixels.resize(values);
            read(OIIO::TypeDesc::UINT8, image.pixels.data());
            if (multiplied) divide_by_alpha(image.pixels, image.channels);
        }
    } catch (const std::bad_alloc&) {
        throw read_error(path, "not enough memory");
    }
    return image;
}

void write_image(const std::filesystem::path& path, const Image& image) {
    check_image(path, image);
    const auto output = output_for(path);
    AtomicFile file(path); // before the work of encoding
    try {
        file.commit(encode(*output, path, output->supports("alpha") ? image : over_white(image)));
    } catch (const std::bad_alloc&) {
        throw write_error(path, "not enough memory");
    }
}

void check_image_path(const std::filesystem::path& path) {
    output_for(path);
    const AtomicFile probe(path);
}

} // namespace lineatlas
