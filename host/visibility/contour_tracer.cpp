#include "contour_tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/vertex_sets.hpp"
#include "surface/round_surface.hpp"
#include "surface/surface_point.hpp"

namespace lineatlas {
namespace {

/// A surface whose cosine to the view is below this is seen edge on and counts as turned away.
constexpr double edge_on = 1e-7;
/// If the cosine of a corner's normal is below this, the surface itself is asked.
constexpr double doubtful = 1e-5;
constexpr double most_off = 0.01;      ///< the most that a chord lies off the silhouette, pixels on
                                       ///< the screen
constexpr double most_off_deep = 0.25; ///< the same towards the eye, in lengths of a pixel
constexpr double longest_unasked = 2;  ///< pixels; a longer chord is halved unless it is straight
constexpr double straight = 1e-5;      ///< a chord this near, in pixels, is straight
constexpr double shortest = 1e-3;      ///< pixels
constexpr double least_ratio = 1e-7;   ///< least ratio of a place's motion by one parameter to that
                                       ///< by the other
constexpr std::uint32_t none = 0xFFFFFFFF;

/// A place on a silhouette.
struct Place {
    glm::dvec2 at{0};    ///< parameters of its surface
    glm::dvec3 world{0}; ///< the place in space
    glm::dvec3 normal{0};
    double radial = 0; ///< the sign of radial curvature: below 0 the surface shows its back
};

/// Where a silhouette crosses an edge of triangles, or ends at a tip.
struct Node {
    Place place;
    double lift = 0;
    double share = 0; ///< share of the way along the edge
    std::uint32_t vertex = none;
};

/// A surface as one view sees it, in the shape's own coordinates.
class SeenSurface {
  public:
    SeenSurface(const SurfaceShape& shape, const PlacedSurface& placed, const glm::dvec4& eye)
        : shape_(shape), placed_(placed), sign_(placed.turned ? -1 : 1) {
        const glm::dmat4 world{placed.model_from_shape};
        eye_ = glm::inverse(world) * eye;
        normal_turn_ = glm::transpose(glm::inverse(glm::dmat3{world}));
        if (shape.kind == SurfaceShape::Kind::revolution && eye_.w == 0) look_level_or_along();
    }

    /// Cosine between the normal and the way to the eye.
    double facing(glm::dvec2 at) const {
        const SurfacePoint point = evaluate(shape_, at);
        const glm::dvec3 to_eye = way_to_eye(point.at);
        const double distance = glm::length(to_eye);
        return distance > 0 ? sign_ * glm::dot(point.normal, to_eye) / distance : 0;
    }

    Place place(glm::dvec2 at) const {
        const SurfacePoint point = evaluate(shape_, at);
        const glm::dvec3 normal = normal_turn_ * (sign_ * point.normal);
        const double length = glm::length(normal);
        return {.at = at,
                .world = placed_.model_from_shape * glm::dvec4{point.at, 1},
                .normal = length > 0 ? normal / length : normal,
                .radial = radial(point)};
    }

    /// The nearest place of the silhouette, by Newton's method along the gradient, in steps that
    /// are shortest in space. Nothing if it leads farther than `reach`, in parameters.
    std::optional<glm::dvec2> nearest(glm::dvec2 at, double reach) const {
        const glm::dvec2 start = at;
        for (int i = 0; i < 12; ++i) {
            const SurfacePoint point = evaluate(shape_, at);
            const glm::dvec3 to_eye = way_to_eye(point.at);
            const double value = glm::dot(point.normal, to_eye);
            if (point.normal == glm::dvec3{0}) return {};
            if (std::abs(value) <= 1e-12 * glm::length(to_eye)) return at;
            // The motion of the point itself adds nothing, because it is at right angles to the
            // normal.
            const glm::dvec2 slope{glm::dot(point.normal_u, to_eye),
                                   glm::dot(point.normal_v, to_eye)};
            const glm::dvec2 step = along(point, slope);
            const double gain = glm::dot(step, slope);
            if (!(gain > 0)) return {};
            at -= step * (value / gain);
            if (!(glm::distance(at, start) < reach)) return {};
        }
        return std::abs(facing(at)) < 1e-9 ? std::optional{at} : std::nullopt;
    }

