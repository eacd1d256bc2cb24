// Pixels by kernels, laid over a picture.

#include "glpasses/layer_pass.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"

namespace lineatlas::test {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

class LayerTest : public testing::Test {
  protected:
    /// The pixels laid over a picture of (200, 100, 50, 255); rows from the top.
    std::vector<Pixel> over(const std::vector<Pixel>& pixels, glm::ivec2 size,
                            const TexelRectangle& part, glm::ivec2 origin) {
        const gl::Buffer buffer = gl::Buffer::create();
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(pixels.size() * sizeof(Pixel)),
                             pixels.data(), 0);
        canvas_.clear({200 / 255.0F, 100 / 255.0F, 50 / 255.0F, 1});
        pass_.draw(buffer.id(), size, part, canvas_.framebuffer(), origin);
        const std::vector<std::uint8_t> bytes = canvas_.read();
        std::vector<Pixel> result(bytes.size() / 4);
        for (std::size_t i = 0; i < bytes.size(); ++i) result[i / 4][i % 4] = bytes[i];
        return result;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{61, 37}};
    gl::LayerPass pass_;
};

TEST_F(LayerTest, PremultipliedPixelsLieOverThePicture) {
    const std::vector<Pixel> pixels{{0, 0, 0, 0}, {10, 20, 30, 255}, {60, 30, 0, 102}};
    const std::vector<Pixel> shown = over(pixels, {3, 1}, {{0, 0}, {3, 1}}, {0, 0});
    const Pixel* lowest = &shown[std::size_t{36} * 61];
    EXPECT_EQ(lowest[0], (Pixel{200, 100, 50, 255})) << "what is transparent leaves all";
    EXPECT_EQ(lowest[1], (Pixel{10, 20, 30, 255}));
    EXPECT_EQ(lowest[2], (Pixel{180, 90, 30, 255})) << "three fifths shine through";
    EXPECT_EQ(lowest[3], (Pixel{200, 100, 50, 255})) << "beside the layer";
}

TEST_F(LayerTest, ThePartIsDrawnPixelByPixelAndNothingElse) {
    constexpr glm::ivec2 size{47, 29}, origin{5, 3};
    std::vector<Pixel> pixels;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x)
            pixels.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7, 255});
    }
    const TexelRectangle part{{4, 9}, {40, 29}};
    const std::vector<Pixel> shown = over(pixels, size, part, origin);
    for (int y = 0; y < 37; ++y) {
        for (int x = 0; x < 61; ++x) {
            const glm::ivec2 at = glm::ivec2{x, y} - origin;
            const bool drawn = at.x >= part.low.x && at.y >= part.low.y && at.x < part.high.x &&
                               at.y < part.high.y;
            const Pixel expected = drawn ? Pixel{static_cast<std::uint8_t>(at.x),
                                                 static_cast<std::uint8_t>(at.y), 7, 255}
                                         : Pixel{200, 100, 50, 255};
            ASSERT_EQ(shown[static_cast<std::size_t>((36 - y) * 61 + x)], expected)
                << x << ", " << y;
        }
    }
}

TEST_F(LayerTest, AnEmptyPartDrawsNothing) {
    const std::vector<Pixel> shown = over({{1, 2, 3, 255}}, {1, 1}, {{0, 0}, {0, 1}}, {0, 0});
    for (const Pixel& pixel : shown) ASSERT_EQ(pixel, (Pixel{200, 100, 50, 255}));
}

} // namespace
} // namespace lineatlas::test
