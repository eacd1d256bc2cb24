#include "pictures.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "lineatlas/error.hpp"
#include "lineatlas/image.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

Json compare(const Image& one, const Image& other) {
    if (one.size != other.size || one.channels != other.channels) return nullptr;
    constexpr int clear = 255 / 20;
    const auto channels = static_cast<std::size_t>(one.channels);
    std::uint64_t differ = 0, differ_clearly = 0;
    for (std::size_t i = 0; i < one.pixels.size(); i += channels) {
        int most = 0;
        for (std::size_t k = i; k < i + channels; ++k)
            most = std::max(most, std::abs(int{one.pixels[k]} - int{other.pixels[k]}));
        differ += most > 0 ? 1 : 0;
        differ_clearly += most > clear ? 1 : 0;
    }
    return {{"pixels", one.pixels.size() / channels},
            {"differ", differ},
            {"differ_clearly", differ_clearly}};
}

} // namespace

Json compare_pictures(const std::filesystem::path& one, const std::filesystem::path& other) {
    if (!std::filesystem::exists(one) || !std::filesystem::exists(other)) return nullptr;
    try {
        return compare(read_image(one), read_image(other));
    } catch (const Error&) {
        return nullptr; // broken
    }
}

} // namespace lineatlas::bench
