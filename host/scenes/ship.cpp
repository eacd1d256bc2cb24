// A three-masted sailing ship on the stocks, with everything inside her.
#include "camera_path.hpp"
#include "scene_list.hpp"
#include "ship_parts.hpp"

namespace lineatlas::scenes {

Scene make_ship() {
    MeshBuilder b;
    const ShipMaterials m{b.group("hull", "painted_wood", {0.52F, 0.60F, 0.66F}),
                          b.group("hull", "white_paint", {0.94F, 0.92F, 0.86F}),
                          b.group("hull", "copper", {0.78F, 0.62F, 0.52F}),
                          b.group("frames", "oak", {0.76F, 0.66F, 0.52F}),
                          b.group("ceiling", "pine", {0.85F, 0.76F, 0.60F}),
                          b.group("deck", "teak", {0.87F, 0.79F, 0.66F}),
                          b.group("joinery", "varnished_wood", {0.76F, 0.60F, 0.46F}),
                          b.group("spars", "spruce", {0.88F, 0.78F, 0.60F}),
                          b.group("rigging", "rope", {0.66F, 0.60F, 0.50F}),
                          b.group("sails", "canvas", {0.97F, 0.94F, 0.86F}),
                          b.group("sails", "tabling", {0.91F, 0.87F, 0.76F}),
                          b.group("fittings", "iron", {0.52F, 0.54F, 0.56F}),
                          b.group("cargo", "wood", {0.80F, 0.67F, 0.50F}),
                          b.group("cargo", "jute", {0.86F, 0.79F, 0.66F})};
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
