// Standard output and error that are full, closed or read by nobody. The picture is drawn. If
// requested output could not be written, the tool fails.
#include <csignal>

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
