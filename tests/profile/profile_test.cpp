// Profiles: the trace as a viewer reads it, the order of GL and kernels on the trace's common
// clock, and the shares of stages in a frame.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/host_clock.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/profile.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

using Json = nlohmann::json;

const std::set<std::string> transfers{"map", "unmap", "read", "write", "copy", "fill"};

/// Finds errors of a trace that would confuse a viewer or a reader; empty if there are none.
class TraceCheck {
  public:
    explicit TraceCheck(const std::string& text) {
        const Json trace = Json::parse(text, nullptr, false);
        if (trace.is_discarded() || !trace.contains("traceEvents")) {
            problems.push_back("no trace");
            return;
        }
        for (const auto& [clock, error] : trace["otherData"]["clock_error_ns"].items()) {
            tolerance_ = std::max(tolerance_, error.get<double>() + 1);
        }
        for (const Json& event : trace["traceEvents"]) read(event);
        for (auto& [thread, events] : threads_) check_thread(thread, events);
        for (const auto& [number, frame] : frames_) check_frame(number, frame);
    }

    /// Expects in every frame that `second` begins after `first` has ended, each on its own queue.
    /// once: after the first piece of work of `first`; later pieces are for other stages.
    void expect_order(const std::string& first, const std::string& second, bool once = false) {
        for (auto& [number, frame] : frames_) {
            double end = -1, start = -1;
            for (const Event& event : frame.work) {
                if (event.stage == first && !(once && end >= 0)) end = std::max(end, event.end);
                if (event.stage == second && start < 0) start = event.start;
            }
            if (end < 0 || start < 0) {
                problems.push_back(first + " or " + second + " is missing");
            } else if (start < end - tolerance_) {
                problems.push_back(second + " began before " + first + " was done");
            }
        }
    }

    void expect_stages(const std::set<std::string>& stages) {
        for (const auto& [number, frame] : frames_) {
            if (frame.stages != stages) {
                std::string names;
                for (const std::string& stage : frame.stages) names += " " + stage;
                problems.push_back("frame " + std::to_string(number) + " has" + names);
            }
        }
    }

    std::size_t frame_count() const { return frames_.size(); }
    std::vector<std::string> problems;

  private:
    struct Event {
        std::string name, stage;
        double start, end; ///< nanoseconds
    };
    struct Frame {
        std::vector<Event> host, work; ///< events of this thread, and of the two queues
        std::set<std::string> stages;
        std::optional<Event> whole;
    };

    void read(const Json& event) {
        const std::string phase = event.value("ph", "");
        const bool named = event.contains("name") && event["name"].is_string() &&
                           event.contains("pid") && event.contains("tid");
        if (!named) return problems.push_back("an event without name, pid or tid");
        const int thread = event["tid"];
        if (phase == "M") {
            if (event["name"] == "thread_name") names_[thread] = event["args"]["name"];
        } else if (phase == "C") {
            if (!event["args"]["samples"].is_number()) problems.push_back("no count of samples");
        } else if (phase == "X") {
            read_complete(event, thread);
        } else {
            problems.push_back("an unknown phase " + phase);
        }
    }

    void read_complete(const Json& event, int thread) {
        if (!event["ts"].is_number() || !event["dur"].is_number() || event["dur"] < 0) {
            return problems.push_back("no times");
        }
        const double start = std::round(event["ts"].get<double>() * 1000);
        const double duration = std::round(event["dur"].get<double>() * 1000);
        const Event read{event["name"], event["args"].value("stage", ""), start, start + duration};
        threads_[thread].push_back(read);
        Frame& frame = frames_[event["args"]["frame"]];
        const std::string track = names_[thread];
        if (track == "frames") {
            frame.whole = read;
            return;
        }
        if (!read.stage.empty()) frame.stages.insert(read.stage);
        (track == "GL passes" || track == "compute queue" ? frame.work : frame.host)
            .push_back(read);
    }

