#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "builder.hpp"

/// The materials of the house.
namespace lineatlas::scenes::house {

struct Materials {
    Group concrete, rim, stone, rock, frame, wood, fabric, metal, bark;
};

constexpr float ground = 0.355F; ///< the top of the rock

/// A terrace: one welded tray of floor, parapet with a rounded rim, and underside.
void add_terrace(MeshBuilder& b, const Materials& m, glm::vec2 lo, glm::vec2 hi, float floor,
                 float parapet);
/// Courses of stone along x from 0 to `length`, each stone through the whole thickness.
void add_stone_wall(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                    float height, float thickness, std::uint32_t key);
/// A band of windows along x: posts, three rows of muntins, and casements that stand open.
void add_windows(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                 float height, int bays);
void add_rail(MeshBuilder& b, const Materials& m, glm::vec3 from, glm::vec3 to, int posts);
void add_steps(MeshBuilder& b, Group g, glm::vec3 foot, glm::vec3 run, float rise, int count,
               glm::vec3 half);
void add_chair(MeshBuilder& b, const Materials& m, const glm::mat4& at);
void add_table(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length, int chairs);
void add_bed(MeshBuilder& b, const Materials& m, const glm::mat4& at);
void add_shelves(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                 std::uint32_t key);
/// Layered ledges of sandstone that step down to the stream.
void add_terrain(MeshBuilder& b, const Materials& m);
void add_tree(MeshBuilder& b, const Materials& m, glm::vec3 foot, float height, std::uint32_t key);

} // namespace lineatlas::scenes::house
