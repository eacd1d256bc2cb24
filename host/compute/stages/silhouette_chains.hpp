#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/standard_camera.hpp"
#include "stages.hpp"

namespace lineatlas::compute {

/// The tables of the stages that find silhouettes, see kernels/chain.cl for what each holds.
struct ChainTables {
    Device* device;
    Table front{*device, table::chain_front}; ///< a byte per triangle: whether it faces the eye
    /// For contours whether faces are crossed. Then for each candidate that may be a silhouette the
    /// number of silhouettes before it, and the number of all.
    Table numbers{*device, table::chain_numbers};
    Table positions{*device, table::chain_positions}; ///< a uint32 per candidate
    Table ordered{*device, table::chain_ordered}; ///< `Segment` each, from the first fixed one on
    Table chosen{*device, table::chain_chosen};   ///< a uint32 per silhouette
    Table total{*device, table::chain_total};     ///< a uint32: how many there are
    Table ways{*device, table::chain_ways};       ///< scratch: two `ChainWay` per silhouette
    Table longer{*device, table::chain_longer};   ///< scratch: the same
    Table going{*device, table::chain_going};   ///< scratch: a uint32 for each of most_chain_steps
    Table places{*device, table::chain_places}; ///< scratch: `ChainPlace` per silhouette
    Table starts{*device, table::chain_starts}; ///< scratch: a uint32 per silhouette and one more
    Table origins{*device, table::chain_origins}; ///< a uint32 per silhouette, in their new order
    /// Vertices of the mesh, then four places of three floats per silhouette; without contours no
    /// room.
    Table vertices{*device, table::contour_vertices};
};

/// Where silhouettes are seen from.
struct SilhouetteView {
    glm::vec4 eye;     ///< Camera::eye()
    bool from_outside; ///< see sees_from_outside()
};

/// The silhouettes of a frame as paths.
struct ChainArgs {
    SegmentTable table; ///< if it has contours, with ChainTables::vertices
    SilhouetteView view;
    /// Contours are drawn at the lifted places, where their visibility is tested.
    bool lifted;
    std::uint32_t count; ///< silhouettes that there is room for, above 0
    const ChainTables& tables;
    Buffer* crossings = nullptr; ///< `ContourCrossing` per silhouette; null: no contours
    /// `positions` of the frame before, from which chains keep names and directions; null: there is
    /// none.
    Buffer* positions_before = nullptr;
};

/// Steps in which the ways of any number of silhouettes get to their ends.
inline constexpr std::uint32_t most_chain_steps = 17;

/// How a frame sees the silhouettes of a model.
inline SilhouetteView silhouette_view(const Camera& camera, const Bounds& bounds) {
    return {camera.eye(), sees_from_outside(camera, bounds)};
}

/// Faces of contours, one after the other.
struct FaceRange {
    std::uint32_t first = 0, count = 0;
};

/// Silhouettes of contours that the host has found.
struct TracedSilhouettes {
    /// Two for each place, as in the stage `contour`: on the surface, and lifted off it.
    std::vector<glm::vec3> vertices;
    /// Paths one after the other, with ends in `vertices`.
    std::vector<Segment> segments;
    std::vector<std::uint32_t> faces;      ///< per segment the face of contours that it runs over
    std::span<const FaceRange> instead_of; ///< faces whose silhouettes these replace
};

/// The silhouettes of a frame as paths: they take the place of the candidates in the table of
/// segments that later stages work on. Keeps the tables of the stages `silhouette` and `chain`,
/// which grow when a frame needs more.
class SilhouetteChains {
  public:
    /// Where contours (kernels/contour.cl) are drawn: on their surface, or lifted off it to the
    /// places where visibility is tested, for stages that know only one place.
    enum class Contours { on_surface, lifted };

    /// `stages` must outlive it.
    explicit SilhouetteChains(Stages& stages, Contours drawn)
        : stages_(stages), device_(stages.device()), drawn_(drawn) {}

    /// Gives up its tables: those of a large model may not fit beside another's.
    void release();
    /// Makes chains keep their names and directions from the frame before. positions_before:
    /// ChainOrder::positions of that frame; null: there is none.
    void follow(Buffer* positions_before) { positions_before_ = positions_before; }
    /// Call when the table holds other segments.
    void forget_lines() {
        fixed_of_ = nullptr;
        vertices_of_ = {};
        last_total_.reset();
    }
    /// Whether the next frames take as many silhouettes as the frame before had, and some more, and
    /// do not wait for their number. Then settle() must follow each.
    void guess(bool on) { guesses_ = on; }
    /// Call when the device is done with a frame. Returns false if it had more silhouettes than
    /// there was room for; then it must be found again, as a frame that follows none.
    bool settle();
    /// Whether the frame has more silhouettes than would have been guessed. It follows none then,
    /// so that it is the same whether or not the host guesses.
    bool has_many_more() const { return has_many_more_; }

