#include <algorithm>

#include "kernel_figures.hpp"
#include "lineatlas/profile.hpp"

// Trace Event Format: complete events ("X") on a thread per track, names as metadata ("M"),
// counters ("C"). Times are microseconds.
namespace lineatlas {
namespace {

using Json = nlohmann::ordered_json;

constexpr int process = 1;
constexpr int frames_thread = 1; // the tracks follow

int thread_of(ProfileTrack track) {
    return frames_thread + 1 + static_cast<int>(track);
}

const char* title_of(ProfileTrack track) {
    switch (track) {
    case ProfileTrack::host:
        return "host";
    case ProfileTrack::handover:
        return "hand-overs";
    case ProfileTrack::gl:
        return "GL passes";
    case ProfileTrack::compute:
        return "compute queue";
    }
    return "unknown";
}

Json metadata(const char* what, int thread, Json arguments) {
    return {{"name", what},
            {"ph", "M"},
            {"pid", process},
            {"tid", thread},
            {"args", std::move(arguments)}};
}

void name_thread(Json& events, int thread, const char* title) {
    events.push_back(metadata("thread_name", thread, {{"name", title}}));
    events.push_back(metadata("thread_sort_index", thread, {{"sort_index", thread}}));
}

class Trace {
  public:
    Trace(std::int64_t zero, std::span<const KernelTime> kernels)
        : zero_(zero), kernels_(kernels) {}

    void add_names(const std::string& description) {
        events_.push_back(
            metadata("process_name", frames_thread, {{"name", "lineatlas, " + description}}));
        name_thread(events_, frames_thread, "frames");
        for (const ProfileTrack track : profile_tracks) {
            name_thread(events_, thread_of(track), title_of(track));
        }
    }

    /// `next`: when the next frame begins, which may be before GL is done with this one.
    void add(const FrameProfile& frame, std::int64_t next) {
        add_complete("frame", "frame", frames_thread, frame.start, std::min(frame.end, next),
                     {{"frame", frame.number}});
        events_.push_back({{"name", "lines"},
                           {"ph", "C"},
                           {"pid", process},
                           {"tid", frames_thread},
                           {"ts", microseconds(frame.start - zero_)},
                           {"args", {{"samples", frame.samples}, {"runs", frame.runs}}}});
        for (const ProfileEvent& event : frame.events) {
            Json arguments{{"frame", frame.number}, {"stage", event.stage}};
            if (event.items > 0) {
                arguments["items"] = event.items;
                arguments["group"] = event.group;
            }
            if (event.bytes > 0) {
                arguments["bytes"] = event.bytes;
                arguments["gb_per_s"] = event.gigabytes_per_second();
                arguments["copy_gb_per_s"] = frame.copy_gigabytes_per_second;
            }
            if (event.items > 0) add_kernel(event, arguments);
            add_complete(event.name, event.stage.empty() ? "none" : event.stage,
                         thread_of(event.track), event.start, event.end, std::move(arguments));
        }
    }

    Json take() { return std::move(events_); }

  private:
    static double microseconds(std::int64_t nanoseconds) {
        return static_cast<double>(nanoseconds) / 1000;
    }

    void add_complete(const std::string& name, const std::string& category, int thread,
                      std::int64_t start, std::int64_t end, Json arguments) {
        events_.push_back({{"name", name},
                           {"cat", category},
                           {"ph", "X"},
                           {"pid", process},
                           {"tid", thread},
                           {"ts", microseconds(start - zero_)},
                           {"dur", microseconds(end - start)},
                           {"args", std::move(arguments)}});
    }

    /// Adds the figures of the event's kernel, as a member of their own: keys of a launch have
    /// other meanings.
    void add_kernel(const ProfileEvent& event, Json& arguments) const {
        const auto own = std::ranges::find_if(kernels_, [&](const KernelTime& kernel) {
            return kernel.stage == event.stage && kernel.name == event.name;
        });
        if (own != kernels_.end()) arguments["kernel"] = figures_of(*own);
    }

    std::int64_t zero_;
    std::span<const KernelTime> kernels_;
    Json events_ = Json::array();
};

} // namespace

std::string profile_trace(std::span<const FrameProfile> frames, const std::string& description) {
    return trace_of(frames, {}, description);
}

std::string trace_of(std::span<const FrameProfile> frames, std::span<const KernelTime> kernels,
                     const std::string& description) {
    Trace trace{frames.empty() ? 0 : frames.front().start, kernels};
    trace.add_names(description);
    Json errors = Json::object();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool last = i + 1 == frames.size();
        trace.add(frames[i], last ? frames[i].end : frames[i + 1].start);
        // The worst of all frames.
        const auto worst = [&](const char* name, const std::optional<std::int64_t>& error) {
            if (error) errors[name] = std::max(errors.value(name, std::int64_t{0}), *error);
        };
        worst("gl", frames[i].gl_error);
        worst("compute", frames[i].compute_error);
    }
    const Json json{{"traceEvents", trace.take()},
                    {"displayTimeUnit", "ms"},
                    {"otherData",
                     {{"device", description},
                      {"clock_error_ns", std::move(errors)},
                      {"frames_dropped", frames.empty() ? 0 : frames.back().dropped}}}};
    // Names of devices need not be UTF-8, but JSON must be.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lineatlas