    /// In a level view the silhouette of a revolution is meridians and parallels. Where one ends on
    /// the other, between a place of each.
    std::optional<glm::dvec2> crossing_between(glm::dvec2 a, glm::dvec2 b) const {
        if (!is_level_) return {};
        const bool a_on_meridian = is_on_meridian(a), b_on_meridian = is_on_meridian(b);
        if (a_on_meridian == b_on_meridian) return {};
        const glm::dvec2 at = a_on_meridian ? glm::dvec2{a.x, b.y} : glm::dvec2{b.x, a.y};
        return at == a || at == b ? std::nullopt : std::optional{at};
    }

    /// The parameters of a tip, for a way that comes from `other`.
    glm::dvec2 tip_towards(glm::dvec2 tip, glm::dvec2 other) const {
        const SurfacePoint point = evaluate(shape_, tip);
        return glm::dot(point.u, point.u) <= glm::dot(point.v, point.v)
                   ? glm::dvec2{other.x, tip.y}
                   : glm::dvec2{tip.x, other.y};
    }

    /// The parameters of a place, where it is a pole as tip_towards().
    glm::dvec2 pole_towards(glm::dvec2 at, glm::dvec2 other) const {
        return is_pole(evaluate(shape_, at)) ? tip_towards(at, other) : at;
    }

  private:
    /// A view of a revolution at right angles to its axis or along it is meant to be just that. As
    /// rounded, its silhouette would change from meridians to parallels beside their crossings.
    void look_level_or_along() {
        const glm::dvec3 way = glm::dvec3{eye_} / glm::length(glm::dvec3{eye_});
        const double along = glm::dot(way, shape_.axis);
        is_level_ = std::abs(along) < rounding_of_views;
        if (is_level_)
            eye_ = glm::dvec4{way - along * shape_.axis, 0};
        else if (glm::length(glm::cross(way, shape_.axis)) < rounding_of_views)
            eye_ = glm::dvec4{std::copysign(1, along) * shape_.axis, 0};
    }

    /// Whether the way from the axis to a place is at right angles to the view.
    bool is_on_meridian(glm::dvec2 at) const {
        const glm::dvec3 out = way_from_axis(shape_, evaluate(shape_, at).at);
        return std::abs(glm::dot(out, glm::dvec3{eye_})) < rounding_of_views * glm::length(out);
    }

    glm::dvec3 way_to_eye(const glm::dvec3& at) const { return glm::dvec3{eye_} - at * eye_.w; }

    /// The change of parameters for given products with both derivatives, by the first fundamental
    /// form.
    static glm::dvec2 along(const SurfacePoint& point, glm::dvec2 change) {
        const double uu = glm::dot(point.u, point.u), uv = glm::dot(point.u, point.v),
                     vv = glm::dot(point.v, point.v);
        const double area = uu * vv - uv * uv;
        if (!(area > 0)) return glm::dvec2{0};
        return glm::dvec2{vv * change.x - uv * change.y, uu * change.y - uv * change.x} / area;
    }

    /// Whether one parameter moves the place by next to nothing: all its values mean one place.
    static bool is_pole(const SurfacePoint& point) {
        const double u = glm::length(point.u), v = glm::length(point.v);
        return std::min(u, v) < least_ratio * std::max(u, v);
    }

    /// How the front turns to the eye along the way to it (Koenderink 1984); 0 so near a pole that
    /// parameters do not tell.
    double radial(const SurfacePoint& point) const {
        if (is_pole(point)) return 0;
        const glm::dvec3 to_eye = way_to_eye(point.at);
        const glm::dvec2 way = along(point, {glm::dot(point.u, to_eye), glm::dot(point.v, to_eye)});
        return sign_ * (way.x * glm::dot(point.normal_u, to_eye) +
                        way.y * glm::dot(point.normal_v, to_eye));
    }

