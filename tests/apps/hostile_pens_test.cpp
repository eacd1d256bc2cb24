// The tool with pictures of pens that are broken, odd or made to use up memory.

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/reader_protocol.hpp"
#include "lineatlas/io.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

std::string big_endian(std::uint32_t number) {
    return {static_cast<char>(number >> 24U), static_cast<char>(number >> 16U),
            static_cast<char>(number >> 8U), static_cast<char>(number)};
}

/// The checksum of ISO 3309, bit by bit.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t sum = 0xFFFFFFFF;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~sum;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
           big_endian(checksum(type + data));
}

/// A PNG file of a few bytes that claims this size.
std::string png_of_size(std::uint32_t width, std::uint32_t height, char bits = 8, char color = 6) {
    const std::string header =
        big_endian(width) + big_endian(height) + bits + color + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", "x") + chunk("IEND", "");
}

/// Readers are silent. In builds with sanitizers they may print (reader_process.cpp), and libpng
/// does.
std::string without_words_of_libpng(const std::string& output) {
    if (!reader::sanitized) return output;
    return std::regex_replace(output, std::regex{"libpng error: [^\n]*\n"}, "");
}

class HostilePens : public Tool {
  protected:
    std::string command(const std::string& name, const std::string& options = "") const {
        return "draw --scene clevis --size 64x48 --width 6 -o " + path("out.png") + " --pen " +
               path(name) + " " + options;
    }

    void expect_one_line(const std::string& name, const std::string& words,
                         const std::string& options = "") {
        Result result = run(command(name, options));
        result.output = without_words_of_libpng(result.output);
        EXPECT_EQ(result.exit_code, 1) << name << "\n" << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
        EXPECT_EQ(result.output.find("lineatlas: cannot read \"" + path(name) + "\": "), 0U)
            << result.output;
        EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
        EXPECT_EQ(result.output.find("its reader"), std::string::npos) << result.output;
    }

    void write_picture(const std::string& name, glm::ivec2 size, int channels, int bits = 8) const {
        const std::vector<std::byte> values(static_cast<std::size_t>(size.x) *
                                            static_cast<std::size_t>(size.y) *
                                            static_cast<std::size_t>(channels * bits / 8));
        write_image(
            path(name),
            {.size = size,
             .channels = channels,
             .bits = bits,
             .premultiplied = false,
             .values = values},
            {.bits = bits == 16 && !name.ends_with(".exr") ? 16 : 0, .dpi = 0, .description = {}});
    }
};

TEST_F(HostilePens, ImagesOfImpossibleSizeAreRefused) {
    write("bomb.png", png_of_size(60'000, 60'000));
    expect_one_line("bomb.png", "its 60000 x 60000 pixels are more than 2^28");
    write("long.png", png_of_size(1'000'000, 1'000'000));
    expect_one_line("long.png", "");
    write("most.png", png_of_size(0x7FFFFFFF, 0x7FFFFFFF));
    expect_one_line("most.png", "");
    write("negative.png", png_of_size(0xFFFFFFFF, 0xFFFFFFFF));
    expect_one_line("negative.png", "");
    write("nothing.png", png_of_size(0, 10));
    expect_one_line("nothing.png", "");
    write("promise.png", png_of_size(8192, 8192));
    expect_one_line("promise.png", "");
}

TEST_F(HostilePens, LimitsOfMemoryAndTimeHoldForImages) {
    write_picture("large.png", {6000, 6000}, 4); // some KB, 144 MB of pixels
    ASSERT_LT(fs::file_size(path("large.png")), 1'000'000U);
    // A sanitizer reserves terabytes, so builds with it have no limit.
    if (!reader::sanitized)
        expect_one_line("large.png", "needs more than 0.1 GiB of memory; --read-memory allows more",
                        "--read-memory 0.1");
    expect_one_line("large.png", "took more than 0.001 s; --read-seconds allows more",
                    "--read-seconds 0.001");
}

TEST_F(HostilePens, DamagedImagesAreRefused) {
    write_picture("whole.png", {64, 16}, 4);
    std::ifstream file{path("whole.png"), std::ios::binary};
    const std::string whole{std::istreambuf_iterator<char>{file}, {}};
    for (const std::size_t size : {4UL, 20UL, 40UL, whole.size() / 2, whole.size() - 30}) {
        write("cut.png", whole.substr(0, size));
        expect_one_line("cut.png", "");
    }
    for (const auto& [name, text] : {std::pair{"empty.png", std::string{}},
                                     {"text.png", std::string{"no picture"}},
                                     {"zeros.tif", std::string(1000, '\0')},
                                     {"text.exr", std::string{"no picture"}},
                                     {"text.unknown", std::string{"no picture"}},
                                     {"bits.png", png_of_size(8, 8, 3)},
                                     {"color.png", png_of_size(8, 8, 8, 5)}}) {
        write(name, text);
        expect_one_line(name, "");
    }
}

TEST_F(HostilePens, UnusualImagesAreTaken) {
    write_picture("one.png", {1, 1}, 1);
    write_picture("long.png", {5000, 1}, 3);
    write_picture("grey.png", {30, 10}, 2);
    write_picture("deep.png", {30, 10}, 4, 16);
    write_picture("deep.tif", {30, 10}, 1, 16);
    write_picture("light.exr", {30, 10}, 4);
    write_picture("photo.jpg", {30, 10}, 3);
    fs::copy_file(path("photo.jpg"), path("wrong.png"));
    for (const char* name : {"one.png", "long.png", "grey.png", "deep.png", "deep.tif", "light.exr",
                             "photo.jpg", "wrong.png"}) {
        const Result result = run(command(name));
        EXPECT_EQ(result.exit_code, 0) << name << "\n" << result.output;
        EXPECT_EQ(result.output, "") << name;
    }
}

} // namespace
} // namespace lineatlas::test
