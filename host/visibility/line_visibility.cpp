#include "lineatlas/visibility.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "compute/choose_device.hpp"
#include "compute/opencl/device_trial.hpp"
#include "core/check_camera.hpp"
#include "core/check_lines.hpp"
#include "core/contact.hpp"
#include "core/standard_camera.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "moving_tables.hpp"
#include "picking.hpp"
#include "trial_lines.hpp"

namespace lineatlas {
namespace {

void check(const VisibilityOptions& options) {
    if (!(options.step >= finest_step && options.step <= longest_step)) {
        std::array<char, 32> number{}; // the shortest that is this float
        const char* end =
            std::to_chars(number.data(), number.data() + number.size(), options.step).ptr;
        throw UsageError("step must be a number from 0.01 to 10000 pixels, not " +
                         std::string(static_cast<const char*>(number.data()), end));
    }
    if (!(options.outline_depth >= 0) || !std::isfinite(options.outline_depth))
        throw UsageError("outline_depth must be a finite number of pixels, at least 0");
    if (!(options.centre_overhang >= 0) || !std::isfinite(options.centre_overhang))
        throw UsageError("centre_overhang must be a finite number of pixels, at least 0");
}

/// Finds intervals of the trial lines, to try a device.
void find_trial_lines(const DeviceOptions& options) {
    const LineSet lines = trial_lines();
    LineVisibility{lines, options}.find(trial_camera(lines), {.outlines = true});
}

} // namespace

class LineVisibility::State {
    friend class LineVisibility;

    void check_ready(const Camera& camera) const {
        if (!tables_)
            throw UsageError(
                "visibility: there are no lines, as set_lines() failed; call it again");
        check_camera(camera);
    }

    LineView view_by(const StandardCamera& standard, LineKindMask kinds, float step,
                     float overhang) const {
        return {.camera = standard.camera,
                .bounds = motion_->bounds(),
                .contact = contact_,
                .lines = kinds,
                .step = step,
                .centre_overhang = overhang,
                .tracer = moving_ ? nullptr : tables_->tracer.get()};
    }

    /// Runs an action on the tables of the lines.
    template <class Action>
    auto work(const Action& action) {
        try {
            const PlacedLines lines = place();
            if (!work_) work_.emplace(stages_, lines);
            auto result = action(*work_, lines);
            if (one_picture_) work_.reset(); // later work takes memory, too
            return result;
        } catch (...) {
            work_.reset(); // half made
            throw;
        }
    }

  public:
    explicit State(const DeviceOptions& options) : State(compute::find_device(options), options) {}

    void set_lines(const LineSet& lines) {
        check_lines(lines);
        tables_.reset();
        moving_.reset();
        normals_ = {};
        moved_ = false;
        work_.reset();
        tables_ = upload_lines(*device_, lines);
        motion_.emplace(lines);
        triangle_count_ = static_cast<std::uint32_t>(lines.triangles.size());
        contact_ = contact_of(lines);
    }

    std::vector<Interval> find(const Camera& camera, const VisibilityOptions& options,
                               const Progress& progress) {
        check_ready(camera);
        check(options);
        outlines_.clear();
        const ExactIntervals::Wanted wanted{.hidden = options.hidden,
                                            .outlines = options.outlines ? &outlines_ : nullptr,
                                            .outline_depth = options.outline_depth};
        return work([&](ExactIntervals& found, const PlacedLines& lines) {
            const StandardCamera standard = standard_camera(camera, motion_->bounds());
            return found.find(
                lines, view_by(standard, options.lines, options.step, options.centre_overhang),
                wanted, {progress, "finding what is visible"});
        });
    }

    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             LineKindMask kinds) {
        check_ready(camera);
        check_pick(position, radius);
        return work([&](ExactIntervals& found, const PlacedLines& lines) {
            const StandardCamera standard = standard_camera(camera, motion_->bounds());
            return lineatlas::pick(found, *device_, lines, motion_->objects(),
                                   view_by(standard, kinds, finest_step, 0), position, radius);
        });
    }

  private:
    SceneMotion& motion() {
        if (!tables_)
            throw UsageError("visibility: there are no lines to move; call set_lines() first");
        return *motion_;
    }

    /// The lines where they are now.
    PlacedLines place() {
        if (moved_) {
            if (!moving_) moving_.emplace(stages_, *tables_, *motion_);
            moving_->move(*tables_, *motion_, normals_);
            moved_ = false;
        }
        return {*tables_, moving_ ? moving_->vertices() : *tables_->vertices,
                motion_->vertex_count(), triangle_count_, moving_ ? moving_->corners() : nullptr};
    }

    State(const compute::FoundDevice& found, const DeviceOptions& options)
        : device_(compute::make_device(found, options)), stages_(*device_),
          one_picture_(options.one_picture) {
        compute::try_device(*device_, "visibility", find_trial_lines);
    }

    std::unique_ptr<compute::Device> device_;
    compute::Stages stages_;
    bool one_picture_;
    std::optional<LineTables> tables_;
    std::optional<SceneMotion> motion_;  ///< of the lines
    std::optional<MovingTables> moving_; ///< from the first motion on
    ContourNormals normals_;
    bool moved_ = false; ///< since place()
    std::uint32_t triangle_count_ = 0;
    float contact_ = 0;
    std::vector<OutlinePart> outlines_;  ///< of the last find()
    std::optional<ExactIntervals> work_; ///< for the lines; made when they are first looked at
};

LineVisibility::LineVisibility(const LineSet& lines, const DeviceOptions& options)
    : state_(std::make_unique<State>(options)) {
    state_->set_lines(lines);
}

LineVisibility::~LineVisibility() = default;
LineVisibility::LineVisibility(LineVisibility&&) noexcept = default;
LineVisibility& LineVisibility::operator=(LineVisibility&&) noexcept = default;

std::string LineVisibility::description() const {
    return state_->device_->description();
}

void LineVisibility::set_lines(const LineSet& lines) {
    state_->set_lines(lines);
}

void LineVisibility::set_lines(const Assembly& parts) {
    state_->set_lines(parts.lines());
}

void LineVisibility::set_transforms(std::span<const glm::mat4> world_from_object) {
    state_->motion().set_transforms(world_from_object);
    state_->moved_ = true;
}

void LineVisibility::set_positions(std::uint32_t first, std::span<const glm::vec3> positions) {
    state_->motion().set_positions(first, positions);
    const LineTables& tables = *state_->tables_;
    state_->device_->upload(*tables.vertices, std::as_bytes(positions), first * sizeof(glm::vec3));
    state_->normals_.expect(state_->stages_, tables, state_->triangle_count_);
    state_->moved_ = true;
}

void LineVisibility::set_hidden(std::span<const std::uint32_t> objects) {
    state_->motion().set_hidden(objects);
    state_->moved_ = true;
}

const std::vector<OutlinePart>& LineVisibility::outlines() const {
    return state_->outlines_;
}

std::vector<Interval> LineVisibility::find(const Camera& camera, const VisibilityOptions& options,
                                           const Progress& progress) {
    return state_->find(camera, options, progress);
}

std::optional<Pick> LineVisibility::pick(const Camera& camera, glm::vec2 position, float radius,
                                         LineKindMask lines) {
    return state_->pick(camera, position, radius, lines);
}

} // namespace lineatlas
