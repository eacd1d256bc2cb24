// Which stages kernels run, by planted costs.

#include <gtest/gtest.h>

#include "renderer/form_costs.hpp"

namespace lineatlas::test {
namespace {

using interop::HandoverRates;
using interop::SharingMode;

HandoverRates copies_at(double bytes_per_millisecond) {
    return {.to_compute = {0.2, bytes_per_millisecond}, .to_gl = {0.2, bytes_per_millisecond}};
}

/// The ship's frame on an H200 whose kernels drew depth and strokes in a CPU's form. By raster
/// forms it took 28.9 ms, of which hand-overs took 19.6; by kernels, with strokes by GL, 13.6.
// Both sides copied 4 GB/s, one after the other.
const HandoverRates h200_copies = copies_at(2e6);
constexpr StageTimes h200{
    .depth = {0.8, 8.5}, .atlas = {1.1, 0.08}, .strokes = {0.25, 6.3}, .fill = {0.8, 0.3}};

TEST(FormCosts, TheShipOfAnH200HasDepthAndSamplesByKernelsAndStrokesByGl) {
    const AutomaticForms forms = cheapest_forms(h200_copies, h200);
    EXPECT_TRUE(forms.depth);
    EXPECT_TRUE(forms.atlas);
    EXPECT_FALSE(forms.strokes);
    EXPECT_FALSE(forms.fill);
    EXPECT_GT(frame_milliseconds({}, h200_copies, h200),
              1.5 * frame_milliseconds(forms, h200_copies, h200));
}

TEST(FormCosts, TheClevisOfAnH200HasThemToo) {
    StageTimes times = h200;
    times.depth = {0.3, 2.9 - 0.08 - 0.25}; // 2.9 ms were all of its frame
    const FrameSize clevis{.segments = 1456, .samples = 10'979, .runs = 273};
    const AutomaticForms forms = cheapest_forms(h200_copies, times, clevis);
    EXPECT_TRUE(forms.depth);
    EXPECT_TRUE(forms.atlas);
    EXPECT_FALSE(forms.strokes);
}

TEST(FormCosts, WithoutCopiesGlKeepsWhatKernelsDoNotDoClearlyFaster) {
    const HandoverRates shared = interop::assumed_rates(SharingMode::external_memory);
    const StageTimes times = stage_times(KernelPlace::gpu, true);
    AutomaticForms forms = cheapest_forms(shared, times);
    EXPECT_FALSE(forms.depth);
    EXPECT_TRUE(forms.atlas);
    EXPECT_FALSE(forms.strokes);
    EXPECT_FALSE(forms.fill);
    StageTimes faster = times;
    faster.depth.kernels = faster.depth.gl / 2;
    forms = cheapest_forms(shared, faster);
    EXPECT_TRUE(forms.depth);
}

TEST(FormCosts, BesideAGpuThatCopiesNoTextureAndNoSampleCrosses) {
    const StageTimes times = stage_times(KernelPlace::gpu, true);
    for (const double rate : {1e6, 4e6, 9e6, 16e6, 32e6}) {
        const AutomaticForms forms = cheapest_forms(copies_at(rate), times);
        EXPECT_TRUE(forms.depth && forms.atlas && forms.strokes) << rate;
        EXPECT_FALSE(forms.fill || forms.spine_depth) << "GL draws them alone, at " << rate;
    }
}

TEST(FormCosts, KernelsOnACpuBesideAGpuLeaveAllToGl) {
    const AutomaticForms forms =
        cheapest_forms(copies_at(4e6), stage_times(KernelPlace::cpu, true));
    EXPECT_FALSE(forms.depth || forms.atlas || forms.strokes || forms.fill || forms.spine_depth);
}

TEST(FormCosts, BesideASoftwareGlKernelsRunAllThatTheirFormIsMadeFor) {
    for (const SharingMode mode : interop::all_modes) {
        const HandoverRates rates = interop::assumed_rates(mode);
        for (const KernelPlace place : {KernelPlace::cpu, KernelPlace::gpu}) {
            const AutomaticForms forms = cheapest_forms(rates, stage_times(place, false));
            EXPECT_TRUE(forms.depth && forms.atlas && forms.strokes && forms.fill &&
                        forms.spine_depth)
                << interop::name_of(mode);
        }
        const AutomaticForms forms =
            cheapest_forms(rates, stage_times(KernelPlace::cpu_as_gpu, false));
        EXPECT_TRUE(forms.atlas) << interop::name_of(mode);
        EXPECT_FALSE(forms.depth || forms.strokes || forms.fill || forms.spine_depth)
            << interop::name_of(mode);
    }
}

TEST(FormCosts, AFrameTakesItsStagesAndWhatCrosses) {
    constexpr StageTimes times{.depth = {1, 2}, .atlas = {4, 8}, .strokes = {16, 32}, .fill = {}};
    const FrameSize frame{
        .pixels = 1000, .texels = 4000, .segments = 100, .samples = 50, .runs = 10};
    const HandoverRates rates{.to_compute = {0.5, 1000}, .to_gl = {0.25, 500}};
    const AutomaticForms kernels{.depth = true, .atlas = true, .strokes = true};
    EXPECT_DOUBLE_EQ(frame_milliseconds(kernels, rates, times, frame),
                     2 + 8 + 32 + 0.25 + 1000 / 500.0);
    const AutomaticForms samples{.atlas = true};
    EXPECT_DOUBLE_EQ(frame_milliseconds(samples, rates, times, frame),
                     1 + 8 + 0.5 + 2 * 4 * 4000 / 1000.0 + 16 + 0.25 + (80 * 10 + 50) / 500.0);
    EXPECT_DOUBLE_EQ(frame_milliseconds({}, rates, times, frame),
                     1 + 4 + 0.25 + 52 * 100 / 500.0 + 0.5 + (50 + 4 * 4000) / 1000.0 + 16 + 0.25 +
                         (80 * 10 + 50) / 500.0);
}

} // namespace
} // namespace lineatlas::test
