#include "report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const std::optional<double>& value) {
    return value ? fmt::format("{:.4f}", *value) : "-";
}

void print_columns(std::string_view first, bool motion) {
    fmt::print("  {:<14}{:>10}{:>10}{:>9}{:>9}{:>9}", first, "samples", "error", "wrong %",
               "f.vis %", "f.hid %");
    fmt::print("{}\n", motion ? "   sparkle crawl px  >.5 px" : "");
}

void print_subject(const SubjectReport& report) {
    fmt::print("{}: {} triangles, {} segments, {} views", report.name, report.triangles,
               report.segments, report.views);
    if (report.typical_motion > 0) fmt::print(", moving {:.2f} px a frame", report.typical_motion);
    fmt::print("\n");
}

void print_row(const std::string& name, const Figures& f, const MotionFigures* motion) {
    fmt::print("  {:<14}{:>10}{:>10.4f}{:>9.3f}{:>9.3f}{:>9.3f}", name, f.samples, f.mean_error(),
               100 * f.share(f.wrong()), 100 * f.share(f.false_visible),
               100 * f.share(f.false_hidden));
    if (motion != nullptr) {
        fmt::print("{:>10}{:>9}{:>9}", text(motion->sparkle()), text(motion->crawl()),
                   text(motion->crawling_share()));
    }
    fmt::print("\n");
}

void print_kinds(const KindFigures& figures, const KindMotion* motion) {
    for (std::size_t i = 0; i < figures.kinds.size(); ++i) {
        if (figures.kinds[i].samples == 0) continue;
        print_row("  " + std::string{line_kind_names[i]}, figures.kinds[i],
                  motion != nullptr ? &motion->kinds[i] : nullptr);
    }
}

const MethodReport* find(const SubjectReport& report, std::string_view method) {
    const auto found = std::ranges::find(report.methods, method, &MethodReport::name);
    return found == report.methods.end() ? nullptr : &*found;
}

/// Prints the errors of another method over those of SAhi.
void print_ratio(const SubjectReport& report, std::string_view other) {
    const MethodReport* ours = find(report, "SAhi");
    const MethodReport* theirs = find(report, other);
    if (ours == nullptr || theirs == nullptr) return;
    const double error = theirs->errors.all.mean_error();
    fmt::print("  SAhi to {}: mean error {:.2f}", other,
               error > 0 ? ours->errors.all.mean_error() / error : 0);
    const auto sparkle = theirs->motion.all.sparkle();
    if (sparkle && *sparkle > 0 && ours->motion.all.sparkle()) {
        fmt::print(", sparkle {:.2f}", *ours->motion.all.sparkle() / *sparkle);
    }
    fmt::print("\n");
}

/// Rounds to seven decimal places; more mean nothing.
double rounded(double value) {
    return std::round(value * 1e7) / 1e7;
}

Json json(const std::optional<double>& value) {
    return value ? Json(rounded(*value)) : Json(nullptr);
}

Json json(const Figures& f) {
    return Json{{"samples", f.samples},
                {"mean_error", rounded(f.mean_error())},
                {"wrong", rounded(f.share(f.wrong()))},
                {"false_visible", rounded(f.share(f.false_visible))},
                {"false_hidden", rounded(f.share(f.false_hidden))}};
}

Json json(const Figures& errors, const MotionFigures& motion) {
    Json result = json(errors);
    result["sparkle"] = json(motion.sparkle());
    result["crawl"] = json(motion.crawl());
    result["sparkle_points"] = motion.points;
    result["crawl_points"] = motion.stroke_points;
    result["crawling"] = json(motion.crawling_share());
    return result;
}

Json json(const MethodReport& method) {
    Json result = json(method.errors.all, method.motion.all);
    result["kinds"] = Json::object();
    for (std::size_t i = 0; i < method.errors.kinds.size(); ++i) {
        const Figures& errors = method.errors.kinds[i];
        if (errors.samples == 0) continue;
        result["kinds"][std::string{line_kind_names[i]}] = json(errors, method.motion.kinds[i]);
    }
    return result;
}

Json json(const SubjectReport& subject) {
    Json methods = Json::object();
    for (const MethodReport& method : subject.methods) methods[method.name] = json(method);
    Json styles = Json::object();
    for (const auto& [name, figures] : subject.styles) {
        styles[name] = {{"drawn", json(figures.mean_shown())},
                        {"sparkle", json(figures.sparkle())},
                        {"flicker", json(figures.flicker())},
                        {"jumps", json(figures.jumps())},
                        {"points", figures.changes}};
    }
    return Json{{"triangles", subject.triangles},
                {"segments", subject.segments},
                {"views", subject.views},
                {"typical_motion", rounded(subject.typical_motion)},
                {"methods", methods},
                {"styles", styles}};
}

