#include "session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cameras/camera_file.hpp"
#include "command_line/joined_models.hpp"
#include "command_line/style_options.hpp"
#include "io/extension.hpp"
#include "io/isolated.hpp"
#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/style_files.hpp"
#include "saving.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {

namespace {

/// The times at which files were written; empty if one does not exist.
std::vector<std::filesystem::file_time_type>
write_times_of(const std::vector<std::filesystem::path>& files) {
    std::vector<std::filesystem::file_time_type> times;
    for (const std::filesystem::path& file : files) {
        std::error_code failure;
        times.push_back(std::filesystem::last_write_time(file, failure));
        if (failure) return {};
    }
    return times;
}

} // namespace

namespace {

/// Tables keep the size that the largest model has given them.
bool is_much_smaller(const LineSet& lines, const Model* before) {
    return before != nullptr && 4 * lines.segments.size() < before->lines.segments.size();
}

} // namespace

bool same(const View& a, const View& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov_y == b.fov_y &&
           a.projection == b.projection;
}

Session::Session(const DeviceOptions& device, ImageWriter& writer, SharedContext& context,
                 std::function<void()> wake)
    : loader(wake), writer_(writer), device_(device), drawing_(context, wake) {
    if (attempt([&] { make_renderer(); })) return;
    device_ = {.compute = "cpp"}; // needs nothing
    make_renderer();
}

Session::~Session() {
    finish_saving();
    drawing_.run([&] {
        picture_.reset();
        shown_ = {};
        spare_ = {};
        preview_ = {};
        preview_before_ = {};
        sketch_.reset();
        in_renderer_.reset();
        renderer_.reset();
    });
}

void Session::make_renderer() {
    drawing_.run([&] {
        renderer_.reset(); // frees its memory first
        renderer_ = std::make_unique<Renderer>(device_);
        description_ = describe_device();
    });
}

std::string Session::describe_device() const {
    const std::string note = renderer_->note();
    return renderer_->description() + (note.empty() ? "" : "; " + note);
}

/// Runs an action and reports its failure.
bool Session::attempt(const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const std::bad_alloc&) {
        messages.error("There is not enough memory for that");
    } catch (const std::exception& error) {
        messages.error(in_words_of_the_tool(error.what()));
    }
    return false;
}

void Session::open(const std::vector<std::filesystem::path>& files) {
    std::vector<std::filesystem::path> models;
    for (const std::filesystem::path& file : files) {
        const std::string extension = lower_extension(file);
        if (extension == ".toml") {
            bool session = false;
            if (!attempt([&] { session = is_session(file); })) continue;
            session ? open_session(file) : use_style(file.string());
        } else if (extension == ".json") {
            open_camera(file);
        } else {
            models.push_back(file);
        }
    }
    if (!models.empty()) open_models(models);
}

void Session::open_models(const std::vector<std::filesystem::path>& files) {
    ModelSource source{
        .files = {}, .scene = {}, .up = up, .lines = line_options, .read = read_limits};
    const Model* before = coming_ ? coming_->model.get() : model_.get();
    const bool added = adds && before != nullptr && !before->source.files.empty();
    if (added) source = before->source;
    source.files.insert(source.files.end(), files.begin(), files.end());
    if (source.files.size() > most_models)
        return messages.error(fmt::format("A scene has {} files at most; open fewer", most_models));
    forget_awaited();
    if (added) await_the_same();
    // The file that was alone becomes a part with its name.
    if (added && before->source.files.size() == 1)
        for (std::string& pattern : awaited_.words->hidden)
            pattern = literal_pattern(before->source.name()) + "/" + pattern;
    loader.start(std::move(source));
}

/// Forgets the choices that wait for the next model, which then stands alone.
void Session::forget_awaited() {
    awaited_ = {};
}

void Session::reload() {
    if (model_ == nullptr || is_other_file_coming()) return;
    forget_awaited();
    await_the_same();
    loader.start(model_->source);
}

/// Makes the next model show the same parts and cuts as the one before it.
void Session::await_the_same() {
    awaited_ = {.words = is_other_file_coming() ? coming_->awaited.words.value_or(ShownInWords{})
                                                : in_words(),
                .keeps_view = true};
}

/// Whether a task takes a model that was read, and not the current one with other parts or cuts.
bool Session::is_other_file_coming() const {
    return coming_ && (model_ == nullptr || coming_->model->whole != model_->whole);
}

void Session::look_at_file() {
    if (model_ == nullptr || model_->source.files.empty() || loader.busy() || coming_) return;
    const WriteTimes times = write_times_of(model_->source.files);
    if (times.empty()) return; // the files may come back
    const bool at_rest = std::exchange(looked_times_, times) == times;
    if (times == read_times_ || !at_rest) return;
    read_times_ = times;
    reload();
}

void Session::look_at_kernels() {
    if (!kernels_.has_changed()) return;
    if (use_device(device_)) messages.notice("Kernels are built again");
}

bool Session::has_files_to_look_at() const {
    return kernels_.is_set() || (model_ != nullptr && !model_->source.files.empty());
}

