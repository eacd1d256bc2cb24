#include "goals.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

constexpr int rounds = 51;

const Row& row_named(const Rows& rows, const std::string& name) {
    const auto found = std::ranges::find(rows, name, &Row::name);
    if (found == rows.end()) throw Error("there is no row " + name);
    return *found;
}

} // namespace

std::vector<Goal> known_goals() {
    return {
        {.name = "scan_share_of_copy", .row = "scan/ours", .rival = "", .wanted = 0.5},
        {.name = "scan_to_boost", .row = "scan/ours", .rival = "scan/boost_compute", .wanted = 2},
    };
}

void measure(Goal& goal, const Rows& rows) {
    std::vector<Job> jobs{row_named(rows, goal.row).prepare(goal_size)};
    if (!goal.rival.empty()) {
        jobs.push_back(row_named(rows, goal.rival).prepare(goal_size));
        const std::vector<double> seconds = race(jobs, rounds);
        goal.seen = seconds[1] / seconds[0]; // the rival's time over the row's
        return;
    }
    for (const Row& row : rows) {
        if (row.name.starts_with("copy/device")) jobs.push_back(row.prepare(goal_size));
    }
    const std::vector<double> seconds = race(jobs, rounds);
    double limit = 0;
    for (std::size_t i = 1; i < jobs.size(); ++i)
        limit = std::max(limit, jobs[i].bytes / seconds[i]);
    goal.seen = jobs[0].bytes / seconds[0] / limit;
}

std::string table(const std::vector<Goal>& goals) {
    std::string result =
        fmt::format("\n{:<32}{:>8}{:>8}\n", "goal at 4 million elements", "wanted", "seen");
    for (const Goal& goal : goals) {
        if (goal.seen == 0) continue;
        result += fmt::format("{:<32}{:>8.2f}{:>8.2f}  {}\n", goal.name, goal.wanted, goal.seen,
                              goal.seen >= goal.wanted ? "reached" : "not reached");
    }
    return result;
}

} // namespace lineatlas::bench
