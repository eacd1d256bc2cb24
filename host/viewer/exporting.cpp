#include "exporting.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <glm/geometric.hpp>

#include "base/numbers.hpp"
#include "command_line/view_options.hpp"
#include "core/style_lengths.hpp"
#include "lineatlas/error.hpp"
#include "output/sheet_output.hpp"
#include "saving.hpp"
#include "vector/sheet.hpp"

namespace lineatlas::viewer {
namespace {

constexpr float print_dpi = 300;

Page page_of(const ExportOptions& options) {
    return parse_page(options.page);
}

Length margin_of(const ExportOptions& options) {
    return {static_cast<double>(options.margin), Unit::mm};
}

double unit_of(const Model& model) {
    return model.unit.value_or(1);
}

bool is_pixels(const ExportOptions& options) {
    return options.format == FileFormat::png;
}

/// The one view on its page, and how large it is.
struct Placed {
    View view;
    glm::ivec2 size;
    Sheet sheet;
};

/// Places the view on the page. With a scale the whole model is drawn from the eye's direction, in
/// the page within its margins. Without one the part that is seen fills the page.
Placed place_on_page(const ExportOptions& options, const ExportedDrawing& drawing) {
    const Page page = page_of(options);
    const Length margin = margin_of(options);
    Sheet sheet = lay_out(drawing.window, page, margin, Unit::mm);
    if (options.scale.empty()) return {drawing.view, drawing.window, sheet};
    const glm::dvec2 room = sheet.size - 2.0 * static_cast<double>(options.margin);
    const double pixel = length_in({1, Unit::px}, Unit::mm); // of a drawing as paths: a CSS pixel
    const glm::ivec2 size{glm::max(glm::round(room / pixel), 1.0)};
    sheet = lay_out(size, page, margin, Unit::mm);
    const View& seen = drawing.view;
    const std::vector<glm::vec3>& points = drawing.model->framed;
    const View whole = frame_points_from({glm::normalize(seen.eye - seen.target), seen.up}, points,
                                         size, seen.fov_y, Projection::orthographic);
    const View view =
        view_to_scale(whole, options.scale, unit_of(*drawing.model), sheet.scale, size, points);
    return {view, size, sheet};
}

/// The view on its page; nothing without a page.
std::optional<Placed> placed(const ExportOptions& options, const ExportedDrawing& drawing) {
    if (!is_on_paper(options)) return std::nullopt;
    return place_on_page(options, drawing);
}

/// The picture that is written. A picture of pixels has as many as its place on paper has at
/// print_dpi.
SavedPicture picture_of(const ExportOptions& options, const ExportedDrawing& drawing,
                        const std::optional<Placed>& place) {
    SavedPicture picture{.model = *drawing.model,
                         .view = drawing.view,
                         .size = drawing.window,
                         .options = drawing.options,
                         .goes_on = drawing.goes_on};
    if (!place) {
        if (is_pixels(options)) picture.size *= options.pixels;
        return picture;
    }
    picture.view = place->view;
    picture.size = place->size;
    if (is_pixels(options)) {
        const double dots =
            length_in({place->sheet.scale, Unit::mm}, Unit::in) * static_cast<double>(print_dpi);
        picture.size = glm::ivec2{glm::max(glm::round(dots * glm::dvec2{place->size}), 1.0)};
        picture.dpi = print_dpi;
        return picture;
    }
    picture.paper = {.page = options.page, .margin = options.margin};
    picture.options.style =
        style_on_page(drawing.options.style, picture.size, page_of(options), margin_of(options));
    return picture;
}

SheetLayout sheet_of(const ExportOptions& options, const Model& model) {
    SheetOptions wanted{.views = options.views,
                        .page = page_of(options),
                        .scale = options.scale,
                        .unit = unit_of(model),
                        .up = *model.source.up,
                        .measures = options.measures};
    wanted.fields.title = model.source.stem();
    wanted.fields.file = model.source.name();
    return lay_out_sheet(model.lines.vertices, wanted);
}

ExportPage page_with_sheet(const ExportOptions& options, const ExportedDrawing& drawing) {
    const SheetLayout layout = sheet_of(options, *drawing.model);
    ExportPage page{.size = layout.size, .scale = layout.scale};
    for (const SheetView& view : layout.views)
        page.views.push_back({.camera = view.camera,
                              .style = style_of_view(drawing.options.style, view),
                              .low = view.corner,
                              .high = view.corner + view.scale * glm::dvec2{view.camera.size}});
    page.sheet = layout;
    return page;
}

void save_sheet(const ExportOptions& options, const ExportedDrawing& drawing,
                const std::filesystem::path& path, Renderer& renderer) {
    const Model& model = *drawing.model;
    const FrameOptions frame = options_of_paths(drawing.options);
    const bool is_cut = options.purpose == Purpose::laser;
    const bool is_drawn = options.purpose == Purpose::plotter;
    const auto find = [&](const SheetView& view) {
        SeenLines seen =
            find_paths(renderer, model.lines, view.camera, frame, !is_cut && !is_drawn);
        go_on(drawing.goes_on);
        return seen;
    };
    const VectorSheet sheet = make_vector_sheet(model.lines, sheet_of(options, model), find,
                                                drawing.options.style, {.mesh = model.mesh.get()});
    const std::string description =
        command_of({.model = model, .view = drawing.view, .size = {}, .options = drawing.options}) +
        fmt::format(" --views {} --page {}",
                    options.measures ? "auto" : fmt::format("{}", fmt::join(options.views, ",")),
                    options.page) +
        (options.scale.empty() ? "" : " --scale " + options.scale);
    go_on(drawing.goes_on);
    write_sheet(path, sheet,
                {.background = !is_cut && !is_drawn,
                 .tags = !is_cut && !is_drawn,
                 .fit_arcs = is_cut,
                 .description = description},
                {.dpi = print_dpi, .description = description});
}

} // namespace

ExportOptions suited_to(Purpose purpose, ExportOptions options) {
    constexpr std::array formats{FileFormat::png, FileFormat::pdf, FileFormat::svg,
                                 FileFormat::dxf};
    options.purpose = purpose;
    options.purpose_by_format = false;
    options.format = formats.at(static_cast<std::size_t>(purpose));
    if (purpose == Purpose::screen) options.sheet = false;
    return options;
}

ExportOptions as_format(FileFormat format, ExportOptions options) {
    const bool was_for_screen =
        options.purpose == Purpose::screen || (options.purpose_by_format && !options.sheet);
    if (was_for_screen) {
        options.purpose = format == FileFormat::pdf   ? Purpose::print
                          : format == FileFormat::dxf ? Purpose::laser
                                                      : Purpose::screen;
        options.purpose_by_format = options.purpose != Purpose::screen;
    }
    options.format = format;
    return options;
}

std::string scale_of_text(std::string text) {
    std::erase(text, ' ');
    const std::optional<double> factor = number_from(text);
    if (!factor) return text;
    const std::string reciprocal = fmt::format("{:g}", 1 / *factor);
    const bool is_exact = std::abs(*factor * number_from(reciprocal).value_or(0) - 1) < 1e-12;
    return *factor < 1 && is_exact ? "1:" + reciprocal : text + ":1";
}

bool is_on_paper(const ExportOptions& options) {
    return options.sheet ||
           (options.purpose != Purpose::screen && options.format != FileFormat::json);
}

ExportPage lay_out(const ExportOptions& options, const ExportedDrawing& drawing) {
    if (options.sheet) return page_with_sheet(options, drawing);
    const std::optional<Placed> place = placed(options, drawing);
    const SavedPicture picture = picture_of(options, drawing, place);
    const Bounds& bounds = drawing.model->lines.bounds;
    PageView view{.camera = make_camera(picture.view, picture.size, bounds),
                  .style = picture.options.style};
    ExportPage page{.size = picture.size, .scale = options.scale};
    view.high = page.size;
    if (place) {
        page.size = place->sheet.size;
        view.low = place->sheet.corner;
        view.high = place->sheet.size - place->sheet.corner;
    } else {
        page.scale.clear();
    }
    page.views.push_back(std::move(view));
    return page;
}

void save(const ExportOptions& options, const ExportedDrawing& drawing,
          const std::filesystem::path& path, Renderer& renderer, ImageWriter& writer) {
    if (options.sheet) return save_sheet(options, drawing, path, renderer);
    SavedPicture picture = picture_of(options, drawing, placed(options, drawing));
    picture.plotter = options.purpose == Purpose::plotter || options.purpose == Purpose::laser;
    picture.fit_arcs = options.purpose == Purpose::laser;
    save(picture, path, renderer, writer);
}

} // namespace lineatlas::viewer
