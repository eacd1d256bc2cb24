// Drivers that do not work. Each gives a message of one line, and pictures are drawn without the
// driver unless the user asked for it.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "environment_variable.hpp"
#include "lineatlas/io.hpp"
#include "planted_error.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class Drivers : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        fs::create_directory(path("vendors"));
        write("vendors/a_fake.icd", LINEATLAS_FAKE_DRIVER "\n");
    }
    void TearDown() override {
        ::unsetenv("OCL_ICD_VENDORS");
        ::unsetenv("LINEATLAS_TEST_DRIVER");
        Tool::TearDown();
    }
    /// Puts PoCL behind the fake driver. Returns false if PoCL is not installed.
    bool add_pocl() const {
        const fs::path pocl = "/etc/OpenCL/vendors/pocl.icd";
        return fs::exists(pocl) && fs::copy_file(pocl, path("vendors/b_pocl.icd"));
    }
    /// The usual folder of PoCL's compiled kernels.
    static std::string usual_pocl_cache() {
        if (const char* own = std::getenv("POCL_CACHE_DIR")) return own;
        if (const char* cache = std::getenv("XDG_CACHE_HOME"))
            return std::string{cache} + "/pocl/kcache";
        const char* home = std::getenv("HOME");
        return std::string{home != nullptr ? home : "/tmp"} + "/.cache/pocl/kcache";
    }
    void use_fake(const char* kind) const {
        ::setenv("OCL_ICD_VENDORS", path("vendors").c_str(), 1);
        ::setenv("LINEATLAS_TEST_DRIVER", kind, 1);
    }
    std::string draw(const std::string& options) const {
        return "draw --scene clevis --size 64x48 -o " + path("x.png") + " " + options;
    }
};

std::size_t lines_with(const std::string& text, const std::string& part) {
    std::istringstream lines{text};
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) count += line.find(part) != line.npos;
    return count;
}

std::size_t longest_line(const std::string& text) {
    std::istringstream lines{text};
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
    return longest;
}

/// A kernel with errors and a log of many lines, and an output that needs the kernel.
struct Broken {
    const char* file;
    const char* from;
    const char* options;
};

class BrokenKernel : public Drivers, public testing::WithParamInterface<Broken> {
  protected:
    static std::string many_errors() {
        std::string text;
        for (int i = 0; i < 15; ++i) text += "unknown_type_" + std::to_string(i) + " broken;\n";
        return text;
    }
    PlantedError broken_{GetParam().file, GetParam().from, many_errors() + GetParam().from};
    const std::string options_ = GetParam().options;
};

/// Tests for which one kernel is enough.
class OneBrokenKernel : public BrokenKernel {};

TEST_P(OneBrokenKernel, IsToldInALineOfDevices) {
    const Result devices = run("devices");
    EXPECT_EQ(devices.exit_code, 0) << devices.output;
    if (lines_with(devices.output, "    driver ") == 0) GTEST_SKIP() << "no OpenCL device";
    EXPECT_EQ(lines_with(devices.output, "does not build: "),
              lines_with(devices.output, "    driver "));
    EXPECT_GE(lines_with(devices.output, "unknown_type_0"), 1U) << "its first error";
    EXPECT_EQ(devices.output.find("unknown_type_1"), std::string::npos) << devices.output;
    EXPECT_LT(longest_line(devices.output), 500U) << devices.output;
    EXPECT_NE(devices.output.find("No device passes its trial, so cpp is used"), std::string::npos)
        << devices.output;
}

TEST_P(BrokenKernel, LeavesThePictureToTheNextDevice) {
    const Result whole = run(draw("--compute cpp " + options_));
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    const Image expected = read_image(path("x.png"));
    fs::remove(path("x.png"));
    const Result drawn = run(draw(options_));
    EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
    EXPECT_EQ(lines_with(drawn.output, "lineatlas: kernels run as C++ on all cores, since "), 1U)
        << drawn.output;
    // PoCL prints its own lines.
    EXPECT_EQ(lines_with(drawn.output, "lineatlas: "), 1U) << drawn.output;
    EXPECT_TRUE(read_image(path("x.png")).pixels == expected.pixels);
}

