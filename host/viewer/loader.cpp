#include "loader.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "core/up_axis.hpp"
#include "io/extension.hpp"
#include "io/isolated.hpp"
#include "io/odd_triangles.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas::viewer {
namespace {

std::atomic<int> threads{0};

} // namespace

struct Loader::Job {
    ModelSource source;
    Reader reader;
    std::atomic<const char*> stage{""};
    std::atomic<bool> cancelled{false};
    std::mutex mutex; ///< of what follows
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

std::shared_ptr<Model> Loader::read(const ModelSource& source) {
    auto model = std::make_shared<Model>();
    model->source = source;
    if (source.file.empty()) {
        Scene scene = make_scene(source.scene);
        model->mesh = std::move(scene.mesh);
        model->view = scene.view(0);
        return model;
    }
    LoadedMesh loaded = load_mesh_isolated(source.file, source.read);
    model->mesh = std::move(loaded.mesh);
    model->origin = loaded.origin;
    model->notes = std::move(loaded.notes);
    if (!source.up)
        model->source.up = loaded.up.value_or(guess_up(model->mesh, usual_up(source.file)));
    return model;
}

void Loader::run(const std::shared_ptr<Job>& job) {
    Result result;
    try {
        job->say(job->source.file.empty() ? "Building the scene" : "Reading the file");
        const std::shared_ptr<Model> model = job->reader(job->source);
        if (!job->cancelled) {
            job->say("Finding its lines");
            model->lines = extract_lines(model->mesh, job->source.lines);
            if (!job->source.file.empty()) add_notes(model->lines.odd, model->notes);
        }
        result = model;
    } catch (const std::bad_alloc&) {
        result = job->source.name() + ": there is not enough memory for this model";
    } catch (const std::exception& error) {
        result = std::string{error.what()};
    }
    const std::lock_guard lock{job->mutex};
    job->result = std::move(result);
    if (job->wake) job->wake();
}

void Loader::start(ModelSource source) {
    cancel();
    job_ = std::make_shared<Job>();
    job_->source = std::move(source);
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
    job->wake = nullptr; // nobody may be there to hear it
    job->result.reset();
}

std::string Loader::name() const {
    return job_ ? job_->source.name() : "";
}

std::string Loader::stage() const {
    return job_ ? job_->stage.load() : "";
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
