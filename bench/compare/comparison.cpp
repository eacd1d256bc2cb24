#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/median.hpp"

namespace lineatlas::bench {
namespace {

/// The probability that at least `least` of n events happen, each of probability p.
double at_least(std::size_t least, std::size_t n, double p) {
    if (least == 0 || p >= 1) return 1;
    if (p <= 0) return 0;
    double sum = 0;
    for (std::size_t k = least; k <= n; ++k) {
        const auto i = static_cast<double>(k), all = static_cast<double>(n);
        sum += std::exp(std::lgamma(all + 1) - std::lgamma(i + 1) - std::lgamma(all - i + 1) +
                        i * std::log(p) + (all - i) * std::log1p(-p));
    }
    return sum;
}

/// The probability that the median of n values drawn from n is one of the `count` smallest. If n is
/// even, the lower of the two middle values counts as the median: it is further out.
double bootstrap_tail(std::size_t count, std::size_t n) {
    return at_least((n + 1) / 2, n, static_cast<double>(count) / static_cast<double>(n));
}

/// The probability that at most `count` of n turns of equal builds lie on one side.
double sign_tail(std::size_t count, std::size_t n) {
    return at_least(n - count, n, 0.5);
}

/// How many of n sorted values lie below the interval.
std::size_t values_below(std::size_t n, double outside) {
    std::size_t count = 0;
    while (bootstrap_tail(count + 1, n) <= outside && sign_tail(count + 1, n) <= outside) ++count;
    return count;
}

/// The probability outside each end of the interval of one row among `rows`.
double outside_of(std::size_t rows) {
    return false_alarms / 2 / static_cast<double>(rows);
}

Verdict verdict_of(const Interval& interval, double least) {
    if (interval.high < 1) return Verdict::faster;
    if (interval.low > 1) return Verdict::slower;
    const bool close = interval.low >= 1 - least && interval.high <= 1 + least;
    return close ? Verdict::same : Verdict::not_told;
}

std::vector<double> ratios(const std::vector<double>& before, const std::vector<double>& after) {
    std::vector<double> result;
    std::ranges::transform(before, after, std::back_inserter(result),
                           [](double a, double b) { return b / a; });
    return result;
}

Compared compare_medians(const std::string& name, const std::vector<double>& before,
                         const std::vector<double>& after) {
    Compared row{.name = name, .before = median(before), .after = median(after)};
    row.ratio = row.after / row.before;
    return row;
}

/// Sets the ratio, the interval and the verdict of a row by its turns.
void judge(Compared& row, const std::vector<double>& of_turns, const Comparison& comparison) {
    row.ratio = median(of_turns);
    row.interval = interval_of_median(of_turns, outside_of(comparison.rows.size()));
    if (of_turns.size() >= comparison.turns_needed) {
        row.verdict = verdict_of(row.interval, comparison.least);
    }
}

const char* words(Verdict verdict) {
    switch (verdict) {
    case Verdict::faster:
        return "faster";
    case Verdict::slower:
        return "slower";
    case Verdict::same:
        return "same";
    case Verdict::not_told:
        break;
    }
    return "cannot be told";
}

/// The text below the rows.
std::string summary(const Comparison& comparison) {
    const auto count = [&](Verdict verdict) {
        return std::ranges::count(comparison.rows, verdict, &Compared::verdict);
    };
    std::string text =
        fmt::format("{} slower, {} faster, {} the same within {:.3g} %, {} cannot be told\n",
                    count(Verdict::slower), count(Verdict::faster), count(Verdict::same),
                    100 * comparison.least, count(Verdict::not_told));
    if (!comparison.by_turns) {
        text += "These runs were not by turns: what else the machine did is part of each ratio. "
                "--interleave of bench kernels and bench frames takes turns.\n";
    } else if (comparison.turns < comparison.turns_needed) {
        text += fmt::format("{} turns: {} are needed for as many rows.\n", comparison.turns,
                            comparison.turns_needed);
    }
    if (!comparison.lone.empty()) {
        text += fmt::format("Only in one of both: {}\n", fmt::join(comparison.lone, ", "));
    }
    return text;
}

} // namespace

Interval interval_of_median(std::vector<double> values, double outside) {
    std::ranges::sort(values);
    const std::size_t below = values_below(values.size(), outside);
    return {values[below], values[values.size() - 1 - below]};
}

std::size_t turns_needed(std::size_t rows) {
    std::size_t turns = 1;
    while (sign_tail(0, turns) > outside_of(rows)) ++turns;
    return turns;
}

namespace {

/// True if both builds report percentiles for the row. Builds without percentiles report means.
bool both_are_quiet(const Figures& before, const Figures& after, const std::string& name) {
    return before.quiet.contains(name) && after.quiet.contains(name) &&
           before.quiet.at(name).size() == before.rows.at(name).size() &&
           after.quiet.at(name).size() == after.rows.at(name).size();
}

} // namespace

Comparison compare(const Figures& before, const Figures& after, double least) {
    Comparison result;
    result.by_turns = !before.turns.empty() && before.turns == after.turns;
    result.least = least;
    std::vector<std::vector<double>> of_turns;
    for (const auto& [name, times] : before.rows) {
        const auto other = after.rows.find(name);
        if (other == after.rows.end() ||
            (result.by_turns && other->second.size() != times.size())) {
            result.lone.push_back(name);
            continue;
        }
        const bool quiet = both_are_quiet(before, after, name);
        const std::vector<double>& first = quiet ? before.quiet.at(name) : times;
        const std::vector<double>& second = quiet ? after.quiet.at(name) : other->second;
        result.rows.push_back(compare_medians(name, first, second));
        of_turns.push_back(result.by_turns ? ratios(first, second) : std::vector<double>{});
    }
    for (const auto& [name, values] : after.rows)
        if (!before.rows.contains(name)) result.lone.push_back(name);
    if (!result.by_turns || result.rows.empty()) return result;
    result.turns = std::ranges::min_element(of_turns, {}, &std::vector<double>::size)->size();
    result.turns_needed = turns_needed(result.rows.size());
    for (std::size_t i = 0; i < result.rows.size(); ++i) judge(result.rows[i], of_turns[i], result);
    return result;
}

bool fails(const Comparison& comparison) {
    return std::ranges::any_of(comparison.rows, [&](const Compared& row) {
        return row.verdict == Verdict::slower && row.ratio > 1 + comparison.least;
    });
}

std::string table(const Comparison& comparison) {
    std::size_t width = 4;
    for (const Compared& row : comparison.rows) width = std::max(width, row.name.size());
    std::string text = fmt::format("{:<{}}{:>12}{:>12}{:>8}  {:<16}\n", "row", width, "before ms",
                                   "after ms", "ratio", "interval");
    for (const Compared& row : comparison.rows) {
        const std::string interval =
            comparison.by_turns
                ? fmt::format("{:.3f} to {:.3f}", row.interval.low, row.interval.high)
                : "-";
        text += fmt::format("{:<{}}{:>12.4f}{:>12.4f}{:>8.3f}  {:<16}{}\n", row.name, width,
                            row.before, row.after, row.ratio, interval, words(row.verdict));
    }
    return text + summary(comparison);
}

} // namespace lineatlas::bench