    const SurfaceShape& shape_;
    const PlacedSurface& placed_;
    double sign_;
    bool is_level_ = false; ///< a revolution, seen at right angles to its axis
    glm::dvec4 eye_{0};
    glm::dmat3 normal_turn_{1.0};
};

/// The place from 0 to 1 where a function changes its sign. at_a and at_b are its values at 0 and
/// 1; one of them is below 0. Uses false position, and weighs the end that stays down (the Illinois
/// method: Dowell and Jarratt 1971).
template <class Function>
double root_between(double at_a, double at_b, const Function& function) {
    double a = 0, b = 1;
    int side = 0;
    for (int i = 0; i < 60 && std::abs(b - a) > 1e-15; ++i) {
        double t = (a * at_b - b * at_a) / (at_b - at_a);
        if (!(t > std::min(a, b) && t < std::max(a, b))) t = 0.5 * (a + b);
        const double value = function(t);
        if (std::abs(value) < 1e-13) return t;
        if ((value > 0) == (at_b > 0)) {
            b = t;
            at_b = value;
            if (side == -1) at_a *= 0.5;
            side = -1;
        } else {
            a = t;
            at_a = value;
            if (side == 1) at_b *= 0.5;
            side = 1;
        }
    }
    return 0.5 * (a + b);
}

} // namespace

/// The silhouettes of one view, as they are found.
class ContourTracer::Frame {
  public:
    Frame(const ContourTracer& tracer, const Camera& camera, bool outside)
        : tracer_(tracer), eye_(camera.eye()),
          clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size_(camera.size), outside_(outside), facing_(tracer.corners_.size(), unknown),
          node_of_edge_(tracer.edge_count_, none) {
        surfaces_.reserve(tracer.surfaces_.surfaces.size());
        for (const PlacedSurface& surface : tracer.surfaces_.surfaces)
            surfaces_.emplace_back(tracer.surfaces_.shapes[surface.shape], surface, eye_);
    }

    compute::TracedSilhouettes trace() {
        for (std::uint32_t i = 0; i < tracer_.faces_.size(); ++i)
            if (tracer_.traces(i)) cross(i);
        write();
        traced_.instead_of = tracer_.traced_;
        return std::move(traced_);
    }

  private:
    static constexpr double unknown = 4; ///< stands for a cosine that is not known

    /// The silhouette through a triangle, from node to node, and places between.
    struct Crossing {
        std::uint32_t face = 0;
        std::uint32_t from = none, to = none; ///< nodes, in the direction that contour.cl gives
        glm::dvec2 from_at{0}, to_at{0};      ///< in the face's own parameters
        double lift = 0;
    };

    const SeenSurface& surface_of(std::uint32_t face) const {
        return surfaces_[tracer_.surfaces_.of_triangle[face]];
    }
    glm::dvec2 parameters(std::uint32_t face, std::uint32_t corner) const {
        return tracer_.surfaces_.parameters[face][corner];
    }
    bool is_tip(std::uint32_t corner) const {
        return tracer_.corners_[corner].normal == glm::dvec3{0};
    }

    /// How much a corner faces the eye: not below 0 if it shows its front.
    double facing(std::uint32_t corner) {
        double& value = facing_[corner];
        if (value != unknown) return value;
        const Corner& one = tracer_.corners_[corner];
        const glm::dvec3 to_eye = glm::dvec3{eye_} - one.at * eye_.w;
        value = glm::dot(one.normal, to_eye) / std::max(glm::length(to_eye), 1e-300);
        if (std::abs(value) < doubtful) {
            const std::uint32_t face = one.place / 3;
            const glm::dvec2 at = parameters(face, one.place % 3);
            const double own = surface_of(face).facing(at);
            if (own != 0) value = own; // 0 at a pole, which has no normal of its own
        }
        value -= edge_on;
        return value;
    }

