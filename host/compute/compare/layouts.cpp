#include "layouts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "lineatlas/error.hpp"
#include "segment_table.h"

namespace lineatlas::compute {
namespace {

constexpr float pixel = 1e-3F; // agreement of positions and lengths on the screen
constexpr float corner = 1e-4F;
constexpr float world = 1e-4F;

std::size_t size_of(FieldKind kind) {
    return kind == FieldKind::byte || kind == FieldKind::channel ? 1 : 4;
}

float half(std::uint32_t bits) {
    return std::bit_cast<float>(bits << 16U);
}

std::uint32_t word_at(const std::byte* place) {
    std::uint32_t word;
    std::memcpy(&word, place, sizeof(word));
    return word;
}

/// Whether two words with different bits agree.
bool words_agree(const Field& field, std::uint32_t a, std::uint32_t b) {
    switch (field.kind) {
    case FieldKind::byte:
    case FieldKind::channel:
    case FieldKind::integer:
        return false;
    case FieldKind::number:
        return agree(std::bit_cast<float>(a), std::bit_cast<float>(b), field.relative,
                     field.absolute);
    case FieldKind::two_halves:
        return agree(half(a & 0xFFFFU), half(b & 0xFFFFU), 0.008F, 1e-6F) &&
               agree(half(a >> 16U), half(b >> 16U), 0.008F, 1e-6F);
    }
    return false;
}

std::string text(FieldKind kind, const std::byte* place) {
    std::ostringstream out;
    out.precision(9);
    switch (kind) {
    case FieldKind::byte:
    case FieldKind::channel:
        out << std::to_integer<int>(*place);
        break;
    case FieldKind::integer:
        out << word_at(place);
        break;
    case FieldKind::number:
        out << std::bit_cast<float>(word_at(place));
        break;
    case FieldKind::two_halves:
        out << half(word_at(place) & 0xFFFFU) << " and " << half(word_at(place) >> 16U);
        break;
    }
    return out.str();
}

bool agree_at(const Field& field, const std::byte* a, const std::byte* b) {
    if (field.kind == FieldKind::byte) return *a == *b;
    if (field.kind == FieldKind::channel)
        return std::abs(std::to_integer<int>(*a) - std::to_integer<int>(*b)) <= 1;
    return word_at(a) == word_at(b) || words_agree(field, word_at(a), word_at(b));
}

/// The first difference in one element.
std::optional<Difference> difference_in(const Layout& layout, const std::byte* a,
                                        const std::byte* b) {
    for (const Field& field : layout.fields) {
        for (std::size_t i = 0; i < field.count; ++i) {
            if (!agree_at(field, a, b)) {
                std::string name = field.name;
                if (field.count > 1) name.append("[").append(std::to_string(i)).append("]");
                return Difference{0, name, text(field.kind, a), text(field.kind, b)};
            }
            a += size_of(field.kind);
            b += size_of(field.kind);
        }
    }
    return std::nullopt;
}

} // namespace

bool agree(float a, float b, float relative, float absolute) {
    if (a == b) return true;
    if (!std::isfinite(a) || !std::isfinite(b)) return false;
    const float largest = std::max(std::fabs(a), std::fabs(b));
    return std::fabs(a - b) <= std::max(absolute, relative * largest);
}

std::size_t Layout::size() const {
    std::size_t bytes = 0;
    for (const Field& field : fields) bytes += field.count * size_of(field.kind);
    return bytes;
}

/// The layouts of types, by their names in kernels.h.
const Layout& layout_of(std::string_view type) {
    static const std::array layouts{
        Layout{"uchar", {{"", FieldKind::byte}}},
        Layout{"uint", {{"", FieldKind::integer}}},
        Layout{"int", {{"", FieldKind::integer}}},
        Layout{"float", {{"", FieldKind::number}}},
        Layout{"ClusterPlace",
               {{"low_x", FieldKind::integer},
                {"low_y", FieldKind::integer},
                {"high_x", FieldKind::integer},
                {"high_y", FieldKind::integer},
                {"nearest", FieldKind::number},
                {"key", FieldKind::integer}}},
        Layout{"DepthTexel", {{"rank", FieldKind::integer}, {"order", FieldKind::number}}},
        Layout{"StrokeBox",
               {{"low", FieldKind::number, 2, 1e-5F, pixel},
                {"high", FieldKind::number, 2, 1e-5F, pixel},
                {"flags", FieldKind::integer},
                {"opacity", FieldKind::number}}},
        Layout{"Cluster",
               {{"low", FieldKind::number, 3},
                {"high", FieldKind::number, 3},
                {"first", FieldKind::integer},
                {"count", FieldKind::integer}}},
        Layout{"ClippedSegment",
               {{"p", FieldKind::number, 4},
                {"q", FieldKind::number, 4},
                {"t0", FieldKind::number},
                {"t1", FieldKind::number},
                {"own_a", FieldKind::two_halves},
                {"own_b", FieldKind::two_halves}}},
        Layout{"Run",
               {{"start", FieldKind::number, 2, 1e-5F, pixel},
                {"end", FieldKind::number, 2, 1e-5F, pixel},
                {"start_corner", FieldKind::number, 2, corner, pixel},
                {"end_corner", FieldKind::number, 2, corner, pixel},
                {"start_arc", FieldKind::number, 1, 1e-5F, pixel},
                {"end_arc", FieldKind::number, 1, 1e-5F, pixel},
                {"start_sample", FieldKind::number, 1, 1e-5F, pixel},
                {"end_sample", FieldKind::number, 1, 1e-5F, pixel},
                {"address", FieldKind::integer},
                {"samples", FieldKind::integer},
                {"flags", FieldKind::integer},
                {"segment", FieldKind::integer},
                {"stroke_start", FieldKind::number, 1, 1e-5F, pixel},
                {"stroke_end", FieldKind::number, 1, 1e-5F, pixel},
                {"start_depth", FieldKind::number},
                {"end_depth", FieldKind::number}}},
        Layout{"RunCuts",
               {{"from", FieldKind::number, LA_MOST_CUTS, 1e-5F, pixel},
                {"to", FieldKind::number, LA_MOST_CUTS, 1e-5F, pixel}}},
        Layout{"Interval",
               {{"start", FieldKind::number, 2, 1e-5F, pixel},
                {"end", FieldKind::number, 2, 1e-5F, pixel},
                {"start_depth", FieldKind::number},
                {"end_depth", FieldKind::number},
                {"start_world", FieldKind::number, 3, 1e-5F, world},
                {"end_world", FieldKind::number, 3, 1e-5F, world},
                {"start_arc", FieldKind::number, 1, 1e-5F, pixel},
                {"end_arc", FieldKind::number, 1, 1e-5F, pixel},
                {"start_sample", FieldKind::number, 1, 1e-5F, pixel},
                {"end_sample", FieldKind::number, 1, 1e-5F, pixel},
                {"alpha", FieldKind::number},
                {"segment", FieldKind::integer},
                {"flags", FieldKind::integer}}},
        Layout{"Color", {{"", FieldKind::channel, 4}}},
        Layout{"FrameRecord",
               {{"points", FieldKind::integer, 4},
                {"sample_total", FieldKind::integer},
                {"run_total", FieldKind::integer},
                {"raw_run_total", FieldKind::integer},
                {"unused", FieldKind::integer}}},
        Layout{"Segment",
               {{"p", FieldKind::integer},
                {"q", FieldKind::integer},
                {"face_a", FieldKind::integer},
                {"face_b", FieldKind::integer},
                {"from_start", FieldKind::integer},
                {"to_end", FieldKind::integer},
                {"path", FieldKind::integer},
                {"tag", FieldKind::integer}}},
        Layout{"ContourCorner", {{"vertex", FieldKind::integer}, {"normal", FieldKind::number, 3}}},
        Layout{"ContourCrossing",
               {{"p", FieldKind::integer},
                {"q", FieldKind::integer},
                {"before", FieldKind::integer},
                {"after", FieldKind::integer},
                {"underside", FieldKind::integer}}},
        Layout{"ChainWay",
               {{"next", FieldKind::integer},
                {"hops", FieldKind::integer},
                {"least", FieldKind::integer},
                {"at", FieldKind::integer}}},
        Layout{"ChainPlace",
               {{"leader", FieldKind::integer},
                {"before", FieldKind::integer},
                {"after", FieldKind::integer},
                {"flags", FieldKind::integer}}},
        Layout{"Entry",
               {{"face", FieldKind::integer},
                {"nearness", FieldKind::number},
                {"key", FieldKind::integer}}},
        Layout{"ScreenFace",
               {{"low", FieldKind::number, 2, 1e-5F, pixel},
                {"high", FieldKind::number, 2, 1e-5F, pixel},
                {"nearest", FieldKind::number},
                {"kind", FieldKind::integer}}},
        Layout{"Batch",
               {{"low", FieldKind::number, 3},
                {"high", FieldKind::number, 3},
                {"joined", FieldKind::integer, 2},
                {"widest", FieldKind::number}}}};
    const auto found = std::ranges::find(layouts, type, &Layout::name);
    if (found == layouts.end())
        throw Error("no layout says how two tables of " + std::string{type} + " are compared");
    return *found;
}

std::optional<Difference> first_difference(const Layout& layout, std::span<const std::byte> first,
                                           std::span<const std::byte> second) {
    if (std::ranges::equal(first, second)) return std::nullopt;
    const std::size_t size = layout.size();
    for (std::size_t i = 0; (i + 1) * size <= first.size(); ++i) {
        auto found = difference_in(layout, first.data() + i * size, second.data() + i * size);
        if (!found) continue;
        found->element = i;
        return found;
    }
    return std::nullopt;
}

} // namespace lineatlas::compute
