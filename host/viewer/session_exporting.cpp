// A Session as a drawing for others: on a page, to scale, for a plotter.
#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "core/style_lengths.hpp"
#include "saving.hpp"
#include "session.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {

ExportedDrawing Session::exported() const {
    return {.model = model_,
            .view = navigation.goal(),
            .window = glm::max(size_, 1),
            .options = still_options(settings),
            .goes_on = {}};
}

void Session::save_picture(const std::filesystem::path& folder, const std::string& extension) {
    if (model_ == nullptr) return;
    const std::filesystem::path path = free_path(folder, extension);
    add_saving(path, [this, path, drawing = exported()](const auto& goes_on) {
        give_lines(drawing.model);
        save({.model = *drawing.model,
              .view = drawing.view,
              .size = drawing.window,
              .options = drawing.options,
              .goes_on = goes_on},
             path, *renderer_, writer_);
    });
}

void Session::export_to(const std::filesystem::path& path, const ExportOptions& options) {
    if (model_ == nullptr) return;
    add_saving(path, [this, path, options, drawing = exported()](const auto& goes_on) mutable {
        drawing.goes_on = goes_on;
        give_lines(drawing.model);
        save(options, drawing, path, *renderer_, writer_);
    });
}

bool Session::is_taken(const std::filesystem::path& path) const {
    const auto whole = [](const std::filesystem::path& any) {
        std::error_code failure;
        return std::filesystem::absolute(any, failure).lexically_normal();
    };
    std::error_code failure; // then saving tells it
    return std::filesystem::exists(path, failure) ||
           std::ranges::any_of(tasks_, [&](const Task& task) {
               return !task.path.empty() && whole(task.path) == whole(path);
           });
}

std::filesystem::path Session::free_path(const std::filesystem::path& folder,
                                         const std::string& extension) const {
    return viewer::free_path(folder, model_->source.stem(), extension,
                             [this](const auto& path) { return is_taken(path); });
}

bool Session::shows_same(const Previewed& a, const Previewed& b) {
    return a.options == b.options && same(a.view, b.view) && a.window == b.window &&
           a.revision == b.revision && a.pixels == b.pixels;
}

const Session::Preview& Session::preview(const ExportOptions& options, int pixels) {
    preview_wanted_ = Previewed{options, navigation.goal(), size_, revision_, pixels};
    return preview_;
}

bool Session::preview_due() const {
    if (model_ == nullptr || !preview_wanted_ || drawing() || stale() || navigation.gliding())
        return false;
    return !preview_begun_ || !shows_same(*preview_begun_, *preview_wanted_);
}

bool Session::has_preview() const {
    return preview_drawn_ && preview_wanted_ && shows_same(*preview_drawn_, *preview_wanted_);
}

void Session::draw_preview() {
    preview_begun_ = preview_wanted_;
    const auto drawn = std::make_shared<Preview>();
    const auto work = [this, drawn, wanted = *preview_wanted_, drawing = exported()] {
        preview_before_ = {}; // on the thread that has made it
        *drawn = make_preview(wanted, drawing);
        glFinish(); // after it the window's context sees the pictures
    };
    const auto then = [this, drawn, wanted = *preview_wanted_](bool) {
        preview_drawn_ = wanted;
        preview_before_ = std::exchange(preview_, std::move(*drawn));
        stale_ = true; // the renderer's last frame was another one
    };
    add_task({.work = work, .then = then});
}

/// On the drawing thread.
Session::Preview Session::make_preview(const Previewed& wanted, const ExportedDrawing& drawing) {
    Preview preview;
    try {
        give_lines(drawing.model);
        preview.page = lay_out(wanted.options, drawing);
        const glm::dvec2 size = preview.page.size;
        const double scale = wanted.pixels / std::max(size.x, size.y);
        FrameOptions options = drawing.options;
        options.steady = false;
        constexpr std::size_t most = 20'000; // with more edges people would wait too long
        if (drawing.model->lines.segments.size() < most)
            options.method = Method::exact;
        else if (options.method == Method::exact)
            options.method = Method::atlas;
        for (const PageView& view : preview.page.views) {
            Camera camera = view.camera;
            camera.size = glm::max(glm::ivec2{glm::round(scale * (view.high - view.low))}, 1);
            options.style = about_origin(view.style, drawing.model->origin);
            if (options.style.made_for == 0)
                multiply_lengths(options.style, static_cast<float>(camera.size.y) /
                                                    static_cast<float>(view.camera.size.y));
            auto canvas = std::make_unique<gl::Canvas>(camera.size);
            canvas->clear({options.style.paper.color, 1});
            for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
                glTextureParameteri(canvas->texture(), filter, GL_LINEAR);
            renderer_->draw(camera, options, canvas->framebuffer());
            preview.pictures.push_back(std::move(canvas));
        }
    } catch (const std::exception& error) {
        preview = {.problem = in_words_of_the_tool(error.what())};
    }
    return preview;
}

} // namespace lineatlas::viewer
