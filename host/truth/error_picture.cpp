#include <array>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "drawing_errors.hpp"

namespace lineatlas {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb grey{150, 150, 150}, red{230, 0, 0}, blue{0, 60, 255};

/// White paper on which points are coloured.
class Sheet {
  public:
    Sheet(glm::ivec2 size, int scale) : scale_(scale) {
        image_.size = size * scale;
        image_.channels = 3;
        image_.pixels.assign(static_cast<std::size_t>(image_.size.x) *
                                 static_cast<std::size_t>(image_.size.y) * 3,
                             255);
    }

    /// A square of 2 `radius` + 1 pixels of the sheet.
    void dot(glm::dvec2 at, const Rgb& color, int radius) {
        const glm::ivec2 middle{glm::floor(at * double(scale_))};
        const glm::ivec2 low = glm::max(middle - radius, glm::ivec2{0});
        const glm::ivec2 high = glm::min(middle + radius, image_.size - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) set({x, y}, color);
    }

    /// The colours of another picture, its dark half grey.
    void copy(const Image& picture) {
        for (int y = 0; y < image_.size.y; ++y) {
            for (int x = 0; x < image_.size.x; ++x) {
                const std::size_t from = (static_cast<std::size_t>(y / scale_) *
                                              static_cast<std::size_t>(picture.size.x) +
                                          static_cast<std::size_t>(x / scale_)) *
                                         static_cast<std::size_t>(picture.channels);
                const auto lightened = static_cast<std::uint8_t>(
                    grey[0] + picture.pixels[from] * (255 - grey[0]) / 255);
                set({x, y}, {lightened, lightened, lightened});
            }
        }
    }

    void mark(const DrawingErrors& errors) {
        for (const WrongPoint& point : errors.missed) dot(glm::dvec2{point.at}, blue, 1);
        for (const WrongPoint& point : errors.false_drawn) dot(glm::dvec2{point.at}, red, 1);
    }

    Image take() { return std::move(image_); }

  private:
    void set(glm::ivec2 at, const Rgb& color) {
        const std::size_t pixel =
            static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image_.size.x) +
            static_cast<std::size_t>(at.x);
        for (std::size_t i = 0; i < 3; ++i) image_.pixels[3 * pixel + i] = color[i];
    }

    int scale_;
    Image image_;
};

} // namespace

Image error_picture(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                    const DrawingErrors& errors, int scale) {
    Sheet sheet{truth.size(), scale};
    for (const DrawnPiece& piece : drawn) {
        const int steps = 1 + static_cast<int>(glm::distance(piece.from, piece.to) * scale * 1.5);
        for (int i = 0; i <= steps; ++i)
            sheet.dot(glm::mix(piece.from, piece.to, double(i) / steps), grey, 0);
    }
    sheet.mark(errors);
    return sheet.take();
}

Image error_picture(const Image& picture, const DrawingErrors& errors, int scale) {
    Sheet sheet{picture.size, scale};
    sheet.copy(picture);
    sheet.mark(errors);
    return sheet.take();
}

} // namespace lineatlas
