#include "table_order.hpp"

#include <algorithm>
#include <utility>

namespace lineatlas {
namespace {

/// Swaps two fields of bits, at a and b, each as wide as the mask.
std::uint32_t swap_bits(std::uint32_t flags, std::uint32_t mask, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t at_a = flags >> a & mask;
    const std::uint32_t at_b = flags >> b & mask;
    return (flags & ~(mask << a | mask << b)) | at_a << b | at_b << a;
}

/// Turns the members that intervals and runs have in common. Arc lengths count from the middle of a
/// path.
template <class Piece>
void turn_ends(Piece& piece, float samples) {
    std::swap(piece.start, piece.end);
    std::swap(piece.start_depth, piece.end_depth);
    piece.start_arc = -std::exchange(piece.end_arc, -piece.start_arc);
    piece.start_sample = samples - std::exchange(piece.end_sample, samples - piece.start_sample);
}

void turn(Interval& interval, float samples) {
    turn_ends(interval, samples);
    std::swap(interval.start_world, interval.end_world);
    interval.flags =
        swap_bits(interval.flags, LA_END_MASK, LA_INTERVAL_START_SHIFT, LA_INTERVAL_END_SHIFT);
    interval.flags = swap_bits(interval.flags, LA_CHANGE_MASK, LA_INTERVAL_START_CHANGE_SHIFT,
                               LA_INTERVAL_END_CHANGE_SHIFT);
    const auto turned = [](std::uint32_t change) {
        return change == LA_CHANGE_HEAD   ? LA_CHANGE_TAIL
               : change == LA_CHANGE_TAIL ? LA_CHANGE_HEAD
                                          : change;
    };
    for (const std::uint32_t shift :
         {LA_INTERVAL_START_CHANGE_SHIFT, LA_INTERVAL_END_CHANGE_SHIFT}) {
        const std::uint32_t change = interval.flags >> shift & LA_CHANGE_MASK;
        interval.flags = (interval.flags & ~(LA_CHANGE_MASK << shift)) | turned(change) << shift;
    }
}

void turn(Run& run) {
    turn_ends(run, static_cast<float>(run.samples));
    // Left and right are swapped.
    std::swap(run.start_corner, run.end_corner);
    for (float* corner : {run.start_corner, run.end_corner}) {
        corner[0] = -corner[0];
        corner[1] = -corner[1];
    }
    run.stroke_start = -std::exchange(run.stroke_end, -run.stroke_start);
    run.flags = swap_bits(run.flags, LA_END_MASK, LA_RUN_START_SHIFT, LA_RUN_END_SHIFT);
    run.flags = swap_bits(run.flags, LA_END_MASK, LA_STROKE_START_SHIFT, LA_STROKE_END_SHIFT);
}

/// Sorts pieces in the order of their segments. Pieces of one segment stand together, in reverse
/// order if the segment is reversed.
template <class Piece>
void restore_order(const TableOrder& order, std::vector<Piece>& pieces) {
    const auto key = [&](const Piece& piece) { return order.source(piece.segment); };
    for (auto first = pieces.begin(); first != pieces.end();) {
        const auto end = std::find_if(first, pieces.end(), [&](const Piece& piece) {
            return piece.segment != first->segment;
        });
        if (order.is_reversed(first->segment)) std::reverse(first, end);
        first = end;
    }
    std::ranges::stable_sort(pieces, {}, key);
    for (Piece& piece : pieces) piece.segment = key(piece);
}

} // namespace

void TableOrder::restore(std::vector<Interval>& intervals,
                         std::span<const std::uint32_t> offsets) const {
    if (origins.empty()) return;
    for (Interval& interval : intervals) {
        if (!is_reversed(interval.segment)) continue;
        const std::uint32_t i = interval.segment;
        // A segment that is hidden as a whole counts as a single sample.
        const std::uint32_t samples = offsets.empty() ? 1 : offsets[i + 1] - offsets[i];
        turn(interval, static_cast<float>(std::max(samples, 1U)));
    }
    restore_order(*this, intervals);
}

void TableOrder::restore(std::vector<Run>& runs) const {
    if (origins.empty()) return;
    for (Run& run : runs) {
        if (is_reversed(run.segment)) turn(run);
    }
    restore_order(*this, runs);
}

void TableOrder::restore(std::vector<OutlinePart>& parts) const {
    if (origins.empty()) return;
    for (OutlinePart& part : parts) {
        if (is_reversed(part.segment)) std::swap(part.start, part.end);
    }
    restore_order(*this, parts);
}

void TableOrder::restore(std::uint32_t segments, std::vector<std::uint32_t>& offsets,
                         std::vector<std::uint8_t>& samples) const {
    const std::vector<std::uint32_t> before = std::move(offsets);
    const std::vector<std::uint8_t> found = std::move(samples);
    std::vector<std::uint32_t> position(segments, 0); // place + 1
    for (std::uint32_t i = 0; i + 1 < before.size(); ++i) position[source(i)] = i + 1;
    offsets.assign(1, 0);
    samples.clear();
    for (std::uint32_t i = 0; i < segments; ++i) {
        if (position[i] != 0) {
            const auto first = found.begin() + before[position[i] - 1];
            const auto end = found.begin() + before[position[i]];
            samples.insert(samples.end(), first, end);
            if (is_reversed(position[i] - 1))
                std::reverse(samples.end() - (end - first), samples.end());
        }
        offsets.push_back(static_cast<std::uint32_t>(samples.size()));
    }
}

} // namespace lineatlas
