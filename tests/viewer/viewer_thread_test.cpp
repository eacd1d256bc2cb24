// The window while a picture is being drawn, by a device whose kernels wait until they are let go.

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <thread>

#include "compute/cpp/cpp_device.hpp"
#include "compute/forwarding_device.hpp"
#include "environment_variable.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/error.hpp"
#include "viewer/drawing_thread.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

/// The device cpp, whose kernels wait while it is held, and fail while it is broken.
class HeldDevice final : public compute::ForwardingDevice {
  public:
    HeldDevice() : ForwardingDevice(compute::make_cpp_device()) {}

    static std::atomic<bool> held, broken;

    std::string description() const override { return "held"; }
    void launch(const compute::Launch& launch) override {
        while (held) std::this_thread::sleep_for(std::chrono::milliseconds{1});
        if (broken) throw Error("the device is broken");
        device().launch(launch);
    }
};
std::atomic<bool> HeldDevice::held{false}, HeldDevice::broken{false};

std::unique_ptr<compute::Device> make_held_device(std::string_view) {
    return std::make_unique<HeldDevice>();
}

class HeldViewer : public testing::Test {
  protected:
    HeldViewer() {
        session().settings.exact_at_rest = false;
        hand_.open_scene("house");
        EXPECT_TRUE(session().messages.all().empty());
    }
    ~HeldViewer() override { HeldDevice::held = HeldDevice::broken = false; }
    viewer::Session& session() { return app_.session(); }
    std::vector<std::uint8_t> picture() { return session().picture(0)->read(); }
    /// Steps until it is so.
    template <class Is>
    void step_until(const Is& is) {
        constexpr int most = 20'000;
        for (int i = 0; i < most && !is(); ++i) app_.step(0.01);
        EXPECT_TRUE(is());
    }
    /// The view is another one, of which a picture is being drawn until it is let go.
    void orbit_and_hold() {
        HeldDevice::held = true;
        session().navigation.orbit({0, 0, 0}, {0.2, 0.1});
        step_until([&] { return session().drawing(); });
    }
    static bool registered() {
        static const bool once = [] {
            compute::register_device({"held", "cpp, held", make_held_device});
            return true;
        }();
        return once;
    }

    bool registered_ = registered();
    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_{{.size = {1280, 800}, .device = {.compute = "held"}, .scale = 1},
                             writer_};
    ViewerDriver hand_{app_};
};

TEST_F(HeldViewer, TheWindowAnswersWhileAPictureIsDrawn) {
    const auto before = picture();
    orbit_and_hold();
    EXPECT_EQ(picture(), before) << "the last one stays in sight";
    EXPECT_TRUE(session().placement().moved);
    const bool sidebar = app_.ui().sidebar;
    app_.input().on_key(GLFW_KEY_TAB, 0, GLFW_PRESS, 0);
    app_.input().on_key(GLFW_KEY_TAB, 0, GLFW_RELEASE, 0);
    const std::uint64_t shown = app_.frames_shown(), drawn = session().frames_drawn();
    app_.step(0);
    EXPECT_NE(app_.ui().sidebar, sidebar) << "keys are heard";
    EXPECT_GT(app_.frames_shown(), shown);
    EXPECT_EQ(session().frames_drawn(), drawn);
    EXPECT_TRUE(session().drawing());
    HeldDevice::held = false;
    hand_.rest();
    EXPECT_FALSE(session().placement().moved);
    EXPECT_NE(picture(), before);
}

TEST_F(HeldViewer, WhatMovesMeanwhileKeepsAPictureFromBecomingExact) {
    HeldDevice::held = true; // else the picture may become exact before
    session().settings.exact_at_rest = true;
    session().refine();
    step_until([&] { return session().drawing() && session().refining(); });
    const auto sampled = picture();
    session().navigation.orbit({0, 0, 0}, {0.01, 0});
    app_.step(0);
    HeldDevice::held = false;
    // A step might also draw the next picture.
    ASSERT_TRUE(session().take_picture(std::chrono::minutes{5}));
    EXPECT_FALSE(session().refined());
    EXPECT_EQ(picture(), sampled) << "as it was";
    step_until([&] { return session().refined(); });
    EXPECT_NE(picture(), sampled);
}

