// Distances that a Session measures.
#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "session.hpp"

namespace lineatlas::viewer {
namespace {

struct Unit {
    double millimetres;
    const char* name;
};
constexpr std::array<Unit, 5> units{
    {{1, "mm"}, {10, "cm"}, {1000, "m"}, {25.4, "in"}, {304.8, "ft"}}};

} // namespace

void Session::toggle_measuring() {
    measuring_ = !measuring_ && model_ != nullptr;
    measured_from_.reset();
    if (measuring_) messages.notice("Click two points to measure between them; R ends it");
}

void Session::measure_at(glm::dvec2 point) {
    const auto at = corner_or_point(model_->lines, navigation.view(), point, size_);
    if (!at) return messages.notice("There is nothing to measure here");
    if (!measured_from_) {
        measured_from_ = at;
        return;
    }
    settings.distances.push_back({*measured_from_, *at});
    measured_from_.reset();
    changed();
}

std::string Session::length_text(double length) const {
    const double unit = model_->unit.value_or(0);
    for (const Unit& known : units)
        if (known.millimetres == unit) return fmt::format("{:.5g} {}", length, known.name);
    if (unit > 0) return fmt::format("{:.5g} mm", length * unit);
    return fmt::format("{:.5g}", length);
}

} // namespace lineatlas::viewer
