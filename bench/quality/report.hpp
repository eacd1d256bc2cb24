#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare.hpp"
#include "interval_errors.hpp"
#include "motion.hpp"
#include "path_errors.hpp"
#include "styled.hpp"

// What `lineatlas-bench-quality` says: tables for people, JSON for programs.
namespace lineatlas::bench {

struct MethodReport {
    std::string name; ///< e.g. "SAhi"
    KindFigures errors;
    KindMotion motion;

    void add(const MethodReport& other);
};

/// What the segment atlas at high quality draws with a style.
struct StyleReport {
    std::string name;
    StyledFigures figures;
};

struct SubjectReport {
    std::string name; ///< a scene, or a model's file name
    std::size_t triangles = 0, segments = 0, views = 0;
    double typical_motion = 0; ///< median of visible points, from frame to frame, pixels
    std::vector<MethodReport> methods;
    std::vector<StyleReport> styles{}; ///< in place of methods; the first is the plain one
};

/// Mean alpha* with the usual number of rays, and with twice as many.
struct OracleReport {
    std::string name;
    double once = 0, twice = 0;
};

struct IntervalReport {
    std::string name;
    IntervalFigures figures;
};

/// SA at some number of probes and depth scale (Fig. 6).
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

/// How it was measured.
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

/// All samples of all subjects, under the name "total".
SubjectReport total_of(const std::vector<SubjectReport>& subjects);
StudyReport total_of(const std::vector<StudyReport>& study);

/// A row per method; with `kinds`, also one per line kind.
void print_table(const SubjectReport& report, bool kinds);
/// A row per style.
void print_styles(const SubjectReport& report);
void print_study(const StudyReport& report);
void print_intervals_header();
void print_intervals(const IntervalReport& report);
/// One view's figures of a method.
void print_view_header();
void print_view(const std::string& name, const KindFigures& figures);
/// The segments that went wrong the most, with what may have caused it.
void print_worst(const Oracle& oracle, const ViewSamples& view, const Camera& camera,
                 std::size_t count);

std::string json_text(const Report& report);

} // namespace lineatlas::bench
