#include "lengths.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/path_share.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

/// Anything shorter than this, in pixels, is rounding of places.
constexpr double shortest = 0.01;
/// Visibility from which on a stroke is drawn in full.
constexpr float fully_shown = static_cast<float>(LA_FULLY_SHOWN) / 255;

/// A stroke before it takes on its overshoots, pixels.
struct ShortStroke {
    Stroke stroke;
    double start_overshoot = 0, end_overshoot = 0;
};

/// Whether a stroke may go on beyond an end. Then its length is not known.
bool is_cut_off(std::uint32_t kind) {
    return kind == LA_END_CLIPPED || kind == LA_END_JOIN;
}
bool is_cut_off(const Stroke& stroke) {
    return is_cut_off(stroke.start_kind) || is_cut_off(stroke.end_kind);
}

void extend(Stroke& stroke, const Stroke& next) {
    const auto length = static_cast<float>(stroke.length());
    const auto own = static_cast<float>(next.length());
    if (length + own > 0) {
        stroke.alpha = (stroke.alpha * length + next.alpha * own) / (length + own);
    }
    stroke.to = next.to;
    stroke.end_kind = next.end_kind;
}

class Lengths {
  public:
    Lengths(Strip& strip, const StrokeFilter& filter, std::span<const Cut> cuts, double crumb)
        : strip_(strip), crumb_(crumb), fill_(filter.fill_holes), drop_(filter.drop_runs),
          undershoot_(filter.undershoot),
          overshoot_(filter.overshoot * (1 - filter.overshoot_variation * path_share(strip.path))),
          cuts_(cuts) {}

    void apply() {
        const auto hidden = std::stable_partition(strip_.strokes.begin(), strip_.strokes.end(),
                                                  [](const Stroke& one) { return one.visible; });
        seen_.assign(strip_.strokes.begin(), hidden);
        if (seen_.empty()) return;
        strip_.strokes.erase(strip_.strokes.begin(), hidden);
        if (strip_.closed) find_seam();
        for (const ShortStroke& stroke : meeting(long_enough(filled()))) emit(stroke);
        std::ranges::stable_sort(strip_.strokes, {}, &Stroke::from);
    }

  private:
    /// Finds the hidden part around the seam of a closed strip.
    void find_seam() {
        const double gap = seen_.front().from + strip_.length - seen_.back().to;
        joined_ = gap <= shortest || gap < fill_;
        seam_room_ = 0.5 * gap;
    }

    std::vector<Stroke> filled() const {
        std::vector<Stroke> result;
        for (const Stroke& next : seen_) {
            const double gap = result.empty() ? 0 : next.from - result.back().to;
            if (!result.empty() && (gap <= shortest || gap < fill_)) {
                extend(result.back(), next);
            } else {
                result.push_back(next);
            }
        }
        if (joined_) {
            result.front().from = 0;
            result.back().to = strip_.length;
            result.front().start_kind = result.back().end_kind = LA_END_JOIN;
        }
        return result;
    }

    std::vector<ShortStroke> long_enough(const std::vector<Stroke>& strokes) const {
        std::vector<ShortStroke> kept;
        for (const Stroke& stroke : strokes) {
            const bool between_changes =
                stroke.start_kind == LA_END_HIDDEN && stroke.end_kind == LA_END_HIDDEN;
            const double least = between_changes ? std::max(drop_, crumb_) : drop_;
            if (!is_cut_off(stroke) && stroke.length() < least) continue;
            kept.push_back({.stroke = stroke,
                            .start_overshoot = overshoot_at(stroke.from, true),
                            .end_overshoot = overshoot_at(stroke.to, false)});
        }
        return kept;
    }

    /// Joins strokes that overshoot into each other.
    std::vector<ShortStroke> meeting(const std::vector<ShortStroke>& strokes) const {
        std::vector<ShortStroke> result;
        for (const ShortStroke& next : strokes) {
            const bool meets = !result.empty() && next.stroke.from - result.back().stroke.to <=
                                                      result.back().end_overshoot +
                                                          next.start_overshoot - 2 * undershoot_;
            if (meets) {
                extend(result.back().stroke, next.stroke);
                result.back().end_overshoot = next.end_overshoot;
            } else {
                result.push_back(next);
            }
        }
        return result;
    }

