#include "compare.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

float share_of(std::uint8_t alpha) {
    return static_cast<float>(alpha) / 255;
}

template <class Visit>
void for_each_sample(const ViewSamples& view, Visit&& visit) {
    for (std::uint32_t i = 0; i < view.lines.segments.size(); ++i) {
        const std::uint32_t begin = view.clipped.offsets[i];
        const std::uint32_t l = view.clipped.samples(i);
        for (std::uint32_t j = 0; j < l; ++j) {
            visit(i, j, share_of(view.alpha[begin + j]), view.truth[begin + j]);
        }
    }
}

/// The layers of the picture, from the bottom up.
enum class Verdict { hidden, visible, false_visible, false_hidden };

Verdict verdict(float alpha, float truth) {
    if (alpha - truth > wrong_threshold) return Verdict::false_visible;
    if (truth - alpha > wrong_threshold) return Verdict::false_hidden;
    return alpha > 0 ? Verdict::visible : Verdict::hidden;
}

glm::vec3 color(Verdict verdict, float alpha) {
    switch (verdict) {
    case Verdict::false_visible:
        return {230, 0, 0};
    case Verdict::false_hidden:
        return {0, 70, 255};
    case Verdict::visible:
        return glm::mix(glm::vec3{200}, glm::vec3{0}, alpha);
    case Verdict::hidden:
        break;
    }
    return glm::vec3{235};
}

class Painter {
  public:
    Painter(glm::ivec2 viewport, int scale) : scale_(scale) {
        image_.size = viewport * scale;
        image_.pixels.assign(static_cast<std::size_t>(image_.size.x) * image_.size.y * 4, 255);
    }

    /// A stroke between two window positions, `width` pixels of the viewport wide.
    void stroke(glm::dvec2 from, glm::dvec2 to, double width, glm::vec3 color) {
        from *= scale_;
        to *= scale_;
        const double reach = std::max(0.5, 0.5 * width * scale_);
        const glm::dvec2 way = to - from;
        const double squared = glm::dot(way, way);
        const glm::ivec2 low = glm::max(glm::ivec2{glm::min(from, to) - reach}, glm::ivec2{0});
        const glm::ivec2 high = glm::min(glm::ivec2{glm::max(from, to) + reach}, image_.size - 1);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 offset = glm::dvec2{x, y} + 0.5 - from;
                const double u =
                    squared > 0 ? glm::clamp(glm::dot(offset, way) / squared, 0.0, 1.0) : 0;
                if (glm::length(offset - way * u) > reach) continue;
                const std::size_t row = static_cast<std::size_t>(image_.size.y - 1 - y);
                std::uint8_t* pixel = &image_.pixels[(row * image_.size.x + x) * 4];
                for (int channel = 0; channel < 3; ++channel) {
                    pixel[channel] = static_cast<std::uint8_t>(color[channel]);
                }
            }
        }
    }

    Image take() { return std::move(image_); }

  private:
    int scale_;
    Image image_;
};

} // namespace

void Figures::add(float alpha, float truth) {
    ++samples;
    error_sum += std::abs(double{alpha} - double{truth});
    if (alpha - truth > wrong_threshold) ++false_visible;
    if (truth - alpha > wrong_threshold) ++false_hidden;
}

void Figures::add(const Figures& other) {
    samples += other.samples;
    error_sum += other.error_sum;
    false_visible += other.false_visible;
    false_hidden += other.false_hidden;
}

void KindFigures::add(const KindFigures& other) {
    all.add(other.all);
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i].add(other.kinds[i]);
}

KindFigures compare(const ViewSamples& view) {
    const std::size_t samples = view.clipped.offsets.back();
    if (view.alpha.size() != samples || view.truth.size() != samples) {
        throw UsageError("compare: " + std::to_string(view.alpha.size()) + " samples and " +
                         std::to_string(view.truth.size()) + " truths for a view with " +
                         std::to_string(samples));
    }
    KindFigures figures;
    for_each_sample(view, [&](std::uint32_t i, std::uint32_t, float alpha, float truth) {
        figures.all.add(alpha, truth);
        figures.kinds[view.lines.segments[i].tag & LA_TAG_KIND_MASK].add(alpha, truth);
    });
    return figures;
}

std::vector<WrongSegment> worst_segments(const ViewSamples& view, std::size_t count) {
    std::vector<WrongSegment> wrong;
    for (std::uint32_t i = 0; i < view.lines.segments.size(); ++i) {
        const std::uint32_t begin = view.clipped.offsets[i];
        const std::uint32_t l = view.clipped.samples(i);
        Figures figures;
        float worst = 0;
        for (std::uint32_t j = 0; j < l; ++j) {
            const float alpha = share_of(view.alpha[begin + j]);
            figures.add(alpha, view.truth[begin + j]);
            worst = std::max(worst, std::abs(alpha - view.truth[begin + j]));
        }
        if (figures.wrong() == 0) continue;
        std::vector<std::uint32_t> worst_samples;
        for (std::uint32_t j = 0; j < l; ++j) {
            const float alpha = share_of(view.alpha[begin + j]);
            if (std::abs(alpha - view.truth[begin + j]) == worst) worst_samples.push_back(j);
        }
        wrong.push_back({i, figures, worst_samples[worst_samples.size() / 2]});
    }
    count = std::min(count, wrong.size());
    const auto worse = [](const WrongSegment& a, const WrongSegment& b) {
        return std::pair{a.figures.wrong(), b.segment} > std::pair{b.figures.wrong(), a.segment};
    };
    std::ranges::partial_sort(wrong, wrong.begin() + static_cast<std::ptrdiff_t>(count), worse);
    wrong.resize(count);
    return wrong;
}

Image error_picture(const ViewSamples& view, glm::ivec2 viewport, int scale) {
    Painter painter{viewport, scale};
    for (const Verdict layer :
         {Verdict::hidden, Verdict::visible, Verdict::false_visible, Verdict::false_hidden}) {
        const bool wrong = layer > Verdict::visible;
        std::uint32_t current = ~0U;
        WindowSegment place{};
        for_each_sample(view, [&](std::uint32_t i, std::uint32_t j, float alpha, float truth) {
            if (verdict(alpha, truth) != layer) return;
            if (i != current) place = window_segment(view.clipped.clipped[i], viewport);
            current = i;
            const double l = view.clipped.samples(i);
            painter.stroke(place.at(j / l), place.at((j + 1) / l), wrong ? 1 : 0.5,
                           color(layer, alpha));
        });
    }
    return painter.take();
}

} // namespace lineatlas::bench
