#pragma once

#include <glm/vec3.hpp>

#include "builder.hpp"

namespace lineatlas::scenes {

struct ShipMaterials {
    Group planking; ///< outer hull, above the wale
    Group stripe;   ///< outer hull, the painted band below the rail
    Group bottom;   ///< outer hull, below the waterline
    Group frames;   ///< ribs, beams, keel
    Group ceiling;  ///< the planking inside the ribs
    Group deck;
    Group joinery; ///< deckhouses, cabins, furniture
    Group spars;
    Group rope;
    Group sail;
    Group tabling; ///< the doubled edges of the sails
    Group iron;
    Group cargo;
    Group sacks;
};

/// The form of the hull: bow towards +x, waterline at y = 0, symmetric in z.
namespace hull {

constexpr float stern = -29.0F;
constexpr float bow = 29.0F;
constexpr float bulwark = 1.05F; ///< height of the sheer above the main deck
constexpr float tween = 2.5F;    ///< depth of the 'tween deck below the main deck

/// Height of the top of the bulwark at `x`.
float sheer(float x);
/// The starboard half-breadth at length `u` (0 stern, 1 bow) and height `h` (0 keel, 1 sheer).
glm::vec3 surface(float u, float h);
/// The half-breadth of the inside at a point of the centre plane.
float half_breadth(float x, float y);
/// Whether (x, z) is in a hatch; `margin` makes the hatches larger.
bool in_hatch(float x, float z, float margin);

} // namespace hull

struct Hatch {
    float x0, x1, half_width;
};
inline constexpr Hatch hatches[] = {
    {9.0F, 13.0F, 1.7F}, {-4.6F, 0.4F, 1.9F}, {-17.0F, -14.0F, 1.5F}};

void add_hull(MeshBuilder& b, const ShipMaterials& m);
void add_decks(MeshBuilder& b, const ShipMaterials& m);
void add_hold(MeshBuilder& b, const ShipMaterials& m);
void add_deck_gear(MeshBuilder& b, const ShipMaterials& m);
void add_rigging(MeshBuilder& b, const ShipMaterials& m);
void add_stores(MeshBuilder& b, const ShipMaterials& m);

/// A rope; a slack one is bent.
void lay(MeshBuilder& b, const ShipMaterials& m, glm::vec3 from, glm::vec3 to, float radius,
         float sag = 0);
void add_coil(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at, float radius, int turns,
              int segments = 14);
/// A square sail of sewn cloths, bellied forward, with reef points.
void add_square_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 head, float head_half,
                     float foot_y, float foot_half, float belly, int rows);
/// A sail rolled up on its yard, which is `half` long to either side and `radius` thick.
void add_furled_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 yard, float half,
                     float radius);
/// A three-cornered sail on a stay.
void add_staysail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 tack, glm::vec3 head,
                  glm::vec3 clew, int cloths, int rows);

} // namespace lineatlas::scenes
