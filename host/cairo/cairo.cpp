#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <cairo-pdf.h>

#include "pdf/pdf_module.hpp"

namespace lineatlas::pdf {
namespace {

struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

cairo_line_join_t join_of(Join join) {
    switch (join) {
    case Join::round:
        return CAIRO_LINE_JOIN_ROUND;
    case Join::bevel:
        return CAIRO_LINE_JOIN_BEVEL;
    case Join::mitre:
        break;
    }
    return CAIRO_LINE_JOIN_MITER;
}

void set_color(cairo_t* context, glm::vec3 color, double opacity) {
    const glm::dvec3 wide{color};
    cairo_set_source_rgba(context, wide.x, wide.y, wide.z, opacity);
}

void add_path(cairo_t* context, const Way& way) {
    cairo_move_to(context, way.start.x, way.start.y);
    for (const Step& step : way.steps) {
        if (step.cubic) {
            const glm::dvec2 a = step.first_control, b = step.last_control;
            cairo_curve_to(context, a.x, a.y, b.x, b.y, step.to.x, step.to.y);
            continue;
        }
        if (!step.arc) {
            cairo_line_to(context, step.to.x, step.to.y);
            continue;
        }
        // Drawn in the frame in which the arc is a part of the unit circle. The pen stays as it is.
        const glm::dvec2 minor = step.ratio * glm::dvec2{-step.major.y, step.major.x};
        const cairo_matrix_t frame{.xx = step.major.x,
                                   .yx = step.major.y,
                                   .xy = minor.x,
                                   .yy = minor.y,
                                   .x0 = step.center.x,
                                   .y0 = step.center.y};
        cairo_save(context);
        cairo_transform(context, &frame);
        if (step.sweep > 0)
            cairo_arc(context, 0, 0, 1, step.from, step.from + step.sweep);
        else
            cairo_arc_negative(context, 0, 0, 1, step.from, step.from + step.sweep);
        cairo_restore(context);
    }
    if (way.closed) cairo_close_path(context);
}

void draw(cairo_t* context, const Way& way) {
    cairo_new_path(context);
    add_path(context, way);
    cairo_stroke(context);
}

void add_path(cairo_t* context, const Area& area) {
    set_color(context, area.color, 1);
    cairo_new_path(context);
    for (const Way& border : area.borders) add_path(context, border);
}

/// Areas that touch leave no seam where pixels are mixtures: below them lie hairlines of their own
/// colours in a PDF, and a picture has no mixtures there.
void draw(cairo_t* context, const std::vector<Area>& areas, bool as_pixels) {
    constexpr double hairline = 0.25; // points
    cairo_set_line_width(context, hairline);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    for (const Area& area : areas) {
        if (as_pixels) break;
        add_path(context, area);
        cairo_stroke(context);
    }
    const cairo_antialias_t usual = cairo_get_antialias(context);
    if (as_pixels) cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
    cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
    for (const Area& area : areas) {
        add_path(context, area);
        cairo_fill(context);
    }
    cairo_set_antialias(context, usual);
}

void draw(cairo_t* context, const Strokes& strokes) {
    set_color(context, strokes.color, strokes.opacity);
    cairo_set_line_width(context, strokes.width);
    cairo_set_line_join(context, join_of(strokes.join));
    cairo_set_miter_limit(context, strokes.mitre_limit);
    cairo_set_line_cap(context, strokes.round_caps ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    for (const Way& way : strokes.ways) {
        std::vector<double> dashes = way.dash_scale > 0 ? strokes.dashes : std::vector<double>{};
        for (double& length : dashes) length *= way.dash_scale;
        cairo_set_dash(context, dashes.data(), static_cast<int>(dashes.size()), 0);
        draw(context, way);
    }
}

/// A font, and the height of its capital letters as a share of its size. cairo's own font, which
/// every machine has, has only ASCII. Other text is in a font of the machine.
struct Font {
    const char* family;
    double capital_height;
};
Font font_for(const std::string& text) {
    const bool ascii = std::ranges::all_of(text, [](char c) { return (c & 0x80) == 0; });
    return ascii ? Font{"@cairo:", 0.67} : Font{"sans-serif", 0.72};
}

void draw(cairo_t* context, const Text& text) {
    set_color(context, text.color, 1);
    const Font font = font_for(text.text);
    cairo_select_font_face(context, font.family, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, text.height / font.capital_height);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.text.c_str(), &extents);
    cairo_save(context);
    cairo_translate(context, text.at.x, text.at.y);
    if (text.upward) cairo_rotate(context, -std::numbers::pi / 2);
    cairo_move_to(context, -text.before * extents.x_advance, 0);
    cairo_show_text(context, text.text.c_str());
    cairo_restore(context);
}

/// Letters have the same places at any resolution.
void set_font_options(cairo_t* context) {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

void draw(cairo_t* context, const Page& page, bool as_pixels) {
    set_font_options(context);
    if (page.background) {
        set_color(context, *page.background, 1);
        cairo_paint(context);
    }
    draw(context, page.areas, as_pixels);
    for (const Strokes& strokes : page.strokes) draw(context, strokes);
    for (const Text& text : page.texts) draw(context, text);
}

using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

std::string write(const Page& page) {
    std::string text;
    const Surface surface{
        cairo_pdf_surface_create_for_stream(&append, &text, page.size.x, page.size.y)};
    check(cairo_surface_status(surface.get()));
    const auto describe = [&](cairo_pdf_metadata_t what, const char* value) {
        cairo_pdf_surface_set_metadata(surface.get(), what, value);
    };
    describe(CAIRO_PDF_METADATA_TITLE, page.title.c_str());
    describe(CAIRO_PDF_METADATA_SUBJECT, page.subject.c_str());
    describe(CAIRO_PDF_METADATA_CREATOR, "lineatlas " LINEATLAS_VERSION);
    // Without a date the same drawing gives the same file at any time.
    describe(CAIRO_PDF_METADATA_CREATE_DATE, "");
    const Context context{cairo_create(surface.get())};
    draw(context.get(), page, false);
    cairo_show_page(context.get());
    check(cairo_status(context.get()));
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return text;
}

/// A channel that was multiplied by alpha, divided by it.
unsigned char straight(std::uint32_t value, std::uint32_t alpha) {
    if (alpha == 0) return 0;
    return static_cast<unsigned char>(std::min(255U, (255 * value + alpha / 2) / alpha));
}

/// The pixels of cairo's own format, native 32-bit words of alpha, red, green and blue.
Pixels pixels_of(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    Pixels pixels{.width = cairo_image_surface_get_width(surface),
                  .height = cairo_image_surface_get_height(surface),
                  .values = {}};
    const unsigned char* row = cairo_image_surface_get_data(surface);
    for (int y = 0; y < pixels.height; ++y, row += cairo_image_surface_get_stride(surface)) {
        for (int x = 0; x < pixels.width; ++x) {
            std::uint32_t word = 0;
            std::memcpy(&word, row + 4 * x, sizeof word);
            const std::uint32_t alpha = word >> 24U;
            for (const unsigned shift : {16U, 8U, 0U})
                pixels.values.push_back(straight(word >> shift & 0xFFU, alpha));
            pixels.values.push_back(static_cast<unsigned char>(alpha));
        }
    }
    return pixels;
}

Pixels paint(const Page& page, double scale) {
    const auto side = [&](double points) { return static_cast<int>(std::lround(points * scale)); };
    const Surface surface{
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, side(page.size.x), side(page.size.y))};
    check(cairo_surface_status(surface.get()));
    const Context context{cairo_create(surface.get())};
    cairo_scale(context.get(), scale, scale);
    draw(context.get(), page, true);
    check(cairo_status(context.get()));
    return pixels_of(surface.get());
}

} // namespace
} // namespace lineatlas::pdf

extern "C" const lineatlas::pdf::Module lineatlas_pdf_4{.write = lineatlas::pdf::write,
                                                        .paint = lineatlas::pdf::paint};