TEST_F(HeldViewer, WhatNeedsTheDeviceWaitsForThePicture) {
    orbit_and_hold();
    const std::jthread letting_go{[] {
        std::this_thread::sleep_for(std::chrono::milliseconds{50});
        HeldDevice::held = false;
    }};
    session().use_device({.compute = "cpp"});
    EXPECT_FALSE(HeldDevice::held);
    EXPECT_EQ(session().device().compute, "cpp");
    hand_.rest();
    const auto after = picture();
    session().changed();
    hand_.rest();
    EXPECT_EQ(picture(), after);
    EXPECT_TRUE(session().messages.all().empty());
}

TEST_F(HeldViewer, TheWindowAnswersWhileAFileIsSaved) {
    app_.ui().folder = folder_.path().string();
    HeldDevice::held = true;
    hand_.press(GLFW_KEY_E, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    step_until([&] { return hand_.has("work.cancel"); });
    const bool hidden = session().settings.style.hidden;
    hand_.press(GLFW_KEY_H);
    hand_.press(GLFW_KEY_E, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT); // waits for the first
    app_.step(0);
    EXPECT_NE(session().settings.style.hidden, hidden) << "keys are heard";
    EXPECT_TRUE(HeldDevice::held);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "house.png"));
    HeldDevice::held = false;
    hand_.rest();
    EXPECT_FALSE(hand_.has("work.cancel"));
    const Image first = read_image(folder_.path() / "house.png");
    const Image second = read_image(folder_.path() / "house-2.png");
    EXPECT_NE(first.pixels, second.pixels) << "each is as it was when it was asked for";
}

TEST_F(HeldViewer, SavingCanBeCancelled) {
    app_.ui().folder = folder_.path().string();
    for (const char* extension : {"svg", "png"}) {
        HeldDevice::held = true;
        session().save_picture(folder_.path(), extension);
        session().save_picture(folder_.path(), extension);
        step_until([&] { return hand_.has("work.cancel"); });
        hand_.press(GLFW_KEY_ESCAPE);
        app_.step(0);
        HeldDevice::held = false;
        hand_.rest();
        EXPECT_EQ(session().work(), "");
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
    session().save_picture(folder_.path(), "svg");
    hand_.rest();
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "house.svg")) << "the next is saved";
}

TEST_F(HeldViewer, AnotherModelWaitsForThePictureAndTheWindowDoesNot) {
    orbit_and_hold();
    session().open_scene("clevis");
    while (viewer::Loader::any_thread()) app_.step(0.01);
    const std::jthread letting_go{[](const std::stop_token& stop) { // ends a test that fails
        for (int i = 0; i < 500 && !stop.stop_requested(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        HeldDevice::held = false;
    }};
    for (int i = 0; i < 10; ++i) app_.step(0);
    EXPECT_TRUE(HeldDevice::held);
    EXPECT_EQ(session().model()->source.name(), "house");
    HeldDevice::held = false;
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "clevis");
}

TEST_F(HeldViewer, AFileIsOfTheModelInSightWhileAnotherIsTaken) {
    session().save_picture(folder_.path(), "svg");
    hand_.open_scene("clevis");
    const auto clevis = picture();
    hand_.open_scene("house");
    HeldDevice::held = true;
    session().open_scene("clevis");
    step_until([&] { return session().drawing(); });
    session().save_picture(folder_.path(), "svg");
    HeldDevice::held = false;
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "clevis");
    EXPECT_EQ(text_of((folder_.path() / "house-2.svg").string()),
              text_of((folder_.path() / "house.svg").string()));
    EXPECT_EQ(picture(), clevis) << "its lines are not those of the file";
}

