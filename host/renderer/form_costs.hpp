#pragma once

#include <cstdint>

#include "glpasses/interop/handover_rates.hpp"
#include "lineatlas/compute_device.hpp"

// Which stages kernels run where a frame leaves that open (StageForm::automatic): those that take
// less time there than in GL, with all that then crosses between the two.
namespace lineatlas {

/// Where kernels run. Values of the tuning table tell it.
enum class KernelPlace {
    cpu,        ///< in a CPU's form
    gpu,        ///< in a GPU's form, which is made for tens of thousands of work-items
    cpu_as_gpu, ///< in a GPU's form whose serial parts are those of a CPU
};
KernelPlace place_of(const compute::Tuning& tuning);

/// Milliseconds of a stage in each form.
struct FormTimes {
    double gl = 0, kernels = 0;
};
/// Those of all stages that have two forms. `fill`: with `depth` where GL draws both at once.
struct StageTimes {
    FormTimes depth, atlas, strokes, fill;
};
/// Stages of the frame that FrameSize describes.
StageTimes stage_times(KernelPlace kernels, bool gl_has_gpu);

/// What decides how many bytes a frame's tables have: as they stand here, the ship at 1024x768 by
/// the method atlas. Every frame is taken for this one, so that a picture's forms depend neither on
/// the frame before it nor on the size of a window.
struct FrameSize {
    std::uint64_t pixels = 786'432;
    std::uint64_t texels = 3'145'728; ///< of the depth
    std::uint64_t segments = 290'000;
    std::uint64_t samples = 211'000;
    std::uint64_t runs = 30'000;
};

/// The stages that kernels run; GL runs the others.
struct AutomaticForms {
    bool depth = false;       ///< for samples, and a fill by it
    bool spine_depth = false; ///< for the method spine, whose passes are GL's
    bool fill = false;        ///< of the method exact, with the depth for it
    bool atlas = false;
    bool strokes = false;
    /// A wait for kernels takes no time: they run on the CPU. So numbers are read as soon as there
    /// are any, and GL draws strokes all the same if they are few.
    bool waits_freely = false;
};

/// The forms that take the least time. Times of other scenes differ, so a form must be ahead by a
/// clear margin. Without that the stage stays where fewer bytes cross: depth and strokes with
/// kernels if bytes are copied, so that no texture and no sample crosses, all else with GL.
AutomaticForms cheapest_forms(const interop::HandoverRates& rates, const StageTimes& times,
                              const FrameSize& frame = {});

/// Milliseconds of the depth, samples and strokes of a frame in these forms, with all that crosses.
double frame_milliseconds(const AutomaticForms& forms, const interop::HandoverRates& rates,
                          const StageTimes& times, const FrameSize& frame = {});

/// The forms of a device in the current GL context.
AutomaticForms forms_for(const compute::Tuning& tuning, const interop::HandoverRates& rates);

} // namespace lineatlas
