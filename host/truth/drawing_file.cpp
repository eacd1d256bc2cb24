#include "drawing_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "core/pair_key.hpp"
#include "core/picture_size.hpp"
#include "flatten.hpp"
#include "io/extension.hpp"
#include "io/source_file.hpp"
#include "svg_path.hpp"
#include "vector/outline.hpp"
#include "vector/sheet.hpp"

namespace lineatlas {
namespace {

constexpr const char* not_ours = "it is no drawing of lineatlas; check what `lineatlas draw` wrote";

/// Pixels; lines end near the picture.
constexpr double farthest = 1e6;

bool is_near(glm::dvec2 at) {
    return std::abs(at.x) <= farthest && std::abs(at.y) <= farthest;
}

bool is_picture(glm::dvec2 size) {
    return std::min(size.x, size.y) >= 1 && std::max(size.x, size.y) <= longest_picture_side;
}

/// Text of a drawing as one line, for messages.
std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return text;
}

/// The size in "..., seen at 1024x768 pixels", which to_svg() writes; 0 without it.
glm::ivec2 size_in(std::string_view description) {
    constexpr std::string_view before = "seen at ";
    glm::ivec2 size{0};
    const std::size_t at = description.rfind(before);
    if (at == description.npos) return size;
    const char* const end = description.data() + description.size();
    const auto width = std::from_chars(description.data() + at + before.size(), end, size.x);
    if (width.ptr != end && *width.ptr == 'x') std::from_chars(width.ptr + 1, end, size.y);
    return size;
}

/// Throws FileError for a drawing with lines far outside of any picture.
void check_places(const DrawingFile& drawing, const std::filesystem::path& path) {
    const auto known = [](const auto& line) { return is_near(line.from) && is_near(line.to); };
    if (!std::ranges::all_of(drawing.legs, known) || !std::ranges::all_of(drawing.tags, known))
        throw read_error(path, "its lines are far outside its picture");
}

Sheet sheet_of(const DrawingFile& drawing, const std::filesystem::path& path) try {
    SvgOptions options;
    const auto page = described(drawing.description, "--page");
    if (page) {
        options.page = parse_page(*page);
        options.units = Unit::mm;
    }
    if (const auto units = described(drawing.description, "--units"))
        options.units = parse_unit(*units);
    if (const auto margin = described(drawing.description, "--margin"))
        options.margin = parse_length(*margin, options.units);
    return lay_out(drawing.size, options);
} catch (const UsageError& error) {
    throw read_error(path, std::string{"of its page: "} + error.what());
}

/// The kind of line that rays do not check.
constexpr std::string_view centre = line_kind_names[LA_KIND_CENTRE];

/// Whether a group of paths has visible lines, by its class.
bool has_visible_lines(std::string_view group) {
    return group != fill_layer && !group.ends_with("hidden") && !group.starts_with(centre);
}

DrawingFile of_svg(const SourceFile& file) {
    pugi::xml_document document;
    if (!document.load_buffer(file.bytes.data(), file.bytes.size()))
        throw read_error(file.path, "it is no XML, or damaged");
    const pugi::xml_node svg = document.child("svg");
    DrawingFile drawing{.description = one_line(svg.child_value("desc"))};
    drawing.size = size_in(drawing.description);
    if (described(drawing.description, "--views"))
        throw read_error(file.path, "it is a sheet of several views; check takes a drawing of one");
    if (!svg || !is_picture(drawing.size)) throw read_error(file.path, not_ours);
    const Sheet sheet = sheet_of(drawing, file.path);
    for (const pugi::xml_node group : svg.children("g")) {
        if (!has_visible_lines(group.attribute("class").value())) continue;
        for (const pugi::xml_node path : group.children("path")) {
            const auto lines = parse_path(path.attribute("d").value());
            if (!lines) throw read_error(file.path, not_ours);
            for (const auto& [from, to] : *lines)
                drawing.legs.push_back(
                    {(from - sheet.corner) / sheet.scale, (to - sheet.corner) / sheet.scale});
            drawing.path_ends.push_back(drawing.legs.size());
        }
    }
    check_places(drawing, file.path);
    return drawing;
}

glm::dvec2 point(const nlohmann::json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>()};
}

/// A whole number from 0 on. The JSON library would convert other values.
std::uint32_t index(const nlohmann::json& json) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > LineSource::none)
        throw std::out_of_range{"index"};
    return json.get<std::uint32_t>();
}