TEST_F(HeldViewer, AModelThatCannotBeTakenLeavesTheOneBefore) {
    const auto house = picture();
    HeldDevice::broken = true;
    session().open_scene("clevis");
    step_until([&] { return !session().messages.all().empty(); });
    HeldDevice::broken = false;
    EXPECT_EQ(session().model()->source.name(), "house");
    session().changed();
    hand_.rest();
    EXPECT_EQ(picture(), house);
    hand_.open_scene("clevis");
    EXPECT_EQ(session().model()->source.name(), "clevis");
}

TEST_F(HeldViewer, ASessionKeepsItsSettingsWhileSomethingElseIsOpened) {
    const std::filesystem::path boxes = folder_.path() / "boxes.obj",
                                file = folder_.path() / "boxes.session.toml";
    std::ofstream{boxes} << box("Nut", {-2, 0, 0}, 1) << box("Bolt", {2, 0, 0}, 9);
    hand_.drop(boxes);
    session().select(0);
    session().hide_selected();
    hand_.rest();
    ASSERT_TRUE(session().save_session(file));
    hand_.open_scene("house");
    HeldDevice::held = true;
    session().open(file);
    step_until([&] { return session().drawing(); });
    session().open_scene("clevis");
    HeldDevice::held = false;
    step_until([&] { return session().model()->source.name() == "boxes.obj"; });
    EXPECT_EQ(session().settings.shown.parts.hidden.size(), 1U);
    EXPECT_EQ(session().session_path(), file);
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "clevis");
    EXPECT_EQ(session().session_path(), "");
}

TEST_F(HeldViewer, EscapeCancelsWhatTheWindowOffersToCancel) {
    const auto reads = std::make_shared<std::atomic<bool>>(true);
    session().loader.set_reader([reads](const auto&) -> std::shared_ptr<viewer::Model> {
        while (*reads) std::this_thread::sleep_for(std::chrono::milliseconds{1});
        throw Error("there is none");
    });
    HeldDevice::held = true;
    session().save_picture(folder_.path(), "svg");
    step_until([&] { return hand_.has("work.cancel"); });
    session().open_scene("clevis");
    step_until([&] { return hand_.has("cancel"); });
    EXPECT_FALSE(hand_.has("work.cancel"));
    hand_.press(GLFW_KEY_ESCAPE);
    app_.step(0);
    EXPECT_FALSE(session().loader.busy());
    EXPECT_EQ(session().work(), viewer::saving_work);
    HeldDevice::held = *reads = false;
    hand_.rest();
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "house.svg"));
    while (viewer::Loader::any_thread()) std::this_thread::yield();
}

TEST_F(HeldViewer, AStoppedRecordingLeavesTheNextOneItsPictures) {
    HeldDevice::held = true;
    session().start_recording(viewer::Session::Move::turntable, folder_.path(), 2);
    step_until([&] { return session().drawing(); });
    session().cancel_recording();
    session().start_recording(viewer::Session::Move::turntable, folder_.path(), 2);
    HeldDevice::held = false;
    hand_.rest();
    for (const char* name : {"0000.png", "0001.png"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "house-pictures-2" / name)) << name;
}

TEST_F(HeldViewer, ANameIsTakenWhileAFileOfThatNameWaits) {
    const std::filesystem::path first = folder_.path() / "house.svg";
    HeldDevice::held = true;
    session().export_to(first, {.format = viewer::FileFormat::svg});
    EXPECT_TRUE(session().is_taken(first));
    EXPECT_EQ(session().free_path(folder_.path(), "svg"), folder_.path() / "house-2.svg");
    session().save_picture(folder_.path(), "svg");
    EXPECT_EQ(session().free_path(folder_.path(), "svg"), folder_.path() / "house-3.svg");
    HeldDevice::held = false;
    hand_.rest();
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "house-2.svg"));
}

