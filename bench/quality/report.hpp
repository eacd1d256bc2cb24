#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare.hpp"
#include "interval_errors.hpp"
#include "motion.hpp"
#include "path_errors.hpp"
#include "styled.hpp"

// The output of `lineatlas-bench-quality`: tables for people, JSON for programs.
namespace lineatlas::bench {

struct MethodReport {
    std::string name; ///< e.g. "SAhi"
    KindFigures errors;
    KindMotion motion;

    void add(const MethodReport& other);
};

/// The figures of drawings by SAhi with a style.
struct StyleReport {
    std::string name;
    StyledFigures figures;
};

struct SubjectReport {
    std::string name; ///< a scene, or a model's file name
    std::size_t triangles = 0, segments = 0, views = 0;
    double typical_motion = 0; ///< median motion of visible points from frame to frame, in pixels
    std::vector<MethodReport> methods;
    std::vector<StyleReport> styles{}; ///< instead of methods; the first has no effects
};

/// The mean of alpha* with the usual number of rays, and with twice as many.
struct OracleReport {
    std::string name;
    double once = 0, twice = 0;
};

struct IntervalReport {
    std::string name;
    IntervalFigures figures;
};

/// The segment atlas with a number of probes and a depth scale (Fig. 6).
struct StudyPoint {
    std::uint32_t probes;
    int depth_scale;
    Figures errors;
    MotionFigures motion;
};

struct StudyReport {
    std::string name;
    std::vector<StudyPoint> points;
};

/// The settings of a measurement.
struct Settings {
    glm::ivec2 size;
    float step;
    std::uint32_t rays;
    std::size_t burst; ///< frames per view
};

struct Report {
    Settings settings;
    std::vector<SubjectReport> subjects;
    std::vector<OracleReport> oracle;
    std::vector<IntervalReport> intervals;
    std::vector<PathReport> paths;
    std::vector<StudyReport> study;
};

/// The figures of all samples of all subjects, under the name "total".
SubjectReport total_of(const std::vector<SubjectReport>& subjects);
StudyReport total_of(const std::vector<StudyReport>& study);

/// Prints a row per method; with `kinds` also a row per kind of line.
void print_table(const SubjectReport& report, bool kinds);
/// Prints a row per style.
void print_styles(const SubjectReport& report);
void print_study(const StudyReport& report);
void print_intervals_header();
void print_intervals(const IntervalReport& report);
/// The figures of a method in one view.
void print_view_header();
void print_view(const std::string& name, const KindFigures& figures);
/// Prints the segments with the most wrong samples, and the nearest blocker of each.
void print_worst(const Oracle& oracle, const ViewSamples& view, const Camera& camera,
                 std::size_t count);

std::string json_text(const Report& report);

} // namespace lineatlas::bench
