#include "stroke_coverage.hpp"

#include <algorithm>

#include "core/pens.hpp"
#include "frame_forms.hpp"
#include "glpasses/storage.hpp"

namespace lineatlas {
namespace {

// A first guess; a frame that needs more makes the table grow.
constexpr std::uint32_t first_entry_capacity = 1U << 14U;

// If there is less than one run for this many pixels, GL draws the runs in less time than a pass
// over the picture takes.
constexpr std::uint64_t pixels_per_run = 128;

std::uint32_t end_kinds(const Pen& pen, bool hidden, bool exact_ends) {
    const bool fades = pen.cap == Cap::butt && pen.path_cap == Cap::round;
    return (pen.join == Join::round ? LA_STROKES_ROUND_JOINS : 0) |
           (pen.cap == Cap::round ? LA_STROKES_ROUND_CAPS : 0) |
           (pen.path_cap == Cap::round ? LA_STROKES_ROUND_PATHS : 0) |
           (exact_ends || hidden || !fades ? LA_STROKES_EXACT_ENDS : 0);
}

} // namespace

StrokeCoverage::StrokeCoverage(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()),
      sharing_(*connection.sharing), lists_{Lists{device_}, Lists{device_}},
      coverage_(sharing_, compute::table::coverage), shown_(sharing_, compute::table::shown_tiles) {
}

bool StrokeCoverage::wants(const Frame& frame) const {
    if (!wants_stroke_kernels(frame.options, frame.automatic)) return false;
    std::size_t layers = 0;
    for (const bool hidden : {false, true}) {
        if (hidden && !has_hidden_) continue;
        layers += pens_->pens(hidden).size();
        if (!std::ranges::all_of(pens_->pens(hidden), is_plain)) return false;
    }
    return layers <= gl::CoveragePass::most_layers && has_bytes(frame.framebuffer);
}

void StrokeCoverage::begin_frame(Frame& frame, const RunPens& pens) {
    pens_ = &pens;
    has_hidden_ = frame.options.draw && frame.options.style.hidden;
    draws_ = can_draw_ = wants(frame);
    const auto pixels = static_cast<std::uint64_t>(frame.camera.size.x) *
                        static_cast<std::uint64_t>(frame.camera.size.y);
    const bool leaves_few =
        frame.options.forms.strokes == StageForm::automatic && frame.automatic.waits_freely;
    fewest_runs_ = leaves_few ? pixels / pixels_per_run : 0;
    if (!draws_ || !coverage_) return;
    for (interop::SharedTable* table : {&coverage_, &shown_})
        table->compute(); // while GL has nothing to do
}

void StrokeCoverage::list(const Frame& frame, bool hidden, const compute::RunTable& runs,
                          float half_width, bool late) {
    Lists& own = lists(hidden);
    if (own.capacity == 0)
        own.capacity = compute::first_capacity<la_uint>(device_, first_entry_capacity);
    own.ends.fit(compute::stroke_ends(device_.tuning(), frame.viewport()) * sizeof(la_uint));
    own.entries.fit(std::uint64_t{own.capacity} * sizeof(la_uint));
    own.total_on_device.fit(sizeof(la_uint));
    stages_.list_strokes({.runs = runs,
                          .viewport = frame.viewport(),
                          .half_width = half_width,
                          .lists = tables(hidden)});
    const auto total = std::as_writable_bytes(std::span{&own.total, 1});
    if (late)
        device_.begin_download(*own.total_on_device, total);
    else
        device_.download(*own.total_on_device, total);
}

bool StrokeCoverage::grow() {
    bool grown = false;
    for (Lists& own : lists_) {
        if (!draws_ || own.total <= own.capacity) continue;
        own.capacity = compute::capacity_for<la_uint>(device_, own.total);
        grown = true;
    }
    return grown;
}

std::uint32_t StrokeCoverage::hidden_layers() const {
    return has_hidden_ ? static_cast<std::uint32_t>(pens_->pens(true).size()) : 0;
}

void StrokeCoverage::begin_drawing(Frame& frame) {
    const PictureTile& part = frame.tile;
    const auto pixels =
        static_cast<std::size_t>(part.size.x) * static_cast<std::size_t>(part.size.y);
    const std::size_t layers = hidden_layers() + pens_->pens(false).size();
    const compute::TileRange tiles = compute::part_tiles(part);
    const auto tile_count = static_cast<std::size_t>(tiles.count.x * tiles.count.y);
    gl::check_buffer_texture(layers * pixels, purpose::strokes);
    coverage_.fit(layers * pixels);
    shown_.fit(layers * tile_count * sizeof(la_uint));
    layers_ = {.coverage = 0,
               .shown = 0,
               .pitch = pixels,
               .part = part,
               .first_tile = tiles.first,
               .tile_count = tiles.count};
}

const StrokeCoverage::Mark& StrokeCoverage::mark(const Pen& pen) {
    const auto found = marks_.find({pen.mark, pen.width});
    if (found != marks_.end()) return found->second;
    const PenMark painted = make_pen(pen.mark, pen.width);
    const auto columns = static_cast<std::size_t>(painted.size.x);
    Mark made{.values = compute::Table{device_, compute::table::mark},
              .length = static_cast<std::uint32_t>(columns),
              .repeat_length = painted.repeat_length};
    if (columns > 0) {
        std::vector<float> values;
        for (std::size_t i = 0; i < columns + 2; ++i) {
            const std::uint8_t value = painted.coverage[(i + columns - 1) % columns];
            values.push_back(static_cast<float>(value) / 255);
        }
        made.values.upload(std::span<const float>{values});
    }
    return marks_.emplace(std::pair{pen.mark, pen.width}, std::move(made)).first->second;
}

void StrokeCoverage::draw(Frame& frame, bool hidden, const compute::RunTable& runs,
                          compute::Buffer& alpha, compute::Buffer* weights, bool exact_ends,
                          bool again) {
    frame.clock(hidden ? "strokes hidden" : "strokes", [&] {
        const std::vector<Pen>& pens = pens_->pens(hidden);
        for (std::uint32_t i = 0; i < pens.size(); ++i) {
            const Pen& pen = pens[i];
            const Mark& own = mark(pen);
            stages_.draw_strokes({.runs = runs,
                                  .lists = tables(hidden),
                                  .alpha = alpha,
                                  .viewport = frame.viewport(),
                                  .part = layers_.part,
                                  .half_width = 0.5F * pen.width,
                                  .opacity = pen.opacity,
                                  .end_kinds = end_kinds(pen, hidden, exact_ends),
                                  .hidden = hidden,
                                  .pen = pens.size() > 1 ? i : LA_ALL_PENS,
                                  .mark = own.values.get(),
                                  .mark_length = own.length,
                                  .repeat_length = own.repeat_length,
                                  .weights = weights,
                                  .again = again,
                                  .coverage = coverage_.compute(),
                                  .shown = shown_.compute(),
                                  .layer = i + (hidden ? 0 : hidden_layers()),
                                  .pitch = static_cast<std::uint32_t>(layers_.pitch)});
        }
    });
}

void StrokeCoverage::pass_to_gl() {
    sharing_.to_gl({&coverage_, &shown_});
}

void StrokeCoverage::show(Frame& frame) {
    layers_.coverage = coverage_.gl();
    layers_.shown = shown_.gl();
    std::array<glm::vec4, gl::CoveragePass::most_layers> colors{};
    std::size_t count = 0;
    for (const bool hidden : {true, false}) { // all hidden lines lie below all visible ones
        if (hidden && !has_hidden_) continue;
        for (const Pen& pen : pens_->pens(hidden)) colors[count++] = glm::vec4{pen.color, 1};
    }
    frame.clock.gl("strokes", [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
        pass_.draw(layers_, std::span{colors}.first(count), frame.camera.origin);
    });
}

} // namespace lineatlas
