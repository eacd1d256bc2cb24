// The process that encodes pictures, with a module that tries forbidden things.

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "hostile_attempts.hpp"
#include "io/confinement.hpp"
#include "io/image_writer.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/error.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

TEST(PictureProcess, IsRefusedEverythingElse) {
    if (reader::sanitized) GTEST_SKIP() << "a build with sanitizers is not confined";
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "some.file", picture = folder.path() / "a.png";
    std::ofstream{file} << "something";
    const Listener listener;
    const int secret = ::open("/etc/passwd", O_RDONLY); // without O_CLOEXEC
    ::setenv("LINEATLAS_TEST_SECRET", "password", 1);
    ::setenv("LINEATLAS_MODULE_DIR", LINEATLAS_HOSTILE_IMAGES, 1);

    ImageWriter writer;
    const std::vector<std::byte> pixel(1);
    writer.write(
        picture,
        {.size = {1, 1}, .channels = 1, .bits = 8, .premultiplied = false, .values = pixel},
        {.bits = 8,
         .dpi = 0,
         .description = std::to_string(listener.port()) + " " + file.string()});
    writer.finish();
    ::close(secret);

    const Confinement offered = offered_confinement();
    std::ifstream report{picture};
    for (const Attempt& attempt : attempts()) {
        std::string line;
        ASSERT_TRUE(std::getline(report, line));
        int error = 0, error_of_early_thread = 0;
        std::istringstream{line} >> error >> error_of_early_thread;
        ASSERT_TRUE(line.ends_with(attempt.name)) << line;
        if (!attempt.is_refused(offered.system_calls, offered.files > 0)) continue;
        EXPECT_NE(error, 0) << "it could " << attempt.name;
        EXPECT_NE(error_of_early_thread, 0) << "a thread of its could " << attempt.name;
    }
    std::string line;
    std::getline(report, line);
    EXPECT_EQ(line, "descriptors");
    std::getline(report, line);
    EXPECT_EQ(line, "environment LINEATLAS_MODULE_DIR");
}

TEST(PictureProcess, TakesNoMoreMemoryAndTimeThanAPictureNeeds) {
    using namespace std::chrono_literals;
    const TemporaryFolder folder;
    ::setenv("LINEATLAS_MODULE_DIR", LINEATLAS_HOSTILE_IMAGES, 1);
    const std::vector<std::byte> pixel(1);
    const auto write = [&](const std::string& how, ImageWriter& writer) -> std::string {
        const fs::path picture = folder.path() / (how + ".png");
        try {
            writer.write(
                picture,
                {.size = {1, 1}, .channels = 1, .bits = 8, .premultiplied = false, .values = pixel},
                {.bits = 8, .dpi = 0, .description = how});
            writer.finish();
        } catch (const FileError& error) {
            EXPECT_FALSE(fs::exists(picture));
            return error.what();
        }
        return fs::exists(picture) ? "written" : "lost";
    };
    const auto ends_with = [](const std::string& text, const std::string& end) {
        return text.ends_with(end) ? testing::AssertionSuccess()
                                   : testing::AssertionFailure() << text;
    };
    if (!reader::sanitized) {
        // A slow machine may need seconds to touch all of the memory.
        ImageWriter patient{"memory.png", {.memory = std::uint64_t{256} << 20U, .time = 60s}};
        EXPECT_TRUE(
            ends_with(write("memory", patient), "encoding it needs more than 0.25 GiB of memory"));
    }
    ImageWriter writer{"time.png", {.memory = std::uint64_t{256} << 20U, .time = 2s}};
    EXPECT_TRUE(ends_with(write("time", writer), "encoding it took more than 2 s"));
    if (reader::sanitized) return; // a sanitizer handles crashes itself, and nothing is confined
    EXPECT_TRUE(ends_with(write("crash", writer), "was ended by signal 11"));
    EXPECT_EQ(write("0 .", writer), "written"); // by another process each time
}

} // namespace
} // namespace lineatlas::test