Json json(const StudyReport& study) {
    Json points = Json::array();
    for (const StudyPoint& point : study.points) {
        Json entry{{"probes", point.probes}, {"depth_scale", point.depth_scale}};
        entry.update(json(point.errors, point.motion));
        points.push_back(entry);
    }
    return points;
}

} // namespace

void MethodReport::add(const MethodReport& other) {
    errors.add(other.errors);
    motion.add(other.motion);
}

SubjectReport total_of(const std::vector<SubjectReport>& subjects) {
    SubjectReport total;
    total.name = "total";
    for (const SubjectReport& subject : subjects) {
        total.triangles += subject.triangles;
        total.segments += subject.segments;
        total.views += subject.views;
        total.methods.resize(subject.methods.size());
        for (std::size_t i = 0; i < subject.methods.size(); ++i) {
            total.methods[i].name = subject.methods[i].name;
            total.methods[i].add(subject.methods[i]);
        }
        total.styles.resize(subject.styles.size());
        for (std::size_t i = 0; i < subject.styles.size(); ++i) {
            total.styles[i].name = subject.styles[i].name;
            total.styles[i].figures.add(subject.styles[i].figures);
        }
    }
    return total;
}

StudyReport total_of(const std::vector<StudyReport>& study) {
    StudyReport total{"total", {}};
    for (const StudyReport& one : study) {
        if (total.points.empty()) {
            total.points = one.points;
            continue;
        }
        for (std::size_t i = 0; i < one.points.size(); ++i) {
            total.points[i].errors.add(one.points[i].errors);
            total.points[i].motion.add(one.points[i].motion);
        }
    }
    return total;
}

void print_table(const SubjectReport& report, bool kinds) {
    print_subject(report);
    print_columns("method", true);
    for (const MethodReport& method : report.methods) {
        print_row(method.name, method.errors.all, &method.motion.all);
        if (kinds) print_kinds(method.errors, &method.motion);
    }
    for (const std::string_view other : {"IBlo", "IBhi", "SAlo"}) print_ratio(report, other);
    fmt::print("\n");
}

void print_styles(const SubjectReport& report) {
    print_subject(report);
    fmt::print("  {:<14}{:>10}{:>10}{:>9}{:>10}{:>9}{:>10}{:>9}\n", "style", "drawn", "sparkle",
               "to plain", "flicker", "to plain", "jumps", "to plain");
    const StyledFigures& plain = report.styles.front().figures;
    const auto six = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.6f}", *value) : "-";
    };
    const auto ratio = [](const std::optional<double>& a, const std::optional<double>& b) {
        return a && b && *b > 0 ? fmt::format("{:.2f}", *a / *b) : "-";
    };
    for (const auto& [name, f] : report.styles) {
        fmt::print("  {:<14}{:>10}{:>10}{:>9}{:>10}{:>9}{:>10}{:>9}\n", name, six(f.mean_shown()),
                   six(f.sparkle()), ratio(f.sparkle(), plain.sparkle()), six(f.flicker()),
                   ratio(f.flicker(), plain.flicker()), six(f.jumps()),
                   ratio(f.jumps(), plain.jumps()));
    }
    fmt::print("\n");
}

void print_study(const StudyReport& report) {
    fmt::print("{}: SA\n", report.name);
    print_columns("probes, depth", true);
    for (const StudyPoint& point : report.points) {
        print_row(fmt::format("{:>6},{:>5}x", point.probes, point.depth_scale), point.errors,
                  &point.motion);
    }
    fmt::print("\n");
}

void print_intervals_header() {
    fmt::print("{:<16}{:>11}{:>11}{:>8}{:>9}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}\n", "intervals",
               "truth px", "visible px", "diff %", "shares %", "f.vis %", "f.hid %", "crumbs",
               "ends", "<.25 %", "<.5 %", "<1 %");
}

void print_intervals(const IntervalReport& report) {
    const IntervalFigures& f = report.figures;
    const auto percent = [&](double pixels) { return 100 * pixels / f.truly_visible; };
    fmt::print("{:<16}{:>11.0f}{:>11.0f}{:>8.3f}{:>9.3f}{:>8.3f}{:>8.3f}{:>8}{:>8}{:>8.1f}{:>8.1f}{"
               ":>8.1f}\n",
               report.name, f.truly_visible, f.visible, percent(f.visible - f.truly_visible),
               100 * (f.shares / f.true_shares - 1), percent(f.falsely_visible),
               percent(f.falsely_hidden), f.crumbs, f.ends, 100 * f.ends_within(0.25),
               100 * f.ends_within(0.5), 100 * f.ends_within(1));
}

