#pragma once

#include "builder.hpp"

namespace lineatlas::scenes {

struct OfficeMaterials {
    Group concrete;
    Group plaster;
    Group frame; ///< of windows and doors
    Group wood;
    Group metal;
    Group plastic;
    Group keys;
    Group fabric;
    Group paper;
    Group leaf;
    Group clay;
};

/// The building stands on y = 0, its long side along x, the entrance at the end towards -x.
namespace office {

constexpr int storeys = 5;
constexpr float storey_height = 3.6F;
constexpr float half_length = 18.0F;
constexpr float half_depth = 8.0F;
constexpr float slab = 0.30F;

constexpr float floor_of(int storey) {
    return 0.15F + storey_height * static_cast<float>(storey);
}

} // namespace office

void add_building(MeshBuilder& b, const OfficeMaterials& m);
/// Partitions, doors and furniture of one storey.
void furnish(MeshBuilder& b, const OfficeMaterials& m, int storey);

// Furniture stands on y = 0 of its transform; desks and chairs face -z.
void add_desk(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key);
void add_chair(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at);
void add_shelf(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key);
void add_plant(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key);
void add_meeting_table(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, float length);
void add_sofa(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at);

} // namespace lineatlas::scenes
