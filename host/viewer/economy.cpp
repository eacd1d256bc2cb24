#include "economy.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/line_pens.hpp"
#include "core/style_lengths.hpp"

namespace lineatlas::viewer {
namespace {

std::size_t index_of(Economy economy) {
    return static_cast<std::size_t>(economy);
}

bool is_for_outlines(const PenRule& rule) {
    const std::vector<std::string>& kinds = rule.match.kinds;
    return std::ranges::find(kinds, outline_name) != kinds.end();
}

/// Whether a rule tells kinds of lines apart without colours, objects or materials, which people
/// look for.
bool is_fine(const PenRule& rule) {
    return !rule.color && rule.match.object.empty() && rule.match.material.empty();
}

/// Whether options have anything that a step of economy leaves out.
bool has(const FrameOptions& options, Economy economy) {
    const Style& style = options.style;
    switch (economy) {
    case Economy::none:
        return false;
    case Economy::samples:
        return options.probes > 1 || options.depth_scale > 1;
    case Economy::effects:
        return style.fill.mode != FillMode::none || style.filter.halo > 0 ||
               style.density.limit > 0 || std::ranges::any_of(style.pens, is_for_outlines);
    case Economy::marks:
        return style.pen.mark != Pen{}.mark || style.hidden || !style.pens.empty();
    case Economy::pixels:
    case Economy::details:
        return true;
    }
    return false;
}

} // namespace

void save_time(FrameOptions& options, Economy economy, glm::ivec2 size) {
    if (economy >= Economy::samples) {
        options.probes = 1;
        options.depth_scale = 1;
    }
    if (economy >= Economy::effects) {
        options.style.fill.mode = FillMode::none;
        options.style.filter.halo = 0;
        options.style.density = {};
        options.style.hidden_density = 0;
        std::erase_if(options.style.pens, is_for_outlines);
    }
    if (economy >= Economy::marks) {
        options.style.pen.mark = Pen{}.mark;
        options.style.hidden = false;
        std::erase_if(options.style.pens, is_fine);
        for (PenRule& rule : options.style.pens) rule.mark.reset();
    }
    if (economy >= Economy::pixels) {
        scale_lengths(options.style, size);
        multiply_lengths(options.style, 1.0F / static_cast<float>(pixel_size(economy)));
    }
}

/// The time of pictures with `to`, which leave out more, as a share of the time of those with
/// `from`.
double Pace::share_between(Economy from, Economy to) const {
    double share = 1;
    for (std::size_t i = index_of(from) + 1; i <= index_of(to); ++i)
        if (saves_.at(i)) share *= shares_.at(i);
    return share;
}

double Pace::expected(Economy economy) const {
    return economy >= last_ ? seconds_ * share_between(last_, economy)
                            : seconds_ / share_between(economy, last_);
}

/// Learns the shares of the steps between two pictures. ratio: the time of the second over that of
/// the first.
void Pace::learn(Economy from, Economy to, double ratio) {
    if (to < from) return learn(to, from, 1 / ratio);
    const std::size_t first = index_of(from) + 1, last = index_of(to);
    std::size_t steps = 0;
    for (std::size_t i = first; i <= last; ++i) steps += saves_.at(i) ? 1 : 0;
    if (steps == 0) return;
    // Half of the correction, because the view has changed too.
    const double error = ratio / share_between(from, to);
    const double correction = std::pow(error, 0.5 / static_cast<double>(steps));
    for (std::size_t i = first; i <= last; ++i)
        if (saves_.at(i)) shares_.at(i) = std::clamp(shares_.at(i) * correction, 0.1, 1.0);
}

void Pace::note(Economy economy, double seconds) {
    const bool is_first = !std::exchange(drawn_.at(index_of(economy)), true);
    // A first picture also makes tables. For pictures with nothing left out a poor guess is better
    // than none.
    if (is_first && economy != Economy::none) return;
    if (economy != last_) {
        if (count_ > 0 && !guessed_) learn(last_, economy, seconds / seconds_);
        count_ = 0;
    }
    if (guessed_) count_ = 0;
    guessed_ = is_first;
    last_ = economy;
    recent_.at(count_++ % recent_.size()) = seconds;
    // The median, or the shorter of two. If something else has held up one picture, that is no
    // reason to draw less.
    std::vector<double> known{recent_.begin(), recent_.end()};
    known.resize(std::min(count_, known.size()));
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>((known.size() - 1) / 2);
    std::ranges::nth_element(known, middle);
    seconds_ = *middle;
}

Economy Pace::choose(const FrameOptions& options, bool details_may_go) {
    constexpr double roomy = 0.8; // otherwise it would go to and fro
    for (std::size_t i = 0; i < economies; ++i)
        saves_.at(i) = has(options, static_cast<Economy>(i));
    saves_.at(index_of(Economy::details)) = details_may_go;
    if (count_ == 0) return Economy::none;
    for (std::size_t i = 0; i < economies; ++i) {
        const auto economy = static_cast<Economy>(i);
        if (i > 0 && !saves_.at(i)) continue;
        if (expected(economy) <= (economy < last_ ? roomy * longest : longest)) return economy;
    }
    return details_may_go ? Economy::details : Economy::pixels;
}

} // namespace lineatlas::viewer
