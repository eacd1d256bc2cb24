#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas {

inline constexpr int finest_depth_scale = 4;  ///< FrameOptions::depth_scale at most
inline constexpr float finest_step = 0.01F;   ///< FrameOptions::step at least, pixels
inline constexpr float longest_step = 10'000; ///< and at most

/// A table that a device should hold, and ways out if it cannot; for messages. Ways out are members
/// of the public API, as in FrameOptions::step. Programs whose users never see the API replace
/// these names by their own (style/member_names.hpp).
struct Purpose {
    std::string_view what;
    std::string_view help;
};

namespace purpose {
inline constexpr Purpose scratch{"work space of a kernel",
                                 "use a smaller Camera::size, fewer FrameOptions::lines, another "
                                 "DeviceOptions::device or DeviceOptions::compute cpp"};
inline constexpr Purpose model{"the model's vertices and triangles",
                               "use another DeviceOptions::device, DeviceOptions::compute "
                               "cpp or a smaller model"};
inline constexpr Purpose segments{"the table of line segments",
                                  "use fewer LineOptions::lines, a larger "
                                  "LineOptions::crease, another DeviceOptions::device or "
                                  "DeviceOptions::compute cpp"};
// Steps that need all line segments at once, when segments come in chunks:
inline constexpr Purpose all_halos{"a halo", "use StrokeFilter::halo 0, another "
                                             "DeviceOptions::device or DeviceOptions::compute cpp"};
inline constexpr Purpose all_items{"an item buffer",
                                   "use FrameOptions::method atlas, another DeviceOptions::device "
                                   "or DeviceOptions::compute cpp"};
inline constexpr Purpose samples{"Renderer::read_samples()",
                                 "use Renderer::read_intervals(), another DeviceOptions::device "
                                 "or DeviceOptions::compute cpp"};
inline constexpr Purpose motion{"the tables that move the model's objects",
                                "use another DeviceOptions::device, DeviceOptions::compute "
                                "cpp or a smaller model"};
inline constexpr Purpose atlas{"the segment atlas",
                               "use a larger FrameOptions::step, a smaller Camera::size or fewer "
                               "FrameOptions::lines"};
inline constexpr Purpose exact{"the method exact",
                               "use FrameOptions::method atlas, a smaller Camera::size or another "
                               "DeviceOptions::device"};
inline constexpr Purpose strokes{"the table of strokes",
                                 "use a larger FrameOptions::step, a smaller Camera::size or fewer "
                                 "FrameOptions::lines"};
inline constexpr Purpose intervals{"the table of intervals",
                                   "use a larger FrameOptions::step, a smaller Camera::size or "
                                   "fewer FrameOptions::lines"};
inline constexpr Purpose density{"line density", "use a smaller Camera::size or Density::limit 0"};
inline constexpr Purpose halos{"the list of halos",
                               "use a smaller StrokeFilter::halo, a smaller Camera::size or "
                               "StrokeFilter::halo 0"};
inline constexpr Purpose depth{"the depth buffer",
                               "use a smaller Camera::size or FrameOptions::depth_scale, or draw "
                               "by tiles (Renderer::draw_tiles)"};
inline constexpr Purpose whole_picture{"a depth buffer for the whole picture",
                                       "use FrameOptions::method atlas with StageForms::atlas "
                                       "compute, which draws by tiles, or a smaller Camera::size "
                                       "or FrameOptions::depth_scale"};
inline constexpr Purpose picture{"the picture", "use a smaller Camera::size, or draw by tiles "
                                                "(Renderer::draw_tiles)"};
inline constexpr Purpose item_buffer{"the item buffer",
                                     "use a smaller Camera::size, fewer FrameOptions::probes or "
                                     "FrameOptions::method atlas"};
inline constexpr Purpose spine{"the spine test", "use FrameOptions::method atlas"};
inline constexpr Purpose fill{"the colours of the fill", "use Fill::mode none"};
inline constexpr Purpose pen{"the mark of a pen", "use a smaller picture for the pen"};
inline constexpr Purpose paper{"the grain of paper", "use Paper::grain 0"};
} // namespace purpose

/// The message about a limit: "<what> needs <needed>, and <available>; <help>".
std::string beyond_limit(const Purpose& purpose, std::string_view needed,
                         std::string_view available);

/// A device, or GL, can't hold something at once. A smaller part of it may fit.
class OutOfMemory : public DeviceError {
  public:
    OutOfMemory(const Purpose& purpose, std::string_view needed, std::string_view available)
        : DeviceError(beyond_limit(purpose, needed, available)) {}
};

/// A device can't hold something. It is thrown where memory is allocated, where nobody knows the
/// purpose of the memory. A caller that knows the purpose makes an error about it by of().
class Shortage : public OutOfMemory {
  public:
    Shortage(std::string needed, std::string available);
    OutOfMemory of(const Purpose& purpose) const;

  private:
    std::string needed_, available_;
};

/// Runs `action` and returns its result. A Shortage that it throws becomes an error about
/// `purpose`.
template <class Action>
auto for_purpose(const Purpose& purpose, Action&& action) -> decltype(action()) {
    try {
        return action();
    } catch (const Shortage& shortage) {
        throw shortage.of(purpose);
    }
}

/// Sizes as people write them: "512 bytes", "1.50 GiB", "640x480".
std::string written_bytes(std::uint64_t bytes);
std::string written_size(glm::ivec2 size);

/// The size for a table that must hold `needed` and is likely to grow: a quarter more, but no more
/// than `most`, the largest size of a table.
constexpr std::uint64_t with_room_to_grow(std::uint64_t needed, std::uint64_t most) {
    return std::max(needed, std::min(needed + needed / 4, most));
}

} // namespace lineatlas
