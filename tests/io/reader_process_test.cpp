// Files are read in separate processes, here with the worst possible readers. Each ends in one
// clear line, and leaves no process, no descriptor and no file.

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "children.hpp"
#include "io/isolated.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

[[noreturn]] void wait_for_ever() {
    for (;;) ::pause();
}

void crash(ReaderOutput&) {
    ::signal(SIGSEGV, SIG_DFL);
    ::raise(SIGSEGV);
}
void abort_it(ReaderOutput&) {
    std::abort();
}
void leave(ReaderOutput&) {
    ::_exit(3);
}
void hang(ReaderOutput&) {
    wait_for_ever();
}
void work_for_ever(ReaderOutput&) {
    for (std::atomic<unsigned> i = 0;; ++i) continue;
}
void allocate_for_ever(ReaderOutput&) {
    std::vector<std::vector<char>> all;
    for (;;) all.emplace_back(1 << 20, 'x');
}
void allocate_at_once(ReaderOutput&) {
    volatile std::size_t size = std::size_t{1} << 40U;
    std::vector<char> all(size);
}
/// Hides a lack of memory, as libraries may: the failure of `new` becomes another error.
void hide_lack_of_memory(ReaderOutput& output) {
    try {
        volatile std::size_t size = std::size_t{1} << 40U;
        std::vector<char> all(size);
    } catch (const std::bad_alloc&) {
        output.value(reader::Answer::read);
    }
}
void talk(ReaderOutput& output) {
    std::printf("this is not heard\n");
    std::fflush(stdout);
    output.value(reader::Answer::read);
    output.text("done");
}
/// Takes 16 MiB in small blocks and frees them. Reports how much went back to the system.
void churn(ReaderOutput& output) {
    const auto end_of_heap = [] { return static_cast<const char*>(::sbrk(0)); };
    const char* highest = nullptr;
    {
        std::vector<std::vector<char>> blocks;
        blocks.reserve(256); // no block stays after them
        for (int i = 0; i < 256; ++i) blocks.emplace_back(64 << 10, 'x');
        highest = end_of_heap();
    }
    output.value(reader::Answer::read);
    output.value(static_cast<std::uint64_t>(highest - end_of_heap()));
}
void refuse(ReaderOutput&) {
    throw std::runtime_error("a line\nand another");
}
void talk_nonsense(ReaderOutput& output) {
    output.value(std::uint8_t{77});
}
void promise_too_much(ReaderOutput& output) {
    output.value(reader::Answer::read);
    output.value(std::uint64_t{1} << 60U);
}
void die_halfway(ReaderOutput& output) {
    output.value(reader::Answer::read);
    output.value(std::uint64_t{100});
    std::abort();
}
void hang_halfway(ReaderOutput& output) {
    output.value(reader::Answer::read);
    output.value(std::uint64_t{100});
    wait_for_ever();
}
void never_end(ReaderOutput& output) {
    output.value(reader::Answer::read);
    for (;;) output.text(std::string(1 << 20, 'x'));
}

/// A reader that opens nothing.
template <void (*read)(ReaderOutput&)>
ReaderKind::Parse only(const fs::path&, std::string_view) {
    return read;
}

constexpr std::array kinds{
    ReaderKind{"crash", only<crash>},
    ReaderKind{"abort", only<abort_it>},
    ReaderKind{"leave", only<leave>},
    ReaderKind{"hang", only<hang>},
    ReaderKind{"work_for_ever", only<work_for_ever>},
    ReaderKind{"allocate_for_ever", only<allocate_for_ever>},
    ReaderKind{"allocate_at_once", only<allocate_at_once>},
    ReaderKind{"hide_lack_of_memory", only<hide_lack_of_memory>},
    ReaderKind{"talk", only<talk>},
    ReaderKind{"churn", only<churn>},
    ReaderKind{"refuse", only<refuse>},
    ReaderKind{"talk_nonsense", only<talk_nonsense>},
    ReaderKind{"promise_too_much", only<promise_too_much>},
    ReaderKind{"die_halfway", only<die_halfway>},
    ReaderKind{"hang_halfway", only<hang_halfway>},
    ReaderKind{"never_end", only<never_end>},
};

std::size_t open_descriptors() {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator{"/proc/self/fd"}, fs::directory_iterator{}));
}

/// True if the process is gone, or only waits to report its end.
bool is_dead(pid_t process) {
    std::ifstream file{"/proc/" + std::to_string(process) + "/stat"};
    std::string number, name, state;
    return !(file >> number >> name >> state) || state == "Z";
}

bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
    return condition();
}

