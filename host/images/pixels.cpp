#include "pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lineatlas {

namespace {

bool has_alpha(int channels) {
    return channels == 2 || channels == 4;
}

/// IEC 61966-2-1.
float decode_srgb(float coded) {
    return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F);
}

float encode_srgb(float linear) {
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

std::uint8_t to_byte(float value) {
    if (!(value > 0.0F)) return 0; // NaN included
    return static_cast<std::uint8_t>(std::min(value, 1.0F) * 255.0F + 0.5F);
}

const std::array<float, 256>& decoded_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = decode_srgb(static_cast<float>(i) / 255.0F);
        return values;
    }();
    return table;
}

} // namespace

std::vector<float> to_linear(const Image& image) {
    const std::array<float, 256>& decoded = decoded_bytes();
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t colors = has_alpha(image.channels) ? channels - 1 : channels;
    std::vector<float> linear(image.pixels.size());
    for (std::size_t pixel = 0; pixel < linear.size(); pixel += channels) {
        float alpha = 1.0F;
        if (colors < channels) {
            alpha = static_cast<float>(image.pixels[pixel + colors]) / 255.0F;
            linear[pixel + colors] = alpha;
        }
        for (std::size_t c = 0; c < colors; ++c)
            linear[pixel + c] = decoded[image.pixels[pixel + c]] * alpha;
    }
    return linear;
}

std::vector<std::uint8_t> from_linear(std::span<const float> pixels, int channels,
                                      bool multiplied) {
    const auto stride = static_cast<std::size_t>(channels);
    const std::size_t colors = has_alpha(channels) ? stride - 1 : stride;
    std::vector<std::uint8_t> bytes(pixels.size());
    for (std::size_t pixel = 0; pixel < bytes.size(); pixel += stride) {
        float scale = 1.0F;
        if (colors < stride) {
            const float alpha = pixels[pixel + colors];
            bytes[pixel + colors] = to_byte(alpha);
            if (multiplied && alpha > 0.0F) scale = 1.0F / alpha;
        }
        for (std::size_t c = 0; c < colors; ++c)
            bytes[pixel + c] = to_byte(encode_srgb(pixels[pixel + c] * scale));
    }
    return bytes;
}

void divide_by_alpha(std::span<std::uint8_t> pixels, int channels) {
    if (!has_alpha(channels)) return;
    const auto stride = static_cast<std::size_t>(channels);
    for (std::size_t pixel = 0; pixel < pixels.size(); pixel += stride) {
        const unsigned alpha = pixels[pixel + stride - 1];
        if (alpha == 0) continue;
        for (std::size_t c = 0; c + 1 < stride; ++c)
            pixels[pixel + c] = static_cast<std::uint8_t>(
                std::min(255U, (pixels[pixel + c] * 255U + alpha / 2) / alpha));
    }
}

Image over_white(const Image& image) {
    if (!has_alpha(image.channels)) return image;
    const auto channels = static_cast<std::size_t>(image.channels);
    Image paper{.size = image.size, .channels = image.channels - 1, .pixels = {}};
    paper.pixels.reserve(image.pixels.size() / channels * (channels - 1));
    for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += channels) {
        const unsigned alpha = image.pixels[pixel + channels - 1];
        for (std::size_t c = 0; c + 1 < channels; ++c)
            paper.pixels.push_back(static_cast<std::uint8_t>(
                (image.pixels[pixel + c] * alpha + 255U * (255U - alpha) + 127U) / 255U));
    }
    return paper;
}

} // namespace lineatlas
