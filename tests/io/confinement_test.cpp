// The rights of a process that reads files. Planted readers try what a hostile file would try after
// it has taken over a parser.

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hostile_attempts.hpp"
#include "io/confinement.hpp"
#include "io/landlock.hpp"
#include "io/reader_process.hpp"
#include "io/reader_protocol.hpp"
#include "io/system_calls.hpp"
#include "lineatlas/error.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

/// The file holds the port.
ReaderKind::Parse try_everything(const fs::path& path, std::string_view) {
    Target target{path.string(), 0};
    std::ifstream{path} >> target.port;
    return [target](ReaderOutput& output) {
        output.value(reader::Answer::read);
        for (const Attempt& attempt : attempts()) output.value(attempt.error(target));
    };
}

ReaderKind::Parse try_everything_by_a_thread(const fs::path& path, std::string_view) {
    Target target{path.string(), 0};
    std::ifstream{path} >> target.port;
    return [target, thread = std::make_shared<EarlyThread>()](ReaderOutput& output) {
        output.value(reader::Answer::read);
        for (const int error : thread->errors(target)) output.value(error);
    };
}

/// Uses what parsers need: memory, threads, exceptions.
ReaderKind::Parse work(const fs::path& path, std::string_view) {
    return [path](ReaderOutput& output) {
        std::vector<char> memory(64 << 20, 'x');
        std::size_t count = 0;
        std::thread{[&] { count = memory.size(); }}.join();
        try {
            throw std::runtime_error{"thrown"};
        } catch (const std::runtime_error&) {
            ++count;
        }
        output.value(reader::Answer::read);
        output.value(count);
    };
}

/// Reports what the process has before it is confined.
ReaderKind::Parse tell_what_it_has(const fs::path&, std::string_view) {
    std::string environment, descriptors;
    for (char** variable = environ; *variable != nullptr; ++variable)
        environment += std::string{*variable} + '\n';
    for (int descriptor = 0; descriptor < 1000; ++descriptor)
        if (::fcntl(descriptor, F_GETFD) >= 0) descriptors += std::to_string(descriptor) + ' ';
    return [=](ReaderOutput& output) {
        output.value(reader::Answer::read);
        output.text(environment);
        output.text(descriptors);
        char end = 0;
        [[maybe_unused]] const ssize_t none = ::read(reader::socket, &end, 1); // until it is killed
    };
}

constexpr std::array kinds{ReaderKind{"try_everything", try_everything},
                           ReaderKind{"try_everything_by_a_thread", try_everything_by_a_thread},
                           ReaderKind{"work", work},
                           ReaderKind{"tell_what_it_has", tell_what_it_has}};

class Confined : public testing::Test {
  protected:
    void SetUp() override {
        if (reader::sanitized) GTEST_SKIP() << "a build with sanitizers is not confined";
        std::ofstream{file_} << listener_.port();
    }