    void check_thread(int thread, std::vector<Event>& events) {
        if (!names_.contains(thread)) problems.push_back("a thread without a name");
        std::ranges::stable_sort(events, {}, &Event::start);
        for (std::size_t i = 1; i < events.size(); ++i) {
            if (events[i].start >= events[i - 1].end) continue;
            problems.push_back(events[i].name + " overlaps " + events[i - 1].name);
        }
    }

    void check_frame(int number, const Frame& frame) {
        const auto say = [&](const std::string& what) {
            problems.push_back("frame " + std::to_string(number) + ": " + what);
        };
        if (!frame.whole) return say("is missing");
        for (const auto* events : {&frame.host, &frame.work}) {
            for (const Event& event : *events) {
                const bool inside = event.start >= frame.whole->start - tolerance_ &&
                                    event.end <= frame.whole->end + tolerance_;
                if (!inside) say(event.name + " lies outside");
            }
        }
        for (const Event& event : frame.work) {
            if (event.stage.empty() && transfers.contains(event.name))
                continue; // of growing tables
            const auto stage = std::ranges::find(frame.host, event.stage, &Event::stage);
            if (stage == frame.host.end()) {
                say(event.name + " belongs to no stage");
            } else if (event.start < stage->start - tolerance_) {
                say(event.name + " began before its stage");
            }
        }
    }

    double tolerance_ = 1; ///< nanoseconds: the stated error between the clocks
    std::map<int, std::string> names_;
    std::map<int, std::vector<Event>> threads_;
    std::map<int, Frame> frames_;
};

std::string joined(const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : problems) text += problem + "\n";
    return text;
}

class Profiles : public testing::Test {
  protected:
    /// A renderer that has drawn `scene` once, so that kernels are built and tables are large
    /// enough.
    Renderer warm(const std::string& scene, const DeviceOptions& device = {}) {
        Renderer renderer{device};
        renderer.set_lines(scene_lines(scene));
        camera_ = scene_cameras(scene, canvas_.size()).front().camera;
        draw(renderer, options_);
        return renderer;
    }

    std::vector<std::uint8_t> draw(Renderer& renderer, const FrameOptions& options) {
        canvas_.clear(glm::vec4{1});
        renderer.draw(camera_, options, canvas_.framebuffer());
        return canvas_.read(); // waits
    }

