#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas {

/// What a device is asked to hold, and what the user can do where it can't: for messages.
struct Purpose {
    std::string_view what;
    std::string_view help;
};

namespace purpose {
inline constexpr Purpose scratch{"work space of a kernel",
                                 "use a smaller --size, fewer --lines kinds, another --device or "
                                 "--compute reference"};
inline constexpr Purpose model{"the model's vertices and triangles",
                               "use another --device, --compute reference or a smaller model"};
inline constexpr Purpose segments{"the table of line segments",
                                  "use fewer --lines kinds, a larger --crease, another --device or "
                                  "--compute reference"};
inline constexpr Purpose motion{"what moves the model's objects",
                                "use another --device, --compute reference or a smaller model"};
inline constexpr Purpose atlas{"the segment atlas",
                               "use a larger --step, a smaller --size or fewer --lines kinds"};
inline constexpr Purpose strokes{"the table of strokes",
                                 "use a larger --step, a smaller --size or fewer --lines kinds"};
inline constexpr Purpose intervals{"the table of intervals",
                                   "use a larger --step, a smaller --size or fewer --lines kinds"};
inline constexpr Purpose density{"line density", "use a smaller --size or --density 0"};
inline constexpr Purpose halos{"the list of halos",
                               "use a smaller --halo, a smaller --size or --halo 0"};
inline constexpr Purpose depth{"the depth buffer", "use a smaller --size, --depth-scale or --tile"};
inline constexpr Purpose whole_picture{"a depth buffer for the whole picture",
                                       "use --method atlas with --atlas compute, which draws by "
                                       "tiles, or a smaller --size or --depth-scale"};
inline constexpr Purpose picture{"the picture", "use a smaller --size or --tile"};
inline constexpr Purpose item_buffer{"the item buffer",
                                     "use a smaller --size, fewer --probes or --method atlas"};
inline constexpr Purpose spine{"the spine test", "use --method atlas"};
inline constexpr Purpose fill{"the colours of the fill", "use --fill none"};
inline constexpr Purpose pen{"the mark of a pen", "use a smaller picture for the pen"};
inline constexpr Purpose paper{"the grain of paper", "use --paper-grain 0"};
} // namespace purpose

/// What the message about every limit looks like. `needed` and `available` end the sentences "what
/// needs" and "and".
std::string beyond_limit(const Purpose& purpose, std::string_view needed,
                         std::string_view available);

/// A device can't hold something. Where it is found, nobody may know what that was for: who does
/// makes a DeviceError of it.
class Shortage : public DeviceError {
  public:
    Shortage(std::string needed, std::string available);
    DeviceError of(const Purpose& purpose) const;

  private:
    std::string needed_, available_;
};

/// Runs `action`; a Shortage in it is of `purpose`.
template <class Action>
auto for_purpose(const Purpose& purpose, Action&& action) -> decltype(action()) {
    try {
        return action();
    } catch (const Shortage& shortage) {
        throw shortage.of(purpose);
    }
}

/// As people write them: "512 bytes", "1.50 GiB", "640x480".
std::string written_bytes(std::uint64_t bytes);
std::string written_size(glm::ivec2 size);

/// For a table that must hold `needed` and is likely to need more soon: a quarter more than that,
/// where there is room. `most`: what a table can hold.
constexpr std::uint64_t with_room_to_grow(std::uint64_t needed, std::uint64_t most) {
    return std::max(needed, std::min(needed + needed / 4, most));
}

} // namespace lineatlas
