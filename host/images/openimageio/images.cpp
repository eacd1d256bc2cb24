#include "io/image_module.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "images/pixels.hpp"

namespace lineatlas::images {

namespace {

constexpr const char* straight_alpha = "oiio:UnassociatedAlpha";

/// OpenImageIO's messages may have several lines and trailing ends of line.
std::runtime_error refusal(const std::string& message, const char* otherwise) {
    const std::string line = message.substr(0, message.find_first_of("\r\n"));
    return std::runtime_error(line.empty() ? otherwise : line);
}

bool is_linear(const OIIO::ImageSpec& spec) {
    return spec.format == OIIO::TypeDesc::HALF || spec.format == OIIO::TypeDesc::FLOAT ||
           spec.format == OIIO::TypeDesc::DOUBLE;
}

/// The writer for an extension; null if none writes into memory.
std::unique_ptr<OIIO::ImageOutput> output_for(const std::string& extension) {
    // Looked up by extension alone, because a whole name could be taken for the address of a
    // plugin.
    auto output = OIIO::ImageOutput::create("picture" + extension);
    if (output && output->supports("ioproxy")) return output;
    OIIO::geterror(); // otherwise it is printed when the program ends
    return nullptr;
}

OIIO::TypeDesc file_type(bool linear, int bits) {
    if (linear) return bits == 32 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF;
    return bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
}

OIIO::ImageSpec spec_of(const Pixels& pixels, const ImageSettings& settings, bool linear) {
    OIIO::ImageSpec spec(pixels.size.x, pixels.size.y, pixels.channels,
                         file_type(linear, settings.bits));
    if (pixels.channels == 2) spec.alpha_channel = 1;
    if (!linear) spec.attribute(straight_alpha, 1);
    // Level 6, the default, takes 1.6 times as long for line drawings and saves a sixth.
    spec.attribute("png:compressionLevel", 2);
    spec.attribute("tiff:zipquality", 2);
    spec.attribute("CompressionQuality", 95); // JPEG: lower ones put rings around strokes
    if (settings.dpi > 0) {
        spec.attribute("XResolution", settings.dpi);
        spec.attribute("YResolution", settings.dpi);
        spec.attribute("ResolutionUnit", "in");
    }
    if (!settings.description.empty()) {
        spec.attribute("ImageDescription", settings.description);
        spec.attribute("Software", "lineatlas " LINEATLAS_VERSION);
    }
    return spec;
}

/// Writes into memory, because several of OpenImageIO's writers do not notice a full disk, and that
/// of JPEG ends the program.
std::vector<unsigned char> encode_by(OIIO::ImageOutput& output, const std::filesystem::path& path,
                                     const Pixels& pixels, const ImageSettings& settings) {
    const std::string_view format = output.format_name();
    const bool linear = format == "openexr" || format == "hdr";
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory(encoded);
    const auto check = [&](bool done) {
        if (!done) throw refusal(output.geterror(), "OpenImageIO refuses it");
    };
    check(output.set_ioproxy(&memory));
    check(output.open(path.filename().string(), spec_of(pixels, settings, linear)));
    if (linear) {
        check(output.write_image(OIIO::TypeDesc::FLOAT, to_linear(pixels).data()));
    } else {
        check(output.write_image(pixels.bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8,
                                 pixels.values.data()));
    }
    check(output.close());
    return encoded;
}

/// Rejects pictures that would not fit into an Image or into memory.
void check_spec(const OIIO::ImageSpec& spec) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0)
        throw std::runtime_error("it holds no pixels");
    if (spec.depth > 1) throw std::runtime_error("it is a volume, not a picture");
    check_pixel_count(spec.width, spec.height);
}

bool can_write(const std::string& extension) {
    return output_for(extension) != nullptr;
}

/// Opens a picture by one format, if its reader reads from memory. Other readers are left out:
/// those of videos, and those that need several files.
bool open_as(std::string_view format, const std::string& name, OIIO::Filesystem::IOProxy& memory,
             std::unique_ptr<OIIO::ImageInput>& input) {
    input = OIIO::ImageInput::create(OIIO::string_view{format.data(), format.size()});
    if (!input || !input->supports("ioproxy")) return false;
    OIIO::ImageSpec hints, ignored;
    hints.attribute(straight_alpha, 1);
    memory.seek(0);
    return input->set_ioproxy(&memory) && input->open(name, ignored, hints);
}

/// Opens a picture as its name says, or else by its content, because names are often wrong.
std::unique_ptr<OIIO::ImageInput> open_in(OIIO::Filesystem::IOProxy& memory,
                                          const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    std::unique_ptr<OIIO::ImageInput> input;
    // "png", not "a.png": a whole name makes OpenImageIO look for such a file.
    const std::string extension = path.extension().string();
    if (!extension.empty() && open_as(extension.substr(1), name, memory, input)) return input;
    const std::string cause = input ? input->geterror() : "";
    std::istringstream formats{OIIO::get_string_attribute("input_format_list")};
    for (std::string format; std::getline(formats, format, ',');)
        if (open_as(format, name, memory, input)) return input;
    OIIO::geterror(); // otherwise it is printed when the program ends
    throw refusal(cause, "no picture that OpenImageIO reads from memory");
}

Image decode(const std::filesystem::path& path, std::string_view file) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(file.data()), file.size()); // reads only
    const auto input = open_in(memory, path);
    const OIIO::ImageSpec spec = input->spec();
    check_spec(spec);

    Image image{
        .size = {spec.width, spec.height}, .channels = std::min(spec.nchannels, 4), .pixels = {}};
    const std::size_t values = static_cast<std::size_t>(spec.width) *
                               static_cast<std::size_t>(spec.height) *
                               static_cast<std::size_t>(image.channels);
    // The reader of TIFF marks straight alpha; those of other 8-bit formats obey the hint or have
    // no other.
    const bool multiplied = spec.get_int_attribute(straight_alpha) == 0 &&
                            (is_linear(spec) || std::string_view(input->format_name()) == "tiff");
    const auto read_to = [&](OIIO::TypeDesc type, void* data) {
        if (!input->read_image(0, 0, 0, image.channels, type, data))
            throw refusal(input->geterror(), "it is damaged or truncated");
    };
    if (is_linear(spec)) {
        std::vector<float> linear(values);
        read_to(OIIO::TypeDesc::FLOAT, linear.data());
        image.pixels = from_linear(linear, image.channels, multiplied);
    } else {
        image.pixels.resize(values);
        read_to(OIIO::TypeDesc::UINT8, image.pixels.data());
        if (multiplied) divide_by_alpha(image.pixels, image.channels);
    }
    return image;
}

std::vector<unsigned char> encode(const std::filesystem::path& path, const Pixels& pixels,
                                  const ImageSettings& settings) {
    const auto output = output_for(path.extension().string());
    if (!output) throw std::runtime_error("this build of OpenImageIO does not write its type");
    Pixels given = pixels;
    std::vector<std::byte> divided, opaque;
    if (given.premultiplied && !is_opaque(given)) {
        divided = straight(given);
        given.values = divided;
    }
    if (has_alpha(given.channels) && !output->supports("alpha")) {
        opaque = over_white(given);
        --given.channels;
        given.values = opaque;
    }
    return encode_by(*output, path, given, settings);
}

} // namespace

} // namespace lineatlas::images

extern "C" const lineatlas::images::Module lineatlas_images_3{.can_write =
                                                                  lineatlas::images::can_write,
                                                              .decode = lineatlas::images::decode,
                                                              .encode = lineatlas::images::encode};
