// What a camera that frames a model leaves out of it.
#include "core/far_part.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "lineatlas/framing.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {
namespace {

/// A sheet of `side` by `side` squares about zero, 2 wide, of 2 triangles each.
Mesh sheet(std::uint32_t side) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x)
            mesh.positions.emplace_back(2.0F * static_cast<float>(x) / static_cast<float>(side) - 1,
                                        2.0F * static_cast<float>(y) / static_cast<float>(side) - 1,
                                        0.0F);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t i = y * (side + 1) + x, above = i + side + 1;
            mesh.triangles.insert(mesh.triangles.end(),
                                  {{i, i + 1, above}, {i + 1, above + 1, above}});
        }
    }
    return mesh;
}

LineSet with_line(std::uint32_t side, float at, float length) {
    Mesh mesh = sheet(side);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{at, 0, 0}, {at, length, 0}});
    mesh.polylines = {{first, first + 1}};
    return extract_lines(mesh);
}

TEST(FarPart, SpecksAreLeftOutThatWouldPushTheModelAside) {
    const LineSet speck = with_line(40, 2, 0.001F);
    const auto far = find_far_part(speck);
    ASSERT_TRUE(far);
    EXPECT_TRUE(is_left_out(*far));
    EXPECT_EQ(far->count, 1U);
    EXPECT_EQ(far->rest.max.x, 1);
    for (const glm::vec3& point : framing_of(speck).points) EXPECT_LE(point.x, 1);
    EXPECT_NE(framing_of(speck).note.find("1 of "), std::string::npos);
}

TEST(FarPart, LargeOrNearPartsStay) {
    EXPECT_FALSE(find_far_part(with_line(40, 2, 0.5F))) << "no speck";
    EXPECT_FALSE(find_far_part(with_line(40, 1.3F, 0.001F))) << "not far";
    EXPECT_FALSE(find_far_part(with_line(10, 2, 0.001F))) << "one of few";
    EXPECT_FALSE(find_far_part(extract_lines(sheet(40))));
    const auto far = find_far_part(with_line(40, 8, 0.5F));
    ASSERT_TRUE(far) << "so far that the model is small";
    EXPECT_TRUE(is_left_out(*far));
}

} // namespace
} // namespace lineatlas::test
