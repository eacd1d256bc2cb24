#include "lineatlas/visibility.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "compute/choose_device.hpp"
#include "core/limits.hpp"
#include "core/picture_size.hpp"
#include "core/standard_camera.hpp"
#include "exact_lines.hpp"
#include "interval_table.hpp"
#include "lineatlas/error.hpp"
#include "outline_parts.hpp"

namespace lineatlas {
namespace {

void check(const VisibilityOptions& options) {
    if (!(options.step >= finest_step) || !std::isfinite(options.step)) {
        throw UsageError("step must be a number of pixels of at least 0.01");
    }
    if (!(options.outline_depth >= 0) || !std::isfinite(options.outline_depth))
        throw UsageError("outline depth must be a number of pixels of at least 0");
}

} // namespace

class LineVisibility::State {
  public:
    explicit State(const DeviceOptions& options) : State(compute::find_device(options), options) {}

    std::string description() const { return device_->description(); }

    void set_lines(const LineSet& lines) {
        tables_.reset();
        work_.reset();
        tables_ = upload_lines(*device_, lines);
        triangle_count_ = static_cast<std::uint32_t>(lines.triangles.size());
        bounds_ = lines.bounds;
    }

    std::vector<Interval> find(const Camera& camera, const VisibilityOptions& options) {
        if (!tables_) throw UsageError("visibility: there are no lines; set_lines() has failed");
        check(options);
        check_picture(camera.size);
        try {
            return find_checked(camera, options);
        } catch (...) {
            work_.reset(); // half made
            throw;
        }
    }

    const std::vector<OutlinePart>& outlines() const { return outlines_; }

  private:
    State(const compute::FoundDevice& found, const DeviceOptions& options)
        : device_(compute::make_device(found, options)), stages_(*device_) {}

    /// What a call leaves to the next: tables that have grown.
    struct Work {
        explicit Work(compute::Stages& stages) : lines(stages), intervals(stages.device()) {}
        ExactLines lines;
        IntervalTable intervals;
    };

    std::vector<Interval> find_checked(const Camera& camera, const VisibilityOptions& options) {
        if (!work_) {
            work_.emplace(stages_);
            work_->lines.make_tables(triangle_count_, tables_->most_segments());
        }
        const StandardCamera standard = standard_camera(camera, bounds_);
        const LineView view{.camera = standard.camera,
                            .bounds = bounds_,
                            .diagonal = glm::distance(bounds_.min, bounds_.max),
                            .lines = options.lines,
                            .step = options.step};
        const std::size_t chunks = tables_->chunks.size();
        IntervalTable& intervals = work_->intervals;
        intervals.begin_frame(true);
        outlines_.clear();
        const auto at_once = [](const char*, const auto& action) { action(); };
        work_->lines.find(
            view, chunks, [&](std::size_t chunk) { return table(chunk); }, at_once,
            [&](std::size_t chunk, const compute::SegmentTable& segments,
                const compute::SpanTable& spans) {
                do {
                    find_intervals(view, segments, spans, options.hidden);
                } while (intervals.grow());
                const SegmentRange range = tables_->chunks[chunk].range;
                if (options.outlines) {
                    add_outline_parts(*device_, work_->lines.outline(options.outline_depth),
                                      intervals.read_table(), work_->lines.order(), range.first,
                                      segments.segment_count, outlines_);
                }
                if (chunks == 1) return;
                intervals.keep(range.first, work_->lines.order(), {});
            });
        return intervals.read(work_->lines.order(), {});
    }

    void find_intervals(const LineView& view, const compute::SegmentTable& segments,
                        const compute::SpanTable& spans, bool hidden) {
        const IntervalTable::Room room = work_->intervals.room();
        stages_.span_intervals({.table = segments,
                                .clipped = work_->lines.clipped(),
                                .spans = spans,
                                .viewport = view.viewport(),
                                .hidden_too = hidden,
                                .intervals = room.intervals,
                                .interval_capacity = room.capacity,
                                .total = room.total});
        work_->intervals.read_total();
    }

    compute::SegmentTable table(std::size_t chunk) const {
        const LineTables::Chunk& part = tables_->chunks[chunk];
        return {*tables_->vertices, *tables_->triangles, *part.segments,
                triangle_count_,    part.range.count,    part.candidates()};
    }

    std::unique_ptr<compute::Device> device_;
    compute::Stages stages_;
    std::optional<LineTables> tables_;
    std::uint32_t triangle_count_ = 0;
    Bounds bounds_;
    std::vector<OutlinePart> outlines_; ///< of the last find()
    std::optional<Work> work_;          ///< for the lines; made when they are first looked at
};

LineVisibility::LineVisibility(const LineSet& lines, const DeviceOptions& options)
    : state_(std::make_unique<State>(options)) {
    state_->set_lines(lines);
}

LineVisibility::~LineVisibility() = default;
LineVisibility::LineVisibility(LineVisibility&&) noexcept = default;
LineVisibility& LineVisibility::operator=(LineVisibility&&) noexcept = default;

std::string LineVisibility::description() const {
    return state_->description();
}

void LineVisibility::set_lines(const LineSet& lines) {
    state_->set_lines(lines);
}

const std::vector<OutlinePart>& LineVisibility::outlines() const {
    return state_->outlines();
}

std::vector<Interval> LineVisibility::find(const Camera& camera, const VisibilityOptions& options) {
    return state_->find(camera, options);
}

} // namespace lineatlas
