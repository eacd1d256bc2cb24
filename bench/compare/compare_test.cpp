// `bench compare` finds the rows that changed and no others. The figures are made up, with the
// noise of a machine that has other work. Nothing is timed.

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "command_line/scratch.hpp"
#include "comparison.hpp"
#include "turns.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::json;

/// Figures of two builds that run by turns on one machine. The machine becomes slower and faster
/// over the turns, each run has noise of its own, and one run in twelve is disturbed by other work.
class Machine {
  public:
    explicit Machine(unsigned seed) : engine_(seed) {}

    /// `factor`: the second build's time of the row `planted` over the first build's.
    std::array<Json, 2> runs(int rows, int turns, const std::string& planted = "",
                             double factor = 1) {
        std::array<std::vector<Json>, 2> all;
        for (int row = 0; row < rows; ++row) {
            const std::string name = "kernel_" + std::to_string(row) + "/ours/65536";
            double load = 1;
            for (int turn = 0; turn < turns; ++turn) {
                load *= std::exp(0.05 * normal_(engine_));
                for (std::size_t build = 0; build < 2; ++build) {
                    const double change = build == 1 && name == planted ? factor : 1;
                    all[build].push_back(
                        run_of(name + "/manual_time", (10 + row) * load * change * noise()));
                }
            }
        }
        return {runs_by_turns("some turns", all[0]), runs_by_turns("some turns", all[1])};
    }

  private:
    double noise() {
        const double other_work = even_(engine_) < 1.0 / 12 ? 1 + longer_(engine_) : 1;
        return other_work * std::exp(0.015 * normal_(engine_));
    }
    static Json run_of(const std::string& name, double microseconds) {
        return {{"benchmarks", Json::array({{{"name", name},
                                             {"run_type", "iteration"},
                                             {"real_time", 1.1 * microseconds},
                                             {"time_unit", "us"},
                                             {"share_of_copy", 0.5},
                                             {"p10_us", microseconds}}})}};
    }

    std::mt19937 engine_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> even_;
    std::exponential_distribution<double> longer_{3};
};

class Compare : public testing::Test {
  protected:
    std::string write(const std::string& name, const Json& json) {
        const std::string path = (scratch_.folder / name).string();
        std::ofstream{path} << json;
        return path;
    }

    Comparison compared(const std::array<Json, 2>& builds, double least = 0.03) {
        return compare(read_figures(write("before.json", builds[0])),
                       read_figures(write("after.json", builds[1])), least);
    }

    /// The program's output and exit code.
    static std::pair<std::string, int> run(const std::string& arguments) {
        FILE* pipe = ::popen((LINEATLAS_BENCH_COMPARE " " + arguments + " 2>&1").c_str(), "r");
        std::string text;
        std::array<char, 512> part{};
        while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
        return {text, WEXITSTATUS(::pclose(pipe))};
    }

    Scratch scratch_;
};

bool is_change(const Compared& row) {
    return row.verdict == Verdict::slower || row.verdict == Verdict::faster;
}

TEST_F(Compare, FindsFivePercentInOneOfSixtyKernels) {
    const std::string planted = "kernel_17/ours/65536";
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Comparison found = compared(Machine{seed}.runs(60, 40, planted, 1.05));
        ASSERT_EQ(found.rows.size(), 60U);
        for (const Compared& row : found.rows) {
            ASSERT_EQ(is_change(row), row.name == planted) << seed << ' ' << row.name << row.ratio;
            if (row.name != planted) continue;
            EXPECT_EQ(row.verdict, Verdict::slower);
            EXPECT_NEAR(row.ratio, 1.05, 0.015);
            EXPECT_GT(row.interval.low, 1);
            EXPECT_LT(row.interval.high, 1.1);
        }
        EXPECT_TRUE(fails(found));
    }
}

