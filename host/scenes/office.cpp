// A furnished office building of five storeys.
#include "camera_path.hpp"
#include "office_parts.hpp"
#include "scene_list.hpp"

namespace lineatlas::scenes {

Scene make_office() {
    MeshBuilder b;
    const OfficeMaterials m{b.group("structure", "concrete", {0.86F, 0.86F, 0.84F}),
                            b.group("walls", "plaster", {0.95F, 0.94F, 0.90F}),
                            b.group("facade", "aluminium", {0.76F, 0.79F, 0.81F}),
                            b.group("furniture", "wood", {0.88F, 0.76F, 0.60F}),
                            b.group("furniture", "metal", {0.79F, 0.81F, 0.83F}),
                            b.group("equipment", "plastic", {0.55F, 0.57F, 0.60F}),
                            b.group("equipment", "keys", {0.68F, 0.70F, 0.73F}),
                            b.group("furniture", "fabric", {0.58F, 0.68F, 0.76F}),
                            b.group("books", "paper", {0.94F, 0.91F, 0.83F}),
                            b.group("plants", "leaf", {0.62F, 0.74F, 0.56F}),
                            b.group("plants", "clay", {0.86F, 0.67F, 0.56F})};
    add_building(b, m);
    for (int storey = 0; storey < office::storeys; ++storey) furnish(b, m, storey);

    Scene scene;
    scene.mesh = b.take();
    // From the corner of the site down to eye height, through the entrance and along the aisle.
    scene.view = walk({{{-43.1F, 11.7F, 24.4F}, {-3.3F, 2.9F, -5.2F}},
                       {{-35, 7.5F, 14}, {-6, 5.5F, -1}},
                       {{-27, 2.4F, 4.5F}, {-10, 3.2F, 1.0F}},
                       {{-20.5F, 1.75F, 1.2F}, {-8, 1.7F, 1.0F}},
                       {{-15, 1.75F, 1.0F}, {-5, 1.5F, 1.6F}},
                       {{-9, 1.75F, 0.9F}, {-1, 1.3F, 2.6F}},
                       {{-2, 1.75F, 0.8F}, {5, 1.2F, 3.4F}},
                       {{5, 1.75F, 0.8F}, {12, 1.3F, 1.5F}},
                       {{9.2F, 1.75F, 0.9F}, {14, 1.0F, 4.6F}}},
                      0.90F, 0.1F, 150);
    return scene;
}

} // namespace lineatlas::scenes