    /// The table of a frame, with the silhouettes that `view` shows, or with none unless they are
    /// `wanted`. Waits for their number, unless it was guessed; then the last segments may be none
    /// that any frame draws. `clock(name, action)` runs a stage.
    template <class Clock>
    SegmentTable table_of(const SegmentTable& candidates, bool wanted, const SilhouetteView& view,
                          Clock&& clock) {
        tables_.front.fit(candidates.triangle_count);
        if (!wanted || candidates.candidates.count == 0) return without(candidates);
        clock("facing", [&] { stages_.facing(candidates, view.eye, front()); });
        return find(candidates, front(), view, clock);
    }
    /// Gives the next frame silhouettes that the host has found, in place of those that it would
    /// find itself.
    void take(TracedSilhouettes traced) { traced_ = std::move(traced); }
    /// Whether triangles face the eye in that frame; a byte each.
    Buffer& front() const { return *tables_.front; }
    /// The last step of table_of(), of a table that has candidates.
    template <class Clock>
    SegmentTable find(const SegmentTable& candidates, Buffer& front, const SilhouetteView& view,
                      Clock&& clock) {
        tables_.numbers.make_room((candidates.candidates.count + 1ULL) * sizeof(la_uint));
        const bool has_contours = candidates.candidates.contours.has_value();
        if (has_contours) clock("contour", [&] { contour(candidates, view.eye); });
        clock("silhouette", [&] { list(candidates, front); });
        const std::uint32_t found = count_;
        count_ += static_cast<std::uint32_t>(traced_.segments.size());
        if (count_ == 0) return with_none(candidates);
        if (has_contours) clock("contour", [&] { place_contours(candidates, front, view, found); });
        const SegmentTable table = has_contours ? with_contours(candidates) : candidates;
        clock("chain", [&] { chain(table, view, found); });
        return with_chains(table);
    }

    /// Where the silhouettes of the last frame came from, see chain_write. Waits for the device.
    /// Empty if there were none.
    std::vector<std::uint32_t> read_origins() const;
    std::uint32_t first() const { return first_; } ///< the first segment that is a silhouette
    std::uint32_t count() const { return count_; } ///< the number of silhouettes
    /// The order for `temporal`. `positions_before` must hold as many as `table.candidates`. Only
    /// if has_order().
    ChainOrder order(const SegmentTable& table, Buffer& positions_before) const;
    bool has_order() const { return has_order_; }

  private:
    SegmentTable without(const SegmentTable& table);
    void contour(const SegmentTable& table, const glm::vec4& eye);
    ChainArgs args(const SegmentTable& table, const SilhouetteView& view,
                   std::uint32_t count) const {
        return {table,
                view,
                drawn_ == Contours::lifted,
                count,
                tables_,
                crossings_.get(),
                positions_before_};
    }
    void list(const SegmentTable& table, Buffer& front);
    /// Finds how many silhouettes there are, or guesses.
    void count_silhouettes(const SegmentTable& table);
    /// Whether there is memory for all tables of a frame with so many silhouettes.
    bool has_memory_for(std::uint64_t silhouettes, const SegmentTable& table) const;
    /// found: silhouettes that the device has found; traced ones follow them.
    void place_contours(const SegmentTable& table, Buffer& front, const SilhouetteView& view,
                        std::uint32_t found);
    /// The table with the vertices of the frame's contours behind its own.
    SegmentTable with_contours(const SegmentTable& table) const;
    void chain(const SegmentTable& table, const SilhouetteView& view, std::uint32_t found);
    void add_traced(const SegmentTable& table, std::uint32_t found);
    void clear_positions(const SegmentTable& table);
    SegmentTable with_none(const SegmentTable& table);
    SegmentTable with_chains(const SegmentTable& table) const;
    void copy_fixed(const SegmentTable& table);

    Stages& stages_;
    Device& device_; ///< of stages_
    Contours drawn_;
    TracedSilhouettes traced_;
    std::uint32_t first_ = 0;
    std::uint32_t count_ = 0; ///< silhouettes of the last frame, or room for them until settle()
    bool guesses_ = false;
    bool is_guessed_ = false; ///< count_
    bool has_many_more_ = false;
    std::optional<std::uint32_t> last_total_; ///< silhouettes of the frame before
    std::uint32_t total_ = 0;                 ///< of the device, after a guess
    bool has_order_ = false;
    Buffer* positions_before_ = nullptr;
    const Buffer* fixed_of_ = nullptr; ///< the table whose fixed lines stand in `ordered`
    /// The table whose vertices stand in `vertices`, and their SegmentTable::version.
    std::pair<const Buffer*, std::uint64_t> vertices_of_{};
    ChainTables tables_{&device_};
    Table crossings_{device_, table::contour_crossings}; ///< ChainArgs::crossings
};

} // namespace lineatlas::compute