TEST_F(Compare, FindsWhatBecameFaster) {
    const Comparison found = compared(Machine{1}.runs(6, 30, "kernel_3/ours/65536", 0.95));
    for (const Compared& row : found.rows)
        EXPECT_EQ(row.verdict == Verdict::faster, row.name == "kernel_3/ours/65536") << row.name;
    EXPECT_FALSE(fails(found));
}

TEST_F(Compare, SaysNothingOfEqualBuilds) {
    for (const int turns : {20, 40}) {
        for (unsigned seed = 100; seed < 120; ++seed) {
            for (const Compared& row : compared(Machine{seed}.runs(60, turns)).rows)
                EXPECT_FALSE(is_change(row)) << seed << ' ' << row.name << ' ' << row.ratio;
        }
    }
}

TEST_F(Compare, TellsWhatItCannotTell) {
    const Comparison few = compared(Machine{5}.runs(60, 12, "kernel_2/ours/65536", 1.5));
    EXPECT_EQ(few.turns_needed, 17U);
    for (const Compared& row : few.rows) EXPECT_EQ(row.verdict, Verdict::not_told);
    EXPECT_NE(table(few).find("12 turns: 17 are needed"), std::string::npos) << table(few);
    // Many turns suffice for a verdict on every row.
    for (const Compared& row : compared(Machine{5}.runs(6, 60), 0.1).rows)
        EXPECT_EQ(row.verdict, Verdict::same) << row.interval.low << ' ' << row.interval.high;
}

/// Draws bootstrap samples. Each end of the interval lies at most one value further out than
/// theirs, because the interval is at least as wide as the sign test's.
TEST_F(Compare, IntervalIsThatOfDrawnSamples) {
    std::mt19937 engine{7};
    std::lognormal_distribution<double> spread{0, 0.2};
    std::vector<double> values(21);
    for (double& value : values) value = spread(engine);
    std::uniform_int_distribution<std::size_t> any{0, values.size() - 1};
    std::vector<double> medians;
    for (int i = 0; i < 40000; ++i) {
        std::vector<double> drawn;
        for (std::size_t k = 0; k < values.size(); ++k) drawn.push_back(values[any(engine)]);
        std::ranges::nth_element(drawn, drawn.begin() + 10);
        medians.push_back(drawn[10]);
    }
    std::ranges::sort(medians);
    std::ranges::sort(values);
    const auto place = [&](double value) {
        return std::ranges::find(values, value) - values.begin();
    };
    const Interval interval = interval_of_median(values, 0.03);
    EXPECT_LE(interval.low, medians[1200]);
    EXPECT_GE(place(interval.low), place(medians[1200]) - 1);
    EXPECT_GE(interval.high, medians[38799]);
    EXPECT_LE(place(interval.high), place(medians[38799]) + 1);
}

TEST_F(Compare, EndsAsFailOverSays) {
    const auto builds = Machine{3}.runs(8, 40, "kernel_4/ours/65536", 1.05);
    const std::string before = write("before.json", builds[0]),
                      after = write("after.json", builds[1]), files = before + ' ' + after;
    const auto [text, code] = run(files + " --fail-over 3%");
    EXPECT_EQ(code, 1) << text;
    EXPECT_NE(text.find("\n1 slower, 0 faster, "), std::string::npos) << text;
    const std::size_t row = text.find("kernel_4/ours/65536");
    EXPECT_NE(text.substr(row, text.find('\n', row) - row).find("slower"), std::string::npos);
    EXPECT_EQ(run(files + " --fail-over 8%").second, 0);
    EXPECT_EQ(run(files).second, 0);
    EXPECT_EQ(run(before + ' ' + before + " --fail-over 3%").second, 0);
}

