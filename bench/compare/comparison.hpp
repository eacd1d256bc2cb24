#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "figures.hpp"

namespace lineatlas::bench {

enum class Verdict {
    faster,   ///< the interval lies below 1
    slower,   ///< it lies above
    same,     ///< it holds 1, and nothing further from 1 than the least change that is asked for
    not_told, ///< it is wider than that, or there is none
};

/// A range that holds a ratio, unless chance is very odd.
struct Interval {
    double low = 0, high = 0;
};

/// One row of a benchmark in both builds.
struct Compared {
    std::string name;
    double before = 0, after = 0; ///< medians, milliseconds
    double ratio = 1;             ///< by turns the median of the turns' ratios, else of the medians
    Interval interval{};          ///< of the ratio; without turns from 0 to 0
    Verdict verdict = Verdict::not_told;
};

struct Comparison {
    bool by_turns = false;
    double least = 0;              ///< change that is asked for: 0.03 is 3 %
    std::size_t turns = 0;         ///< the fewest of a row
    std::size_t turns_needed = 0;  ///< for a verdict on as many rows
    std::vector<Compared> rows;    ///< those that both have, by name
    std::vector<std::string> lone; ///< rows that only one has
};

/// How often anything is said to have changed between two equal builds: in one comparison of 1,000,
/// whatever the number of rows.
inline constexpr double false_alarms = 1e-3;

/// The interval of the median of `values` by the bootstrap, which for a median needs no drawing of
/// samples: its distribution is binomial (Efron 1979, section 3). `outside`: the probability of
/// what lies below it, and of what lies above. A bootstrap of few values promises too much: the
/// interval is at least that of the sign test, which is exact.
Interval interval_of_median(std::vector<double> values, double outside);

/// Turns below which chance alone may put all ratios of one among `rows` rows on one side.
std::size_t turns_needed(std::size_t rows);

Comparison compare(const Figures& before, const Figures& after, double least);

/// Whether a row is slower, and by more than the least change.
bool fails(const Comparison& comparison);

/// For people.
std::string table(const Comparison& comparison);

} // namespace lineatlas::bench
