#include <iterator>

#include <fmt/format.h>

#include "lineatlas/profile.hpp"

namespace lineatlas {

std::string profile_csv(std::span<const FrameProfile> frames) {
    std::string text = "frame,track,stage,name,start_us,duration_us,items,group,bytes,"
                       "gb_per_s,copy_gb_per_s\n";
    if (frames.empty()) return text;
    const std::int64_t zero = frames.front().start;
    for (const FrameProfile& frame : frames) {
        for (const ProfileEvent& event : frame.events) {
            fmt::format_to(
                std::back_inserter(text), "{},{},{},{},{:.3f},{:.3f},{},{},{},{:.3f},{:.3f}\n",
                frame.number, name_of(event.track), event.stage, event.name,
                static_cast<double>(event.start - zero) / 1000,
                static_cast<double>(event.end - event.start) / 1000, event.items, event.group,
                event.bytes, event.gigabytes_per_second(), frame.copy_gigabytes_per_second);
        }
    }
    return text;
}

} // namespace lineatlas
