#include "far_part.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "lineatlas/framing.hpp"

namespace lineatlas {
namespace {

/// A small part has at most this share of all triangles and lines.
constexpr double small_share = 0.02;
/// A tiny part, which is not framed if it lies far away, has at most this share of them.
constexpr double tiny_share = 0.001;
/// A part lies far away if the frame would have to be this many times as large.
constexpr float far_ratio = 2;
/// Specks are tiny together, and each has at most this share of the rest's extent. They lie far
/// away if the frame would have to be this many times as large.
constexpr float speck_ratio = 1.25F, speck_share = 0.01F;
/// The model is cut into so many slices along an axis. Gaps narrower than a slice do not count.
constexpr std::size_t slices = 256;

Bounds joined(const Bounds& a, const Bounds& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

float extent(const Bounds& bounds) {
    return glm::distance(bounds.min, bounds.max);
}

/// Calls `each` with the box of every triangle and line.
template <class Each>
void for_each_box(const LineSet& lines, Each each) {
    const auto at = [&](std::uint32_t vertex) { return lines.vertices[vertex]; };
    for (const glm::uvec3& t : lines.triangles) {
        each(Bounds{glm::min(glm::min(at(t.x), at(t.y)), at(t.z)),
                    glm::max(glm::max(at(t.x), at(t.y)), at(t.z))});
    }
    for (const Segment& s : lines.segments)
        each(Bounds{glm::min(at(s.p), at(s.q)), glm::max(at(s.p), at(s.q))});
}

/// What lies in the slices along an axis.
struct Slices {
    std::array<std::size_t, slices> middles{};       ///< boxes whose middle lies there
    std::array<std::ptrdiff_t, slices + 1> change{}; ///< of the number of boxes that reach there

    void add(std::size_t from, std::size_t to) {
        ++middles[(from + to) / 2];
        ++change[from];
        --change[to + 1];
    }

    /// The slices up to and from gaps that cut off at most `most` boxes at either end.
    std::pair<std::size_t, std::size_t> main_part(std::size_t most) const {
        std::array<bool, slices> covered{};
        std::ptrdiff_t boxes = 0;
        for (std::size_t i = 0; i < slices; ++i) covered[i] = (boxes += change[i]) > 0;
        std::size_t first = 0, last = slices - 1, cut = 0;
        for (std::size_t i = 0; i < slices && cut <= most; cut += middles[i++])
            if (!covered[i]) first = i + 1;
        cut = 0;
        for (std::size_t i = slices; i-- > first && cut <= most; cut += middles[i])
            if (!covered[i]) last = i - 1;
        return {first, last};
    }
};

} // namespace

std::optional<FarPart> find_far_part(const LineSet& lines) {
    const Bounds& all = lines.bounds;
    const glm::vec3 size = glm::max(all.max - all.min, glm::vec3{1e-30F});
    const auto slice_of = [&](float value, int axis) {
        const float place = (value - all.min[axis]) / size[axis] * static_cast<float>(slices);
        return std::min(static_cast<std::size_t>(std::max(place, 0.0F)), slices - 1);
    };
    std::array<Slices, 3> axes{};
    std::size_t total = 0;
    for_each_box(lines, [&](const Bounds& box) {
        ++total;
        for (int axis = 0; axis < 3; ++axis) {
            axes[static_cast<std::size_t>(axis)].add(slice_of(box.min[axis], axis),
                                                     slice_of(box.max[axis], axis));
        }
    });
    const auto most = static_cast<std::size_t>(small_share * static_cast<double>(total));
    std::array<std::pair<std::size_t, std::size_t>, 3> kept;
    std::ranges::transform(axes, kept.begin(),
                           [&](const Slices& along) { return along.main_part(most); });
    Bounds main;
    std::size_t stray = 0;
    float longest = 0;
    for_each_box(lines, [&](const Bounds& box) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto [first, last] = kept[static_cast<std::size_t>(axis)];
            inside = inside && slice_of(box.min[axis], axis) >= first &&
                     slice_of(box.max[axis], axis) <= last;
        }
        if (inside) {
            main = joined(main, box);
        } else {
            ++stray;
            longest = std::max(longest, extent(box));
        }
    });
    if (stray == 0 || stray > most) return std::nullopt;
    const FarPart far{
        .count = stray, .total = total, .rest = main, .ratio = extent(all) / extent(main)};
    const bool specks = is_left_out(far) && longest <= speck_share * extent(main);
    if (!(far.ratio >= (specks ? speck_ratio : far_ratio))) return std::nullopt;
    return far;
}

bool is_left_out(const FarPart& far) {
    return static_cast<double>(far.count) <= tiny_share * static_cast<double>(far.total);
}

std::vector<glm::vec3> points_to_frame(const LineSet& lines, const std::optional<FarPart>& far) {
    if (!far || !is_left_out(*far)) return lines.vertices;
    std::vector<glm::vec3> points;
    std::ranges::copy_if(lines.vertices, std::back_inserter(points), [&](const glm::vec3& p) {
        return glm::all(glm::greaterThanEqual(p, far->rest.min)) &&
               glm::all(glm::lessThanEqual(p, far->rest.max));
    });
    return points;
}

std::string note_of(const FarPart& far) {
    const std::string parts =
        fmt::format("{} of {} triangles and lines lie far from all others", far.count, far.total);
    if (is_left_out(far))
        return fmt::format("{}; they are not framed, which would make the picture {:.3g} times as "
                           "wide",
                           parts, far.ratio);
    return fmt::format("{}, and the picture is {:.3g} times as wide for their sake", parts,
                       far.ratio);
}

Framing framing_of(const LineSet& lines) {
    const std::optional<FarPart> far = find_far_part(lines);
    return {.points = points_to_frame(lines, far), .note = far ? note_of(*far) : std::string{}};
}

} // namespace lineatlas