    void expect_all_refused(std::string_view kind) {
        const Confinement offered = offered_confinement();
        ReaderProcess process{kind, file_, {}};
        for (const Attempt& attempt : attempts()) {
            const int error = process.value<int>();
            const bool refused = attempt.is_refused(offered.system_calls, offered.files > 0);
            EXPECT_TRUE(!refused || error != 0) << "a reader could " << attempt.name;
        }
        if (!offered.system_calls && offered.files == 0) return;
        EXPECT_EQ(std::distance(fs::directory_iterator{folder_.path()}, fs::directory_iterator{}),
                  1);
        EXPECT_GT(fs::file_size(file_), 0U);
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "some.file";
    Listener listener_;
    Target target_{file_.string(), listener_.port()};
};

TEST_F(Confined, AReaderIsRefusedEverythingElse) {
    expect_all_refused("try_everything");
}

TEST_F(Confined, AThreadThatALibraryStartsIsRefusedEverythingElse) {
    expect_all_refused("try_everything_by_a_thread");
}

/// Tests in a copy of this process that has two threads.
TEST_F(Confined, AProcessWithThreadsIsNotConfinedAndMustNotRead) {
    const pid_t child = ::fork();
    if (child == 0) {
        EarlyThread thread;
        try {
            confine_to_reading();
        } catch (const DeviceError& error) {
            ::_exit(std::string_view{error.what()}.starts_with("cannot confine") ? 0 : 2);
        }
        ::_exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

TEST_F(Confined, AReaderHasWhatItNeeds) {
    ReaderProcess process{"work", file_, {}};
    EXPECT_EQ(process.value<std::size_t>(), (std::size_t{64} << 20U) + 1);
}

TEST_F(Confined, AReaderInheritsNeitherDescriptorsNorSecrets) {
    const int secret = ::open("/etc/passwd", O_RDONLY); // without O_CLOEXEC
    ASSERT_GT(secret, 2);
    ::setenv("LINEATLAS_TEST_SECRET", "password", 1);
    ::setenv("LD_LIBRARY_PATH", "/nowhere", 1);
    ReaderProcess process{"tell_what_it_has", file_, {}};
    ::close(secret);
    ::unsetenv("LD_LIBRARY_PATH");
    EXPECT_EQ(process.text(), "LD_LIBRARY_PATH=/nowhere\nOPENIMAGEIO_THREADS=1\n");
    EXPECT_EQ(process.text(), "0 1 2 ");
    std::ifstream status{"/proc/" + std::to_string(process.id()) + "/status"};
    bool no_new_privileges = false;
    for (std::string line; std::getline(status, line);)
        no_new_privileges = no_new_privileges || line == "NoNewPrivs:\t1";
    EXPECT_TRUE(no_new_privileges);
}

/// The errors of all attempts in a new process, after `prepare`.
std::vector<int> errors_after(const std::function<void()>& prepare, const Target& target) {
    int pipe[2];
    if (::pipe(pipe) != 0) return {};
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(pipe[1], STDOUT_FILENO);
        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        prepare();
        std::vector<int> errors(attempts().size());
        for (std::size_t i = 0; i < attempts().size(); ++i) errors[i] = attempts()[i].error(target);
        ::_exit(::write(STDOUT_FILENO, errors.data(), errors.size() * sizeof(int)) > 0 ? 0 : 1);
    }
    ::close(pipe[1]);
    std::vector<int> errors(attempts().size());
    const ssize_t got = ::read(pipe[0], errors.data(), errors.size() * sizeof(int));
    ::close(pipe[0]);
    ::waitpid(child, nullptr, 0);
    return got == static_cast<ssize_t>(errors.size() * sizeof(int)) ? errors : std::vector<int>{};
}

TEST_F(Confined, SystemCallsAreRefusedByThemselves) {
    if (!has_seccomp()) GTEST_SKIP() << describe(offered_confinement());
    const std::vector<int> errors = errors_after(restrict_system_calls, target_);
    ASSERT_EQ(errors.size(), attempts().size());
    for (std::size_t i = 0; i < attempts().size(); ++i)
        EXPECT_EQ(errors[i], EPERM) << attempts()[i].name;
}

TEST_F(Confined, FilesAreRefusedByThemselves) {
    if (landlock_version() == 0) GTEST_SKIP() << describe(offered_confinement());
    const auto expect_refused = [&](const std::vector<int>& errors, bool reading) {
        ASSERT_EQ(errors.size(), attempts().size());
        for (std::size_t i = 0; i < attempts().size(); ++i) {
            const std::string_view name = attempts()[i].name;
            const bool refused = attempts()[i].least == By::landlock || name.ends_with("a file");
            const bool asked = name == "ask for a file", tcp = name == "connect";
            const bool read = reading && name == "open a file";
            const bool expected = (refused && !asked && !read) || (tcp && landlock_version() >= 4);
            EXPECT_TRUE(!expected || errors[i] == EACCES) << name << ": " << errors[i];
            EXPECT_TRUE(!read || errors[i] == 0) << name << ": " << errors[i];
        }
    };
    expect_refused(errors_after([] { restrict_files(Files::none); }, target_), false);
    expect_refused(errors_after([] { restrict_files(Files::read); }, target_), true);
}

TEST(Confinement, SaysWhatIsMissingAndWhy) {
    if (reader::sanitized) {
        EXPECT_EQ(describe({}), "not confined: built with a sanitizer");
        return;
    }
    const std::string none =
        knows_seccomp() ? "this kernel has no seccomp" : "built without libseccomp";
    EXPECT_EQ(describe({.system_calls = true, .files = 7}), "confined by seccomp, Landlock 7");
    EXPECT_EQ(describe({.system_calls = true, .files = 0}),
              "confined by seccomp; this kernel has no Landlock");
    EXPECT_EQ(describe({.system_calls = false, .files = 1}), "confined by Landlock 1; " + none);
    EXPECT_EQ(describe({}), "confined by limits alone; " + none + ", this kernel has no Landlock");
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv, lineatlas::test::kinds))
        return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