    void cross(std::uint32_t i) {
        const Face& face = tracer_.faces_[i];
        std::array<double, 3> eye{};
        std::uint32_t tip = 3;
        for (std::uint32_t k = 3; k-- > 0;)
            if (is_tip(face.corners[static_cast<int>(k)])) tip = k;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (k != tip) eye[k] = facing(face.corners[static_cast<int>(k)]);
        if (tip < 3)
            eye[tip] = eye[(tip + 1) % 3]; // a silhouette across the opposite side runs
                                           // into the tip
        const int fronts = (eye[0] >= 0) + (eye[1] >= 0) + (eye[2] >= 0);
        if (fronts == 0 || fronts == 3) return;
        Crossing crossing{.face = i, .lift = lift_of(face)};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t next = (k + 1) % 3;
            const bool falls = eye[k] >= 0;
            if (falls == (eye[next] >= 0)) continue;
            if (k == tip || next == tip) continue;
            glm::dvec2 at{0};
            (falls ? crossing.from : crossing.to) =
                edge_node(i, k, {eye[k], eye[next]}, crossing.lift, at);
            (falls ? crossing.from_at : crossing.to_at) = at;
        }
        if (tip < 3) end_at_tip(i, tip, crossing);
        crossings_.push_back(crossing);
    }

    /// The lift of the kernel `contour_places`.
    double lift_of(const Face& face) const {
        double most = 0;
        for (int k = 0; k < 3; ++k) {
            const Corner& a = tracer_.corners_[face.corners[k]];
            const Corner& b = tracer_.corners_[face.corners[(k + 1) % 3]];
            const glm::dvec3 way = b.at - a.at;
            most = std::max(
                {most, std::abs(glm::dot(way, a.normal)), std::abs(glm::dot(way, b.normal))});
        }
        return LA_CONTOUR_LIFT * most;
    }

    /// Ends a silhouette at a tip. At the tip one parameter may have any value, so it gets the
    /// value at the other end.
    void end_at_tip(std::uint32_t face, std::uint32_t tip, Crossing& crossing) {
        const bool ends = crossing.to == none;
        const glm::dvec2 other = ends ? crossing.from_at : crossing.to_at;
        glm::dvec2 at = surface_of(face).tip_towards(parameters(face, tip), other);
        Node node;
        node.place = surface_of(face).place(at + (other - at) * 1e-3);
        node.place.world = tracer_.corners_[tracer_.faces_[face].corners[static_cast<int>(tip)]].at;
        node.lift = crossing.lift;
        nodes_.push_back(node);
        (ends ? crossing.to : crossing.from) = static_cast<std::uint32_t>(nodes_.size() - 1);
        (ends ? crossing.to_at : crossing.from_at) = at;
    }

    std::uint32_t edge_node(std::uint32_t face, std::uint32_t k, std::array<double, 2> eye,
                            double lift, glm::dvec2& at) {
        const std::uint32_t edge = tracer_.faces_[face].edges[static_cast<int>(k)];
        const bool turned = (edge & LA_CONTOUR_TURNED) != 0;
        // Both faces look along it in one direction, and find the same place bit by bit.
        const SeenSurface& surface = surface_of(face);
        const glm::dvec2 first = parameters(face, k), second = parameters(face, (k + 1) % 3);
        // From a pole the edge goes along its other end's meridian, whichever the pole's own is.
        glm::dvec2 a = surface.pole_towards(first, second), b = surface.pole_towards(second, first);
        if (turned) {
            std::swap(a, b);
            std::swap(eye[0], eye[1]);
        }
        std::uint32_t& known = node_of_edge_[edge & ~LA_CONTOUR_TURNED];
        if (known == none) {
            Node node;
            node.share = root_between(eye[0], eye[1],
                                      [&](double t) { return surface.facing(a + (b - a) * t); });
            node.place = surface.place(a + (b - a) * node.share);
            stay_beside_edge(tracer_.faces_[face], k, turned ? 1 - node.share : node.share,
                             node.place);
            meet_corner(tracer_.faces_[face], k, node.place);
            known = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back(node);
        }
        Node& node = nodes_[known];
        node.lift = std::max(node.lift, lift);
        at = a + (b - a) * node.share;
        return known;
    }

