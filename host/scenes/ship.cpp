// A three-masted sailing ship on the stocks, with everything inside her.
#include "camera_path.hpp"
#include "scene_list.hpp"
#include "ship_parts.hpp"

namespace lineatlas::scenes {

Scene make_ship() {
    MeshBuilder b;
    const ShipMaterials m{b.group("hull", "painted_wood", {0.20F, 0.24F, 0.30F}),
                          b.group("hull", "white_paint", {0.80F, 0.79F, 0.74F}),
                          b.group("hull", "copper", {0.50F, 0.33F, 0.24F}),
                          b.group("frames", "oak", {0.47F, 0.35F, 0.22F}),
                          b.group("ceiling", "pine", {0.62F, 0.49F, 0.32F}),
                          b.group("deck", "teak", {0.66F, 0.55F, 0.40F}),
                          b.group("joinery", "varnished_wood", {0.50F, 0.31F, 0.17F}),
                          b.group("spars", "spruce", {0.70F, 0.57F, 0.36F}),
                          b.group("rigging", "rope", {0.33F, 0.28F, 0.21F}),
                          b.group("sails", "canvas", {0.85F, 0.81F, 0.70F}),
                          b.group("sails", "tabling", {0.76F, 0.71F, 0.58F}),
                          b.group("fittings", "iron", {0.22F, 0.23F, 0.24F}),
                          b.group("cargo", "wood", {0.57F, 0.42F, 0.26F}),
                          b.group("cargo", "jute", {0.67F, 0.58F, 0.42F})};
    add_hull(b, m);
    add_decks(b, m);
    add_hold(b, m);
    add_stores(b, m);
    add_deck_gear(b, m);
    add_rigging(b, m);

    Scene scene;
    scene.mesh = b.take();
    scene.view = walk({{{53.6F, 9.3F, 44.1F}, {10.0F, 14.5F, -9.6F}},
                       {{46, 7, 32}, {9, 11.5F, -4}},
                       {{36, 4, 22}, {8, 7, 0}},
                       {{16, 4, 14}, {-4, 5, 0}},
                       {{2, 6, 10}, {-10, 4, 0}},
                       {{-6, 6.2F, 6}, {-2, 3.6F, -1}},
                       {{-9.0F, 4.2F, 2.9F}, {6, 4, 0.5F}},
                       {{-2.0F, 4.0F, 3.1F}, {14, 4.4F, 0}},
                       {{7.0F, 4.1F, 3.0F}, {20, 5, 0}}},
                      0.80F, 0.15F, 220);
    return scene;
}

} // namespace lineatlas::scenes