TEST_P(OneBrokenKernel, EndsInALineWhereTheDeviceWasAskedFor) {
    const std::string wrong = GetParam().file + std::string{" does not build: "};
    for (const char* device : {"--device opencl: ", "--compute opencl "})
        expect_refused(draw(device + options_), 1, wrong);
    ::setenv("LINEATLAS_BUILD_LOG", path("log").c_str(), 1);
    const Result kept = run(draw("--compute opencl " + options_));
    ::unsetenv("LINEATLAS_BUILD_LOG");
    EXPECT_NE(kept.output.find("the whole log is in \"" + path("log") + '"'), std::string::npos)
        << kept.output;
    EXPECT_NE(read(path("log")).find("unknown_type_14"), std::string::npos) << read(path("log"));
}

constexpr Broken halo{"halo.cl", "KERNEL(halo_count", "--set halo=3 --interop copy"};

INSTANTIATE_TEST_SUITE_P(Kernels, OneBrokenKernel, testing::Values(halo));
INSTANTIATE_TEST_SUITE_P(
    Kernels, BrokenKernel,
    testing::Values(Broken{"scan.cl", "KERNEL(scan_list", ""}, // a kernel of every frame
                    Broken{"visible.cl", "KERNEL(visible_count", ""},
                    Broken{"compact.cl", "KERNEL(compact_count", "--method atlas"}, halo),
    [](const auto& tested) {
        const std::string file = tested.param.file;
        return file.substr(0, file.find('.'));
    });

TEST_F(Drivers, ThatAbortAreLeftOut) {
    use_fake("abort");
    const std::string cause = "\"Fake\" failed a trial (Aborted)";
    const Result alone = run("devices");
    EXPECT_EQ(alone.exit_code, 0) << alone.output;
    EXPECT_NE(alone.output.find("no OpenCL device can be used (" + cause + ")"), std::string::npos)
        << alone.output;
    expect_refused(draw("--device opencl:fake"), 1, cause);
    EXPECT_EQ(run(draw("--method atlas --stats")).exit_code, 0);
    if (!add_pocl()) GTEST_SKIP() << "PoCL is not installed";
    const Result beside = run("devices");
    EXPECT_EQ(beside.exit_code, 0) << beside.output;
    EXPECT_NE(beside.output.find("* opencl:Portable"), std::string::npos) << beside.output;
    EXPECT_NE(beside.output.find("not used: " + cause), std::string::npos) << beside.output;
    expect_refused(draw("--device opencl:fake"), 2, cause);
    EXPECT_EQ(run(draw("--device opencl:portable")).exit_code, 0);
}

TEST_F(Drivers, OfOneNameAreNumbered) {
    use_fake("twins");
    const Result devices = run("devices");
    EXPECT_EQ(devices.exit_code, 0) << devices.output;
    for (const char* name : {" opencl:Fake:Card #1\n", " opencl:Fake:Card #2\n"})
        EXPECT_EQ(lines_with(devices.output + "\n", std::string{name, std::strlen(name) - 1}), 1U)
            << devices.output;
    expect_refused(draw("--device opencl:fake:#2"), 1, "opencl: Card #2 (Fake): ");
    expect_refused(draw("--device opencl::card"), 1, "opencl: Card #1 (Fake): ");
    expect_refused(draw("--device opencl::#3"), 2,
                   "there is \"opencl:Fake:Card #1\" \"opencl:Fake:Card #2\"");
}

TEST_F(Drivers, WholeNamesChooseADeviceAlone) {
    use_fake("family");
    expect_refused(draw("--device opencl::card"), 1, "opencl: Card Plus (Fake): ");
    expect_refused(draw("--device opencl:Fake:Card"), 1, "opencl: Card (Fake): ");
}

