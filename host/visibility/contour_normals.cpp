#include "contour_normals.hpp"

#include "core/corner_normals.hpp"

namespace lineatlas {

void ContourNormals::expect(compute::Stages& stages, const LineTables& lines,
                            std::uint32_t triangle_count) {
    if (!lines.contour_chunk().corners) return;
    if (!offsets_) {
        compute::Device& device = stages.device();
        const CornerPlaces found =
            find_corner_places(download_contours(device, lines, triangle_count).contours,
                               download_segments(device, lines));
        auto offsets = compute::upload(device, found.offsets, compute::table::corner_place_offsets);
        places_ = compute::upload(device, found.places, compute::table::corner_places);
        offsets_ = std::move(offsets);
    }
    are_old_ = true;
}

void ContourNormals::find(compute::Stages& stages, const LineTables& lines) {
    if (!are_old_) return;
    const LineTables::Chunk& chunk = lines.contour_chunk();
    stages.launch_each<compute::kernels::contour_normals>(chunk.corner_count(),
                                                          {.vertices = *lines.vertices,
                                                           .triangles = *lines.triangles,
                                                           .offsets = *offsets_,
                                                           .places = *places_,
                                                           .corners = *chunk.corners});
    are_old_ = false;
}

} // namespace lineatlas
