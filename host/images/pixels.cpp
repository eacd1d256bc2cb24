#include "pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace lineatlas {

namespace {

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

/// The linear light of every value of `T`.
template <class T>
const std::vector<float>& decoded_values() {
    static const std::vector<float> table = [] {
        constexpr std::size_t largest = std::numeric_limits<T>::max();
        std::vector<float> values(largest + 1);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = decode_srgb(static_cast<float>(i) / largest);
        return values;
    }();
    return table;
}

template <class T>
std::span<const T> values_of(const Pixels& pixels) {
    return {reinterpret_cast<const T*>(pixels.values.data()), pixels.values.size() / sizeof(T)};
}

template <class T>
std::vector<float> to_linear(std::span<const T> values, std::size_t channels, std::size_t colors) {
    const std::vector<float>& decoded = decoded_values<T>();
    std::vector<float> linear(values.size());
    for (std::size_t pixel = 0; pixel < linear.size(); pixel += channels) {
        float alpha = 1.0F;
        if (colors < channels) {
            alpha = static_cast<float>(values[pixel + colors]) / std::numeric_limits<T>::max();
            linear[pixel + colors] = alpha;
        }
        for (std::size_t c = 0; c < colors; ++c)
            linear[pixel + c] = decoded[values[pixel + c]] * alpha;
    }
    return linear;
}

template <class T>
bool is_opaque(std::span<const T> values, std::size_t channels) {
    for (std::size_t alpha = channels - 1; alpha < values.size(); alpha += channels)
        if (values[alpha] != std::numeric_limits<T>::max()) return false;
    return true;
}

template <class T>
void divide_by_alpha(std::span<T> values, std::size_t channels) {
    constexpr std::uint64_t largest = std::numeric_limits<T>::max();
    for (std::size_t pixel = 0; pixel < values.size(); pixel += channels) {
        const std::uint64_t alpha = values[pixel + channels - 1];
        if (alpha == 0 || alpha == largest) continue;
        for (std::size_t c = 0; c + 1 < channels; ++c)
            values[pixel + c] = static_cast<T>(
                std::min(largest, (values[pixel + c] * largest + alpha / 2) / alpha));
    }
}

template <class T>
std::vector<std::byte> over_white(std::span<const T> values, std::size_t channels) {
    constexpr std::uint64_t largest = std::numeric_limits<T>::max();
    std::vector<std::byte> paper(values.size_bytes() / channels * (channels - 1));
    auto* next = reinterpret_cast<T*>(paper.data());
    for (std::size_t pixel = 0; pixel < values.size(); pixel += channels) {
        const std::uint64_t alpha = values[pixel + channels - 1];
        for (std::size_t c = 0; c + 1 < channels; ++c)
            *next++ = static_cast<T>(
                (values[pixel + c] * alpha + largest * (largest - alpha) + largest / 2) / largest);
    }
    return paper;
}

} // namespace

void check_pixel_count(std::int64_t width, std::int64_t height) {
    constexpr std::int64_t most = std::int64_t{1} << 28; // 16384 x 16384
    if (width * height > most)
        throw std::runtime_error("its " + std::to_string(width) + " x " + std::to_string(height) +
                                 " pixels are more than 2^28");
}

bool has_alpha(int channels) {
    return channels == 2 || channels == 4;
}

std::vector<float> to_linear(const Pixels& pixels) {
    const auto channels = static_cast<std::size_t>(pixels.channels);
    const std::size_t colors = has_alpha(pixels.channels) ? channels - 1 : channels;
    return pixels.bits == 16 ? to_linear(values_of<std::uint16_t>(pixels), channels, colors)
                             : to_linear(values_of<std::uint8_t>(pixels), channels, colors);
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
    divide_by_alpha<std::uint8_t>(pixels, static_cast<std::size_t>(channels));
}

bool is_opaque(const Pixels& pixels) {
    if (!has_alpha(pixels.channels)) return true;
    const auto channels = static_cast<std::size_t>(pixels.channels);
    return pixels.bits == 16 ? is_opaque(values_of<std::uint16_t>(pixels), channels)
                             : is_opaque(values_of<std::uint8_t>(pixels), channels);
}

std::vector<std::byte> straight(const Pixels& pixels) {
    std::vector<std::byte> values(pixels.values.begin(), pixels.values.end());
    const auto channels = static_cast<std::size_t>(pixels.channels);
    if (pixels.bits == 16)
        divide_by_alpha<std::uint16_t>({reinterpret_cast<std::uint16_t*>(values.data()),
                                        values.size() / sizeof(std::uint16_t)},
                                       channels);
    else
        divide_by_alpha<std::uint8_t>(
            {reinterpret_cast<std::uint8_t*>(values.data()), values.size()}, channels);
    return values;
}

std::vector<std::byte> over_white(const Pixels& pixels) {
    const auto channels = static_cast<std::size_t>(pixels.channels);
    return pixels.bits == 16 ? over_white(values_of<std::uint16_t>(pixels), channels)
                             : over_white(values_of<std::uint8_t>(pixels), channels);
}

} // namespace lineatlas
