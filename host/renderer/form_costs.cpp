#include "form_costs.hpp"

#include <algorithm>

#include "compute/stages/tables.hpp"
#include "glpasses/current_context.hpp"

namespace lineatlas {
namespace {

// The share by which a form must be ahead.
constexpr double margin = 1.25;

/// The costs of a frame's forms in milliseconds: each stage, and what crosses for it.
class FrameCosts {
  public:
    FrameCosts(const interop::HandoverRates& rates, const StageTimes& times, const FrameSize& frame)
        : rates_(rates), times_(times), frame_(frame) {}

    double samples(bool depth_by_kernels, bool atlas_by_kernels) const {
        const double stages =
            of(times_.depth, depth_by_kernels) + of(times_.atlas, atlas_by_kernels);
        if (atlas_by_kernels) {
            // Depth, and the number of a triangle at each texel.
            return stages + (depth_by_kernels ? 0 : rates_.to_compute.of(texels() * 2));
        }
        // Kernels look at GL's depth all the same, for outlines and for what is hidden whole.
        const std::uint64_t segments = frame_.segments * (sizeof(ClippedSegment) + sizeof(la_uint));
        return stages + rates_.to_gl.of(segments + (depth_by_kernels ? texels() : 0)) +
               rates_.to_compute.of(frame_.samples + (depth_by_kernels ? 0 : texels()));
    }
    double samples(bool depth_by_kernels) const {
        return std::min(samples(depth_by_kernels, true), samples(depth_by_kernels, false));
    }
    double strokes(bool by_kernels) const {
        const std::uint64_t bytes =
            by_kernels ? frame_.pixels : frame_.runs * sizeof(Run) + frame_.samples;
        return of(times_.strokes, by_kernels) + rates_.to_gl.of(bytes);
    }
    /// Of a frame that has depth for nothing else.
    double fill(bool by_kernels) const {
        if (!by_kernels) return times_.fill.gl;
        return times_.depth.kernels + times_.fill.kernels +
               rates_.to_gl.of(frame_.pixels * sizeof(la_uint));
    }
    double spine_depth(bool by_kernels) const {
        return of(times_.depth, by_kernels) + (by_kernels ? rates_.to_gl.of(texels()) : 0);
    }

  private:
    static double of(const FormTimes& times, bool by_kernels) {
        return by_kernels ? times.kernels : times.gl;
    }
    std::uint64_t texels() const { return frame_.texels * sizeof(float); }

    const interop::HandoverRates& rates_;
    const StageTimes& times_;
    const FrameSize& frame_;
};

enum class Keeper { gl, kernels };

/// Whether kernels should have a stage that costs so much there and in GL. `keeper`: who has it if
/// neither is clearly ahead.
bool is_for_kernels(double kernels, double gl, Keeper keeper) {
    return keeper == Keeper::kernels ? kernels <= gl * margin : kernels * margin < gl;
}

} // namespace

KernelPlace place_of(const compute::Tuning& tuning) {
    if (tuning.depth_lanes > 1) return KernelPlace::cpu;
    return tuning.depth_each ? KernelPlace::gpu : KernelPlace::cpu_as_gpu;
}

StageTimes stage_times(KernelPlace kernels, bool gl_has_gpu) {
    // GL on an H100, but its strokes on an H200, or llvmpipe on two cores. docs/devices.md says
    // which figures are assumed.
    StageTimes times = gl_has_gpu ? StageTimes{.depth = {.gl = 2.65},
                                               .atlas = {.gl = 1.1},
                                               .strokes = {.gl = 0.25},
                                               .fill = {.gl = 0.8}}
                                  : StageTimes{.depth = {.gl = 53},
                                               .atlas = {.gl = 100},
                                               .strokes = {.gl = 26},
                                               .fill = {.gl = 81}};
    switch (kernels) {
    case KernelPlace::cpu: // PoCL on two cores
        times.depth.kernels = 9.3;
        times.atlas.kernels = 11;
        times.strokes.kernels = 14;
        times.fill.kernels = 8.2;
        break;
    case KernelPlace::gpu: // samples on an H100; the others were not measured: as fast as GL there
        times.depth.kernels = 2.65;
        times.atlas.kernels = 0.07;
        times.strokes.kernels = 0.25;
        times.fill.kernels = 0.3;
        break;
    case KernelPlace::cpu_as_gpu: // not measured; serial parts are slower than llvmpipe
        times.depth.kernels = 106;
        times.atlas.kernels = 22;
        times.strokes.kernels = 52;
        times.fill.kernels = 16;
        break;
    }
    return times;
}

AutomaticForms cheapest_forms(const interop::HandoverRates& rates, const StageTimes& times,
                              const FrameSize& frame) {
    const FrameCosts costs{rates, times, frame};
    const Keeper keeper = rates.copies() ? Keeper::kernels : Keeper::gl;
    AutomaticForms forms;
    forms.depth = is_for_kernels(costs.samples(true), costs.samples(false), keeper);
    forms.atlas = costs.samples(forms.depth, true) <= costs.samples(forms.depth, false);
    forms.strokes = is_for_kernels(costs.strokes(true), costs.strokes(false), keeper);
    forms.fill = is_for_kernels(costs.fill(true), costs.fill(false), Keeper::gl);
    forms.spine_depth =
        is_for_kernels(costs.spine_depth(true), costs.spine_depth(false), Keeper::gl);
    return forms;
}

double frame_milliseconds(const AutomaticForms& forms, const interop::HandoverRates& rates,
                          const StageTimes& times, const FrameSize& frame) {
    const FrameCosts costs{rates, times, frame};
    return costs.samples(forms.depth, forms.atlas) + costs.strokes(forms.strokes);
}

AutomaticForms forms_for(const compute::Tuning& tuning, const interop::HandoverRates& rates) {
    const KernelPlace place = place_of(tuning);
    AutomaticForms forms = cheapest_forms(rates, stage_times(place, !gl::is_software()));
    forms.waits_freely = place == KernelPlace::cpu;
    return forms;
}

} // namespace lineatlas
