// The place of a file that is written: links, permissions and files that others left there.
#include "io/atomic_file.hpp"

#include <chrono>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <string_view>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lineatlas/error.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    static void put(const fs::path& target, std::string_view text) {
        AtomicFile{target}.commit(
            {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
    static std::string read(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream{file, std::ios::binary}.rdbuf();
        return text.str();
    }
    fs::path at(const std::string& name) const { return folder_.path() / name; }

    TemporaryFolder folder_;
};

TEST_F(AtomicFileTest, KeepsPermissions) {
    for (const unsigned mode : {0600U, 0640U, 0644U, 0755U, 0666U}) {
        put(at("x"), "old");
        ASSERT_EQ(::chmod(at("x").c_str(), mode), 0);
        put(at("x"), "new");
        struct stat status {};
        ASSERT_EQ(::stat(at("x").c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, mode);
        EXPECT_EQ(read(at("x")), "new");
    }
}

TEST_F(AtomicFileTest, ANewFileHasThoseOfTheUmask) {
    const mode_t before = ::umask(027);
    put(at("x"), "new");
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat(at("x").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(AtomicFileTest, KeepsTheOwner) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    put(at("x"), "old");
    ASSERT_EQ(::chown(at("x").c_str(), 12345, 54321), 0);
    put(at("x"), "new");
    struct stat status {};
    ASSERT_EQ(::stat(at("x").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 12345U);
    EXPECT_EQ(status.st_gid, 54321U);
}

TEST_F(AtomicFileTest, WritesThroughLinksThatLeadToNoFileYet) {
    fs::create_directory(at("real"));
    fs::create_symlink("real/x", at("relative"));
    fs::create_symlink(at("relative"), at("absolute"));
    put(at("absolute"), "new");
    EXPECT_TRUE(fs::is_symlink(at("absolute")));
    EXPECT_TRUE(fs::is_symlink(at("relative")));
    EXPECT_EQ(read(at("real/x")), "new");
}

TEST_F(AtomicFileTest, RefusesLinksThatLeadNowhere) {
    fs::create_symlink(at("b"), at("a"));
    fs::create_symlink(at("a"), at("b"));
    EXPECT_THROW(AtomicFile{at("a")}, FileError);
    fs::create_symlink(at("missing/x"), at("c"));
    EXPECT_THROW(AtomicFile{at("c")}, FileError);
    EXPECT_TRUE(fs::is_symlink(at("a")) && fs::is_symlink(at("c")));
}

TEST_F(AtomicFileTest, HasNoNameBeforeItIsWhole) {
    const int probe = ::open(folder_.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "this file system has no files without names";
    ::close(probe);
    const AtomicFile begun{at("x")};
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(AtomicFileTest, RemovesWhatKilledWritersLeft) {
    fs::create_directory(at("there"));
    const auto plant = [&](const std::string& name, std::chrono::hours age) {
        std::ofstream{at(name)} << "half";
        fs::last_write_time(at(name), fs::file_time_type::clock::now() - age);
    };
    plant("there/.lineatlas-1-0.part", std::chrono::hours{2});
    plant("there/.lineatlas-1-1.part", std::chrono::hours{0}); // somebody may still be writing it
    plant("there/.lineatlas-notes", std::chrono::hours{2});
    plant("there/mine.part", std::chrono::hours{2});
    put(at("there/x"), "new");
    EXPECT_FALSE(fs::exists(at("there/.lineatlas-1-0.part")));
    EXPECT_TRUE(fs::exists(at("there/.lineatlas-1-1.part")));
    EXPECT_TRUE(fs::exists(at("there/.lineatlas-notes")));
    EXPECT_TRUE(fs::exists(at("there/mine.part")));
}

} // namespace
} // namespace lineatlas::test
