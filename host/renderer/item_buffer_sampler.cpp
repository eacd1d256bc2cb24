#include "item_buffer_sampler.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

namespace lineatlas {
namespace {

/// A line on the raster. Columns are counted along its major axis, rows across it. A line is drawn
/// in the columns whose centre it crosses, and at least in one column. So lines that follow each
/// other share no column.
class RasterLine {
  public:
    RasterLine(const ClippedSegment& segment, glm::ivec2 size)
        : p_(window_position(segment.p, size)), d_(window_position(segment.q, size) - p_) {
        axis_ = std::abs(d_.x) >= std::abs(d_.y) ? 0 : 1;
        const float length = std::abs(d_[axis_]);
        slope_ = length > 0.0F ? d_[1 - axis_] / d_[axis_] : 0.0F;
        const float low = std::min(p_[axis_], p_[axis_] + d_[axis_]);
        first_ = std::max(column_from(low), 0);
        last_ = std::min(column_from(low + length), size[axis_]);
        if (first_ >= last_) {
            first_ =
                std::clamp(static_cast<int>(std::floor(low + 0.5F * length)), 0, size[axis_] - 1);
            last_ = first_ + 1;
        }
    }

    int axis() const { return axis_; }
    /// The columns of the piece from `from` to `to`, 0 to 1 along the line: the first, and one past
    /// the last. One at least.
    glm::ivec2 columns(float from, float to) const {
        const float a = p_[axis_] + d_[axis_] * from;
        const float b = p_[axis_] + d_[axis_] * to;
        const glm::ivec2 columns{std::max(column_from(std::min(a, b)), first_),
                                 std::min(column_from(std::max(a, b)), last_)};
        if (columns.x < columns.y) return columns;
        const int middle = column_at(0.5F * (from + to));
        return {middle, middle + 1};
    }
    int column_at(float u) const {
        const auto column = static_cast<int>(std::floor(p_[axis_] + d_[axis_] * u));
        return std::clamp(column, first_, last_ - 1);
    }
    /// Place across the line at a column's centre.
    float row_at(int column) const { return point_at(centre(column))[1 - axis_]; }

    /// The line as it must be drawn. By the diamond-exit rule it has to cross the centre of its
    /// last column by half a texel, and must not reach the centre of the next column. Rounding
    /// decides about ends on a centre.
    gl::ItemLine ends(glm::ivec2 size) const {
        const bool forward = d_[axis_] >= 0.0F;
        const float before = forward ? -0.25F : 0.25F;
        const float start = centre(forward ? first_ : last_ - 1) + before;
        const float end = centre(forward ? last_ : first_ - 1) + before;
        return {to_ndc(point_at(start), size), to_ndc(point_at(end), size)};
    }

  private:
    /// Window position; depth from -1 to 1.
    static glm::vec3 window_position(const float* clip, glm::ivec2 size) {
        const glm::vec3 ndc = glm::make_vec3(clip) / clip[3];
        return {(glm::vec2{ndc} + 1.0F) * (glm::vec2{size} * 0.5F), ndc.z};
    }
    static glm::vec3 to_ndc(glm::vec3 window, glm::ivec2 size) {
        return {glm::vec2{window} * (2.0F / glm::vec2{size}) - 1.0F, window.z};
    }
    static float centre(int column) { return static_cast<float>(column) + 0.5F; }
    /// The first column whose centre does not lie before `place`.
    static int column_from(float place) { return static_cast<int>(std::ceil(place - 0.5F)); }

    /// The point of the line at a place along the major axis. Beyond an end the line goes on at the
    /// depth of that end, because the slope of a short line may lead far away.
    glm::vec3 point_at(float place) const {
        const float along = place - p_[axis_];
        const float u = d_[axis_] != 0.0F ? std::clamp(along / d_[axis_], 0.0F, 1.0F) : 0.0F;
        glm::vec3 point;
        point[axis_] = place;
        point[1 - axis_] = p_[1 - axis_] + slope_ * along;
        point.z = p_.z + d_.z * u;
        return point;
    }

    glm::vec3 p_, d_;
    int axis_, first_, last_;
    float slope_;
};

/// Looks for one line in the ID images.
class LineSearch {
  public:
    LineSearch(const gl::ItemImages& images, std::uint32_t id, const RasterLine& line)
        : images_(images), line_(line), id_(id), rows_(images.size[1 - line.axis()]),
          column_stride_(line.axis() == 0 ? 1 : images.size.x),
          row_stride_(line.axis() == 0 ? images.size.x : 1) {}

