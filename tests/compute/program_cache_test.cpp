// The cache of built programs: its files may be damaged, swapped and half written at any time.

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compute/opencl/program_cache.hpp"
#include "program_cache_damage.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;
using compute::ProgramCache;

using Bytes = std::vector<unsigned char>;

std::string key_of(unsigned i) {
    return "key " + std::to_string(i) + std::string(i * 17U, 'k');
}

constexpr unsigned program_count = 8;
constexpr unsigned smallest_program = 100'000;

/// A program that can be recognised by its size and bytes.
const Bytes& program_of(unsigned i) {
    static const std::vector<Bytes> programs = [] {
        std::vector<Bytes> all;
        for (unsigned k = 0; k < program_count; ++k) {
            Bytes& program = all.emplace_back(smallest_program + k * 997U);
            for (std::size_t j = 0; j < program.size(); ++j) {
                program[j] = static_cast<unsigned char>((j * (2 * k + 1)) >> 3U);
            }
        }
        return all;
    }();
    return programs[i];
}

/// The number of programs that are found. Expects that each is the right one and whole.
unsigned count_found(const ProgramCache& cache) {
    unsigned found = 0;
    for (unsigned i = 0; i < program_count; ++i) {
        const auto program = cache.find(key_of(i));
        if (!program) continue;
        EXPECT_EQ(*program, program_of(i)) << "another program than was stored under key " << i;
        ++found;
    }
    return found;
}

void store_all(const ProgramCache& cache) {
    for (unsigned i = 0; i < program_count; ++i) cache.store(key_of(i), program_of(i));
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const auto& file : fs::directory_iterator{folder}) result.push_back(file.path());
    return result;
}

/// Runs `action` in another process.
template <class Action>
pid_t start_process(Action&& action) {
    const pid_t child = ::fork();
    if (child == 0) {
        action();
        ::_exit(0);
    }
    return child;
}

TEST(ProgramCache, FindsWhatWasStored) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path() / "made" / "when needed"};
    EXPECT_EQ(count_found(cache), 0U);
    store_all(cache);
    EXPECT_EQ(count_found(cache), program_count);
    EXPECT_EQ(ProgramCache{folder.path()}.find(key_of(0)), std::nullopt);

    cache.store(key_of(1), program_of(5));
    EXPECT_EQ(cache.find(key_of(1)), program_of(5));
    cache.store("", {});
    EXPECT_EQ(cache.find(""), Bytes{});
}

TEST(ProgramCache, TwoHundredDamagesAreNeverTrusted) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    std::minstd_rand random{1};
    unsigned missed = 0;
    store_all(cache);
    for (unsigned round = 0; round < 200; ++round) {
        const auto any = [&] { return static_cast<unsigned>(random() % program_count); };
        const unsigned one = any(), other = any();
        SCOPED_TRACE(damage(cache.file_of(key_of(one)), cache.file_of(key_of(other)), random));
        missed += count_found(cache) < program_count ? 1 : 0;
        for (const unsigned i : {one, other}) cache.store(key_of(i), program_of(i));
        ASSERT_EQ(count_found(cache), program_count);
    }
    // Some damages change nothing, such as a file swapped with itself.
    EXPECT_GT(missed, 180U);
}

TEST(ProgramCache, TwoHundredKillsLeaveWholeEntriesOnly) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    // Large, so that a writer spends much of its time on the file.
    const Bytes large[2] = {Bytes(2'000'000, 'a'), Bytes(1'500'001, 'b')};
    std::minstd_rand random{2};
    unsigned interrupted = 0, whole = 0;
    // A writer lives for up to three files, so that slow machines and sanitizers do not matter.
    const auto start = std::chrono::steady_clock::now();
    ::waitpid(start_process([&] { cache.store(key_of(0), large[0]); }), nullptr, 0);
    const std::chrono::duration<double> longest = 3 * (std::chrono::steady_clock::now() - start);
    std::uniform_real_distribution<double> part{0, 1};
    for (unsigned round = 0; round < 200; ++round) {
        const pid_t child = start_process([&] {
            for (unsigned i = 0;; i ^= 1U) cache.store(key_of(i), large[i]);
        });
        std::this_thread::sleep_for(part(random) * longest);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        for (unsigned i = 0; i < 2; ++i) {
            const auto program = cache.find(key_of(i));
            if (!program) continue;
            ASSERT_TRUE(*program == large[i]) << "not what was stored under key " << i;
            ++whole;
        }
        for (const fs::path& file : files_in(folder.path())) {
            if (file.extension() == ".part") ++interrupted;
            // Some files are removed, so that the test also finds nothing sometimes.
            if (file.extension() == ".part" || round % 10 == 0) fs::remove(file);
        }
    }
    EXPECT_GT(interrupted, 4U) << "hardly any kill hit a writer while it wrote";
    EXPECT_GT(whole, 4U) << "hardly any writer came to an end";
    RecordProperty("interrupted", static_cast<int>(interrupted));
    store_all(cache);
    EXPECT_EQ(count_found(cache), program_count);
}

TEST(ProgramCache, EightProcessesFillItAtOnce) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    std::vector<pid_t> children;
    for (unsigned process = 0; process < 8; ++process) {
        children.push_back(start_process([&] {
            for (unsigned round = 0; round < 20; ++round) {
                store_all(cache);
                if (count_found(cache) != program_count || testing::Test::HasFailure()) ::_exit(1);
            }
        }));
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(count_found(cache), program_count);
    EXPECT_EQ(files_in(folder.path()).size(), program_count) << "a part was left";
}