    /// The overshoot at an end: the square of the ink beside the end over the full overshoot, so
    /// that crumbs overshoot little. It never reaches a gap beside a nearer line.
    double overshoot_at(double place, bool at_start) const {
        if (!(overshoot_ > 0)) return 0;
        const double ink = at_start ? ink_within(place, place + overshoot_)
                                    : ink_within(place - overshoot_, place);
        double most = std::min(ink * ink / overshoot_, overshoot_);
        for (const Cut& cut : cuts_) {
            const bool beyond = at_start ? cut.from < place : cut.to > place;
            const double room = at_start ? place - cut.to : cut.from - place;
            if (beyond) most = std::clamp(room, 0.0, most);
        }
        return most;
    }

    /// Length that is visible between two places, times its opacity.
    double ink_within(double low, double high) const {
        double ink = ink_of_lap(low, high);
        if (joined_) {
            ink += ink_of_lap(low + strip_.length, high + strip_.length) +
                   ink_of_lap(low - strip_.length, high - strip_.length);
        }
        return ink;
    }

    double ink_of_lap(double low, double high) const {
        double ink = 0;
        for (const Stroke& stroke : seen_) {
            const double length = std::min(stroke.to, high) - std::max(stroke.from, low);
            const float opacity = std::min(stroke.alpha / fully_shown, 1.0F);
            ink += std::max(length, 0.0) * static_cast<double>(opacity);
        }
        return ink;
    }

    /// Gives a stroke its final length and emits its pieces between gaps.
    void emit(ShortStroke grown) {
        grow(grown);
        Stroke& stroke = grown.stroke;
        double least = shortest;
        for (const Cut& cut : cuts_) {
            if (cut.to <= stroke.from || cut.from >= stroke.to) continue;
            least = std::max(drop_, shortest);
            Stroke before = stroke;
            before.to = cut.from;
            before.end_kind = LA_END_HIDDEN;
            if (before.length() >= (is_cut_off(stroke.start_kind) ? shortest : least)) {
                strip_.strokes.push_back(before);
            }
            stroke.from = cut.to;
            stroke.start_kind = LA_END_HIDDEN;
        }
        if (stroke.length() >= (is_cut_off(stroke.end_kind) ? shortest : least)) {
            strip_.strokes.push_back(stroke);
        }
    }

    void grow(ShortStroke& grown) const {
        Stroke& stroke = grown.stroke;
        const bool first = stroke.from <= seen_.front().from;
        const bool last = stroke.to >= seen_.back().to;
        stroke.from -= growth(stroke.start_kind, grown.start_overshoot, first);
        stroke.to += growth(stroke.end_kind, grown.end_overshoot, last);
        // No farther than the path is drawn, unless it ends there.
        if (strip_.closed) return;
        if (stroke.from < 0 && !strip_.open_start) {
            stroke.from = 0;
            stroke.start_kind = LA_END_CLIPPED;
        }
        if (stroke.to > strip_.length && !strip_.open_end) {
            stroke.to = strip_.length;
            stroke.end_kind = LA_END_CLIPPED;
        }
    }

    double growth(std::uint32_t kind, double overshoot, bool at_seam) const {
        if (kind == LA_END_PATH) return overshoot;
        if (kind != LA_END_HIDDEN) return 0;
        const double grown = overshoot - undershoot_;
        return at_seam ? std::min(grown, seam_room_) : grown;
    }

    Strip& strip_;
    double crumb_, fill_, drop_, undershoot_, overshoot_;
    std::span<const Cut> cuts_;
    std::vector<Stroke> seen_; ///< the visible strokes before any change
    bool joined_ = false;      ///< visible across the seam
    double seam_room_ = std::numeric_limits<double>::infinity();
};

} // namespace

void filter_lengths(Strip& strip, const StrokeFilter& filter, std::span<const Cut> cuts,
                    double crumb) {
    Lengths{strip, filter, cuts, crumb}.apply();
}

} // namespace lineatlas
