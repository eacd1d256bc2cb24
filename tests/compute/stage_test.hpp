#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "compare.hpp"
#include "devices.hpp"

// Shared by the tests of single stages. Each test gives a stage small hand-made tables with a known
// answer: by hand, or computed in double precision in another way than the kernel's.
namespace lineatlas::test {

/// A stage on every device.
class StageTest : public testing::TestWithParam<TestDevice> {
  protected:
    template <class T>
    std::unique_ptr<compute::Buffer> put(const std::vector<T>& values) {
        return to_device(*on_.device, values);
    }
    template <class T>
    std::vector<T> get(compute::Buffer& buffer, std::size_t count) {
        return read_back<T>(*on_.device, buffer, count);
    }
    compute::Stages& stages() { return on_.stages; }
    compute::Device& device() { return *on_.device; }

  private:
    DeviceStages on_{GetParam().make()};
};

/// The fixture and its suites, for a stage's file.
#define LINEATLAS_STAGE_TEST(Name) LINEATLAS_STAGE_TEST_OF(Name, StageTest)
#define LINEATLAS_STAGE_TEST_OF(Name, Base)                                                        \
    class Name : public Base {};                                                                   \
    INSTANTIATE_TEST_SUITE_P(OnDevice, Name, testing::ValuesIn(test_devices()),                    \
                             [](const auto& info) { return info.param.name; })

/// The picture of frames made by hand: sizes that are powers of two keep places exact.
inline constexpr glm::ivec2 hand_size{64, 64};

/// A place in the window: pixels from the lower left, window depth, and w there.
using WindowPlace = glm::vec4;

/// A line of a frame made by hand.
struct HandLine {
    WindowPlace p, q;
    std::uint32_t samples;
    std::uint32_t from_start = 0, to_end = 0;
    std::uint32_t tag = LA_KIND_CREASE;
    float t0 = 0, t1 = 1;               ///< clip parameters
    std::uint32_t own_a = 0, own_b = 0; ///< as in ClippedSegment
    std::uint32_t vertex_p = 0, vertex_q = 0;
};

/// The tables of a hand-made frame. All its lines are drawn.
class HandFrame {
  public:
    HandFrame(compute::Device& device, std::span<const HandLine> lines);

    std::uint32_t count() const { return count_; }
    std::uint32_t samples() const { return samples_; }
    compute::ClippedTable clipped() { return {*clipped_, *offsets_, *arcs_}; }
    /// There are no triangles.
    compute::SegmentTable table(compute::Buffer& vertices) {
        return {vertices, *no_triangles_, *segments_, 0, count_};
    }

  private:
    std::uint32_t count_, samples_ = 0;
    std::unique_ptr<compute::Buffer> segments_, clipped_, offsets_, arcs_, no_triangles_;
};

/// A face beside a line as project_clip packs it: slope in window depth per pixel to the left, and
/// the height of the third corner in pixels, positive to the left. Exact for few bits.
std::uint32_t pack_own_face(float slope, float height);
float slope_of(std::uint32_t packed);
float height_of(std::uint32_t packed);

} // namespace lineatlas::test
