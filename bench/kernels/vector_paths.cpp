// overlaps, plotter: steps on the host between a drawing's paths and its file, for a picture of n
// pixels. overlaps has one piece of a path per 20 pixels, plotter one stroke per 480.
// Bytes: every point of a path (VectorPoint) read and written once.

#include <cmath>

#include "common.hpp"
#include "vector/overlaps.hpp"
#include "vector/paths.hpp"
#include "vector/plotter.hpp"

namespace lineatlas::bench {
namespace {

double side_of(std::uint32_t n) {
    return std::sqrt(static_cast<double>(n));
}

/// Winding paths of `pieces` pieces. Every second path runs along the previous one, a little beside
/// it.
std::vector<VectorPath> crowd(std::uint32_t n, std::size_t count, std::uint32_t pieces) {
    Random random{3};
    const auto side = static_cast<float>(side_of(n));
    std::vector<VectorPath> paths;
    std::vector<glm::dvec2> points;
    while (paths.size() < count) {
        if (paths.size() % 2 == 0) {
            double angle = static_cast<double>(random.between(0, 6.28F));
            points.assign(1, {random.between(0, side), random.between(0, side)});
            for (std::uint32_t i = 0; i < pieces; ++i) {
                angle += static_cast<double>(random.between(-0.2F, 0.2F));
                points.push_back(points.back() + glm::dvec2{std::cos(angle), std::sin(angle)} *
                                                     static_cast<double>(random.between(0.3F, 6)));
            }
        } else {
            for (glm::dvec2& point : points) point += 0.1;
        }
        paths.push_back(path_through(LineKind::crease, true, points));
    }
    return paths;
}

Row overlaps_row() {
    return {"overlaps/host", [](std::uint32_t n) -> Job {
                constexpr std::uint32_t pieces = 25;
                const auto paths = crowd(n, n / 20 / pieces, pieces);
                const glm::dvec2 picture{side_of(n), side_of(n)};
                require(remove_overlaps(paths, picture).size() < paths.size(), "overlaps");
                return {.run = [=] { remove_overlaps(paths, picture); },
                        .bytes = 2.0 * sizeof(VectorPoint) * (n / 20.0)};
            }};
}

Row plotter_row() {
    return {"plotter/host", [](std::uint32_t n) -> Job {
                const auto given = crowd(n, n / 480, 1);
                const auto paths = std::make_shared<std::vector<VectorPath>>(given);
                const PenTravel travel = order_for_plotter(*paths);
                require(travel.after < travel.before, "plotter");
                return {.run = [=] { order_for_plotter(*paths); },
                        .bytes = 4.0 * sizeof(VectorPoint) * (n / 480.0),
                        .reset = [=] { *paths = given; }};
            }};
}

} // namespace

Rows vector_path_rows(const Devices& /*devices*/) {
    return {overlaps_row(), plotter_row()};
}

} // namespace lineatlas::bench