    /// Puts the place on the edge if the surface is far from its triangle. Such a surface is not
    /// believed.
    void stay_beside_edge(const Face& face, std::uint32_t k, double share, Place& place) const {
        const Corner& p = tracer_.corners_[face.corners[static_cast<int>(k)]];
        const Corner& q = tracer_.corners_[face.corners[static_cast<int>((k + 1) % 3)]];
        if (is_between(p.at, q.at, place.world)) return;
        place.world = p.at + share * (q.at - p.at);
        place.normal = p.normal;
    }

    /// Whether a place may lie on an arc from p to q.
    static bool is_between(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& place) {
        return glm::distance(place, 0.5 * (p + q)) <= glm::distance(p, q);
    }

    /// Moves a place beside a corner to the corner. So all silhouettes across edges beside the
    /// corner meet there, bit by bit.
    void meet_corner(const Face& face, std::uint32_t k, Place& place) const {
        const glm::dvec2 here = on_screen(place.world);
        for (const std::uint32_t corner : {k, (k + 1) % 3}) {
            const Corner& one = tracer_.corners_[face.corners[static_cast<int>(corner)]];
            if (glm::distance(on_screen(one.at), here) < shortest) place.world = one.at;
        }
    }

    glm::dvec2 on_screen(const glm::dvec3& world) const {
        const glm::dvec4 clip = clip_from_world_ * glm::dvec4{world, 1};
        return 0.5 * size_ * (glm::dvec2{clip} / clip.w);
    }

    /// Whether the chord between two places is as good as the silhouette, judged by a place
    /// between.
    bool is_straight(const Place& a, const Place& b, const Place& between, double most) const {
        const glm::dvec2 p = on_screen(a.world), q = on_screen(b.world);
        const glm::dvec2 way = q - p, to = on_screen(between.world) - p;
        const double length = glm::length(way);
        const double off =
            length > 0 ? std::abs(way.x * to.y - way.y * to.x) / length : glm::length(to);
        if (!(off < most)) return false;
        const double share = length > 0 ? glm::dot(to, way) / (length * length) : 0.5;
        if (!(share > 0.2 && share < 0.8)) return false; // a place beside an end says nothing
        const glm::dvec3 in_space = b.world - a.world, beside = between.world - a.world;
        const double squared = glm::dot(in_space, in_space);
        if (!(squared > 0) || !(length > 0)) return true;
        const glm::dvec3 foot = in_space * (glm::dot(beside, in_space) / squared);
        return glm::distance(beside, foot) * length < most_off_deep * std::sqrt(squared);
    }

    /// Adds the places between two places of a surface, without the two.
    void refine(const SeenSurface& surface, const Place& a, const Place& b, int depth,
                std::vector<Place>& places) {
        constexpr int deepest = 8; // 256 chords in a triangle
        const double length = glm::distance(on_screen(a.world), on_screen(b.world));
        if (depth == deepest || !(length > shortest)) return;
        const std::optional<glm::dvec2> crossing = surface.crossing_between(a.at, b.at);
        const double reach = 2 * glm::distance(a.at, b.at) + 1e-9;
        const std::optional<glm::dvec2> at =
            crossing ? crossing : surface.nearest(0.5 * (a.at + b.at), reach);
        if (!at) return; // the surface cannot be followed, so the chord stays
        const Place middle = surface.place(*at);
        if (!is_between(a.world, b.world, middle.world)) return;
        // One place says little of a chord that bends both ways.
        const bool doubted = depth == 0 && length > longest_unasked;
        if (is_straight(a, b, middle, doubted ? straight : most_off) && !crossing) return;
        refine(surface, a, middle, depth + 1, places);
        places.push_back(middle);
        refine(surface, middle, b, depth + 1, places);
    }

