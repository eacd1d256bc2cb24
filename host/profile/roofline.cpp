#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "kernel_figures.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas {
namespace {

constexpr double width = 900, height = 600, margin = 70;

/// Powers of two along an axis, and where they are drawn.
struct Axis {
    int first, last; ///< exponents
    double from, to; ///< in the picture

    double place(double value) const {
        const double share = (std::log2(value) - first) / (last - first);
        return from + std::clamp(share, 0.0, 1.0) * (to - from);
    }
};

/// The axis around all values, which are above 0.
Axis axis_around(const std::vector<double>& values, double from, double to) {
    const auto [least, most] = std::ranges::minmax(values);
    return {static_cast<int>(std::floor(std::log2(least))) - 1,
            static_cast<int>(std::ceil(std::log2(most))) + 1, from, to};
}

struct Dot {
    const KernelTime* kernel;
    double intensity; ///< operations per byte
};

std::vector<Dot> dots_of(std::span<const KernelTime> kernels) {
    std::vector<Dot> dots;
    for (const KernelTime& kernel : kernels) {
        if (kernel.operations > 0 && kernel.bytes > 0 && kernel.median > 0)
            dots.push_back({&kernel, kernel.operations / kernel.bytes});
    }
    return dots;
}

std::string power(int exponent) {
    return exponent < 0 ? fmt::format("1/{}", 1LL << -exponent)
                        : fmt::format("{}", 1LL << exponent);
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, text);
}

/// A place for a label at which it covers no other: `place`, or below it.
glm::dvec2 free_place(glm::dvec2 place, const std::vector<glm::dvec2>& others) {
    constexpr double line = 13, length = 130;
    const auto hides = [&](glm::dvec2 other) {
        return std::abs(other.y - place.y) < line && std::abs(other.x - place.x) < length;
    };
    while (std::ranges::any_of(others, hides)) place.y += line;
    return place;
}

/// What a viewer shows when the pointer is on a dot: a line for each figure that is known.
std::string title_of(const KernelTime& kernel) {
    std::string text = fmt::format("{} {}: {}", kernel.stage, kernel.name, name_of(kernel.bound));
    const nlohmann::ordered_json figures = figures_of(kernel);
    for (const auto& [key, value] : figures.items()) {
        if (key == "bound" || value.is_null()) continue;
        text += fmt::format("\n{}: {:.6g}", key, value.get<double>());
    }
    return text;
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg = "<g stroke=\"#ddd\">\n";
    for (int i = x.first; i <= x.last; ++i) {
        const double at = x.place(std::exp2(i));
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", at, y.from, y.to);
    }
    for (int i = y.first; i <= y.last; ++i) {
        const double at = y.place(std::exp2(i));
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", x.from, at, x.to);
    }
    svg += "</g>\n";
    const auto step = [](const Axis& axis) { return std::max(1, (axis.last - axis.first) / 10); };
    for (int i = x.first; i <= x.last; i += step(x))
        svg += text_at(x.place(std::exp2(i)), y.from + 18, "middle", power(i));
    for (int i = y.first; i <= y.last; i += step(y))
        svg += text_at(x.from - 6, y.place(std::exp2(i)) + 4, "end", power(i));
    return svg + text_at((x.from + x.to) / 2, height - 20, "middle", "operations per byte") +
           text_at(x.from - 50, y.to - 14, "start", "10⁹ operations a second");
}

std::string roof_line(const Roofs& roofs, const Axis& x, const Axis& y) {
    const double ridge = roofs.arithmetic / roofs.copy, left = std::exp2(y.first) / roofs.copy;
    const double start = std::max(left, std::exp2(x.first));
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}H{:.1f}\" fill=\"none\" "
                       "stroke=\"black\" stroke-width=\"2\"/>\n",
                       x.place(start), y.place(start * roofs.copy), x.place(ridge),
                       y.place(roofs.arithmetic), x.to) +
           text_at(x.to, y.place(roofs.arithmetic) - 8, "end",
                   fmt::format("{:.0f} Gop/s; a copy: {:.1f} GB/s", roofs.arithmetic, roofs.copy));
}

} // namespace

std::string roofline_svg(std::span<const KernelTime> kernels, const Roofs& roofs) {
    const std::vector<Dot> dots = dots_of(kernels);
    std::string svg =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
                    "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" "
                    "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" "
                    "fill=\"white\"/>\n",
                    width, height);
    if (!dots.empty() && roofs.copy > 0 && roofs.arithmetic > 0) {
        std::vector<double> across{roofs.arithmetic / roofs.copy}, up{roofs.arithmetic};
        double longest = 0;
        for (const Dot& dot : dots) {
            across.push_back(dot.intensity);
            up.push_back(dot.kernel->gigaops_per_second);
            longest = std::max(longest, dot.kernel->sum);
        }
        const Axis x = axis_around(across, margin, width - margin);
        const Axis y = axis_around(up, height - margin, margin);
        svg += grid(x, y) + roof_line(roofs, x, y);
        std::vector<glm::dvec2> labels;
        for (const Dot& dot : dots) {
            // The area of a dot is its share of time.
            const double radius = 2 + 12 * std::sqrt(dot.kernel->sum / longest);
            const double at_x = x.place(dot.intensity);
            const double at_y = y.place(dot.kernel->gigaops_per_second);
            fmt::format_to(std::back_inserter(svg),
                           "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#36c\" "
                           "fill-opacity=\"0.6\"><title>{}</title></circle>\n",
                           at_x, at_y, radius, title_of(*dot.kernel));
            if (dot.kernel->sum < 0.02 * longest) continue;
            labels.push_back(free_place({at_x + radius + 3, at_y + 4}, labels));
            svg += text_at(labels.back().x, labels.back().y, "start", dot.kernel->name);
        }
    }
    return svg + "</svg>\n";
}

} // namespace lineatlas