TEST_F(HeldViewer, AVideoCanBeCancelled) {
    const std::filesystem::path program = folder_.path() / "ffmpeg";
    std::ofstream{program} << "#!/bin/sh\nfor last; do :; done\ntouch \"$last\"\nexec sleep 600\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const EnvironmentVariable path{"PATH", folder_.path().string() + ":" + std::getenv("PATH")};
    session().start_recording(viewer::Session::Move::turntable, folder_.path(), 2);
    const std::filesystem::path video = folder_.path() / "house-pictures.mp4";
    step_until([&] { return hand_.has("work.cancel") && std::filesystem::exists(video); });
    EXPECT_EQ(session().work(), viewer::video_work);
    hand_.press(GLFW_KEY_ESCAPE);
    const auto start = std::chrono::steady_clock::now();
    hand_.rest();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes{1});
    EXPECT_FALSE(std::filesystem::exists(video));
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "house-pictures" / "0001.png"));
}

TEST_F(HeldViewer, TheWindowClosesWhileAPictureIsDrawn) {
    orbit_and_hold();
    app_.window().close();
    app_.run();
    EXPECT_TRUE(session().drawing()); // ~HeldViewer() lets it go
}

TEST(ViewerEnd, WhatIsToBeSavedIsSavedBeforeTheWindowIsGone) {
    const TemporaryFolder folder;
    {
        ImageWriter writer;
        viewer::Application app{{.size = {600, 400}, .scale = 1, .scripted = true}, writer};
        ViewerDriver{app}.open_scene("clevis");
        app.session().save_picture(folder.path(), "svg");
        app.session().save_picture(folder.path(), "svg");
        app.step(0); // the first begins
    }
    for (const char* name : {"clevis.svg", "clevis-2.svg"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
}

TEST(ViewerEnd, AFileThatCouldNotBeSavedIsNamed) {
    const TemporaryFolder folder;
    ImageWriter writer;
    viewer::Application app{{.size = {600, 400}, .scale = 1, .scripted = true}, writer};
    ViewerDriver{app}.open_scene("clevis");
    app.session().export_to(folder.path() / "lost" / "clevis.svg",
                            {.format = viewer::FileFormat::svg});
    app.session().save_picture(folder.path(), "svg");
    const std::vector<std::string> failures = app.session().finish_saving();
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_NE(failures.front().find("lost/clevis.svg"), std::string::npos) << failures.front();
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "clevis.svg"));
}

/// A context that there is not.
struct NoContext final : viewer::SharedContext {
    void make_current() override {}
    void release() override {}
};

TEST(DrawingThread, DoesOneThingAfterTheOther) {
    NoContext context;
    std::atomic<int> woken{0}, done{0};
    viewer::DrawingThread thread{context, [&] { ++woken; }};
    EXPECT_FALSE(thread.busy());
    for (int i = 0; i < 100; ++i) thread.start([&, i] { EXPECT_EQ(done++, i); });
    int seen = 0;
    thread.run([&] { seen = done; });
    EXPECT_EQ(seen, 100);
    EXPECT_EQ(woken, 100);
    EXPECT_THROW(thread.run([] { throw std::runtime_error{"no"}; }), std::runtime_error);
    thread.run([&] { seen = 0; });
    EXPECT_EQ(seen, 0);
}

TEST(DrawingThread, WaitsAsLongAsItIsTold) {
    NoContext context;
    viewer::DrawingThread thread{context, [] {}};
    std::atomic<bool> ends{false};
    thread.start([&] {
        while (!ends) std::this_thread::yield();
    });
    EXPECT_FALSE(thread.wait_for(std::chrono::milliseconds{1}));
    EXPECT_TRUE(thread.busy());
    ends = true;
    thread.wait();
    EXPECT_TRUE(thread.wait_for(std::chrono::milliseconds{0}));
}

} // namespace
} // namespace lineatlas::test
