#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "io/image_writer.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"

namespace fs = std::filesystem;
using lineatlas::check_image_path;
using lineatlas::FileError;
using lineatlas::Image;
using lineatlas::ImageWriter;
using lineatlas::Pixels;
using lineatlas::read_image;
using lineatlas::write_image;

namespace {

class ImageIo : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_image_io_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_))
            found.push_back(entry.path().filename().string());
        return found;
    }

    fs::path folder_;
};

template <typename Call>
std::string error_of(Call call) {
    try {
        call();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
        return error.what();
    }
    ADD_FAILURE() << "no FileError";
    return {};
}

testing::AssertionResult has(std::string_view text, std::string_view part) {
    if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << text << "\" lacks \"" << part << '"';
}

/// A gradient in both directions with every alpha from 0 up.
Image gradient(int channels, glm::ivec2 size = {64, 48}) {
    Image image{.size = size, .channels = channels, .pixels = {}};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < channels; ++c)
                image.pixels.push_back(
                    static_cast<std::uint8_t>((x * 4 + y * (c + 1) + 20 * c) % 256));
    return image;
}

Pixels pixels_of(const Image& image) {
    return {.size = image.size,
            .channels = image.channels,
            .bits = 8,
            .premultiplied = false,
            .values = std::as_bytes(std::span{image.pixels})};
}

int largest_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    int largest = 0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
        largest = std::max(largest, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
    return largest;
}

} // namespace

// This test must be the first one. Once the module is loaded here, its libraries have threads, and
// no process is started.
TEST_F(ImageIo, AWriterIsLikeWriteImage) {
    for (const bool own_process : {true, false}) {
        if (!own_process) write_image(folder_ / "loads.png", gradient(1));
        const Image image = gradient(4, {300, 200}); // more than a socket holds
        const ImageWriter unused;
        ImageWriter writer;
        const auto write_gone = [&] {
            writer.write(folder_ / "gone" / "a.png", pixels_of(image));
            writer.finish();
        };
        EXPECT_TRUE(has(error_of(write_gone), "its folder does not exist"));
        for (const char* name : {"a.png", "b.png"}) writer.write(folder_ / name, pixels_of(image));
        EXPECT_TRUE(writer.is_whole(folder_ / "b.png", image.size));
        EXPECT_FALSE(writer.is_whole(folder_ / "b.png", {300, 201}));
        EXPECT_FALSE(writer.is_whole(folder_ / "none.png", image.size));
        { ImageWriter().write(folder_ / "c.png", pixels_of(image)); }
        { // never completed
            ImageWriter broken;
            broken.begin(folder_ / "d.png", pixels_of(image));
            broken.append(pixels_of(image).values.first(1000));
        }
        EXPECT_FALSE(fs::exists(folder_ / "d.png"));
        writer.begin(folder_ / "d.png", pixels_of(image));
        for (std::size_t row = 0; row < 200; ++row) {
            writer.append(pixels_of(image).values.subspan(row * 1200, 1200));
        }
        writer.finish();
        for (const char* name : {"a.png", "b.png", "c.png", "d.png"}) {
            EXPECT_EQ(largest_difference(read_image(folder_ / name), image), 0) << name;
            fs::remove(folder_ / name);
        }
    }
}

TEST_F(ImageIo, NothingIsWrittenOfAPictureThatIsGivenUp) {
    const fs::path first = folder_ / "given_up.png", second = folder_ / "next.png";
    ImageWriter writer;
    const std::vector<std::byte> row(40), all(400);
    const Pixels empty{.size = {40, 10}, .channels = 1};
    Pixels whole = empty;
    whole.values = all;
    writer.begin(first, empty);
    writer.append(row);
    writer.abandon();
    writer.write(second, whole);
    writer.finish();
    EXPECT_FALSE(fs::exists(first));
    EXPECT_TRUE(writer.is_whole(second, {40, 10}));
}