class Reading : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_reader_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        file_ = write("some.file", "something");
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, std::string_view content) const {
        const fs::path path = folder_ / name;
        std::ofstream{path, std::ios::binary} << content;
        return path;
    }

    static std::string message_of(const std::function<void()>& action) {
        try {
            action();
        } catch (const FileError& error) {
            return error.what();
        }
        return "no error";
    }

    /// The message of a read file. Expects that the read leaves nothing.
    std::string message(std::string_view kind, const ReadLimits& limits = {}) {
        const std::size_t descriptors = open_descriptors();
        std::string text = message_of([&] {
            ReaderProcess process{kind, file_, limits};
            for (;;) process.text();
        });
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
        EXPECT_EQ(errno, ECHILD);
        EXPECT_EQ(open_descriptors(), descriptors);
        EXPECT_EQ(std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}), 1);
        EXPECT_EQ(text.find('\n'), text.npos) << text;
        const std::string start = "cannot read \"" + file_.string() + "\": ";
        EXPECT_EQ(text.find(start), 0U) << text;
        return text.substr(std::min(start.size(), text.size()));
    }

    /// The reader process of a program.
    static pid_t reader_of(pid_t program) {
        std::vector<pid_t> children;
        comes_true([&] { return !(children = test::children_of(program)).empty(); });
        return children.empty() ? -1 : children.front();
    }

    fs::path folder_, file_;
};

TEST_F(Reading, KeepsTheMemoryThatItFreed) {
    if (reader::sanitized) GTEST_SKIP() << "a sanitizer has an allocator of its own";
    ReaderProcess process{"churn", file_, {}};
    EXPECT_EQ(process.value<std::uint64_t>(), 0U);
}

TEST_F(Reading, SaysHowTheProcessEnded) {
    EXPECT_EQ(message("crash"), "its reader crashed (SIGSEGV); the file is damaged or hostile");
    EXPECT_EQ(message("abort"), "its reader crashed (SIGABRT); the file is damaged or hostile");
    EXPECT_EQ(message("die_halfway"),
              "its reader crashed (SIGABRT); the file is damaged or hostile");
    EXPECT_EQ(message("leave"), "its reader ended unexpectedly with code 3");
    EXPECT_EQ(message("refuse"), "a line?and another");
    EXPECT_EQ(message("talk"), "its reader ended unexpectedly with code 0") << "only one text came";
}

TEST_F(Reading, EndsAtTheLimitOfTime) {
    const ReadLimits limits{.memory = 0, .time = 200ms};
    const std::string late =
        "reading it took more than 0.2 s; LoadOptions::read_seconds allows more";
    for (const char* kind : {"hang", "work_for_ever", "hang_halfway"})
        EXPECT_EQ(message(kind, limits), late) << kind;
}

TEST_F(Reading, EndsAtTheLimitOfMemory) {
    if (reader::sanitized) GTEST_SKIP() << "sanitizers reserve terabytes";
    const ReadLimits limits{.memory = 64 << 20, .time = {}};
    const std::string large =
        "reading it needs more than 0.0625 GiB of memory; LoadOptions::read_memory allows more";
    for (const char* kind : {"allocate_for_ever", "allocate_at_once", "hide_lack_of_memory"})
        EXPECT_EQ(message(kind, limits), large) << kind;
}

TEST_F(Reading, RefusesImpossibleAnswers) {
    const std::string nonsense =
        "its reader gave an answer that makes no sense; the file is damaged or hostile";
    EXPECT_EQ(message("talk_nonsense"), nonsense);
    EXPECT_EQ(message("promise_too_much"), nonsense);
    EXPECT_EQ(message("never_end", {.memory = 64 << 20, .time = {}}), nonsense);
}

TEST_F(Reading, SurvivesTheKillOfItsProcess) {
    std::string text;
    std::thread reading{[&] {
        text = message_of([&] { const ReaderProcess process{"hang", file_, {}}; });
    }};
    const pid_t process = reader_of(::getpid());
    EXPECT_GT(process, 0);
    if (process > 0) ::kill(process, SIGKILL);
    reading.join();
    EXPECT_NE(text.find("its reader was killed (SIGKILL)"), text.npos) << text;
    EXPECT_TRUE(is_dead(process));
}

/// The reading program may end in any way.
TEST_F(Reading, LeavesNoProcessWhenTheProgramEnds) {
    for (const int signal : {SIGKILL, SIGINT, SIGTERM}) {
        std::array<std::string, 3> words{"test", "--read-for-ever", file_.string()};
        std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data()};
        pid_t program = -1;
        ASSERT_EQ(
            ::posix_spawn(&program, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ),
            0);
        const pid_t process = reader_of(program);
        ::kill(program, signal);
        ::waitpid(program, nullptr, 0);
        ASSERT_GT(process, 0);
        EXPECT_TRUE(comes_true([&] { return is_dead(process); })) << "signal " << signal;
    }
}

TEST_F(Reading, RefusesWhatCannotFitBeforeItIsRead) {
    const fs::path sparse = folder_ / "sparse.png";
    std::ofstream{sparse}.close();
    fs::resize_file(sparse, std::uintmax_t{2} << 30U); // zeros that take no room on the disk
    const auto message = [&](const ReadLimits& limits) {
        return message_of([&] { read_image_isolated(sparse, limits); });
    };
    EXPECT_EQ(message({}), "cannot read \"" + sparse.string() +
                               "\": reading it needs more than 0.5 GiB of memory; "
                               "LoadOptions::read_memory allows more");
    EXPECT_NE(message({.memory = 1000, .time = {}}).find("more than 9.31e-07 GiB"),
              std::string::npos);
}