/// A curve in the form that to_json() writes.
VectorCurve curve_of(const nlohmann::json& json) {
    VectorCurve curve{.first = index(json.at("points").at(0)),
                      .last = index(json.at("points").at(1))};
    if (json.contains("controls")) {
        const nlohmann::json& controls = json.at("controls");
        curve.cubic = VectorCubic{point(controls.at(0)), point(controls.at(1))};
        return curve;
    }
    curve.arc = {.center = point(json.at("center")),
                 .major = point(json.at("major")),
                 .ratio = json.at("ratio").get<double>(),
                 .from = json.at("from").get<double>(),
                 .sweep = json.at("sweep").get<double>()};
    return curve;
}

void add_path(const nlohmann::json& path, DrawingFile& drawing) {
    if (!path.at("visible").get<bool>() || path.value("kind", "") == centre) return;
    std::vector<glm::dvec2> points;
    for (const nlohmann::json& one : path.at("points")) points.push_back(point(one));
    std::vector<VectorCurve> curves;
    if (path.contains("curves"))
        for (const nlohmann::json& one : path.at("curves")) curves.push_back(curve_of(one));
    append_legs(flattened(points, curves), drawing.legs);
    drawing.path_ends.push_back(drawing.legs.size());
    if (!path.contains("pieces")) return;
    for (const nlohmann::json& piece : path.at("pieces")) {
        const std::size_t at = index(piece.at("point"));
        const glm::dvec2 a = points.at(at);
        const glm::dvec2 b = points.at((at + 1) % points.size());
        const glm::dvec2 part = piece.contains("part") ? point(piece.at("part")) : glm::dvec2{0, 1};
        drawing.tags.push_back({glm::mix(a, b, part.x), glm::mix(a, b, part.y),
                                index(piece.value("from", nlohmann::json(LineSource::none))),
                                index(piece.value("to", nlohmann::json(LineSource::none)))});
    }
}

DrawingFile of_json(const SourceFile& file) {
    try {
        const nlohmann::json json = nlohmann::json::parse(file.bytes);
        if (json.value("format", "") != "lineatlas-drawing") throw read_error(file.path, not_ours);
        const glm::dvec2 size = point(json.at("size"));
        if (!is_picture(size)) throw read_error(file.path, not_ours);
        DrawingFile drawing{.size = glm::ivec2{size},
                            .description = one_line(json.value("description", ""))};
        for (const nlohmann::json& path : json.at("paths")) add_path(path, drawing);
        check_places(drawing, file.path);
        return drawing;
    } catch (const nlohmann::json::exception&) {
        throw read_error(file.path, "it is no JSON of a drawing, or damaged");
    } catch (const std::out_of_range&) {
        throw read_error(file.path, "a piece names a point that is not there");
    }
}

} // namespace

DrawingFile read_drawing(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".svg") return of_svg(read_source(path));
    if (extension == ".json") return of_json(read_source(path));
    throw read_error(path, "a drawing to check ends in .svg or .json");
}

std::vector<std::string> all_described(std::string_view description, std::string_view option) {
    std::vector<std::string> values;
    for (const char sign : {' ', '='}) {
        std::string name{" "};
        name += option;
        name += sign;
        for (std::size_t at = description.find(name); at != std::string_view::npos;
             at = description.find(name, at + name.size())) {
            std::string_view value = description.substr(at + name.size());
            const bool in_quotes = value.starts_with('\'');
            if (in_quotes) value.remove_prefix(1);
            values.emplace_back(value.substr(0, value.find_first_of(in_quotes ? "'" : " ;")));
        }
    }
    return values;
}

std::optional<std::string> described(std::string_view description, std::string_view option) {
    std::vector<std::string> values = all_described(description, option);
    if (values.empty()) return std::nullopt;
    return std::move(values.front());
}

DrawnLines find_segments(const DrawingFile& drawing, const LineSet& lines) {
    std::unordered_map<std::uint64_t, std::uint32_t> segments;
    for (std::uint32_t i = 0; i < lines.sources.size(); ++i) {
        const auto [known, is_new] =
            segments.emplace(pair_key(lines.sources[i].from, lines.sources[i].to), i);
        // Several segments have these positions: parts of one edge, or intersections, which have no
        // edge.
        if (!is_new) known->second = DrawnPiece::unknown;
    }
    DrawnLines drawn{.legs = drawing.legs, .pieces = {}, .path_ends = drawing.path_ends};
    for (const TaggedPiece& tag : drawing.tags) {
        const auto found = segments.find(pair_key(tag.p, tag.q));
        drawn.pieces.push_back(
            {tag.from, tag.to, found != segments.end() ? found->second : DrawnPiece::unknown});
    }
    return drawn;
}

} // namespace lineatlas