TEST_F(ImageIo, APictureCutShortIsNotWhole) {
    ImageWriter writer;
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr", "a.bmp"}) {
        const fs::path path = folder_ / name;
        writer.write(path, pixels_of(gradient(3, {200, 150})));
        EXPECT_TRUE(writer.is_whole(path, {200, 150})) << name;
        const auto size = fs::file_size(path);
        for (const auto part : {size - 40, size / 2, size / 10}) {
            fs::resize_file(path, part);
            EXPECT_FALSE(writer.is_whole(path, {200, 150})) << name << " " << part;
        }
    }
}

TEST_F(ImageIo, PngAndTiffKeepEveryValue) {
    for (const char* name : {"a.png", "a.PNG", "a.tif", "a.tiff"})
        for (int channels = 1; channels <= 4; ++channels) {
            const Image image = gradient(channels);
            write_image(folder_ / name, image);
            const Image back = read_image(folder_ / name);
            EXPECT_EQ(back.size, image.size);
            EXPECT_EQ(back.channels, channels) << name;
            EXPECT_EQ(largest_difference(back, image), 0) << name << ' ' << channels;
        }
}

TEST_F(ImageIo, ExrKeepsOpaqueColoursThroughLinearLight) {
    for (const int channels : {1, 3, 4}) {
        Image image = gradient(channels);
        if (channels == 4)
            for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
        write_image(folder_ / "a.exr", image);
        const Image back = read_image(folder_ / "a.exr");
        EXPECT_EQ(back.channels, channels);
        EXPECT_LE(largest_difference(back, image), 1) << channels;
    }
}

TEST_F(ImageIo, ExrKeepsHalfTransparentColours) {
    Image image{.size = {2, 1}, .channels = 4, .pixels = {200, 100, 50, 128, 10, 20, 30, 64}};
    write_image(folder_ / "a.exr", image);
    EXPECT_LE(largest_difference(read_image(folder_ / "a.exr"), image), 1);
}

TEST_F(ImageIo, JpegGetsThePictureOverWhite) {
    Image image{.size = {16, 16}, .channels = 4, .pixels = {}};
    for (int i = 0; i < 256; ++i) image.pixels.insert(image.pixels.end(), {0, 0, 0, 0});
    write_image(folder_ / "a.jpg", image);
    const Image back = read_image(folder_ / "a.jpg");
    EXPECT_EQ(back.channels, 3);
    EXPECT_GE(*std::min_element(back.pixels.begin(), back.pixels.end()), 254);

    for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 128;
    write_image(folder_ / "a.jpeg", image);
    EXPECT_NEAR(read_image(folder_ / "a.jpeg").pixels[0], 127, 2);

    write_image(folder_ / "grey.jpg", gradient(2));
    EXPECT_EQ(read_image(folder_ / "grey.jpg").channels, 1);
}

TEST_F(ImageIo, ReplacesAFileAndLeavesNothingBeside) {
    write_image(folder_ / "a.png", gradient(3));
    write_image(folder_ / "a.png", gradient(1, {5, 7}));
    EXPECT_EQ(read_image(folder_ / "a.png").size, glm::ivec2(5, 7));
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

TEST_F(ImageIo, WritesThroughALink) {
    fs::create_directory(folder_ / "real");
    write_image(folder_ / "real" / "a.png", gradient(1));
    fs::create_symlink(folder_ / "real" / "a.png", folder_ / "link.png");
    write_image(folder_ / "link.png", gradient(1, {3, 3}));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
    EXPECT_EQ(read_image(folder_ / "real" / "a.png").size, glm::ivec2(3, 3));
}

TEST_F(ImageIo, WritesIntoTheCurrentFolderAndLongNames) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    const std::string long_name = std::string(240, 'n').append(".png");
    write_image("plain.png", gradient(1));
    write_image(long_name, gradient(1));
    fs::current_path(before);
    EXPECT_EQ(names().size(), 2U);
}

