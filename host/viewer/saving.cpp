#include "saving.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/style_lengths.hpp"
#include "io/atomic_file.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/progress.hpp"
#include "output/picture_output.hpp"
#include "output/vector_output.hpp"
#include "settings.hpp"
#include "style/settings.hpp"

namespace lineatlas::viewer {
namespace {

std::string word(const std::string& text) {
    return text.find_first_of(" \t\"'[],#*?\\()&;<>|$") == std::string::npos ? text
                                                                             : "'" + text + "'";
}

/// The options of every setting that differs from its default.
std::string style_arguments(const Style& style) {
    const Style plain = default_style();
    std::string text;
    for (const Setting& setting : lineatlas::settings()) {
        const SettingValue value = setting.get(style);
        if (value == setting.get(plain)) continue;
        text += fmt::format(" --set {}", word(setting.key + "=" + value_to_toml(value)));
    }
    return text;
}

void save_paths(const SavedPicture& picture, const Camera& camera,
                const std::filesystem::path& path, Renderer& renderer,
                const std::string& description) {
    VectorFrame frame;
    frame.style = picture.options.style;
    frame.paths.mesh = picture.model.mesh.get();
    frame.paths.plotter = picture.plotter;
    frame.svg.fit_arcs = picture.fit_arcs;
    frame.svg.background = !picture.plotter;
    if (picture.paper) {
        frame.svg.page = parse_page(picture.paper->page);
        frame.svg.margin = {static_cast<double>(picture.paper->margin), Unit::mm};
        frame.svg.units = Unit::mm;
    }
    frame.svg.title = picture.model.source.stem();
    frame.json.origin = picture.model.origin;
    frame.description = description;
    frame.certify = [&](const auto&...) -> std::string { // before the file is written
        go_on(picture.goes_on);
        return {};
    };
    VectorOutput output{
        std::move(frame), picture.model.lines, [&](const Camera& seen) -> SeenLines {
            SeenLines found =
                find_paths(renderer, picture.model.lines, seen, picture.options, !picture.plotter);
            go_on(picture.goes_on);
            return found;
        }};
    output.draw(camera, path);
    output.finish();
}

void save_pixels(const SavedPicture& picture, const Camera& camera,
                 const std::filesystem::path& path, Renderer& renderer, ImageWriter& writer,
                 const std::string& description) {
    check_image_path(path);
    ImageSettings settings;
    settings.description = description;
    settings.dpi = picture.dpi;
    PictureOutput output{{.size = picture.size,
                          .options = picture.options,
                          .settings = settings,
                          .goes_on = picture.goes_on},
                         renderer,
                         writer};
    output.draw(camera, path);
    output.finish();
}

} // namespace

void go_on(const std::function<bool()>& goes_on) {
    if (goes_on && !goes_on()) throw Cancelled("saving was cancelled");
}

std::string command_of(const SavedPicture& picture) {
    const FrameOptions& options = picture.options;
    const ModelSource& source = picture.model.source;
    std::string text = source.files.empty() ? "draw --scene " + source.scene : "draw";
    for (const std::filesystem::path& file : source.files)
        text += fmt::format(" {}", word(file.filename().string()));
    text += fmt::format(" --method {} --probes {} --depth-scale {} --step {:g} --size {}x{}",
                        name_of(options.method), options.probes, options.depth_scale, options.step,
                        picture.size.x, picture.size.y);
    const Model& model = picture.model;
    for (const std::uint32_t part : model.shown.parts.only)
        text += " --only " + word(model.parts.pattern_of(part));
    for (const std::uint32_t part : model.shown.parts.hidden)
        text += " --hide " + word(model.parts.pattern_of(part));
    for (const SectionPlane& plane : model.planes) text += " --section " + word(plane.name);
    if (model.shown.crease) text += fmt::format(" --crease {}", *model.shown.crease);
    if (model.shown.silhouettes) text += " --silhouettes " + word_of(*model.shown.silhouettes);
    if (options.lines) text += " --lines " + line_kinds_to_text(*options.lines);
    if (picture.paper)
        text +=
            fmt::format(" --page {} --margin {:g}mm", picture.paper->page, picture.paper->margin);
    if (picture.plotter) text += " --plotter --transparent";
    if (picture.fit_arcs) text += " --fit-arcs";
    if (picture.dpi > 0) text += fmt::format(" --dpi {:g}", picture.dpi);
    return text + style_arguments(options.style);
}

FrameOptions options_of_paths(FrameOptions options) {
    options.method = Method::exact;
    options.steady = false;
    options.intervals = KeptIntervals::all;
    options.draw = false;
    return options;
}

SeenLines find_paths(Renderer& renderer, const LineSet& lines, const Camera& camera,
                     const FrameOptions& options, bool filled) {
    renderer.draw(camera, options, 0);
    SeenLines seen{renderer.read_intervals(), renderer.read_outlines()};
    if (filled) seen.fills = find_fills(lines, camera, options.style.fill);
    return seen;
}

void save(const SavedPicture& picture, const std::filesystem::path& path, Renderer& renderer,
          ImageWriter& writer) {
    SavedPicture still = picture;
    still.options.steady = false; // not averaged with the frames before
    const Camera camera = make_camera(picture.view, picture.size, picture.model.lines.bounds);
    const bool by_paths = is_path_file(path);
    if (by_paths) still.options = options_of_paths(still.options);
    const std::string description = command_of(still); // with the focus as the file has places
    still.options.style = about_origin(still.options.style, picture.model.origin);
    if (by_paths) return save_paths(still, camera, path, renderer, description);
    save_pixels(still, camera, path, renderer, writer, description);
}

void save_text(const std::string& text, const std::filesystem::path& path) {
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

std::filesystem::path free_path(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension,
                                const std::function<bool(const std::filesystem::path&)>& is_taken) {
    std::filesystem::path path = folder / fmt::format("{}.{}", stem, extension);
    for (int number = 2; is_taken(path); ++number) {
        path = folder / fmt::format("{}-{}.{}", stem, number, extension);
    }
    return path;
}

} // namespace lineatlas::viewer