    std::vector<FrameProfile> profile(Renderer& renderer, int frames) {
        FrameOptions options = options_;
        options.profile = true;
        for (int i = 0; i < frames; ++i) draw(renderer, options);
        return renderer.take_profiles();
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
    Camera camera_{};
    FrameOptions options_{.forms = {.atlas = StageForm::compute, .depth = StageForm::raster}};
};

const std::set<std::string> atlas_stages{
    "depth", "handover", "pyramid",  "facing",  "silhouette", "chain", "project_clip",
    "scan",  "atlas",    "temporal", "compact", "strokes",    "planes"};

void expect_sound(TraceCheck& check, StageForm depth = StageForm::raster) {
    if (depth == StageForm::raster) {
        // The numbers of surfaces are copied while segments are projected.
        check.expect_order("depth", "pyramid", true);
        check.expect_order("pyramid", "project_clip");
        check.expect_order("depth", "atlas");
    } else {
        check.expect_order("depth", "project_clip");
    }
    check.expect_order("project_clip", "scan");
    check.expect_order("scan", "atlas");
    check.expect_order("atlas", "temporal");
    check.expect_order("temporal", "compact");
    check.expect_order("compact", "strokes");
}

TEST_F(Profiles, ATraceTellsEveryStageInOrderOnOneClock) {
    for (const std::string scene : {"house", "ship"}) {
        SCOPED_TRACE(scene);
        Renderer renderer = warm(scene);
        const std::vector<FrameProfile> frames = profile(renderer, 3);
        TraceCheck check{profile_trace(frames, renderer.description())};
        EXPECT_EQ(check.frame_count(), 3U);
        std::set<std::string> stages = atlas_stages;
        if (scene == "ship") stages.insert("cull"); // large enough for clusters
        check.expect_stages(stages);
        expect_sound(check);
        EXPECT_EQ(joined(check.problems), "");
    }
}

TEST_F(Profiles, OfDepthByKernelsThePyramidIsAPart) {
    options_.forms.depth = StageForm::compute;
    Renderer renderer = warm("ship");
    TraceCheck check{profile_trace(profile(renderer, 3), renderer.description())};
    EXPECT_EQ(check.frame_count(), 3U);
    std::set<std::string> stages = atlas_stages;
    stages.erase("pyramid");
    check.expect_stages(stages);
    expect_sound(check, StageForm::compute);
    EXPECT_EQ(joined(check.problems), "");
}

TEST_F(Profiles, TheCheckFindsWhatIsWrong) {
    Renderer renderer = warm("house");
    const std::vector<FrameProfile> frames = profile(renderer, 1);
    const auto problems = [&](const auto& plant) {
        std::vector<FrameProfile> wrong = frames;
        for (ProfileEvent& event : wrong[0].events) plant(event);
        TraceCheck check{profile_trace(wrong, "")};
        check.expect_stages(atlas_stages);
        expect_sound(check);
        return joined(check.problems);
    };
    constexpr std::int64_t far = 1'000'000'000;
    EXPECT_EQ(problems([](ProfileEvent&) {}), "");
    const auto shifted = [&](ProfileTrack track, const std::string& stage, std::int64_t by) {
        return problems([&](ProfileEvent& event) {
            if (event.track != track || event.stage != stage) return;
            event.start += by;
            event.end += by;
        });
    };
    EXPECT_NE(shifted(ProfileTrack::compute, "atlas", -far).find("before its stage"),
              std::string::npos);
    EXPECT_NE(shifted(ProfileTrack::gl, "strokes", far).find("outside"), std::string::npos);
    EXPECT_NE(shifted(ProfileTrack::gl, "depth", far).find("before depth was done"),
              std::string::npos);
    const std::string longer = problems([](ProfileEvent& event) {
        if (event.name == "scan_chunks_reduce") event.end += 3 * far;
    });
    EXPECT_NE(longer.find("overlaps"), std::string::npos);
    const std::string renamed = problems([](ProfileEvent& event) {
        if (event.stage == "temporal") event.stage = "smooth";
    });
    EXPECT_NE(renamed.find("temporal is missing"), std::string::npos);
    EXPECT_EQ(joined(TraceCheck{"{"}.problems), "no trace\n");
}

TEST_F(Profiles, TimesLieWithinThoseOfTheHost) {
    Renderer renderer = warm("house");
    const std::int64_t before = host_nanoseconds();
    const std::vector<FrameProfile> frames = profile(renderer, 2);
    const std::int64_t after = host_nanoseconds();
    for (const FrameProfile& frame : frames) {
        ASSERT_TRUE(frame.gl_error.has_value());
        const std::int64_t error = std::max(*frame.gl_error, frame.compute_error.value_or(0));
        for (const ProfileEvent& event : frame.events) {
            EXPECT_GE(event.start, before - error) << event.name;
            EXPECT_LE(event.end, after + error) << event.name;
        }
        EXPECT_GT(frame.samples, 0U);
    }
}

TEST_F(Profiles, StagesAddUpToTheFrame) {
    for (const char* compute : {"opencl", "cpp"}) {
        Renderer renderer = warm("house", {.compute = compute});
        // Work without a stage is missing in every frame. Other programs take time from some frames
        // only.
        double largest = 0;
        for (const FrameProfile& frame : profile(renderer, 5)) {
            double sum = 0;
            for (const StageShare& share : stage_shares(frame)) sum += share.nanoseconds;
            const auto length = static_cast<double>(frame.end - frame.start);
            largest = std::max(largest, sum / length);
            EXPECT_LE(sum, length + 1) << compute;
        }
        EXPECT_GE(largest, 0.95) << compute;
    }
}

TEST_F(Profiles, PassesOnOneFramebufferAreToldApart) {
    Renderer renderer = warm("house");
    options_.style.fill.mode = FillMode::lambert;
    options_.style.paper.grain = 0.3F;
    FrameOptions waiting = options_;
    waiting.measure_stages = true;
    double least = 1e9; // the time that waiting after the stage measures, milliseconds
    for (int i = 0; i < 5; ++i) {
        canvas_.clear(glm::vec4{1});
        const FrameStats stats = renderer.draw(camera_, waiting, canvas_.framebuffer());
        const auto paper = std::ranges::find(stats.stages, "paper", &StageTime::name);
        ASSERT_NE(paper, stats.stages.end());
        least = std::min(least, paper->milliseconds);
    }
    double most = 0;
    for (const FrameProfile& frame : profile(renderer, 5)) {
        for (const ProfileEvent& event : frame.events) {
            if (event.track != ProfileTrack::gl || event.stage != "paper") continue;
            most = std::max(most, static_cast<double>(event.end - event.start) * 1e-6);
        }
    }
    EXPECT_GT(most, 0.3 * least) << "the first pass got the time of both";
}

TEST(StageShares, OverlappingWorkIsCountedOnce) {
    using enum ProfileTrack;
    const FrameProfile frame{.start = 100,
                             .end = 200,
                             .events = {{host, "scan", "scan", 90, 130},
                                        {compute, "scan", "kernel", 120, 150},
                                        {gl, "depth", "depth", 140, 160},
                                        {handover, "handover", "handover", 155, 170},
                                        {host, "strokes", "strokes", 180, 190},
                                        {compute, "", "other", 192, 194}}};
    std::map<std::string, double> shares;
    for (const StageShare& share : stage_shares(frame)) shares[share.stage] = share.nanoseconds;
    const std::map<std::string, double> expected{
        {"scan", 20 + 20 + 5}, {"depth", 5 + 10}, {"handover", 10}, {"strokes", 10}};
    EXPECT_EQ(shares, expected);
}

TEST_F(Profiles, ChangesNoPixel) {
    Renderer renderer = warm("clevis");
    FrameOptions profiled = options_;
    profiled.profile = true;
    EXPECT_TRUE(draw(renderer, options_) == draw(renderer, profiled));
    EXPECT_EQ(renderer.take_profiles().size(), 1U);
    draw(renderer, options_);
    EXPECT_TRUE(renderer.take_profiles().empty());
}

TEST_F(Profiles, EveryFrameIsToldOrCountedAsDropped) {
    for (const Method method : {Method::atlas, Method::opengl}) {
        Renderer renderer = warm("house");
        FrameOptions options = options_;
        options.method = method;
        options.profile = true;
        constexpr std::size_t drawn = 12;
        std::vector<FrameProfile> frames;
        for (std::size_t i = 0; i < drawn; ++i) {
            renderer.draw(camera_, options, canvas_.framebuffer());
            for (FrameProfile& frame : renderer.take_profiles(false)) frames.push_back(frame);
        }
        for (FrameProfile& frame : renderer.take_profiles(true)) frames.push_back(frame);
        ASSERT_FALSE(frames.empty());
        EXPECT_EQ(frames.size() + frames.back().dropped, drawn);
        EXPECT_EQ(frames.back().number, drawn - 1);
        EXPECT_TRUE(std::ranges::is_sorted(frames, {}, &FrameProfile::number));
    }
}

TEST_F(Profiles, AFrameThatFailsLeavesNothingBehind) {
    Renderer renderer = warm("clevis");
    FrameOptions wrong = options_;
    wrong.profile = true;
    wrong.depth_scale = 9;
    EXPECT_THROW(draw(renderer, wrong), UsageError);
    EXPECT_TRUE(renderer.take_profiles().empty());
    EXPECT_EQ(profile(renderer, 2).size(), 2U);
}

TEST_F(Profiles, EveryMethodIsProfiled) {
    options_.style.fill.mode = FillMode::lambert;
    options_.style.paper.grain = 0.3F;
    options_.style.hidden = true;
    const std::pair<Method, const char*> methods[] = {{Method::spine, "spine"},
                                                      {Method::item_buffer, "item_buffer"},
                                                      {Method::opengl, "lines"},
                                                      {Method::atlas, "strokes hidden"}};
    Renderer renderer = warm("clevis");
    for (const auto& [method, stage] : methods) {
        options_.method = method;
        TraceCheck check{profile_trace(profile(renderer, 2), "")};
        if (method != Method::opengl) check.expect_order("fill", "paper");
        EXPECT_EQ(joined(check.problems), "") << stage;
        const std::vector<FrameProfile> frames = profile(renderer, 1);
        EXPECT_TRUE(std::ranges::any_of(frames[0].events, [&](const ProfileEvent& event) {
            return event.stage == stage;
        })) << stage;
    }
}

TEST_F(Profiles, CsvHasARowPerEvent) {
    Renderer renderer = warm("clevis");
    const std::vector<FrameProfile> frames = profile(renderer, 2);
    std::istringstream csv{profile_csv(frames)};
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "frame,track,stage,name,start_us,duration_us,items,group,bytes,gb_per_s,"
                    "copy_gb_per_s");
    std::size_t rows = 0;
    for (; std::getline(csv, line); ++rows) EXPECT_EQ(std::ranges::count(line, ','), 10) << line;
    EXPECT_EQ(rows, frames[0].events.size() + frames[1].events.size());
    EXPECT_NE(profile_table(frames).find("covered: "), std::string::npos);
    EXPECT_EQ(profile_table({}), "no frame was profiled\n");
}