    /// The cusp between two places, where radial curvature changes its sign. Beyond it the surface
    /// hides its own silhouette.
    Place cusp_between(const SeenSurface& surface, Place a, Place b) const {
        for (int i = 0; i < 40 && glm::distance(on_screen(a.world), on_screen(b.world)) > 1e-5;
             ++i) {
            const double reach = 2 * glm::distance(a.at, b.at) + 1e-9;
            const std::optional<glm::dvec2> at = surface.nearest(0.5 * (a.at + b.at), reach);
            if (!at) break;
            const Place middle = surface.place(*at);
            if (!is_between(a.world, b.world, middle.world)) break;
            ((middle.radial < 0) == (a.radial < 0) ? a : b) = middle;
        }
        return b;
    }

    std::uint32_t add_vertex(const Place& place, double lift) {
        traced_.vertices.emplace_back(place.world);
        traced_.vertices.emplace_back(place.world + place.normal * lift);
        return static_cast<std::uint32_t>(traced_.vertices.size() - 2);
    }

    std::uint32_t vertex_of(std::uint32_t number) {
        Node& node = nodes_[number];
        if (node.vertex == none) node.vertex = add_vertex(node.place, node.lift);
        return node.vertex;
    }

    void add_segment(const Crossing& crossing, std::uint32_t p, std::uint32_t q, double radial) {
        Segment segment = tracer_.faces_[crossing.face].segment;
        segment.p = p;
        segment.q = q;
        segment.face_b = LA_NO_FACE;
        segment.tag |= LA_TAG_CONTOUR;
        if (radial < 0)
            segment.tag |=
                outside_ && (segment.tag & LA_TAG_SOLID) != 0 ? LA_TAG_BURIED : LA_TAG_UNDERSIDE;
        traced_.segments.push_back(segment);
        traced_.faces.push_back(crossing.face);
    }

    void add_crossing(const Crossing& crossing) {
        const SeenSurface& surface = surface_of(crossing.face);
        // An end may have been found by another face. This face sees it in its own parameters.
        std::vector<Place> places{surface.place(crossing.from_at)}, between;
        Place end = surface.place(crossing.to_at);
        places.front().world = nodes_[crossing.from].place.world;
        end.world = nodes_[crossing.to].place.world;
        refine(surface, places.front(), end, 0, between);
        places.insert(places.end(), between.begin(), between.end());
        places.push_back(end);
        std::uint32_t p = vertex_of(crossing.from);
        for (std::size_t i = 1; i < places.size(); ++i) {
            const Place& a = places[i - 1];
            const Place& b = places[i];
            const bool turns = (a.radial < 0) != (b.radial < 0) && a.radial != 0 && b.radial != 0;
            if (turns) {
                const std::uint32_t cusp = add_vertex(cusp_between(surface, a, b), crossing.lift);
                add_segment(crossing, p, cusp, a.radial);
                p = cusp;
            }
            const std::uint32_t q =
                i + 1 == places.size() ? vertex_of(crossing.to) : add_vertex(b, crossing.lift);
            add_segment(crossing, p, q,
                        turns ? b.radial : (a.radial < 0 || b.radial < 0 ? -1.0 : 1.0));
            p = q;
        }
    }