TEST_F(Drivers, ThatRefuseOrAreMissingAreNamed) {
    const std::string fake = path("vendors/a_fake.icd");
    use_fake("refuse");
    const auto expect_said = [&](const std::string& words) {
        for (const std::string& command : {std::string{"devices"}, draw("--compute opencl")}) {
            const std::string said = run(command).output;
            EXPECT_NE(said.find("no OpenCL device was found (" + words), std::string::npos) << said;
        }
    };
    expect_said(fake + ": " LINEATLAS_FAKE_DRIVER " has no device; on Debian and Ubuntu: apt "
                       "install pocl-opencl-icd)");
    write("vendors/a_fake.icd", "libpocl_that_is_gone.so.2\n");
    expect_said(fake + ": libpocl_that_is_gone.so.2: cannot open shared object file: No such file "
                       "or directory); --compute cpp");
    if (!add_pocl()) GTEST_SKIP() << "PoCL is not installed";
    expect_refused(draw("--device opencl:gone"), 2, fake + ": libpocl_that_is_gone.so.2: cannot");
}

/// The driver loses the pixels of tiles from which strokes are removed again.
TEST_F(Drivers, ThatComputeSomethingElseAreNotUsed) {
    if (!add_pocl()) GTEST_SKIP() << "PoCL is not installed";
    fs::remove(path("vendors/a_fake.icd"));
    ::setenv("OCL_ICD_VENDORS", path("vendors").c_str(), 1);
    // Verdicts must be new, but PoCL's compiled kernels need not.
    const EnvironmentVariable compiled{"POCL_CACHE_DIR", usual_pocl_cache()};
    const EnvironmentVariable cache{"XDG_CACHE_HOME", path("cache")};
    const auto draw_here = [&] { return run(draw("--interop copy --method atlas")); };
    const std::string word = "something else than C++: stage strokes differs: kernel strokes_tiles";
    {
        const EnvironmentVariable layer{"OPENCL_LAYERS", LINEATLAS_FAULT_LAYER};
        const EnvironmentVariable fault{"LINEATLAS_TEST_MISCOMPILE",
                                        "(uchar)pixels[y * STROKE_STRIDE + x]=>(uchar)0"};
        const Result devices = run("devices --wait 120");
        EXPECT_EQ(devices.exit_code, 0) << devices.output;
        EXPECT_EQ(lines_with(devices.output, "    kernels          yes"), 1U) << devices.output;
        EXPECT_EQ(lines_with(devices.output, "    frames           no"), 1U) << devices.output;
        EXPECT_NE(devices.output.find(word), std::string::npos) << devices.output;
        EXPECT_NE(devices.output.find("No device passes"), std::string::npos) << devices.output;
        expect_refused(draw("--device opencl:portable --method atlas"), 1, word);
        const Result drawn = draw_here();
        EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
        EXPECT_EQ(lines_with(drawn.output, "lineatlas: kernels run as C++ on all cores, since "),
                  1U)
            << drawn.output;
    }
    const Image by_cpp = read_image(path("x.png"));
    fs::remove_all(path("cache")); // otherwise the verdict stays
    const Result drawn = draw_here();
    EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
    EXPECT_EQ(lines_with(drawn.output, "lineatlas: "), 0U) << drawn.output;
    EXPECT_TRUE(read_image(path("x.png")).pixels == by_cpp.pixels);
}

TEST_F(Drivers, WithoutABuildLogAreQuoted) {
    use_fake("silent");
    const Result devices = run("devices");
    EXPECT_NE(devices.output.find("does not build: clCompileProgram returned "
                                  "CL_COMPILE_PROGRAM_FAILURE (-15)"),
              std::string::npos)
        << devices.output;
}

} // namespace
} // namespace lineatlas::test