void print_view_header() {
    print_columns("view", false);
}
void print_view(const std::string& name, const KindFigures& figures) {
    print_row(name, figures.all, nullptr);
    print_kinds(figures, nullptr);
}

void print_worst(const Oracle& oracle, const ViewSamples& view, const Camera& camera,
                 std::size_t count) {
    const std::vector<WrongSegment> worst = worst_segments(view, count);
    if (worst.empty()) return;
    // "blocker" is the nearest surface before the worst sample, in pixel widths at the line.
    fmt::print("  worst segments\n    {:>8} {:<11}{:>16}{:>9}{:>7}{:>7}{:>7}{:>7}  {}\n", "segment",
               "kind", "window", "samples", "f.vis", "f.hid", "alpha", "truth", "blocker px");
    for (const WrongSegment& wrong : worst) {
        const std::uint32_t i = wrong.segment;
        const std::uint32_t j = wrong.worst_sample;
        const std::uint32_t l = view.clipped.samples(i);
        const glm::dvec2 place =
            window_segment(view.clipped.clipped[i], camera.size).at((j + 0.5) / l);
        const auto blocker = oracle.nearest_blocker(view.clipped, camera, i, j);
        const auto kind = view.lines.segments[i].tag & LA_TAG_KIND_MASK;
        const std::uint32_t index = view.clipped.offsets[i] + j;
        // Positions count from the upper left, as in picture viewers.
        fmt::print(
            "    {:>8} {:<11}{:>8.1f},{:>7.1f}{:>9}{:>7}{:>7}{:>7.2f}{:>7.2f}  {}\n", i,
            line_kind_names[kind], place.x, camera.size.y - place.y, l, wrong.figures.false_visible,
            wrong.figures.false_hidden, view.alpha[index] / 255.0, view.truth[index],
            blocker ? fmt::format("{:.2f} (triangle {})", blocker->distance, blocker->triangle)
                    : "none");
    }
}

std::string json_text(const Report& report) {
    const Settings& settings = report.settings;
    Json json_report{{"size", {settings.size.x, settings.size.y}},
                     {"step", settings.step},
                     {"rays", settings.rays},
                     {"burst", settings.burst},
                     {"scenes", Json::object()}};
    for (const SubjectReport& subject : report.subjects) {
        json_report["scenes"][subject.name] = json(subject);
    }
    if (!report.subjects.empty()) json_report["total"] = json(total_of(report.subjects));
    for (const OracleReport& oracle : report.oracle) {
        json_report["oracle"][oracle.name] = {{"mean_alpha", rounded(oracle.once)},
                                              {"mean_alpha_twice", rounded(oracle.twice)}};
    }
    for (const IntervalReport& one : report.intervals) {
        const IntervalFigures& f = one.figures;
        json_report["intervals"][one.name] = {{"length", rounded(f.length)},
                                              {"visible", rounded(f.visible)},
                                              {"truly_visible", rounded(f.truly_visible)},
                                              {"falsely_visible", rounded(f.falsely_visible)},
                                              {"falsely_hidden", rounded(f.falsely_hidden)},
                                              {"missing", rounded(f.missing)},
                                              {"crumbs", f.crumbs},
                                              {"ends", f.ends},
                                              {"ends_within_quarter", rounded(f.ends_within(0.25))},
                                              {"ends_within_pixel", rounded(f.ends_within(1))}};
    }
    for (const PathReport& one : report.paths) {
        const PathFigures& f = one.figures;
        json_report["paths"][one.name][one.method] = {
            {"visible", rounded(f.visible)},
            {"undecided", rounded(f.undecided)},
            {"missed", rounded(f.missed_share())},
            {"off", rounded(f.off)},
            {"false", rounded(f.false_share())},
            {"strict_hidden", rounded(f.hidden_share())},
            {"surely_wrong_pixels", rounded(f.surely_wrong)},
            {"missed_ink", rounded(f.missed_ink_share())},
            {"false_ink", rounded(f.false_ink_share())},
            {"paths", f.paths},
            {"gaps", f.gaps}};
    }
    for (const StudyReport& study : report.study) json_report["study"][study.name] = json(study);
    // JSON must be UTF-8; file names in it need not be.
    return json_report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lineatlas::bench