    /// Writes the chains one after another, those with ends first.
    void write() {
        std::vector<std::uint32_t> onwards(nodes_.size(), none); // per node the crossing that
                                                                 // begins there
        std::vector<bool> goes_on(nodes_.size(), false);         // a crossing ends there
        for (std::uint32_t i = 0; i < crossings_.size(); ++i) {
            onwards[crossings_[i].from] = i;
            goes_on[crossings_[i].to] = true;
        }
        std::vector<bool> is_done(crossings_.size(), false);
        for (const bool of_loops : {false, true})
            for (std::uint32_t i = 0; i < crossings_.size(); ++i)
                if (!is_done[i] && (of_loops || !goes_on[crossings_[i].from]))
                    write_chain(i, onwards, is_done);
    }

    void write_chain(std::uint32_t first, const std::vector<std::uint32_t>& onwards,
                     std::vector<bool>& is_done) {
        const std::size_t begin = traced_.segments.size();
        std::uint32_t last = first;
        for (std::uint32_t i = first; i != none && !is_done[i]; i = onwards[crossings_[i].to]) {
            is_done[i] = true;
            add_crossing(crossings_[i]);
            last = i;
        }
        const bool closed = crossings_[last].to == crossings_[first].from;
        const auto count = static_cast<std::uint32_t>(traced_.segments.size() - begin);
        for (std::uint32_t k = 0; k < count; ++k) {
            Segment& segment = traced_.segments[begin + k];
            segment.from_start = k;
            segment.to_end = count - 1 - k;
            segment.path = traced_.segments[begin].path;
            if (closed) segment.tag |= LA_TAG_CLOSED;
        }
    }

    const ContourTracer& tracer_;
    glm::dvec4 eye_; ///< as Camera::eye()
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_; ///< of the picture, pixels
    bool outside_;
    std::vector<SeenSurface> surfaces_;
    std::vector<double> facing_;              ///< per corner
    std::vector<std::uint32_t> node_of_edge_; ///< per edge, or none
    std::vector<Node> nodes_;
    std::vector<Crossing> crossings_;
    compute::TracedSilhouettes traced_;
};

ContourTracer::ContourTracer(const LineSet& lines)
    : surfaces_(lines.contours.surfaces), edge_count_(lines.contours.edges.size()) {
    const Contours& contours = lines.contours;
    corners_.reserve(contours.corners.size());
    for (const ContourCorner& corner : contours.corners)
        corners_.push_back({.at = glm::dvec3{lines.vertices[corner.vertex]},
                            .normal = {corner.normal[0], corner.normal[1], corner.normal[2]}});
    const std::size_t first = lines.segments.size() - contours.faces.size();
    faces_.reserve(contours.faces.size());
    for (std::uint32_t i = 0; i < contours.faces.size(); ++i) {
        Face face{.edges = contours.faces[i], .segment = lines.segments[first + i]};
        for (int k = 0; k < 3; ++k) {
            const glm::uvec2 ends = contours.edges[face.edges[k] & ~LA_CONTOUR_TURNED];
            face.corners[k] = (face.edges[k] & LA_CONTOUR_TURNED) != 0 ? ends.y : ends.x;
            corners_[face.corners[k]].place = 3 * i + static_cast<std::uint32_t>(k);
        }
        faces_.push_back(face);
    }
    leave_out_mixed();
}

void ContourTracer::leave_out_mixed() {
    std::vector<std::uint32_t> first_of_edge(edge_count_, none);
    VertexSets patches{faces_.size()};
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& first = first_of_edge[faces_[i].edges[k] & ~LA_CONTOUR_TURNED];
            if (first == none)
                first = i;
            else
                patches.unite(first, i);
        }
    }
    std::vector<bool> mixed(faces_.size(), false);
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
        if (!traces(i)) mixed[patches.find(i)] = true;
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
        if (mixed[patches.find(i)]) surfaces_.of_triangle[i] = KnownSurfaces::none;
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
        if (!traces(i)) continue;
        if (i == 0 || !traces(i - 1)) traced_.push_back({i, 0});
        ++traced_.back().count;
    }
}

compute::TracedSilhouettes ContourTracer::trace(const Camera& camera, bool outside) const {
    return Frame{*this, camera, outside}.trace();
}

} // namespace lineatlas
