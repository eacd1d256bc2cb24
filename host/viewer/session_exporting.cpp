// A Session as a drawing for others: on a page, to scale, for a plotter.
#include <algorithm>

#include <glm/common.hpp>

#include "core/style_lengths.hpp"
#include "freed_memory.hpp"
#include "session.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {

ExportedDrawing Session::exported() const {
    return {.model = *model_,
            .view = navigation.goal(),
            .window = glm::max(size_, 1),
            .options = still_options(settings)};
}

bool Session::export_to(const std::filesystem::path& path, const ExportOptions& options) {
    if (model_ == nullptr) return false;
    return attempt([&] {
        drawing_.run([&] { save(options, exported(), path, *renderer_, writer_); });
        give_freed_memory_back(); // a page has many more pixels than the window
        messages.notice("Saved " + path.string());
        changed(); // the renderer's last frame is not that of the window any more
    });
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
    if (model_ == nullptr || !preview_wanted_ || stale() || navigation.gliding()) return false;
    return !preview_drawn_ || !shows_same(*preview_drawn_, *preview_wanted_);
}

void Session::draw_preview() {
    preview_drawn_ = preview_wanted_;
    drawing_.run([&] { make_preview(); });
    stale_ = true; // the renderer's last frame was another one
}

/// On the drawing thread.
void Session::make_preview() {
    preview_ = {};
    try {
        preview_.page = lay_out(preview_wanted_->options, exported());
        const glm::dvec2 size = preview_.page.size;
        const double scale = preview_wanted_->pixels / std::max(size.x, size.y);
        FrameOptions options = still_options(settings);
        options.steady = false;
        constexpr std::size_t most = 20'000; // with more edges people would wait too long
        if (model_->lines.segments.size() < most)
            options.method = Method::exact;
        else if (options.method == Method::exact)
            options.method = Method::atlas;
        for (const PageView& view : preview_.page.views) {
            Camera camera = view.camera;
            camera.size = glm::max(glm::ivec2{glm::round(scale * (view.high - view.low))}, 1);
            options.style = about_origin(view.style, origin());
            if (options.style.made_for == 0)
                multiply_lengths(options.style, static_cast<float>(camera.size.y) /
                                                    static_cast<float>(view.camera.size.y));
            auto canvas = std::make_unique<gl::Canvas>(camera.size);
            canvas->clear({options.style.paper.color, 1});
            for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
                glTextureParameteri(canvas->texture(), filter, GL_LINEAR);
            renderer_->draw(camera, options, canvas->framebuffer());
            preview_.pictures.push_back(std::move(canvas));
        }
        glFinish(); // after it the window's context sees the pictures
    } catch (const std::exception& error) {
        preview_ = {.problem = in_words_of_the_tool(error.what())};
    }
}

} // namespace lineatlas::viewer
