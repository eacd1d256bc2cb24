#include "frame_oracles.hpp"

#include "density.hpp"
#include "filter.hpp"
#include "halo.hpp"
#include "scan.hpp"

namespace lineatlas::test {

void FrameOracles::scan(FrameState& state) const {
    state.offsets = state.counts;
    state.offsets.push_back(0);
    oracles::scan(state.offsets, compute::ScanKind::saturate);
    state.arcs = state.lengths;
    state.arcs.push_back(0);
    oracles::scan(state.arcs, compute::ScanKind::wrap);
}

void FrameOracles::halo(const Camera& camera, FrameState& state) const {
    state.cuts.resize(state.runs.size());
    oracles::halo({.segments = segments_,
                   .clipped = state.clipped,
                   .runs = state.runs,
                   .viewport = glm::vec2{camera.size},
                   .width = settings_.filter.halo + settings_.half_width,
                   .tolerance = depth_tolerance(camera)},
                  state.cuts);
}

void FrameOracles::filter(const Camera& camera, FrameState& state) const {
    const std::vector<std::uint8_t> alpha = state.alpha;
    std::vector<Run> filtered(settings_.run_capacity);
    state.record = oracles::filter({.frame = {.segments = segments_,
                                              .clipped = state.clipped,
                                              .offsets = state.offsets,
                                              .arcs = state.arcs,
                                              .viewport = glm::vec2{camera.size},
                                              .half_width = settings_.half_width},
                                    .alpha = alpha,
                                    .capacity = capacity_of(state),
                                    .filter = settings_.filter,
                                    .runs = state.runs,
                                    .cuts = state.cuts},
                                   state.alpha, filtered, state.record);
    filtered.resize(state.record.points[0]);
    state.runs = filtered;
}

void FrameOracles::density(const Camera& camera, FrameState& state) const {
    const glm::vec2 viewport{camera.size};
    const glm::ivec2 cells = compute::density_cells(viewport);
    state.weights.resize(LA_DENSITY_BINS * static_cast<std::size_t>(cells.x * cells.y));
    std::vector<Run> runs = state.runs;
    oracles::density({.segments = segments_,
                      .arcs = state.arcs,
                      .alpha = state.alpha,
                      .viewport = viewport,
                      .density = settings_.density,
                      .focus = StageSettings::focus(viewport),
                      .far_limit = settings_.far_limit},
                     runs, state.weights);
    state.flags.clear();
    for (const Run& run : runs) state.flags.push_back(run.flags);
}

} // namespace lineatlas::test
