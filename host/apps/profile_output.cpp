#include "profile_output.hpp"

#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "io/atomic_file.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

constexpr const char* terminal = "-";

} // namespace

void ProfileOptions::declare(CLI::App& app, const std::string& group) {
    app.add_option("--profile", paths_,
                   "Where a frame's time goes: .json for Perfetto or chrome://tracing, .csv, or - "
                   "for a table; may be given again")
        ->expected(1)
        ->take_all()
        ->group(group);
}

void ProfileOptions::check() const {
    for (const std::string& path : paths_) {
        if (path == terminal) continue;
        const std::string extension = std::filesystem::path{path}.extension().string();
        if (extension != ".json" && extension != ".csv") {
            throw UsageError(
                fmt::format("--profile \"{}\": the file must end in .json or .csv, or be -", path));
        }
        const AtomicFile writable{path};
    }
}

void ProfileOptions::add_to(OutputPlaces& places) const {
    for (const std::string& path : paths_) {
        if (path != terminal) places.writes("--profile", path);
    }
}

void ProfileOptions::write(std::span<const FrameProfile> frames,
                           const std::string& description) const {
    for (const std::string& path : paths_) {
        if (path == terminal) {
            print_output(profile_table(frames));
            continue;
        }
        const bool csv = path.ends_with(".csv");
        const std::string text = csv ? profile_csv(frames) : profile_trace(frames, description);
        AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
}

bool ProfiledOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    const bool drawn = output_.draw(camera, path);
    take(false);
    return drawn;
}

void ProfiledOutput::take(bool wait) {
    std::vector<FrameProfile> more = renderer_.take_profiles(wait);
    frames_.insert(frames_.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
}

std::vector<FrameProfile> ProfiledOutput::take() {
    take(true);
    return std::move(frames_);
}

} // namespace lineatlas::apps
