// lineatlas-bench-compare: compares two builds. Says which rows changed, and for which the figures
// do not suffice.

#include <charconv>

#include <CLI/App.hpp>
#include <fmt/core.h>

#include "command_line/program.hpp"
#include "comparison.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

/// "3%" or "3" as 0.03.
double parse_percent(const std::string& text) {
    double percent = 0;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, percent);
    const bool whole = end == last || std::string_view{end, last} == "%";
    if (error == std::errc{} && whole && percent > 0 && percent < 100) return percent / 100;
    throw UsageError(
        fmt::format("--fail-over \"{}\": it must be above 0% and below 100%, such as 3%", text));
}

int run(int argc, char** argv) {
    CLI::App app{"Compares two runs of bench kernels, bench frames or draw --profile, row by row",
                 "lineatlas-bench-compare"};
    std::string before, after, fail_over;
    app.add_option("BEFORE", before, "Figures of the build before, JSON")->required();
    app.add_option("AFTER", after, "Figures of the build after")->required();
    app.add_option("--fail-over", fail_over,
                   "End with exit code 1 if a row is slower by more than that: 3%");
    app.footer(
        "A ratio above 1 is slower. Only runs by turns (--interleave of bench kernels and "
        "bench frames)\nsay what changed: their intervals are by the bootstrap, for all rows "
        "together. Two equal builds\nare said to differ less than once in a thousand "
        "comparisons.\n"
        "Examples:\n"
        "  lineatlas bench kernels --interleave ../before/build/release --turns 40 \\\n"
        "      --benchmark_filter=ours/65536 --json after.json --json-other before.json\n"
        "  lineatlas bench compare before.json after.json --fail-over 3%");
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    constexpr double usual = 0.03;
    const double least = fail_over.empty() ? usual : parse_percent(fail_over);
    const Comparison comparison = compare(read_figures(before), read_figures(after), least);
    if (!fail_over.empty() && !comparison.by_turns) {
        throw UsageError("--fail-over needs figures of two builds that ran by turns, so that a "
                         "slower machine does not fail; bench kernels --interleave takes them");
    }
    print_output(table(comparison));
    return !fail_over.empty() && fails(comparison) ? 1 : 0;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-compare");
}
