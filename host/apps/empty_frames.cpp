#include "empty_frames.hpp"

#include <fmt/format.h>

#include "core/empty_drawing.hpp"
#include "io/source_file.hpp"

namespace lineatlas::apps {

bool EmptyFrames::draw(const Camera& camera, const std::filesystem::path& path) {
    const bool drawn = output_.draw(camera, path);
    ++frames_;
    if (drawn && any_in_view(lines_, camera)) return true;
    if (empty_++ > 0) return false;
    first_ = path;
    cause_ = why_no_line(lines_, kinds_, camera);
    return false;
}

std::string EmptyFrames::report() const {
    if (empty_ == 0) return {};
    if (frames_ == 1) return "no line is drawn: " + cause_;
    return fmt::format("no line is drawn in {} of {} frames; first {}: {}", empty_, frames_,
                       quoted(first_), cause_);
}

} // namespace lineatlas::apps