TEST_F(ImageIo, PathsThatCannotBeWrittenAreFoundBeforehandAndAtWriting) {
    fs::create_directory(folder_ / "folder.png");
    std::ofstream(folder_ / "file") << 'x';
    const std::pair<fs::path, const char*> cases[] = {
        {folder_ / "a.xyz", "unknown picture type \".xyz\"; try .png"},
        {folder_ / "a", "has no extension"},
        {folder_ / "none" / "a.png", "its folder does not exist"},
        {folder_ / "file" / "a.png", "its folder"},
        {folder_ / "folder.png", "it is a folder"},
    };
    for (const auto& [path, cause] : cases) {
        EXPECT_TRUE(has(error_of([&] { check_image_path(path); }), cause));
        const std::string message = error_of([&] { write_image(path, gradient(4)); });
        EXPECT_TRUE(has(message, "cannot write \"" + path.string() + "\": "));
        EXPECT_TRUE(has(message, cause));
    }
    EXPECT_EQ(names().size(), 2U) << "nothing is left behind";
    EXPECT_NO_THROW(check_image_path(folder_ / "good.exr"));
    EXPECT_EQ(names().size(), 2U) << "looking leaves nothing behind";
}

TEST_F(ImageIo, ReadOnlyFolderIsFoundBeforehand) {
    // Nobody can make a file in /proc. Permission bits would not stop the superuser.
    if (!fs::is_directory("/proc/self")) GTEST_SKIP() << "no /proc on this system";
    EXPECT_TRUE(
        has(error_of([] { check_image_path("/proc/self/a.png"); }), "cannot be written to"));
    if (::geteuid() == 0) return;
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_TRUE(
        has(error_of([&] { check_image_path(folder_ / "a.png"); }), "cannot be written to"));
    fs::permissions(folder_, fs::perms::owner_all);
    EXPECT_TRUE(names().empty());
}

TEST_F(ImageIo, ADiskThatFillsUpLeavesTheOldFile) {
    write_image(folder_ / "a.bmp", gradient(3, {8, 8}));
    for (const char* name : {"a.bmp", "b.png", "c.exr", "d.tif", "e.jpg"}) {
        Image image = gradient(4, {400, 400});
        std::uint32_t noise = 1; // incompressible
        for (std::uint8_t& value : image.pixels)
            value = static_cast<std::uint8_t>((noise = noise * 1664525U + 1013904223U) >> 24U);
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        rlimit small = before;
        small.rlim_cur = 4096;
        setrlimit(RLIMIT_FSIZE, &small);
        std::string message;
        try {
            write_image(folder_ / name, image);
        } catch (const FileError& error) {
            message = error.what();
        }
        setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_TRUE(has(message, "cannot write")) << name;
    }
    EXPECT_EQ(names(), std::vector<std::string>{"a.bmp"});
    EXPECT_EQ(read_image(folder_ / "a.bmp").size, glm::ivec2(8, 8));
}

TEST_F(ImageIo, RefusesPicturesThatMakeNoSense) {
    Image image = gradient(3);
    image.pixels.pop_back();
    EXPECT_TRUE(has(error_of([&] { write_image(folder_ / "a.png", image); }), "makes no sense"));
    EXPECT_TRUE(has(error_of([&] { write_image(folder_ / "a.png", Image{}); }), "0 x 0"));
    EXPECT_TRUE(names().empty());
}

TEST_F(ImageIo, ReadErrorsNameTheFile) {
    EXPECT_TRUE(has(error_of([&] { read_image(folder_ / "none.png"); }), "no such file"));
    EXPECT_TRUE(has(error_of([&] { read_image(folder_); }), "it is a folder"));
    std::ofstream(folder_ / "empty.png").close();
    EXPECT_TRUE(has(error_of([&] { read_image(folder_ / "empty.png"); }), "empty"));
    std::ofstream(folder_ / "text.png") << "hello, this is no picture at all";
    EXPECT_TRUE(has(error_of([&] { read_image(folder_ / "text.png"); }), "text.png"));
    std::ofstream(folder_ / "text.xyz") << "hello";
    EXPECT_TRUE(has(error_of([&] { read_image(folder_ / "text.xyz"); }), "text.xyz"));

    write_image(folder_ / "whole.png", gradient(4, {200, 200}));
    std::ifstream stream(folder_ / "whole.png", std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    std::ofstream(folder_ / "half.png", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    EXPECT_TRUE(has(error_of([&] { read_image(folder_ / "half.png"); }), "half.png"));
}
