// The tool is killed, or has no room or no folder for its file. The old file stays, or the new file
// is whole.
#include <chrono>
#include <csignal>
#include <cstdint>
#include <map>
#include <random>
#include <string_view>
#include <thread>

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

constexpr const char* old_content = "what was there before";

class OutputFaults : public Tool {
  protected:
    /// The content of the files of a folder.
    std::map<std::string, std::string> contents(const std::string& folder) const {
        std::map<std::string, std::string> result;
        for (const auto& entry : fs::directory_iterator{path(folder)}) {
            result[entry.path().filename().string()] = read(entry.path());
        }
        return result;
    }

    /// Starts the tool in a new process group. limit: the largest size of a file in bytes.
    static pid_t start(const std::string& arguments, rlim_t limit = RLIM_INFINITY) {
        const pid_t process = ::fork();
        if (process != 0) return process;
        ::setpgid(0, 0);
        const rlimit largest{limit, limit};
        ::setrlimit(RLIMIT_FSIZE, &largest);
        ::signal(SIGXFSZ, SIG_IGN);                 // the write fails, as on a full disk
        ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE); // permissions count for the superuser, too
        const std::string command =
            std::string{"exec "} + LINEATLAS_TOOL + " " + arguments + " >/dev/null 2>&1";
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(9);
    }

    static int wait_for(pid_t process) {
        int status = 0;
        ::waitpid(process, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
};

const std::vector<std::string> endings{".png", ".bmp", ".svg", ".json", ".dxf", ".pdf"};

TEST_F(OutputFaults, ALimitOfFileSizesIsNamed) {
    for (const std::string& ending : endings) {
        const Result result = shell("ulimit -f 1; " LINEATLAS_TOOL " draw --scene clevis -o " +
                                    path("limited" + ending) + " 2>&1");
        EXPECT_EQ(result.exit_code, 1) << ending;
        EXPECT_NE(result.output.find("a file may have at most "), std::string::npos)
            << ending << result.output;
        EXPECT_NE(result.output.find("raise that limit (ulimit -f)"), std::string::npos)
            << ending << result.output;
        EXPECT_FALSE(fs::exists(path("limited" + ending)));
    }
    const Result printed =
        shell("ulimit -f 1; " LINEATLAS_TOOL " styles --keys 2>&1 >" + path("printed"));
    EXPECT_EQ(printed.exit_code, 1);
    EXPECT_NE(printed.output.find("cannot write to standard output: a file may have at most "),
              std::string::npos)
        << printed.output;
}

TEST_F(OutputFaults, AKillAtAnyTimeLeavesOldOrWholeFiles) {
    constexpr int kills = 32;
    std::mt19937 random{7};
    int unchanged = 0, changed = 0, left_behind = 0;
    for (int i = 0; i < kills; ++i) {
        const std::string& ending = endings[static_cast<std::size_t>(i) % endings.size()];
        const std::string arguments = "draw --scene clevis --size 160x120 --turntable 6 -o ";
        const std::string whole = "whole" + ending, killed = "killed" + ending;
        if (!fs::exists(path(whole))) {
            fs::create_directory(path(whole));
            ASSERT_EQ(wait_for(start(arguments + path(whole) + "/%d" + ending)), 0);
        }
        fs::remove_all(path(killed));
        fs::create_directory(path(killed));
        for (int frame = 0; frame < 6; ++frame) {
            write(killed + "/" + std::to_string(frame) + ending, old_content);
        }
        const pid_t process = start(arguments + path(killed) + "/%d" + ending);
        // Between the first frame and the last, or soon after.
        const fs::path first = path(killed + "/0" + ending);
        while (fs::file_size(first) == std::string_view{old_content}.size()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::this_thread::sleep_for(
            std::chrono::microseconds(std::uniform_int_distribution{0, 60'000}(random)));
        ::kill(-process, SIGKILL);
        wait_for(process);
        const std::map<std::string, std::string> expected = contents(whole);
        for (const auto& [name, content] : contents(killed)) {
            // Killed between two system calls; such files are whole, too.
            if (name.ends_with(".part")) {
                ++left_behind;
                const auto whole_one = [&](const auto& file) { return file.second == content; };
                EXPECT_TRUE(std::ranges::any_of(expected, whole_one)) << name;
                continue;
            }
            ASSERT_TRUE(expected.contains(name)) << name;
            if (content == old_content)
                ++unchanged;
            else if (content == expected.at(name))
                ++changed;
            else
                ADD_FAILURE() << name << " is neither old nor whole, kill " << i;
        }
    }
    EXPECT_EQ(unchanged + changed, 6 * kills);
    EXPECT_GT(unchanged, 0);
    EXPECT_GT(changed, 0);
    EXPECT_LE(left_behind, kills / 10);
    std::cout << changed << " files were whole, " << unchanged << " as before\n";
}

TEST_F(OutputFaults, ADiskWithoutRoomLeavesWhatWasThere) {
    fs::create_directory(path("full"));
    const auto expect_old = [&](const std::string& option, const std::string& name) {
        write("full/" + name, old_content);
        EXPECT_EQ(wait_for(start("draw --scene clevis " + option + path("full/" + name), 1000)), 1)
            << name;
        EXPECT_EQ(read(path("full/" + name)), old_content) << name;
        fs::remove(path("full/" + name));
        fs::remove(path("other.png"));
        EXPECT_TRUE(fs::is_empty(path("full"))) << "something is left beside " << name;
    };
    for (const std::string& ending : endings) expect_old("-o ", "x" + ending);
    // The picture itself fits.
    const std::string small = "--size 8x8 -o " + path("other.png") + " --profile ";
    for (const char* name : {"x.json", "x.csv"}) expect_old(small, name);
}

TEST_F(OutputFaults, AReadOnlyFolderKeepsWhatItHas) {
    fs::create_directory(path("closed"));
    const auto expect_exit = [&](int code, const std::string& option, const std::string& name) {
        EXPECT_EQ(wait_for(start("draw --scene clevis --size 64x48 " + option + path(name))), code)
            << name;
    };
    std::vector<std::string> names;
    for (const std::string& ending : endings) names.push_back("x" + ending);
    const std::string profile = "-o " + path("other.png") + " --profile ";
    for (const std::string& name : names) write("closed/" + name, old_content);
    write("closed/x.csv", old_content);
    const auto before = contents("closed");
    fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
    for (const std::string& name : names) expect_exit(1, "-o ", "closed/" + name);
    expect_exit(1, profile, "closed/x.csv");
    expect_exit(1, "-o ", "closed/new.png");
    EXPECT_EQ(contents("closed"), before);
    fs::permissions(path("closed"), fs::perms::owner_all);
    expect_exit(0, "-o ", "closed/new.png"); // only the permission was missing
}

TEST_F(OutputFaults, AFolderThatGoesAwayIsSaid) {
    fs::create_directory(path("away"));
    const pid_t process =
        start("draw --scene clevis --size 64x48 --turntable 100000 -o " + path("away/%d.png"));
    while (fs::is_empty(path("away"))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    fs::rename(path("away"), path("gone"));
    EXPECT_EQ(wait_for(process), 1);
    EXPECT_FALSE(fs::exists(path("away")));
}

} // namespace
} // namespace lineatlas::test