/// The times of two single runs differ by the machine's state as much as by the build.
TEST_F(Compare, GivesNoVerdictWithoutTurns) {
    const Json frames = {
        {"scenes",
         {{"ship", {{"methods", {{"SAhi", {{"ms", 50.0}, {"stages", {{"atlas", 12.5}}}}}}}}}}}};
    Json slower = frames;
    slower["scenes"]["ship"]["methods"]["SAhi"]["stages"]["atlas"] = 25.0;
    const Comparison found = compared({frames, slower});
    ASSERT_EQ(found.rows.size(), 2U);
    EXPECT_EQ(found.rows[1].name, "ship SAhi atlas");
    EXPECT_DOUBLE_EQ(found.rows[1].ratio, 2);
    EXPECT_EQ(found.rows[1].verdict, Verdict::not_told);
    const std::string files = write("a.json", frames) + ' ' + write("b.json", slower);
    const auto [text, code] = run(files);
    EXPECT_EQ(code, 0);
    EXPECT_NE(text.find("not by turns"), std::string::npos) << text;
    EXPECT_EQ(run(files + " --fail-over 3%").second, 2);
}

TEST_F(Compare, ReadsProfiles) {
    const auto event = [](const char* name, const char* stage, double microseconds) {
        return Json{{"ph", "X"}, {"name", name}, {"cat", stage}, {"dur", microseconds}};
    };
    const auto profile = [&](double atlas) {
        return Json{{"traceEvents",
                     {{{"ph", "M"}, {"name", "process_name"}},
                      event("frame", "frame", 900),
                      event("atlas", "atlas", atlas),
                      event("atlas", "atlas", atlas),
                      event("scan_chunks_reduce", "scan", 40)}}};
    };
    const Comparison found = compared({profile(100), profile(150)});
    ASSERT_EQ(found.rows.size(), 3U);
    EXPECT_EQ(found.rows[0].name, "atlas");
    EXPECT_DOUBLE_EQ(found.rows[0].ratio, 1.5);
    EXPECT_EQ(found.rows[1].name, "frame");
    EXPECT_DOUBLE_EQ(found.rows[1].before, 0.9);
    EXPECT_EQ(found.rows[2].name, "scan scan_chunks_reduce");
}

/// If one of the builds reports no percentiles, the means of both are compared.
TEST_F(Compare, ComparesLikeWithLike) {
    auto builds = Machine{4}.runs(1, 20);
    for (Json& run : builds[0]["runs"]) run["benchmarks"][0].erase("p10_us");
    const Comparison found = compared(builds);
    ASSERT_EQ(found.rows.size(), 1U);
    EXPECT_EQ(found.rows[0].name, "kernel_0/ours/65536");
    EXPECT_NEAR(found.rows[0].ratio, 1, 0.03); // means are 1.1 times the percentiles
}

TEST_F(Compare, NamesRowsThatOnlyOneHas) {
    const auto builds = Machine{2}.runs(3, 20), more = Machine{2}.runs(4, 20);
    const Comparison found = compared({builds[0], more[1]});
    EXPECT_EQ(found.rows.size(), 3U);
    EXPECT_EQ(found.lone, std::vector<std::string>{"kernel_3/ours/65536"});
}

TEST_F(Compare, RefusesWhatHasNoFigures) {
    const std::string good = write("good.json", Machine{1}.runs(1, 1)[0]);
    const auto expect_refused = [&](const std::string& arguments, int code, const char* words) {
        const auto [text, ended] = run(arguments);
        EXPECT_EQ(ended, code) << text;
        EXPECT_NE(text.find(words), std::string::npos) << text;
        EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
    };
    expect_refused(good + " /nonexistent.json", 1, "cannot read \"/nonexistent.json\"");
    expect_refused(good + ' ' + write("other.json", {{"some", "thing"}}), 1, "has no figures");
    expect_refused(good + ' ' + write("list.json", Json::array({1, 2})), 1, "has no figures");
    expect_refused(good + ' ' + write("odd.json", {{"benchmarks", {{{"name", 3}}}}}), 1,
                   "has no figures");
    expect_refused(good + ' ' + good + " --fail-over much", 2, "--fail-over \"much\"");
    expect_refused(good + ' ' + good + " --fail-over 0%", 2, "--fail-over \"0%\"");
}

} // namespace
} // namespace lineatlas::bench
