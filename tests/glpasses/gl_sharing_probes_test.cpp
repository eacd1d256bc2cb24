// The answers of probes about drivers that share, refuse, lie, crash or hang.

#include <chrono>

#include "gl_sharing_support.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/gl_context.hpp"
#include "lineatlas/error.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

using interop::ModeReport;
using interop::SharingMode;

class GlSharingProbes : public GlSharing {
  protected:
    static ModeReport report() { return interop::probe_mode(device(), SharingMode::gl_sharing); }
    static void expect_no(const char* behaviour, const std::string& reason) {
        behave(behaviour);
        const ModeReport found = report();
        EXPECT_FALSE(found.works) << behaviour;
        EXPECT_NE(found.reason.find(reason), std::string::npos) << found.reason;
        // By default the next best mode is taken, and the mode itself can't be forced.
        EXPECT_EQ(interop::connect({}).sharing->mode(), SharingMode::host_pointer) << behaviour;
        EXPECT_THROW(interop::connect({.interop = "gl-sharing"}), DeviceError);
    }
};

TEST_F(GlSharingProbes, SharesBuffersAndTextures) {
    take_counts();
    const ModeReport found = report();
    EXPECT_TRUE(found.works) << found.reason;
    const LayerCounts counts = take_counts();
    EXPECT_NE(found.reason.find(said_of_textures(counts)), std::string::npos) << found.reason;
    EXPECT_EQ(counts.violations, 0U);
    EXPECT_EQ(interop::connect({}).sharing->mode(), SharingMode::gl_sharing);
}

TEST_F(GlSharingProbes, SharesWithEvents) {
    behave("events");
    const ModeReport found = report();
    EXPECT_TRUE(found.works) << found.reason;
    EXPECT_EQ(take_counts().violations, 0U);
}

TEST_F(GlSharingProbes, SharesBuffersAlone) {
    behave("buffers-only");
    const ModeReport found = report();
    EXPECT_TRUE(found.works) << found.reason;
    EXPECT_NE(found.reason.find("textures not"), std::string::npos) << found.reason;
}

TEST_F(GlSharingProbes, SaysWhyNot) {
    expect_no("refuse", "clCreateContext");
    expect_no("lie", "sharing a GL buffer failed");
    expect_no("stale", "other data");
}

TEST_F(GlSharingProbes, AsksBeforeItCreatesAContext) {
    take_counts();
    expect_no("other-device", "GL does not run on this device");
    expect_no("no-query", "clGetGLContextInfoKHR");
    EXPECT_EQ(take_counts().contexts, 0U);
}

TEST_F(GlSharingProbes, SharesExternalMemory) {
    if (const std::string why = missing_vulkan(); !why.empty()) GTEST_SKIP() << why;
    take_counts();
    const ModeReport found = interop::probe_mode(device(), SharingMode::external_memory);
    EXPECT_TRUE(found.works) << found.reason;
    EXPECT_EQ(take_counts().violations, 0U);
    EXPECT_EQ(interop::connect({}).sharing->mode(), SharingMode::external_memory);
}

TEST_F(GlSharingProbes, SaysWhyExternalMemoryIsNotShared) {
    const auto reason = [] {
        const ModeReport found = interop::probe_mode(device(), SharingMode::external_memory);
        EXPECT_FALSE(found.works);
        return found.reason;
    };
    EXPECT_EQ(reason(), "the device does not list cl_khr_external_memory_opaque_fd");
    if (const std::string why = missing_vulkan(); !why.empty()) GTEST_SKIP() << why;
    behave("external stale");
    EXPECT_EQ(reason(), "a round trip returned other data");
    EXPECT_EQ(interop::connect({}).sharing->mode(), SharingMode::host_pointer);
}

TEST_F(UsesLayer, NothingIsSharedWithoutAGlContext) {
    EXPECT_TRUE(interop::current_gl_properties().empty());
    EXPECT_EQ(interop::gl_sharing_obstacle(device()), "no GL context is current");
}

/// Runs `lineatlas devices`, which tries each mode in a separate process.
class GlSharingTool : public Tool {
  protected:
    static Result devices(const std::string& behaviour, const std::string& options = "") {
        use_gl_sharing_layer();
        behave(behaviour.c_str());
        Result result = run("devices " + options);
        behave("");
        return result;
    }
    static void expect_line(const Result& result, const std::string& line) {
        EXPECT_EQ(result.exit_code, 0) << result.output;
        EXPECT_NE(result.output.find(line), std::string::npos) << line << "\n" << result.output;
    }
};

TEST_F(GlSharingTool, ListsADriverThatShares) {
    expect_line(devices(""), "gl-sharing       yes");
}

TEST_F(GlSharingTool, SurvivesADriverThatCrashes) {
    const Result result = devices("crash");
    expect_line(result, "gl-sharing       no   the driver crashed (Segmentation fault)");
    expect_line(result, "host-pointer     yes");
}

TEST_F(GlSharingTool, SurvivesADriverThatHangs) {
    const auto start = std::chrono::steady_clock::now();
    const Result result = devices("hang", "--wait 10");
    expect_line(result, "gl-sharing       no   no answer within 10 seconds");
    expect_line(result, "host-pointer     yes");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds{60});
}

} // namespace
} // namespace lineatlas::test