void Session::open_scene(const std::string& name) {
    forget_awaited();
    loader.start({.files = {}, .scene = name, .up = glm::vec3{0, 1, 0}, .lines = line_options});
}

void Session::open_camera(const std::filesystem::path& file) {
    attempt([&] {
        const CameraPath path = read_camera_path(file, navigation.goal(), origin());
        navigation.glide_to(path.view(path.first_frame()));
    });
}

void Session::open_first_camera(const std::filesystem::path& file) {
    attempt([&] {
        read_camera_path(file, View{.up = up.value_or(glm::vec3{0, 1, 0})});
        first_camera_ = file;
    });
}

/// Returns the first camera once, when the model is there whose origin the camera refers to.
std::optional<View> Session::take_first_camera() {
    std::optional<View> view;
    const std::filesystem::path file = std::exchange(first_camera_, {});
    if (file.empty()) return view;
    attempt([&] {
        const CameraPath path =
            read_camera_path(file, View{.up = up.value_or(glm::vec3{0, 1, 0})}, origin());
        view = path.view(path.first_frame());
    });
    return view;
}

glm::dvec3 Session::origin() const {
    return model_ ? model_->origin : glm::dvec3{0};
}

void Session::load_pens(const Style& style) {
    const auto read = [&](const auto& path) { return read_image_isolated(path, read_limits); };
    const auto images = read_pen_images(style, {}, read);
    if (images.empty()) return; // the window need not wait for the drawing thread
    drawing_.run([&] {
        for (const auto& [mark, image] : images) renderer_->set_pen_image(mark, image);
    });
}

void Session::use_style(const std::string& name) {
    attempt([&] {
        const Style style = name.empty() ? default_style() : load_style(name);
        load_pens(style);
        settings.style = style;
        settings.style_name = name;
        changed();
    });
}

bool Session::use_device(const DeviceOptions& device) {
    drawing_.wait();
    take_picture(); // which is of the device before
    return attempt([&] {
        drawing_.run([&] {
            renderer_->set_device(device);
            sketch_.reset();
            description_ = describe_device();
        });
        device_ = device;
        sketched_.reset();
        timings.clear();
        timings_due_ = 0;
        changed();
    });
}

/// Gives the renderer the lines of a model, unless it has them. What draws a model calls this
/// first: the renderer may have those of another one. On the drawing thread.
void Session::give_lines(const std::shared_ptr<const Model>& model) {
    if (in_renderer_ == model) return;
    in_renderer_.reset();
    renderer_->set_lines(model->lines);
    in_renderer_ = model;
}

void Session::show(std::shared_ptr<Model> model) {
    const bool is_other = model_ != nullptr && model_->whole != model->whole;
    const bool renews = is_other && is_much_smaller(model->lines, model_.get());
    const bool is_new = model_ == nullptr || is_other;
    const auto work = [this, model, is_new, renews, device = device_,
                       options = frame_options(settings, 0)] {
        give_lines(model);
        if (renews) {
            renderer_->set_device(device);
            sketch_.reset();
        }
        // The first time on a computer this takes many seconds.
        const auto progress = [this](float done) {
            work_done_ = done;
            return !ends_;
        };
        if (is_new) renderer_->prepare(options, progress);
    };
    coming_ = {model, std::exchange(awaited_, {})};
    const auto then = [this](bool worked) {
        const Coming coming = *std::exchange(coming_, std::nullopt);
        if (worked) return take_shown(coming.model, coming.awaited);
        if (model_ != nullptr) settings.shown = model_->shown;
    };
    add_task({.what = is_new ? "Getting ready to draw" : "", .work = work, .then = then});
}

/// Shows a model whose lines the renderer has.
void Session::take_shown(const std::shared_ptr<Model>& model, const Awaited& awaited) {
    const std::shared_ptr<Model> before = std::exchange(model_, model);
    sketched_.reset();
    const bool new_parts = before == nullptr || before->whole != model_->whole;
    if (new_parts) {
        for (const std::filesystem::path& file : model_->source.files) recent.add(file);
        read_times_ = write_times_of(model_->source.files);
        selected.clear();
        pace_ = {};
        settings.shown = model_->shown;
        whole_bounds_ = bounds_of(*model_->whole);
        steps_.clear();
        if (!awaited.keeps_view) {
            settings.bookmarks.clear();
            settings.distances.clear();
            measured_from_.reset();
            session_path_.clear();
        }
        if (awaited.words) take_words(*awaited.words);
    }
    std::optional<View> first = take_first_camera();
    if (awaited.session) {
        const SessionFile& session = awaited.session->session;
        take_session(session);
        session_path_ = awaited.session->path;
        recent.add(awaited.session->path);
        if (!session.views.empty()) first = view_of(session.views.front(), origin());
    }
    if (!first && !awaited.keeps_view) {
        const glm::vec3 up_axis = *model_->source.up;
        first = model_->view ? *model_->view
                             : frame_points(model_->framed, glm::max(size_, 1), up_axis);
    }
    if (first) {
        navigation.set_view(*first);
        views_.clear();
    } else if (before && before->source.files.size() != model_->source.files.size()) {
        fit(); // the new model may be out of sight
    }
    for (const std::string& note : model_->notes) messages.notice(note);
    timings.clear();
    timings_due_ = 0;
    changed();
}

