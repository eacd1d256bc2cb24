#include "report.hpp"

#include <fstream>

#include <fmt/core.h>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

void print_row(const std::string& name, const Figures& f) {
    fmt::print("{:<22}{:>9}{:>9.4f}{:>8}{:>9.3f}{:>9.3f}{:>9.3f}\n", name, f.samples,
               f.mean_error(), f.wrong(), 100 * f.share(f.wrong()), 100 * f.share(f.false_visible),
               100 * f.share(f.false_hidden));
}

std::string json(const Figures& f) {
    return fmt::format(R"({{"samples": {}, "mean_error": {:.6f}, "wrong": {:.6f}, )"
                       R"("false_visible": {:.6f}, "false_hidden": {:.6f}}})",
                       f.samples, f.mean_error(), f.share(f.wrong()), f.share(f.false_visible),
                       f.share(f.false_hidden));
}

std::string json(const KindFigures& figures) {
    std::string result = "{\"all\": " + json(figures.all);
    for (std::size_t i = 0; i < figures.kinds.size(); ++i) {
        if (figures.kinds[i].samples == 0) continue;
        result += fmt::format(", \"{}\": {}", line_kind_names[i], json(figures.kinds[i]));
    }
    return result + "}";
}

std::string json_string(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result + "\"";
}

} // namespace

void print_header() {
    fmt::print("{:<22}{:>9}{:>9}{:>8}{:>9}{:>9}{:>9}\n", "view", "samples", "error", "wrong",
               "wrong %", "f.vis %", "f.hid %");
}

void print_figures(const std::string& name, const KindFigures& figures) {
    print_row(name, figures.all);
    for (std::size_t i = 0; i < figures.kinds.size(); ++i) {
        if (figures.kinds[i].samples == 0) continue;
        print_row("  " + std::string{line_kind_names[i]}, figures.kinds[i]);
    }
}

void print_worst(const Oracle& oracle, const ViewSamples& view, const Camera& camera,
                 std::size_t count) {
    const std::vector<WrongSegment> worst = worst_segments(view, count);
    if (worst.empty()) return;
    // Blocker: the nearest surface before the worst sample, in pixel widths at the line.
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
        // From the upper left, as picture viewers count.
        fmt::print(
            "    {:>8} {:<11}{:>8.1f},{:>7.1f}{:>9}{:>7}{:>7}{:>7.2f}{:>7.2f}  {}\n", i,
            line_kind_names[kind], place.x, camera.size.y - place.y, l, wrong.figures.false_visible,
            wrong.figures.false_hidden, view.alpha[index] / 255.0, view.truth[index],
            blocker ? fmt::format("{:.2f} (triangle {})", blocker->distance, blocker->triangle)
                    : "none");
    }
}

void write_json(const std::filesystem::path& path, const std::string& subject,
                const std::vector<ViewReport>& views, const KindFigures& total) {
    std::ofstream file{path};
    file << "{\"subject\": " << json_string(subject) << ",\n \"views\": [";
    for (std::size_t i = 0; i < views.size(); ++i) {
        file << (i == 0 ? "\n" : ",\n") << "  {\"view\": " << json_string(views[i].name)
             << ", \"figures\": " << json(views[i].figures) << "}";
    }
    file << "],\n \"total\": " << json(total) << "}\n";
    file.close();
    if (!file) throw FileError("cannot write \"" + path.string() + "\"");
}

} // namespace lineatlas::bench