TEST_F(Profiles, KernelsHaveTheirSizesBesideACopy) {
    for (const char* compute : {"opencl", "cpp"}) {
        Renderer renderer = warm("house", {.compute = compute});
        const std::size_t triangles = scene_lines("house").triangles.size();
        for (const FrameProfile& frame : profile(renderer, 2)) {
            EXPECT_GT(frame.copy_gigabytes_per_second, 0.01) << compute;
            EXPECT_LT(frame.copy_gigabytes_per_second, 10000) << compute;
            const auto kernel = std::ranges::find_if(frame.events, [](const ProfileEvent& event) {
                return event.name == "facing" && event.track == ProfileTrack::compute;
            });
            ASSERT_NE(kernel, frame.events.end());
            EXPECT_EQ(kernel->items, triangles);
            EXPECT_GT(kernel->group, 0U);
            EXPECT_GE(kernel->bytes, 13 * triangles); // 3 indices and a byte, and the vertices
        }
    }
}

class ProfileTool : public Tool {
  protected:
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream{path(name)}.rdbuf();
        return text.str();
    }
};

TEST_F(ProfileTool, WritesTracesTablesAndCsv) {
    const Result result =
        run("draw --scene clevis --size 200x150 --atlas compute --repeat 3 -o " + path("a.png") +
            " --profile - --profile " + path("t.json") + " --profile " + path("t.csv"));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_NE(result.output.find("covered: "), std::string::npos) << result.output;
    TraceCheck check{text_of("t.json")};
    EXPECT_EQ(joined(check.problems), "");
    EXPECT_EQ(check.frame_count(), 3U);
    EXPECT_NE(text_of("t.csv").find("\n2,"), std::string::npos);
}

TEST_F(ProfileTool, ProfilesEveryFrameOfASequence) {
    for (const char* extension : {"png", "svg"}) {
        const Result result = run("draw --scene clevis --size 200x150 --turntable 5 -o " +
                                  path("f%d.") + extension + " --profile " + path("t.json"));
        EXPECT_EQ(result.exit_code, 0) << result.output;
        TraceCheck check{text_of("t.json")};
        EXPECT_EQ(joined(check.problems), "");
        EXPECT_EQ(check.frame_count(), 5U);
    }
}

TEST_F(ProfileTool, RefusesOtherFiles) {
    const std::string draw = "draw --scene clevis -o " + path("x.png") + " --profile ";
    expect_refused(draw + path("t.txt"), 2, ".json or .csv");
    expect_refused(draw + path("no/such/folder/t.json"), 1, "t.json");
}

} // namespace
} // namespace lineatlas::test
