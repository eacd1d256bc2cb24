// Reads the picture of a pen's mark. The checksums of its chunks are corrected, because readers
// refuse nearly every changed picture by them.
#include <zlib.h>

#include "fuzz.hpp"
#include "lineatlas/io.hpp"

namespace {

std::uint32_t number_at(std::span<const std::uint8_t> bytes) {
    return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
           std::uint32_t{bytes[2]} << 8U | bytes[3];
}

void mend(std::vector<std::uint8_t>& file) {
    constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    if (file.size() < signature.size()) return;
    std::copy(signature.begin(), signature.end(), file.begin());
    constexpr std::size_t around = 12; // length and name before the data, a checksum after
    for (std::size_t at = signature.size(); at + around <= file.size();) {
        const std::size_t length = number_at(std::span{file}.subspan(at));
        if (length > file.size() - at - around) return;
        const auto sum = static_cast<std::uint32_t>(
            crc32(0, file.data() + at + 4, static_cast<unsigned>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += around + length;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    std::vector<std::uint8_t> bytes{data, data + size};
    mend(bytes);
    const std::filesystem::path file = fuzz::put_file(".png", bytes);
    try {
        const Image image = read_image(file);
        fuzz::expect(image.size.x > 0 && image.size.y > 0, "a picture without pixels");
        fuzz::expect(image.pixels.size() == static_cast<std::size_t>(image.size.x) *
                                                static_cast<std::size_t>(image.size.y) *
                                                static_cast<std::size_t>(image.channels),
                     "pixels are missing");
    } catch (const FileError& error) {
        fuzz::expect_good_refusal(error, file);
    }
    return 0;
}
