// The state in the kernel of every thread of processes that work on other people's files: for every
// format, and including threads that libraries start when they are loaded.

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "children.hpp"
#include "io/confinement.hpp"
#include "io/extension.hpp"
#include "io/image_codec.hpp"
#include "io/image_encoder.hpp"
#include "io/image_writer.hpp"
#include "io/mesh_source.hpp"
#include "io/reader_process.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/io.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

/// Reads a file, reports it, and waits until the test has looked.
template <class Read>
ReaderKind::Parse stay_after(Read read) {
    return [read](ReaderOutput& output) mutable {
        try {
            read();
        } catch (const FileError&) {
            // Refused files serve the test as well.
        }
        output.value(reader::Answer::read);
        char end = 0;
        [[maybe_unused]] const ssize_t none = ::read(reader::socket, &end, 1);
    };
}

ReaderKind::Parse read_model(const fs::path& path, std::string_view) {
    return stay_after(
        [source = read_mesh_source(path)]() mutable { parse_mesh(std::move(source)); });
}

ReaderKind::Parse read_picture(const fs::path& path, std::string_view) {
    SourceFile file = read_source(path);
    image_module(type_by_content(file.bytes));
    return stay_after([file = std::move(file)] { decode_image(file); });
}

constexpr std::array kinds{ReaderKind{"model", read_model}, ReaderKind{"picture", read_picture}};

std::string line_of(const fs::path& status, std::string_view name) {
    std::ifstream file{status};
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name)) return line.substr(line.find_last_of('\t') + 1);
    return "none";
}

void expect_confined(int process, const std::string& what) {
    const fs::path threads = "/proc/" + std::to_string(process) + "/task";
    std::size_t count = 0;
    for (const fs::path& thread : fs::directory_iterator{threads}) {
        ++count;
        EXPECT_EQ(line_of(thread / "status", "NoNewPrivs:"), "1") << what;
        if (!offered_confinement().system_calls) continue;
        EXPECT_EQ(line_of(thread / "status", "Seccomp:"), "2") << what;
    }
    EXPECT_GT(count, 0U) << what;
}

class ReaderThreads : public testing::Test {
  protected:
    void SetUp() override {
        if (reader::sanitized) GTEST_SKIP() << "a build with sanitizers is not confined";
    }
    fs::path write(const std::string& name, std::string_view content) const {
        const fs::path path = folder_.path() / name;
        std::ofstream{path, std::ios::binary} << content;
        return path;
    }
    TemporaryFolder folder_;
};

TEST_F(ReaderThreads, OfModelsAreConfined) {
    // The files have no more than what selects the reader, because only its loaded libraries
    // matter.
    for (const std::string extension :
         {"obj", "ply", "stl", "off", "om", "gltf", "glb", "3mf", "step", "iges", "brep"}) {
        const fs::path path = write("model." + extension, "something\n");
        try {
            const ReaderProcess process{"model", path, {}};
            expect_confined(process.id(), extension);
        } catch (const FileError& error) { // this build lacks its module
            EXPECT_NE(std::string_view{error.what()}.find("cannot load"), std::string_view::npos)
                << error.what();
        }
    }
}

TEST_F(ReaderThreads, OfPicturesAreConfined) {
    const std::vector<std::byte> values(12);
    const Pixels pixels{.size = {2, 2}, .channels = 3, .values = values};
    // This process has no library of the module and no thread of one.
    ImageWriter writer{"picture.exr"};
    for (const std::string extension : {"png", "jpg", "tif", "exr", "bmp"}) {
        const fs::path path = folder_.path() / ("picture." + extension);
        writer.write(path, pixels);
        writer.finish();
        const ReaderProcess reading{"picture", path, {}};
        expect_confined(reading.id(), "reading " + extension);
    }
}

TEST_F(ReaderThreads, OfWhatEncodesPicturesAreConfined) {
    const std::vector<std::byte> values(12);
    for (const std::string extension : {"png", "jpg", "tif", "exr"}) {
        const std::string name = "picture." + extension;
        ImageEncoder encoder{type_by_name(name), {}};
        PictureTask task{.numbers = {}, .path = name, .description = {}};
        task.numbers = {.kind = PictureTask::Kind::encode,
                        .width = 2,
                        .height = 2,
                        .channels = 3,
                        .bits = 8,
                        .premultiplied = 0,
                        .file_bits = 0,
                        .dpi = 0,
                        .bytes = values.size()};
        encoder.begin(task);
        encoder.append(values);
        EXPECT_FALSE(encoder.finish().empty()) << extension;
        expect_confined(children_of(::getpid()).at(0), "encoding " + extension);
    }
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv, lineatlas::test::kinds))
        return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