void Session::glide_to(StandardView view) {
    if (model_ == nullptr) return;
    const glm::vec3 up_axis = *model_->source.up;
    const View& now = navigation.view();
    navigation.glide_to(frame_points_from({direction_to(view, up_axis), up_axis}, model_->framed,
                                          glm::max(size_, 1), now.fov_y, now.projection));
}

void Session::look_from(glm::vec3 direction) {
    if (model_ == nullptr) return;
    const glm::vec3 up_axis = *model_->source.up;
    const float above = glm::dot(direction, up_axis);
    if (std::abs(above) > 0.999F)
        return glide_to(above > 0 ? StandardView::top : StandardView::bottom);
    const View& now = navigation.view();
    navigation.glide_to(frame_points_from({direction, up_axis}, model_->framed, glm::max(size_, 1),
                                          now.fov_y, now.projection));
}

void Session::toggle_projection() {
    const bool parallel = navigation.goal().projection == Projection::orthographic;
    navigation.set_projection(parallel ? Projection::perspective : Projection::orthographic);
    changed();
}

void Session::fit() {
    if (model_ == nullptr) return;
    const View& view = navigation.goal();
    navigation.glide_to(frame_points_from({glm::normalize(view.eye - view.target), view.up},
                                          model_->framed, glm::max(size_, 1), view.fov_y,
                                          view.projection));
}

void Session::note_step() {
    if (std::exchange(step_due_, false)) steps_.note(settings);
    if (model_ != nullptr && !navigation.gliding()) views_.note(navigation.view());
}

void Session::take(const Settings* step) {
    if (step == nullptr) return messages.notice("There is no other step");
    attempt([&] { load_pens(step->style); });
    settings = *step;
    stale_ = true;
    ++revision_;
}

void Session::glide_to(const View* step) {
    if (step != nullptr) navigation.glide_to(*step);
}

void Session::undo() {
    note_step();
    take(steps_.back());
}

void Session::redo() {
    take(steps_.forward());
}

void Session::camera_back() {
    glide_to(views_.back());
}

void Session::camera_forward() {
    glide_to(views_.forward());
}

glm::dvec3 Session::point_at(glm::dvec2 point) const {
    if (model_ == nullptr) return {};
    const Ray ray = ray_at(navigation.view(), point, size_);
    const glm::dvec3 centre = 0.5F * (model_->lines.bounds.min + model_->lines.bounds.max);
    return pick(model_->lines, ray).value_or(centre);
}

Camera Session::camera() const {
    return make_camera(navigation.view(), size_, model_->lines.bounds);
}

bool Session::save_style(const std::filesystem::path& path) {
    return attempt([&] {
        save_text(write_style(settings.style), path);
        messages.notice("Saved " + path.string());
    });
}

bool Session::save_camera(const std::filesystem::path& path) {
    return attempt([&] {
        save_text(camera_file(navigation.goal(), origin()), path);
        messages.notice("Saved " + path.string());
    });
}

bool Session::save_trace(const std::filesystem::path& path) {
    if (timings.profiles().empty()) {
        messages.notice("There are no timings yet (T)");
        return false;
    }
    return attempt([&] {
        save_text(profile_trace(timings.profiles(), description_), path);
        messages.notice("Saved " + path.string());
    });
}

void Session::resize(glm::ivec2 pixels) {
    if (pixels == size_) return;
    size_ = pixels;
    changed();
}

void Session::advance(double seconds) {
    messages.advance(seconds);
    navigation.advance(seconds);
    outdated_ =
        stale_ || !tasks_.empty() || (drawn_view_ && !same(*drawn_view_, navigation.view()));
    if (!tasks_.empty()) return; // one of them may take a model to be shown
    std::optional<Loader::Result> result;
    if (!drawing()) result = loader.take();
    if (!result) {
        restart_stale_job(seconds);
        return show_wanted();
    }
    if (auto* model = std::get_if<std::shared_ptr<Model>>(&*result)) {
        show(std::move(*model));
    } else {
        messages.error(std::get<std::string>(*result));
        forget_awaited();
        if (model_ != nullptr) settings.shown = model_->shown;
    }
}

bool Session::stale() const {
    if (drawing() || model_ == nullptr || size_.x <= 0 || size_.y <= 0) return false;
    const bool provisional = moving_ && (settings.steady || economy() != Economy::none);
    return stale_ || provisional || refine_due_ || !drawn_view_ ||
           !same(*drawn_view_, navigation.view());
}

bool Session::take_timings() {
    if (timings_due_ == 0 || drawing()) return false;
    std::vector<FrameProfile> frames;
    drawing_.run([&] {
        frames = renderer_->take_profiles(false);
        if (sketch_ != nullptr)
            std::ranges::move(sketch_->take_profiles(false), std::back_inserter(frames));
    });
    for (const FrameProfile& frame : frames) timings_due_ -= 1 + static_cast<int>(frame.dropped);
    timings_due_ = std::max(timings_due_, 0);
    timings.add(frames);
    return !frames.empty();
}

} // namespace lineatlas::viewer
