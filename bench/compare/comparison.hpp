#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "figures.hpp"

namespace lineatlas::bench {

enum class Verdict {
    faster,   ///< the ratio's interval lies below 1
    slower,   ///< the interval lies above 1
    same,     ///< the interval holds 1 and stays within Comparison::least of it
    not_told, ///< the interval is wider than that, or there is no interval
};

/// A range that holds a ratio with high probability.
struct Interval {
    double low = 0, high = 0;
};

/// One row of a benchmark in both builds.
struct Compared {
    std::string name;
    double before = 0, after = 0; ///< medians, milliseconds
    double ratio = 1; ///< with turns the median of the turns' ratios, else the ratio of the medians
    Interval interval{}; ///< of the ratio; 0 to 0 without turns
    Verdict verdict = Verdict::not_told;
};

struct Comparison {
    bool by_turns = false;
    double least = 0;              ///< the smallest change that counts: 0.03 is 3 %
    std::size_t turns = 0;         ///< of the row with the fewest turns
    std::size_t turns_needed = 0;  ///< for verdicts on this number of rows
    std::vector<Compared> rows;    ///< rows that both builds have, sorted by name
    std::vector<std::string> lone; ///< names of rows that only one build has
};

/// The probability that a comparison of two equal builds reports any change, whatever the number of
/// rows.
inline constexpr double false_alarms = 1e-3;

/// The bootstrap interval of the median of `values`. The bootstrap distribution of a median is
/// binomial, so no samples are drawn (Efron 1979, section 3). `outside`: the probability below the
/// interval, and also the probability above it. With few values the bootstrap interval is too
/// narrow. So the result is at least as wide as the interval of the sign test, which is exact.
Interval interval_of_median(std::vector<double> values, double outside);

/// The number of turns that verdicts on `rows` rows need. With fewer turns, chance alone may put
/// all ratios of one of the rows on the same side of 1.
std::size_t turns_needed(std::size_t rows);

Comparison compare(const Figures& before, const Figures& after, double least);

/// True if a row is slower by more than Comparison::least.
bool fails(const Comparison& comparison);

/// The comparison as text for people.
std::string table(const Comparison& comparison);

} // namespace lineatlas::bench
