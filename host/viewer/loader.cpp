#include "loader.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "command_line/joined_models.hpp"
#include "command_line/values.hpp"
#include "core/far_part.hpp"
#include "core/up_axis.hpp"
#include "io/isolated.hpp"
#include "io/model_types.hpp"
#include "io/odd_triangles.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"
#include "style/frame_settings.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {
namespace {

std::atomic<int> threads{0};

} // namespace

struct Loader::Job {
    ModelSource source;
    Reader reader;
    /// A model of which something else is to be shown, or null.
    std::shared_ptr<const Model> model{};
    Shown shown{};
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::atomic<const char*> stage{""};
    std::atomic<bool> cancelled{false};
    std::mutex mutex; ///< guards the members below
    std::function<void()> wake;
    std::optional<Result> result;

    void say(const char* what) {
        stage = what;
        wake_up();
    }
    void wake_up() {
        const std::lock_guard lock{mutex};
        if (wake) wake();
    }
};

namespace {

std::shared_ptr<Model> model_of(const ModelSource& source, LoadedMesh loaded) {
    auto model = std::make_shared<Model>();
    model->source = source;
    model->parts = Parts{loaded};
    model->origin = loaded.origin;
    model->notes = std::move(loaded.notes);
    model->unit = loaded.unit;
    if (!source.up)
        model->source.up =
            loaded.up.value_or(guess_up(loaded.mesh, usual_up(source.files.front())));
    model->mesh = model->whole = std::make_shared<const Mesh>(std::move(loaded.mesh));
    return model;
}

std::shared_ptr<Model> showing(const Model& model, const Shown& shown) {
    auto result = std::make_shared<Model>();
    result->source = model.source;
    result->whole = model.whole;
    result->parts = model.parts;
    result->shown = shown;
    result->mesh = model.whole;
    if (shown.parts != ShownParts{})
        result->mesh = std::make_shared<const Mesh>(model.parts.shown(*model.whole, shown.parts));
    if (std::ranges::any_of(shown.cuts, &Cut::on)) {
        CutMesh cut = apply_cuts(*result->mesh, shown.cuts, model.origin);
        result->mesh = std::make_shared<const Mesh>(std::move(cut.mesh));
        result->planes = std::move(cut.planes);
        result->notes = std::move(cut.notes);
    }
    result->origin = model.origin;
    result->unit = model.unit;
    result->view = model.view;
    return result;
}

const char* what_is_done(const ModelSource& source) {
    if (source.files.empty()) return "Building the scene";
    return source.files.size() == 1 ? "Reading the file" : "Reading the files";
}

void find_lines(Model& model, const Progress& progress) {
    LineOptions options = model.source.lines;
    if (model.shown.crease)
        options.crease = parse_crease("crease", fmt::format("{}", *model.shown.crease));
    options.silhouettes = model.shown.silhouettes.value_or(LineOptions{}.silhouettes);
    model.lines = extract_lines(*model.mesh, options, progress);
    const std::optional<FarPart> far = find_far_part(model.lines);
    if (far) model.notes.push_back(note_of(*far));
    model.framed = points_to_frame(model.lines, far);
}

} // namespace

std::string ModelSource::name() const {
    if (files.empty()) return scene;
    const std::string first = files.front().filename().string();
    return files.size() == 1 ? first : fmt::format("{} + {}", first, files.size() - 1);
}

std::string ModelSource::stem() const {
    return files.empty() ? scene : files.front().stem().string();
}

std::shared_ptr<Model> Loader::read(const ModelSource& source) {
    if (!source.files.empty())
        return model_of(source, load_models_isolated(source.files, source.read));
    Scene scene = make_scene(source.scene);
    const View view = scene.view(0);
    std::shared_ptr<Model> model = model_of(source, {.mesh = std::move(scene.mesh), .notes = {}});
    model->view = view;
    return model;
}

void Loader::run(const std::shared_ptr<Job>& job) {
    Result result;
    try {
        std::shared_ptr<Model> model;
        if (job->model) {
            job->say("Finding the lines of what is shown");
            model = showing(*job->model, job->shown);
        } else {
            job->say(what_is_done(job->source));
            model = job->reader(job->source);
            if (!job->cancelled) job->say("Finding its lines");
        }
        if (!job->cancelled) {
            find_lines(*model, [&](float) { return !job->cancelled; });
            if (!job->model && !job->source.files.empty())
                add_notes(model->lines.odd, model->notes);
        }
        result = model;
    } catch (const std::bad_alloc&) {
        result = job->source.name() + ": there is not enough memory for this model";
    } catch (const std::exception& error) {
        result = in_words_of_the_tool(error.what());
    }
    const std::lock_guard lock{job->mutex};
    job->result = std::move(result);
    if (job->wake) job->wake();
}

void Loader::start(ModelSource source) {
    auto job = std::make_shared<Job>();
    job->source = std::move(source);
    start(std::move(job));
}

void Loader::start(std::shared_ptr<const Model> model, Shown shown) {
    auto job = std::make_shared<Job>();
    job->source = model->source;
    job->model = std::move(model);
    job->shown = std::move(shown);
    start(std::move(job));
}

void Loader::start(std::shared_ptr<Job> job) {
    cancel();
    job_ = std::move(job);
    job_->reader = reader_;
    job_->wake = wake_;
    ++threads;
    std::thread{[job = job_]() mutable {
        run(job);
        job.reset();
        --threads;
    }}.detach();
}

void Loader::cancel() {
    const std::shared_ptr<Job> job = std::exchange(job_, nullptr);
    if (job == nullptr) return;
    job->cancelled = true;
    const std::lock_guard lock{job->mutex};
    job->wake = nullptr; // the receiver may be gone
    job->result.reset();
}

std::string Loader::name() const {
    return job_ ? job_->source.name() : "";
}

const Shown* Loader::shown() const {
    return job_ && job_->model ? &job_->shown : nullptr;
}

std::string Loader::stage() const {
    return job_ ? job_->stage.load() : "";
}

bool Loader::shows_progress() const {
    constexpr std::chrono::milliseconds unnoticed{300};
    return job_ && (!job_->model || std::chrono::steady_clock::now() - job_->start > unnoticed);
}

std::optional<Loader::Result> Loader::take() {
    if (job_ == nullptr) return {};
    std::optional<Result> result;
    {
        const std::lock_guard lock{job_->mutex};
        result = std::exchange(job_->result, std::nullopt);
    }
    if (result) job_.reset();
    return result;
}

bool Loader::any_thread() {
    return threads > 0;
}

} // namespace lineatlas::viewer