TEST(ProgramCache, AFolderThatCannotBeWrittenIsNoError) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "file";
    std::ofstream{file} << "not a folder";
    for (const fs::path& place : {file, file / "below", fs::path{"/proc/lineatlas"}}) {
        const ProgramCache cache{place};
        store_all(cache);
        EXPECT_EQ(count_found(cache), 0U);
        EXPECT_FALSE(cache.store("new", program_of(0)));
    }

    const fs::path closed = folder.path() / "closed";
    const ProgramCache cache{closed};
    store_all(cache);
    fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
    const bool stored = cache.store("new", program_of(0)); // a superuser can always write it
    EXPECT_EQ(stored, cache.find("new").has_value());
    EXPECT_EQ(count_found(cache), program_count);
    fs::permissions(closed, fs::perms::owner_all);
}

TEST(ProgramCache, WhatIsNoFileIsNeitherReadNorReplaced) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    fs::create_directories(cache.file_of(key_of(0)) / "inside");
    ASSERT_EQ(::mkfifo(cache.file_of(key_of(1)).c_str(), 0600), 0);
    EXPECT_EQ(count_found(cache), 0U) << "or the test hangs at the pipe";
    store_all(cache);
    EXPECT_EQ(count_found(cache), program_count - 1) << "all but the one that is a folder";
    EXPECT_TRUE(fs::exists(cache.file_of(key_of(0)) / "inside"));
}

TEST(ProgramCache, WhatOthersMayWriteIsNotTrusted) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    const fs::path file = cache.file_of(key_of(0));
    const auto others = {fs::perms::group_write, fs::perms::others_write};
    for (const fs::perms other : others) {
        cache.store(key_of(0), program_of(0));
        ASSERT_EQ(cache.find(key_of(0)), program_of(0));
        fs::permissions(file, other, fs::perm_options::add);
        EXPECT_EQ(cache.find(key_of(0)), std::nullopt);
    }
    cache.store(key_of(0), program_of(0));
    EXPECT_EQ(cache.find(key_of(0)), program_of(0)) << "it is replaced";
}

TEST(ProgramCache, WhatOthersOwnIsNotTrusted) {
    if (::geteuid() != 0) GTEST_SKIP() << "only a superuser can give files away";
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path()};
    cache.store(key_of(0), program_of(0));
    constexpr uid_t nobody = 65534;
    ASSERT_EQ(::chown(cache.file_of(key_of(0)).c_str(), nobody, nobody), 0);
    EXPECT_EQ(cache.find(key_of(0)), std::nullopt);
    cache.store(key_of(0), program_of(0));
    EXPECT_EQ(cache.find(key_of(0)), program_of(0)) << "it is replaced";
}

TEST(ProgramCache, IsForItsUserAloneWhateverTheUmask) {
    const TemporaryFolder folder;
    const mode_t umask = ::umask(0);
    const ProgramCache cache{folder.path() / "made" / "when needed"};
    cache.store(key_of(0), program_of(0));
    ::umask(umask);
    for (const fs::path& made : {folder.path() / "made", folder.path() / "made" / "when needed"})
        EXPECT_EQ(fs::status(made).permissions(), fs::perms::owner_all) << made;
    EXPECT_EQ(fs::status(cache.file_of(key_of(0))).permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST(ProgramCache, DropsTheLongestUnusedBeyondItsLimit) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path(), 5 * (smallest_program + 5'000)};
    const auto now = fs::file_time_type::clock::now();
    for (unsigned i = 0; i < 4; ++i) {
        cache.store(key_of(i), program_of(i));
        fs::last_write_time(cache.file_of(key_of(i)), now - std::chrono::hours{10 - i});
    }
    EXPECT_TRUE(cache.find(key_of(0))); // it is used, so it is no longer the oldest
    cache.store(key_of(4), program_of(4));
    cache.store(key_of(5), program_of(5));
    EXPECT_TRUE(cache.find(key_of(0)));
    EXPECT_FALSE(cache.find(key_of(1)));
    EXPECT_TRUE(cache.find(key_of(5)));

    cache.store("too large", Bytes(6 * smallest_program));
    EXPECT_FALSE(cache.find("too large"));
    EXPECT_TRUE(cache.find(key_of(5)));
}

TEST(ProgramCache, RemovesWhatKilledWritersLeftButNothingElse) {
    const TemporaryFolder folder;
    const ProgramCache cache{folder.path(), 10};
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours{2};
    for (const char* name : {"old.part", "young.part", "old.txt"}) {
        std::ofstream{folder.path() / name} << "something longer than the limit";
        if (*name == 'o') fs::last_write_time(folder.path() / name, old);
    }
    ProgramCache{folder.path()}.store(key_of(0), program_of(0));
    EXPECT_FALSE(fs::exists(folder.path() / "old.part"));
    EXPECT_TRUE(fs::exists(folder.path() / "young.part"));
    EXPECT_TRUE(fs::exists(folder.path() / "old.txt"));
}

TEST(ProgramCache, StandsWhereTheUserKeepsCaches) {
    ::setenv("HOME", "/home/someone", 1);
    ::unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(ProgramCache::default_folder(), fs::path{"/home/someone/.cache/lineatlas"});
    ::setenv("XDG_CACHE_HOME", "/var/caches", 1);
    EXPECT_EQ(ProgramCache::default_folder(), fs::path{"/var/caches/lineatlas"});
    ::setenv("XDG_CACHE_HOME", "relative", 1);
    EXPECT_EQ(ProgramCache::default_folder(), fs::path{"/home/someone/.cache/lineatlas"});
    ::unsetenv("HOME");
    EXPECT_EQ(ProgramCache::default_folder(), std::nullopt);
}

} // namespace
} // namespace lineatlas::test
