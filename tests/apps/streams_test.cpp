// Standard output and error that are full, closed or read by nobody. The picture is drawn. If
// requested output could not be written, the tool fails.
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

const std::string tool = LINEATLAS_TOOL;

class Streams : public Tool {
  protected:
    std::string draw(const std::string& name) const {
        return tool + " draw --scene clevis --size 64x48 -o " + path(name);
    }
    /// Runs `command` with descriptor 3 as a pipe that nobody reads any more.
    static std::string unread(const std::string& command) {
        return "bash -c 'exec 3> >(true); wait $!; " + command + "'";
    }
    static int exit_code(const std::string& command) { return shell(command).exit_code; }
};

/// A terminal that nobody looks at.
class Terminal {
  public:
    Terminal() : own_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
        EXPECT_EQ(::grantpt(own_), 0);
        EXPECT_EQ(::unlockpt(own_), 0);
        // Open, so that what a program has written stays when it ends.
        other_ = ::open(name().c_str(), O_RDWR | O_NOCTTY);
        EXPECT_GE(other_, 0);
    }
    ~Terminal() {
        ::close(other_);
        ::close(own_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    std::string name() const { return ::ptsname(own_); }
    /// All that was written so far.
    std::string text() const {
        std::string text(65536, ' ');
        const ssize_t count = ::read(own_, text.data(), text.size());
        text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return text;
    }

  private:
    int own_, other_ = -1;
};

TEST_F(Streams, ATerminalShowsTheStageAndIsLeftClean) {
    const Terminal terminal;
    const std::string command = tool + " draw --scene clevis --size 64x48 -o " + path("x.svg");
    ASSERT_EQ(exit_code(command + " 2>" + terminal.name()), 0);
    const std::string text = terminal.text();
    const std::size_t finding = text.find("lineatlas: finding lines");
    const std::size_t drawing = text.find("lineatlas: drawing");
    EXPECT_NE(finding, std::string::npos) << text;
    EXPECT_NE(drawing, std::string::npos) << text;
    EXPECT_LT(finding, drawing);
    const std::string cleared = "\r\x1b[K";
    EXPECT_NE(text.find(cleared, drawing), std::string::npos) << text;
    EXPECT_EQ(shell(command + " 2>&1").output, "") << "no terminal";
}

TEST_F(Streams, ALongNameOfAFileStaysOnTheLineOfTheStage) {
    const Terminal terminal;
    const std::string name = "a\nb\t\x1b[2J" + std::string(150, 'n') + ".obj";
    write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string command = tool + " draw \"" + path(name) + "\" -o " + path("x.svg");
    ASSERT_EQ(exit_code(command + " 2>" + terminal.name()), 0);
    const std::string text = terminal.text();
    EXPECT_NE(text.find("lineatlas: reading a?b??[2Jnnnn"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.find(std::string(60, 'n')), std::string::npos) << text;
}

TEST_F(Streams, ErrorsThatNobodyTakesChangeNothing) {
    for (const char* nowhere : {"2>/dev/full", "2>&-", "2>&3"}) {
        // Progress, then the line at the end.
        const auto code_of = [&](const std::string& command) {
            return exit_code(unread(command + " " + nowhere));
        };
        EXPECT_EQ(code_of(draw("%d.png") + " --turntable 2"), 0) << nowhere;
        EXPECT_TRUE(fs::exists(path("1.png"))) << nowhere;
        fs::remove(path("1.png"));
        EXPECT_EQ(code_of(draw("x.nothing")), 1) << nowhere;
        EXPECT_EQ(code_of(tool + " draw"), 2) << nowhere;
    }
}

TEST_F(Streams, OutputThatIsFullOrClosedIsAFailure) {
    for (const std::string& command :
         {tool + " styles", tool + " styles pencil", tool + " styles --keys", tool + " --help",
          tool + " devices --wait 1", draw("stats.png") + " --stats --repeat 1",
          draw("profile.png") + " --profile - --repeat 1",
          draw("compared.png") + " --compare-with cpp"}) {
        for (const char* nowhere : {"/dev/full", "&-"}) {
            // The messages come back; some may be from drivers.
            const Result result = shell(command + " 2>&1 >" + nowhere);
            EXPECT_EQ(result.exit_code, 1) << command << " >" << nowhere << "\n" << result.output;
            EXPECT_NE(result.output.find("lineatlas: cannot write to standard output: "),
                      std::string::npos)
                << command << " >" << nowhere << "\n"
                << result.output;
        }
    }
    EXPECT_TRUE(fs::exists(path("stats.png")));
    EXPECT_TRUE(fs::exists(path("profile.png")));
}

TEST_F(Streams, APictureNeedsNoOutput) {
    EXPECT_EQ(exit_code(draw("a.png") + " <&- >&- 2>&-"), 0);
    EXPECT_EQ(exit_code(draw("b.png") + " </dev/null >/dev/full"), 0);
    // None of the tool's own descriptors got the number of a closed stream.
    const Result usual = shell("cmp " + path("a.png") + " " + path("b.png") + " 2>&1");
    EXPECT_EQ(usual.exit_code, 0) << usual.output;
}

TEST_F(Streams, AReaderThatHasSeenEnoughEndsItSilently) {
    const Result result = shell(unread(tool + " styles --keys >&3; echo ended $?") + " 2>&1");
    EXPECT_EQ(result.output, "ended " + std::to_string(128 + SIGPIPE) + "\n");
}

#ifdef LINEATLAS_BENCH
TEST_F(Streams, BenchmarksReportFullOutputToo) {
    const std::string bench = LINEATLAS_BENCH " --modes copy --sizes 1 --rounds 1";
    EXPECT_EQ(exit_code(bench + " 2>/dev/full"), 0);
    const Result full = shell(bench + " 2>&1 >/dev/full");
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.output.find("cannot write to standard output"), std::string::npos)
        << full.output;
    EXPECT_EQ(exit_code(LINEATLAS_BENCH " --no-such-option 2>/dev/full"), 2);
}
#endif

} // namespace
} // namespace lineatlas::test
