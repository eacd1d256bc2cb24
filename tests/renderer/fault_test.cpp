// Failures of a driver: every creation and every command of a frame fails in turn.
#include <iostream>

#include <CL/cl.h>

#include "fault_support.hpp"

namespace lineatlas::test {
namespace {

class Fault : public FaultFixture {
  protected:
    /// Expects that a destroyed renderer leaves nothing but the shared context with its programs.
    /// After a failure not even that is left.
    static void expect_only_shared(const ClCounts& shared) {
        const ClCounts& left = opencl_faults().references;
        for (const ClKind kind : {cl_contexts, cl_programs}) EXPECT_LE(left[kind], shared[kind]);
        for (const ClKind kind : {cl_queues, cl_memory, cl_kernels, cl_events})
            EXPECT_EQ(left[kind], shared[kind]);
    }

    /// Runs a renderer from construction to destruction with the n-th creation failing, for n from
    /// 1 until no creation fails.
    void fail_each_creation(int& fail, const int& creations, const FrameOptions& options) {
        const Picture expected = draw(*make_renderer(), options);
        const long live_gl = gl_faults().live;
        const ClCounts live_cl = opencl_faults().references;
        int failed = 0, survived = 0, n = 0;
        for (bool reached = true; reached;) {
            fail = ++n;
            const int before = creations;
            try {
                const Picture picture = draw(*make_renderer(), options);
                reached = fail == 0;
                if (reached) ++survived;
                EXPECT_EQ(picture, expected) << "creation " << n;
            } catch (const DeviceError& error) {
                ++failed;
                EXPECT_EQ(fail, 0) << "failed before creation " << n << ": " << error.what();
                EXPECT_GT(std::string{error.what()}.size(), 20U);
            }
            EXPECT_GT(creations, before);
            EXPECT_EQ(gl_faults().live, live_gl) << "objects of GL left after creation " << n;
            {
                SCOPED_TRACE("OpenCL objects left after creation " + std::to_string(n));
                expect_only_shared(live_cl);
            }
            fail = 0;
            if (HasFailure()) return;
        }
        EXPECT_GT(failed, 20);
        EXPECT_EQ(draw(*make_renderer(), options), expected);
        EXPECT_EQ(opencl_faults().references, live_cl);
        std::cout << failed << " failures ended in an error, " << survived << " were survived\n";
    }
};

TEST_P(Fault, EveryOpenClCreationThatFailsIsACleanError) {
    fail_each_creation(opencl_faults().fail_creation, opencl_faults().creations,
                       all_effects(Method::atlas));
}

TEST_P(Fault, EveryGlCreationThatFailsIsACleanError) {
    for (const Method method : {Method::atlas, Method::spine, Method::item_buffer}) {
        SCOPED_TRACE(static_cast<int>(method));
        fail_each_creation(gl_faults().fail_creation, gl_faults().creations, all_effects(method));
    }
}

TEST_P(Fault, ARendererGoesOnAfterAQueueThatFailsInTheMiddleOfAFrame) {
    const FrameOptions options = all_effects(Method::atlas);
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    for (int frame = 0; frame < 2; ++frame) { // after the second frame all lasting objects exist
        opencl_faults().commands = 0;
        EXPECT_EQ(draw(*renderer, options), expected);
    }
    const int commands = opencl_faults().commands;
    EXPECT_GT(commands, 20);
    int failed = 0;
    for (int n = 1; n <= commands; ++n) {
        opencl_faults().fail_command = n;
        try {
            draw(*renderer, options);
        } catch (const DeviceError&) {
            ++failed;
        }
        opencl_faults().fail_command = 0;
        EXPECT_EQ(draw(*renderer, options), expected) << "after command " << n;
        if (HasFailure()) return;
    }
    EXPECT_EQ(failed, commands);
}

TEST_P(Fault, ALostContextIsSaidAndANewOneWorks) {
    const FrameOptions options = all_effects(Method::atlas);
    std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    gl_faults().context_lost = true;
    try {
        draw(*renderer, options);
        ADD_FAILURE() << "nothing was said";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string{error.what()}.find("context was lost"), std::string::npos);
    }
    EXPECT_NO_THROW(renderer.reset());
    gl_faults().context_lost = false;
    canvas_.reset(); // of the old context
    const gl::HeadlessContext another;
    canvas_ = std::make_unique<gl::Canvas>(fault_size);
    EXPECT_EQ(draw(*make_renderer(), options), expected);
}

TEST_P(Fault, AnErrorThatComesLateIsSaidToo) {
    const FrameOptions options = all_effects(Method::atlas);
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    opencl_faults().commands = 0;
    draw(*renderer, options);
    const int commands = opencl_faults().commands;
    for (int n = 1; n <= commands; ++n) {
        opencl_faults().late = true;
        opencl_faults().fail_command = n;
        int said = 0;
        // If only the next frame waits for a command, the error is that frame's.
        for (int frame = 0; frame < 2; ++frame) {
            try {
                draw(*renderer, options);
            } catch (const DeviceError& error) {
                ++said;
                EXPECT_NE(std::string{error.what()}.find("ERROR_FOR_EVENTS"), std::string::npos);
            }
        }
        opencl_faults().late = false;
        EXPECT_EQ(said, 1) << "command " << n;
        EXPECT_EQ(draw(*renderer, options), expected) << "after command " << n;
        if (HasFailure()) return;
    }
}

TEST_P(Fault, ADeviceThatIsLostIsSaidAndANewRendererWorks) {
    const FrameOptions options = all_effects(Method::atlas);
    const Picture expected = draw(*make_renderer(), options);
    const long live_gl = gl_faults().live;
    const ClCounts live_cl = opencl_faults().references;
    for (const int n : {1, 7, 20}) {
        std::unique_ptr<Renderer> renderer = make_renderer();
        draw(*renderer, options);
        opencl_faults().status = CL_DEVICE_NOT_AVAILABLE;
        opencl_faults().lost = true;
        opencl_faults().fail_command = n;
        for (int frame = 0; frame < 2; ++frame) {
            try {
                draw(*renderer, options);
                ADD_FAILURE() << "nothing was said";
            } catch (const DeviceError& error) {
                const std::string said = error.what();
                // The second frame first makes its tables again.
                if (frame == 1) continue;
                EXPECT_NE(said.find("the device is lost"), std::string::npos) << said;
            }
        }
        EXPECT_THROW(renderer->set_device({.compute = "cpp"}), DeviceError);
        EXPECT_NO_THROW(renderer.reset());
        EXPECT_EQ(gl_faults().live, live_gl);
        expect_only_shared(live_cl);
        opencl_faults().reset();
        EXPECT_EQ(draw(*make_renderer(), options), expected);
        EXPECT_EQ(opencl_faults().references, live_cl);
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, Fault, testing::Values("copy", "host-pointer"), mode_name);

} // namespace
} // namespace lineatlas::test