    /// Whether the line is seen in the middle of its piece from `from` to `to`, 0 to 1 along it.
    std::uint8_t is_seen(float from, float to) const {
        const int column = line_.column_at(0.5F * (from + to));
        return found_in(column, lowest_row(column)) > 0 ? 255 : 0;
    }

    /// The seen share of the line's piece from `from` to `to`.
    std::uint8_t share_seen(float from, float to) const {
        const glm::ivec2 columns = line_.columns(from, to);
        int found = 0;
        int covered = 0;
        for (int column = columns.x; column < columns.y; ++column) {
            const int row = lowest_row(column);
            const int in_image = std::min(row + images_.line_width, rows_) - std::max(row, 0);
            const int width = std::max(in_image, 1);
            covered += width;
            found += std::min(found_in(column, row), width);
        }
        return static_cast<std::uint8_t>((found * 255 + covered / 2) / covered);
    }

  private:
    /// The lowest row that the line covers in a column: the line is `line_width` texels high,
    /// around its spine.
    int lowest_row(int column) const {
        const float half = 0.5F * static_cast<float>(images_.line_width - 1);
        return static_cast<int>(std::floor(line_.row_at(column) - half));
    }
    /// Texels of a column that hold the line. One more row on either side is looked at, because the
    /// raster may round another way.
    int found_in(int column, int row) const {
        const int first = std::max(row - 1, 0);
        const int last = std::min(row + images_.line_width + 1, rows_);
        std::ptrdiff_t texel =
            std::ptrdiff_t{column} * column_stride_ + std::ptrdiff_t{first} * row_stride_;
        int found = 0;
        for (int r = first; r < last; ++r, texel += row_stride_) {
            for (std::uint32_t layer = 0; layer < images_.layers; ++layer) {
                const std::uint32_t id = images_.texels[layer][texel];
                if (id == id_) ++found;
                if (id == id_ || id == 0) break; // nothing lies behind an empty texel
            }
        }
        return found;
    }

    const gl::ItemImages& images_;
    const RasterLine& line_;
    std::uint32_t id_;
    int rows_;
    std::ptrdiff_t column_stride_, row_stride_;
};

} // namespace

void ItemBufferSampler::fill_lines(glm::ivec2 size) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < lines_.clipped.size(); ++i)
        count += lines_.samples(i) > 0 ? 1U : 0U;
    auto next = pass_.map_lines(count).begin();
    for (std::size_t i = 0; i < lines_.clipped.size(); ++i) {
        if (lines_.samples(i) > 0) *next++ = RasterLine{lines_.clipped[i], size}.ends(size);
    }
}

void ItemBufferSampler::walk(const gl::ItemImages& images) {
    alpha_.clear();
    alpha_.reserve(lines_.offsets.back());
    const bool partial = images.layers > 1;
    std::uint32_t id = 0;
    for (std::size_t i = 0; i < lines_.clipped.size(); ++i) {
        const std::uint32_t l = lines_.samples(i);
        if (l == 0) continue;
        const RasterLine line{lines_.clipped[i], images.size};
        const LineSearch search{images, ++id, line};
        const float inverse_l = 1.0F / static_cast<float>(l);
        for (std::uint32_t j = 0; j < l; ++j) {
            const float from = static_cast<float>(j) * inverse_l;
            const float to = static_cast<float>(j + 1) * inverse_l;
            alpha_.push_back(partial ? search.share_seen(from, to) : search.is_seen(from, to));
        }
    }
}

std::span<const std::uint8_t> ItemBufferSampler::sample(const Frame& frame) {
    const auto scale = static_cast<int>(frame.probes_per_axis());
    const gl::ItemBufferShape shape{.viewport = frame.camera.size,
                                    .scale = scale,
                                    .layers = scale > 1 ? gl::ItemBufferPass::max_layers : 1};
    fill_lines(shape.size());
    const gl::ItemImages images =
        pass_.draw(frame.scene.gl_triangles(), frame.camera.clip_from_world(), shape);
    walk(images);
    pass_.unmap_images();
    return alpha_;
}

} // namespace lineatlas