/// The limits for pictures do not depend on the size of a file, because a large file need not be a
/// picture.
TEST_F(Reading, GivesPicturesTheSameWhateverTheirSize) {
    const ReadLimits usual = limits_for_picture({});
    EXPECT_EQ(usual.memory, std::uint64_t{512} << 20U);
    EXPECT_EQ(usual.time, 60s);
    const ReadLimits filled = limits_for(130'000'000, usual);
    EXPECT_EQ(filled.memory, usual.memory);
    EXPECT_EQ(filled.time, usual.time);
    const ReadLimits given = limits_for_picture({.memory = 5, .time = 7s});
    EXPECT_EQ(given.memory, 5U);
    EXPECT_EQ(given.time, 7s);
}

TEST_F(Reading, GivesLargerFilesMoreTimeAndMemory) {
    const ReadLimits small = limits_for(100, {}), large = limits_for(130'000'000, {});
    EXPECT_EQ(small.time, 60s);
    EXPECT_EQ(large.time, 190s);
    EXPECT_EQ(small.memory, (std::uint64_t{2} << 30U) + 3200);
    EXPECT_GT(large.memory, std::uint64_t{6'000'000'000});
    const ReadLimits given = limits_for(130'000'000, {.memory = 5, .time = 7s});
    EXPECT_EQ(given.memory, 5U);
    EXPECT_EQ(given.time, 7s);
}

constexpr std::string_view model = "mtllib some.mtl\n"
                                   "o box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0\n"
                                   "usemtl red\nf 1 2 3 4\nusemtl blue\nf 1 2\nf 1 2 3\nf 1 2 5\n"
                                   "l 1 2 3 4\nl 1 3\n";

void expect_equal(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.triangle_group, b.triangle_group);
    EXPECT_EQ(a.polylines, b.polylines);
    ASSERT_EQ(a.groups.size(), b.groups.size());
    for (std::size_t i = 0; i < a.groups.size(); ++i) {
        EXPECT_EQ(a.groups[i].object, b.groups[i].object);
        EXPECT_EQ(a.groups[i].material, b.groups[i].material);
        EXPECT_EQ(a.groups[i].color, b.groups[i].color);
    }
}

TEST_F(Reading, BringsTheWholeMesh) {
    write("some.mtl", "newmtl red\nKd 1 0.25 0\n");
    const fs::path path = write("some.obj", model);
    const LoadedMesh here = load_mesh(path), there = load_mesh_isolated(path);
    EXPECT_EQ(here.mesh.groups.size(), 2U);
    EXPECT_TRUE(here.mesh.groups[0].color.has_value());
    EXPECT_EQ(here.mesh.polylines.size(), 2U);
    EXPECT_EQ(here.notes.size(), 2U);
    EXPECT_EQ(here.notes, there.notes);
    expect_equal(here.mesh, there.mesh);
}

TEST_F(Reading, BringsTheSameErrors) {
    write("none.obj", "v 0 0 0\n");
    write("bad.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                     "property float y\nproperty float z\nend_header\n0 0 0\n");
    fs::create_directory(folder_ / "folder.obj");
    for (const char* name : {"none.obj", "bad.ply", "missing.stl", "folder.obj", "some.file"}) {
        const std::string here = message_of([&] { load_mesh(folder_ / name); });
        EXPECT_NE(here, "no error") << name;
        EXPECT_EQ(here, message_of([&] { load_mesh_isolated(folder_ / name); }));
    }
}

TEST_F(Reading, BringsPictures) {
    const fs::path path = folder_ / "some.png";
    Image image{.size = {7, 5}, .channels = 4, .pixels = std::vector<std::uint8_t>(7 * 5 * 4)};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::uint8_t>(i);
    write_image(path, image);
    const Image read = read_image_isolated(path);
    EXPECT_EQ(read.size, image.size);
    EXPECT_EQ(read.channels, 4);
    EXPECT_EQ(read.pixels, image.pixels);
    const fs::path text = write("text.png", "no picture");
    const std::string here = message_of([&] { read_image(text); });
    EXPECT_NE(here, "no error");
    EXPECT_EQ(here, message_of([&] { read_image_isolated(text); }));
}

TEST_F(Reading, WorksInManyThreads) {
    const fs::path path = write("some.obj", model);
    std::atomic<int> good = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < 5; ++k) good += load_mesh_isolated(path).mesh.triangles.size() == 3;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(good, 20);
}

} // namespace
} // namespace lineatlas

int main(int argc, char** argv) {
    using namespace lineatlas;
    const std::string kind = argc > 2 ? argv[2] : "";
    const bool real = kind == "mesh" || kind == "image";
    const std::optional<int> code =
        real ? serve_as_reader(argc, argv) : serve_as_reader(argc, argv, kinds);
    if (code) return *code;
    if (argc == 3 && std::string{argv[1]} == "--read-for-ever") {
        const ReaderProcess process{"hang", argv[2], {}};
        return 0;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
