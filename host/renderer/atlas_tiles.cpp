// Pictures that no framebuffer or depth buffer can hold. Segments, runs and styles are those of the
// whole picture. Only depth, with the samples that need it, fills and strokes are drawn tile by
// tile.
#include "atlas_method.hpp"
#include "compute/transfer.hpp"
#include "core/tiles.hpp"
#include "lineatlas/error.hpp"
#include "tile_loop.hpp"

namespace lineatlas {

void AtlasMethod::prepare_tiles(const Frame& frame) {
    if (frame.options.method != Method::atlas || frame.options.forms.atlas == StageForm::raster) {
        throw UsageError(
            "tiles: only the method exact, and atlas in its compute form, draw pictures of " +
            std::to_string(frame.camera.size.x) + "x" + std::to_string(frame.camera.size.y) +
            " by tiles; choose one of them or a smaller Camera::size");
    }
    raster_ = false;
    cull_hidden_ = false;
    carries_ = false;
    chains_.guess(false);
    temporal_.forget(); // the next frame has nothing to be averaged with
    make_atlas(frame);
}

void AtlasMethod::sample_tiles(Frame& frame, const TileTarget& target,
                               const ProgressPart& progress) {
    depth_.begin_tiles();
    float done = 0;
    const std::vector<PictureTile> tiles = make_tiles(frame.camera.size, target.tile_size);
    for (const PictureTile& tile : tiles) {
        progress(done++ / static_cast<float>(tiles.size()));
        const compute::DepthTile depth = depth_.draw_tile(frame, tile);
        frame.clock("atlas", [&] {
            compute::AtlasArgs args = atlas_args(frame);
            args.tile = &depth;
            stages_.atlas(args);
        });
    }
}

FrameStats AtlasMethod::draw_tiles(Frame& frame, const TileTarget& target) {
    prepare_tiles(frame);
    // Samples take about as long as strokes do.
    const ProgressPart progress{target.progress, "drawing tiles"};
    const ProgressPart sampling = progress.part(0, 0.5F), drawing = progress.part(0.5F, 1);
    const auto chunks = static_cast<float>(frame.scene.chunk_count());
    for (std::size_t chunk = 0; chunk < frame.scene.chunk_count(); ++chunk) {
        const auto before = static_cast<float>(chunk);
        ProgressPart part = sampling.part(before / chunks, (before + 1) / chunks);
        begin_chunk(frame, chunk);
        project(frame);
        // Samples are counted first: if the atlas were too small, drawing all depth again would
        // take long.
        grow_atlas(compute::read_one<la_uint>(device_, offsets_.compute(), segment_count_));
        bool sampled = false;
        do {
            if (!sampled) sample_tiles(frame, target, part);
            part = part.part(1, 1); // sampling once more is no progress
            strokes_.make_runs(frame, segment_atlas(), nullptr, nullptr);
            sampled = !strokes_.changes_samples();
        } while (grow());
        alpha_.set_size(strokes_.sample_total());
        keep_chunk(frame);
    }
    draw_by_tiles(frame, target, drawing, [&] {
        fill_.draw_tile(frame, depth_); // the depth of the tile was drawn for its samples alone
        strokes_.draw(frame, alpha_);
    });
    return stats();
}

} // namespace lineatlas
