#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A piece of a table that belongs to one part.
struct PartRoom {
    std::uint32_t first = 0;
    std::uint32_t size = 0;
    bool operator==(const PartRoom&) const = default;
};

/// The pieces of all tables that belong to one part.
struct PartRooms {
    PartRoom vertices;   ///< one more than the part has, so that the lists of its last vertex have
                         ///< an end
    PartRoom triangles;  ///< as many as the part has
    PartRoom fixed;      ///< of LineSet::segments
    PartRoom candidates; ///< silhouettes in LineSet::segments, counted from first_candidate
    PartRoom replaced;   ///< silhouettes that contours stand for, from first_replaced
    PartRoom faces;      ///< contours, from first_face; also of Contours::faces
    PartRoom corners;    ///< of Contours::corners
    PartRoom edges;      ///< of Contours::edges; one more than the part has
    PartRoom clusters;   ///< of SceneBuffers
    bool operator==(const PartRooms&) const = default;
};

/// What an Assembly consists of.
struct AssemblyState {
    struct Part {
        PartRooms rooms{}; ///< kept for another part when this one is gone
        bool is_there = false;
        PartRooms has{}; ///< sizes only: how much of `rooms` it uses
        Bounds box{};
    };
    /// A part that was added, removed or replaced.
    struct Change {
        std::uint32_t object;
        PartRooms rooms; ///< of the part after the change
    };

    LineSet lines;
    std::vector<Part> parts; ///< in the order of LineSet::objects
    PartRooms used{};        ///< sizes only: how much of each table is given to parts
    /// Places in LineSet::segments, where fixed lines come first and contours last.
    std::uint32_t first_candidate = 0, first_replaced = 0, first_face = 0;
    std::uint32_t cluster_count = 0, object_room = 0;
    /// The number of this layout of the tables, unique among all assemblies. A new layout moves
    /// everything.
    std::uint64_t layout = 0;
    std::vector<Change> changes{}; ///< since this layout was made

    std::map<std::array<float, 3>, std::uint16_t> colors{};
    using GroupKey = std::tuple<std::string, std::string, std::optional<std::array<float, 3>>>;
    std::map<GroupKey, std::uint32_t> groups{};
};

/// The rooms of fixed lines, candidates, replaced candidates and contours, as places in
/// LineSet::segments.
inline std::array<PartRoom, 4> segment_rooms(const AssemblyState& state, const PartRooms& rooms) {
    const auto from = [](std::uint32_t first, PartRoom room) {
        return PartRoom{.first = first + room.first, .size = room.size};
    };
    return {rooms.fixed, from(state.first_candidate, rooms.candidates),
            from(state.first_replaced, rooms.replaced), from(state.first_face, rooms.faces)};
}

/// A part by itself. Its indices count from 0, and its fixed segments come before its candidates.
/// Its groups and colours keep their numbers in the whole.
LineSet part_lines(const AssemblyState& state, std::uint32_t object);

} // namespace lineatlas
