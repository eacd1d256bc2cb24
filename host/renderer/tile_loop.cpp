#include "tile_loop.hpp"

#include "backdrop.hpp"
#include "core/tiles.hpp"

namespace lineatlas {

void draw_by_tiles(Frame& frame, const TileTarget& target, const ProgressPart& progress,
                   const std::function<void()>& draw) {
    const std::vector<PictureTile> tiles = make_tiles(frame.camera.size, target.tile_size);
    float done = 0;
    for (const PictureTile& tile : tiles) {
        progress(done++ / static_cast<float>(tiles.size()));
        frame.tile = tile;
        target.begin(tile);
        draw();
        frame.backdrop.draw_paper(frame, frame.options.style.paper);
        frame.clock("output", [&] { target.end(tile); });
    }
    progress(1);
}

} // namespace lineatlas
