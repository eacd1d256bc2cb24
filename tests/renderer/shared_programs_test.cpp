// Programs are built once in a process. The tests count requests to the driver.
#include <array>
#include <thread>
#include <vector>

#include "fault_support.hpp"

namespace lineatlas::test {
namespace {

class SharedPrograms : public FaultFixture {
  protected:
    SharedPrograms() { opencl_faults().builds_once = false; }

    /// Forgets all programs that are built.
    void forget_programs() {
        const std::unique_ptr<Renderer> renderer = make_renderer();
        opencl_faults().fail_command = 1;
        EXPECT_THROW(draw(*renderer, {}), DeviceError);
        opencl_faults().reset();
    }
};

TEST_P(SharedPrograms, AProcessBuildsAProgramOnce) {
    const FrameOptions options = all_effects(Method::atlas);
    const std::unique_ptr<Renderer> first = make_renderer();
    const Picture expected = draw(*first, options);
    opencl_faults().builds = 0;
    EXPECT_EQ(draw(*make_renderer(), options), expected); // while the first one exists
    EXPECT_EQ(draw(*make_renderer(), options), expected); // after another one is destroyed
    EXPECT_EQ(opencl_faults().builds, 0);
}

TEST_P(SharedPrograms, WhatHasFailedIsNotShared) {
    const Picture expected = draw(*make_renderer(), {});
    for (const bool lost : {false, true}) {
        const std::unique_ptr<Renderer> renderer = make_renderer();
        draw(*renderer, {});
        opencl_faults().lost = lost;
        opencl_faults().fail_command = 3;
        EXPECT_THROW(draw(*renderer, {}), DeviceError);
        opencl_faults().reset();
        EXPECT_EQ(draw(*make_renderer(), {}), expected);
        EXPECT_GT(opencl_faults().builds, 0) << "a context in which something failed is in use";
        opencl_faults().builds = 0;
        EXPECT_EQ(draw(*make_renderer(), {}), expected);
        EXPECT_EQ(opencl_faults().builds, 0);
    }
}

TEST_P(SharedPrograms, ThreadsBuildAProgramOnceTogether) {
    forget_programs();
    const Picture expected = draw(*make_renderer(), {});
    const int builds = opencl_faults().builds;
    EXPECT_GT(builds, 0);
    forget_programs();
    std::array<Picture, 3> pictures;
    {
        std::vector<std::jthread> threads;
        for (Picture& picture : pictures) {
            threads.emplace_back([this, &picture] {
                const gl::HeadlessContext context;
                gl::Canvas canvas{fault_size};
                canvas.clear({1, 1, 1, 1});
                Renderer renderer{{.compute = "opencl", .interop = GetParam()}};
                renderer.set_lines(lines_);
                renderer.draw(camera_, {}, canvas.framebuffer());
                picture = canvas.read();
            });
        }
    }
    for (const Picture& picture : pictures) EXPECT_EQ(picture, expected);
    EXPECT_EQ(opencl_faults().builds, builds);
}

// Programs do not depend on the sharing mode.
INSTANTIATE_TEST_SUITE_P(OneMode, SharedPrograms, testing::Values("host-pointer"), mode_name);

} // namespace
} // namespace lineatlas::test
