#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "check_drawing.hpp"
#include "lineatlas/vector.hpp"
#include "svg_groups.hpp"

namespace lineatlas {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;

double rounded(double value, double steps) {
    return std::round(value * steps) / steps;
}
double pixels(double value) {
    return rounded(value, 1000);
}
double depth(double value) {
    return rounded(value, 1e7);
}
/// Sines and roots differ in their last digits from one system to the next.
double of_curve(double value) {
    return rounded(value, 1e9);
}

/// Names from files may be in any encoding.
std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// As few digits as a float needs.
double short_float(double value) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, static_cast<float>(value));
    return number_from({text, end}).value_or(0);
}

Json piece_json(const VectorPiece& piece) {
    Json json{{"point", piece.point}};
    if (piece.source.from != LineSource::none) {
        json["from"] = piece.source.from;
        json["to"] = piece.source.to;
    }
    if (piece.from > 0 || piece.to < 1) {
        json["part"] = {rounded(double{piece.from}, 1000), rounded(double{piece.to}, 1000)};
    }
    if (piece.source.triangle != LineSource::none) json["triangle"] = piece.source.triangle;
    if (piece.over_start != glm::vec3{0}) {
        const auto shares = [](glm::vec3 over) {
            Json json = Json::array();
            for (int k = 0; k < 3; ++k) json.push_back(rounded(double{over[k]}, 1000));
            return json;
        };
        json["over"] = {shares(piece.over_start), shares(piece.over_end)};
    }
    if (piece.source.crossing != LineSource::none) json["crossing"] = piece.source.crossing;
    if (piece.group != VectorPiece::none) json["group"] = piece.group;
    if (piece.edge != VectorPiece::none) json["edge"] = piece.edge;
    if (piece.face != VectorPiece::none) json["face"] = piece.face;
    if (piece.entity != 0) json["entity"] = piece.entity;
    return json;
}

/// With all digits: it is exact.
Json curve_json(const VectorCurve& curve) {
    Json json{{"points", {curve.first, curve.last}}};
    if (curve.edge != VectorCurve::none) json["edge"] = curve.edge;
    if (curve.cubic) {
        const auto& [from, to] = *curve.cubic;
        json["controls"] = {{of_curve(from.x), of_curve(from.y)}, {of_curve(to.x), of_curve(to.y)}};
        return json;
    }
    const VectorArc& arc = curve.arc;
    json["center"] = {of_curve(arc.center.x), of_curve(arc.center.y)};
    json["major"] = {of_curve(arc.major.x), of_curve(arc.major.y)};
    json["ratio"] = of_curve(arc.ratio);
    json["from"] = of_curve(arc.from);
    json["sweep"] = of_curve(arc.sweep);
    return json;
}

Json path_json(const VectorPath& path, const VectorDrawing& drawing, const JsonOptions& options) {
    Json json{{"kind", line_kind_names[static_cast<std::size_t>(path.kind)]},
              {"visible", path.visible},
              {"closed", path.closed},
              {"outline", path.outline},
              {"alpha", rounded(static_cast<double>(path.alpha), 1000)}};
    if (path.thinned) json["thinned"] = true;
    if ((path.visible ? drawing.pens : drawing.hidden_pens).size() > 1) json["pen"] = path.pen;
    Json points = Json::array();
    Json depths = Json::array();
    Json world = Json::array();
    Json arcs = Json::array();
    for (const VectorPoint& point : path.points) {
        points.push_back({pixels(point.at.x), pixels(point.at.y)});
        depths.push_back(depth(point.depth));
        const glm::dvec3 at =
            options.origin + glm::dvec3{short_float(point.world.x), short_float(point.world.y),
                                        short_float(point.world.z)};
        world.push_back({at.x, at.y, at.z});
        arcs.push_back(pixels(point.arc));
    }
    json["points"] = std::move(points);
    json["depth"] = std::move(depths);
    json["world"] = std::move(world);
    json["arc"] = std::move(arcs);
    if (!path.curves.empty()) {
        json["curves"] = Json::array();
        for (const VectorCurve& curve : path.curves) json["curves"].push_back(curve_json(curve));
    }
    if (!options.tags) return json;
    json["pieces"] = Json::array();
    for (const VectorPiece& piece : path.pieces) json["pieces"].push_back(piece_json(piece));
    return json;
}

Json fill_json(const VectorFill& fill) {
    constexpr double steps = 10000;
    Json rings = Json::array();
    for (const std::vector<glm::dvec2>& ring : fill.rings) {
        Json points = Json::array();
        for (const glm::dvec2 point : ring)
            points.push_back({rounded(point.x, steps), rounded(point.y, steps)});
        rings.push_back(std::move(points));
    }
    return {{"object", fill.object}, {"color", color_text(fill.color)}, {"rings", rings}};
}

/// A member whose value is a list, an element on a line each.
template <class Element, class Made>
std::string list_text(const char* key, const std::vector<Element>& elements, const Made& made) {
    std::string text = ",\n\"";
    text.append(key).append("\":[");
    const char* before = "\n";
    for (const Element& element : elements) {
        text += before + text_of(made(element));
        before = ",\n";
    }
    return text + "\n]";
}

/// The pens, which paths name by number if there are several.
Json pens_json(const std::vector<Pen>& pens) {
    Json json = Json::array();
    for (const Pen& pen : pens) {
        json.push_back({{"mark", pen.mark},
                        {"width", pixels(static_cast<double>(pen.width))},
                        {"color", color_text(pen.color)},
                        {"opacity", rounded(static_cast<double>(pen.opacity), 1000)}});
    }
    return json;
}

Json head_json(const VectorDrawing& drawing, const JsonOptions& options) {
    Json json{{"format", "lineatlas-drawing"},
              {"version", version},
              {"units", "pixels"},
              {"size", {drawing.size.x, drawing.size.y}}};
    if (!options.description.empty()) json["description"] = options.description;
    if (!options.certificate.empty()) json["certificate"] = options.certificate;
    if (drawing.travel) {
        json["pen_travel"] = {{"before", pixels(drawing.travel->before)},
                              {"after", pixels(drawing.travel->after)}};
    }
    if (drawing.pens.size() > 1) json["pens"] = pens_json(drawing.pens);
    if (drawing.hidden_pens.size() > 1) json["hidden_pens"] = pens_json(drawing.hidden_pens);
    if (!options.tags) return json;
    json["groups"] = Json::array();
    for (const MeshGroup& group : drawing.groups) {
        json["groups"].push_back({{"object", group.object}, {"material", group.material}});
    }
    return json;
}

} // namespace

std::string to_json(const VectorDrawing& drawing, const JsonOptions& options) {
    check_drawing(drawing);
    std::string text = text_of(head_json(drawing, options));
    text.pop_back(); // the brace that closes it
    if (!drawing.fills.empty()) text += list_text("fills", drawing.fills, fill_json);
    text += list_text("paths", drawing.paths,
                      [&](const VectorPath& path) { return path_json(path, drawing, options); });
    return text + "}\n";
}

} // namespace lineatlas
