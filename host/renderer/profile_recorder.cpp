#include "profile_recorder.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/host_clock.hpp"
#include "core/limits.hpp"

namespace lineatlas {
namespace {

constexpr std::size_t most_pending = 4;
constexpr std::size_t most_finished = 1024; // kept if nobody takes them

/// FrameProfile::copy_gigabytes_per_second: the best of a few copies, because other work can only
/// slow a copy down.
double measure_copy(compute::Device& device) try {
    constexpr std::uint64_t bytes = std::uint64_t{32} << 20U; // more than most caches hold
    constexpr int rounds = 5;
    const auto from = device.allocate(bytes), to = device.allocate(bytes);
    device.clear(*from, bytes);
    double best = 0;
    for (int i = 0; i < rounds; ++i) {
        device.finish();
        const std::int64_t start = host_nanoseconds();
        device.copy(*from, *to, bytes);
        device.finish();
        const std::int64_t taken = std::max<std::int64_t>(host_nanoseconds() - start, 1);
        best = std::max(best, 2.0 * static_cast<double>(bytes) / static_cast<double>(taken));
    }
    return best;
} catch (const Shortage&) {
    return 0; // better a profile without that column than none
}

} // namespace

ProfileRecorder::ProfileRecorder(compute::Device& device, bool gl_is_software)
    : device_(device), gl_is_software_(gl_is_software),
      copy_gigabytes_per_second_(measure_copy(device)) {}

ProfileRecorder::Frame::Frame(ProfileRecorder& recorder) : recorder_(recorder) {
    recorder_.collect(false);
    if (recorder_.pending_.size() == most_pending) {
        recorder_.release(recorder_.pending_.front());
        recorder_.pending_.pop_front();
        ++recorder_.dropped_;
    }
    auto recording = std::make_unique<Recording>();
    recording->profile.number = recorder_.number_++;
    recording->profile.copy_gigabytes_per_second = recorder_.copy_gigabytes_per_second_;
    recording->commands = recorder_.device_.begin_log();
    recording->gl_offset = gl::read_clock_offset();
    recording->profile.start = host_nanoseconds();
    recorder_.current_ = std::move(recording);
}

ProfileRecorder::Frame::~Frame() {
    if (!recorder_.current_) return;
    recorder_.device_.end_log();
    recorder_.in_pass_ = false;
    recorder_.release(*recorder_.current_);
    recorder_.current_.reset();
}

void ProfileRecorder::Frame::finish(const FrameStats& stats) {
    Recording& recording = *recorder_.current_;
    if (recorder_.in_pass_) recorder_.end_pass();
    recorder_.device_.end_log();
    recording.profile.end = host_nanoseconds();
    recording.profile.samples = stats.samples;
    recording.profile.runs = stats.runs;
    recorder_.pending_.push_back(std::move(recording));
    recorder_.current_.reset();
}

void ProfileRecorder::begin_stage(ProfileTrack track, const char* stage) {
    std::vector<Pass>& passes = current_->passes;
    const bool is_pass = track == ProfileTrack::gl;
    const bool goes_on = in_pass_ && is_pass && std::strcmp(passes.back().stage, stage) == 0;
    if (in_pass_ && !goes_on) end_pass();
    const std::int64_t now = host_nanoseconds();
    if (is_pass && !goes_on) begin_pass(stage, now);
    const ProfileTrack thread =
        track == ProfileTrack::handover ? ProfileTrack::handover : ProfileTrack::host;
    current_->profile.events.push_back({thread, stage, stage, now, 0});
}

void ProfileRecorder::end_stage() {
    current_->profile.events.back().end = host_nanoseconds();
}

void ProfileRecorder::begin_pass(const char* stage, std::int64_t now) {
    const GLuint start = gl_is_software_ ? 0 : queries_.stamp();
    current_->passes.push_back({stage, now, start, 0});
    in_pass_ = true;
}

void ProfileRecorder::end_pass() {
    current_->passes.back().end = queries_.stamp();
    glFlush(); // GL that works by tiles would mix the work of two passes on one framebuffer
    in_pass_ = false;
}

std::vector<FrameProfile> ProfileRecorder::take(bool wait) {
    collect(wait);
    std::vector<FrameProfile> result(std::make_move_iterator(finished_.begin()),
                                     std::make_move_iterator(finished_.end()));
    finished_.clear();
    return result;
}

void ProfileRecorder::collect(bool wait) {
    while (!pending_.empty() && (wait || is_complete(pending_.front()))) {
        finished_.push_back(finished(pending_.front()));
        pending_.pop_front();
        if (finished_.size() <= most_finished) continue;
        finished_.pop_front();
        ++dropped_;
    }
}

bool ProfileRecorder::is_complete(const Recording& recording) {
    const std::vector<Pass>& passes = recording.passes;
    return (passes.empty() || gl::TimerQueries::is_available(passes.back().end)) &&
           (!recording.commands || recording.commands->complete());
}

void ProfileRecorder::release(Recording& recording) {
    for (const Pass& pass : recording.passes) {
        for (const GLuint stamp : {pass.start, pass.end}) {
            if (stamp != 0) queries_.give_back(stamp);
        }
    }
    recording.passes.clear();
}

FrameProfile ProfileRecorder::finished(Recording& recording) {
    FrameProfile& profile = recording.profile;
    add_commands(recording); // while no other thread has the events
    add_passes(recording);
    release(recording);
    std::ranges::stable_sort(profile.events, {}, &ProfileEvent::start);
    for (const ProfileEvent& event : profile.events) profile.end = std::max(profile.end, event.end);
    profile.dropped = dropped_;
    return std::move(profile);
}

void ProfileRecorder::add_passes(Recording& recording) {
    if (!recording.passes.empty()) recording.profile.gl_error = recording.gl_offset.error;
    for (const Pass& pass : recording.passes) {
        // GL takes passes in order, and no pass before it is submitted.
        std::int64_t start = std::max(pass.submitted, gl_end_);
        const std::int64_t offset = recording.gl_offset.nanoseconds;
        if (pass.start != 0) start = std::max(start, gl::TimerQueries::time(pass.start) + offset);
        gl_end_ = std::max(start, gl::TimerQueries::time(pass.end) + offset);
        recording.profile.events.push_back(
            {ProfileTrack::gl, pass.stage, pass.stage, start, gl_end_, 0, 0, 0});
    }
}

void ProfileRecorder::add_commands(Recording& recording) {
    if (!recording.commands) return;
    const std::vector<compute::CommandTime> commands = recording.commands->read();
    std::vector<ProfileEvent>& events = recording.profile.events;
    const std::size_t stages = events.size();
    std::size_t at = 0;
    for (const compute::CommandTime& command : commands) {
        while (at < stages && events[at].end < command.submitted) ++at;
        const bool inside = at < stages && events[at].start <= command.submitted;
        events.push_back({ProfileTrack::compute, inside ? events[at].stage : std::string{},
                          std::string{command.name}, command.start, command.end, command.items,
                          command.group, command.bytes});
    }
    recording.profile.compute_error = recording.commands->error();
}

} // namespace lineatlas
