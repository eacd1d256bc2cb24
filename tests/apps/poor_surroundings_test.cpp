// OpenCL drivers without a home, a linker or memory. The tool draws a picture or prints one line
// about the missing thing, and never aborts.
#include <cstdlib>

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/stat.h>

#include "io/reader_protocol.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class PoorSurroundings : public Tool {
  protected:
    static void SetUpTestSuite() {
        ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE); // permissions count for the superuser, too
        for (const char* name : {"POCL_CACHE_DIR", "XDG_CACHE_HOME"}) ::unsetenv(name);
    }
    void SetUp() override {
        Tool::SetUp();
        for (const char* name : {"closed", "tmp", "cold"}) fs::create_directory(path(name));
        fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
    }
    void TearDown() override {
        fs::permissions(path("closed"), fs::perms::owner_all);
        Tool::TearDown();
    }

    /// `before`: commands of the shell, and variables for the tool.
    Result draw(const std::string& before, const std::string& options = "") const {
        return draw_to("x%d.png", before, "--turntable 1 " + options);
    }
    /// Draws one picture, for which no OpenCL driver starts.
    Result draw_one(const std::string& before) const { return draw_to("x.png", before, ""); }
    Result draw_to(const std::string& name, const std::string& before,
                   const std::string& options) const {
        // Without a cache no trial of the device comes first.
        return shell("bash -c '" + before +
                     " LINEATLAS_CACHE=off " LINEATLAS_TOOL
                     " draw --scene clevis --size 64x48 -o " +
                     path(name) + " " + options + "' 2>&1");
    }
    /// Lists the devices.
    Result devices(const std::string& before, const std::string& options = "") const {
        return shell("bash -c '" + before + " " LINEATLAS_TOOL " devices " + options + "' 2>&1");
    }
    /// Lets the first device run one kernel, in the same way as `devices` tries the mode
    /// host-pointer in a separate process. PoCL needs 10 seconds to compile all kernels again.
    Result one_kernel(const std::string& before) const { return devices(before, "--probe 0 2"); }
    static bool ran_a_kernel(const Result& result) {
        return result.exit_code == 0 &&
               result.output.find("a round trip succeeded") != std::string::npos;
    }
    fs::path private_folder() const {
        return fs::path{path("tmp")} / ("lineatlas-" + std::to_string(::geteuid()));
    }
};

TEST_F(PoorSurroundings, AHomeThatCannotBeWrittenTo) {
    const std::string temporary = "TMPDIR=" + path("tmp") + " ";
    for (const std::string& home :
         {"HOME=" + path("closed"), "HOME=" + path("closed/none"), std::string{"env -u HOME"},
          "HOME=" + path("tmp") + " XDG_CACHE_HOME=" + path("closed")}) {
        fs::remove_all(private_folder());
        const Result result = one_kernel(temporary + home);
        EXPECT_TRUE(ran_a_kernel(result)) << home << "\n" << result.output;
        struct stat status {};
        ASSERT_EQ(::lstat(private_folder().c_str(), &status), 0) << home;
        EXPECT_EQ(status.st_mode & 0777U, 0700U);
        EXPECT_FALSE(fs::is_empty(private_folder() / "pocl")) << home;
    }
    // A home that can be written to is used.
    fs::remove_all(private_folder());
    EXPECT_TRUE(ran_a_kernel(one_kernel(temporary + "HOME=" + path("cold"))));
    EXPECT_TRUE(fs::is_empty(path("tmp")));
    EXPECT_FALSE(fs::is_empty(path("cold")));
}

TEST_F(PoorSurroundings, AFolderThatOthersCanWriteToIsNotUsed) {
    fs::create_directory(private_folder());
    fs::permissions(private_folder(), fs::perms::all);
    const std::string home = "HOME=" + path("closed") + " TMPDIR=";
    const Result open = draw(home + path("tmp"));
    EXPECT_NE(open.output.find("set POCL_CACHE_DIR to a folder of your own"), std::string::npos)
        << open.output;
    EXPECT_TRUE(fs::is_empty(private_folder()));
    fs::remove(private_folder());
    fs::create_directory_symlink(path("cold"), private_folder());
    EXPECT_NE(draw(home + path("tmp")).output.find("POCL_CACHE_DIR"), std::string::npos);
    EXPECT_TRUE(fs::is_empty(path("cold")));
    const Result none = draw(home + path("none"));
    EXPECT_NE(none.output.find("no temporary directory"), std::string::npos) << none.output;
    EXPECT_TRUE(ran_a_kernel(one_kernel(home + path("none") + " POCL_CACHE_DIR=" + path("cold"))));
}

TEST_F(PoorSurroundings, AMissingLinkerIsNamed) {
    const std::string surroundings =
        "TMPDIR=" + path("tmp") + " HOME=" + path("cold") + " PATH=" + path("closed");
    const Result result = draw(surroundings);
    EXPECT_LE(result.exit_code, 1) << result.output;
    EXPECT_NE(result.output.find("PoCL needs the linker ld"), std::string::npos) << result.output;
    EXPECT_EQ(std::ranges::count(result.output, '\n'), 2) << "that, and the time" << result.output;
    EXPECT_TRUE(fs::is_empty(path("tmp"))) << "the trial leaves nothing behind";
    EXPECT_EQ(draw(surroundings, "--compute cpp").exit_code, 0);
    const Result one = draw_one(surroundings);
    EXPECT_EQ(one.exit_code, 0);
    EXPECT_EQ(one.output, "");
    EXPECT_NE(devices(surroundings).output.find("; --compute cpp does without"), std::string::npos);
    // The linker may be in another folder than usual.
    fs::create_directory(path("bin"));
    fs::create_symlink("/usr/bin/ld", path("bin/ld"));
    EXPECT_TRUE(ran_a_kernel(
        one_kernel("TMPDIR=" + path("tmp") + " HOME=" + path("cold") + " PATH=" + path("bin"))));
}

TEST_F(PoorSurroundings, AnOldDriverOfOpenGlIsNamed) {
    const std::string old = "MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330";
    const Result result = draw(old, "--method atlas");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.output.find("no OpenGL 4.5 core context: its best is OpenGL 3.3"),
              std::string::npos)
        << result.output;
    EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
    const std::string paths = " draw --scene clevis -o " + path("x.svg");
    EXPECT_EQ(shell("env " + old + " " LINEATLAS_TOOL + paths).exit_code, 0) << "they do without";
}

TEST_F(PoorSurroundings, LittleMemoryEndsInADrawingOrOneLine) {
    if (reader::sanitized) GTEST_SKIP() << "sanitizers reserve terabytes";
    for (const char* limit : {"-v 100000", "-v 300000", "-v 600000", "-v 700000", "-v 800000",
                              "-v 4000000", "-d 20000", "-d 100000", "-d 300000", "-d 2000000"}) {
        const Result result = draw_one(std::string{"ulimit "} + limit + ";");
        EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1)
            << limit << ": " << result.exit_code << "\n"
            << result.output;
        if (result.exit_code == 1) {
            EXPECT_NE(result.output.find("MiB (ulimit"), std::string::npos) << limit << "\n"
                                                                            << result.output;
        }
        if (std::string_view{limit}.ends_with("000000")) {
            EXPECT_EQ(result.exit_code, 0) << limit;
        }
    }
}

} // namespace
} // namespace lineatlas::test
