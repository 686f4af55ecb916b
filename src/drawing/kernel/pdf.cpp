#include <cairo-pdf.h>
#include <pango/pangocairo.h>

#include "cairo.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "fusee/drawing/sheet.h"
#include "look.h"

namespace fusee::drawing {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;  // PDF's unit

struct FreeFont {
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

/// Letters with the widths that they have at any size.
OwnedGlib<PangoLayout> layout_on(cairo_t* context) {
    OwnedGlib<PangoLayout> layout(pango_cairo_create_layout(context));
    PangoContext* const letters = pango_layout_get_context(layout.get());
    const std::unique_ptr<cairo_font_options_t, FreeFont> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(letters, options.get());
    pango_context_set_round_glyph_positions(letters, FALSE);
    return layout;
}

/// Draws on a context whose unit is the millimetre. Letters come from cairo and Pango: an SVG in between would take four times as long.
class Painter {
public:
    explicit Painter(cairo_t* context) : context_(context), layout_(layout_on(context)), font_(pango_font_description_new()) {
        pango_font_description_set_family(font_.get(), core::listed(kFonts, {}, ",").c_str());
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    }
    void draw(const Sheet& sheet) {
        for (const Stroke& stroke : sheet.strokes) draw(stroke);
        for (const Arrow& arrow : sheet.arrows) draw(arrow);
        for (const Text& text : sheet.texts) draw(text);
    }

private:
    void draw(const Stroke& stroke) {
        const PenLook& pen = kPens[static_cast<std::size_t>(stroke.pen)];
        for (const Point& p : stroke.line) cairo_line_to(context_, p[0], p[1]);
        if (stroke.closed) cairo_close_path(context_);
        cairo_set_line_width(context_, pen.width_mm);
        cairo_set_dash(context_, pen.dashes_mm.data(), pen.dashes, 0.0);
        cairo_stroke(context_);
    }
    void draw(const Arrow& arrow) {
        place(arrow.tip, arrow.towards);
        cairo_move_to(context_, 0.0, 0.0);
        cairo_line_to(context_, -kArrowLength, kArrowHalfWidth);
        cairo_line_to(context_, -kArrowLength, -kArrowHalfWidth);
        cairo_fill(context_);
        cairo_restore(context_);
    }
    void draw(const Text& text) {
        pango_font_description_set_absolute_size(font_.get(), text.size * PANGO_SCALE);
        pango_layout_set_font_description(layout_.get(), font_.get());
        pango_layout_set_text(layout_.get(), text.words.data(), static_cast<int>(text.words.size()));
        int width = 0, height = 0;
        pango_layout_get_size(layout_.get(), &width, &height);
        const double before = text.align == Align::kLeft ? 0.0 : text.align == Align::kMiddle ? 0.5 : 1.0;
        place(text.at, text.upright ? -0.5 * core::kPi : 0.0);
        cairo_move_to(context_, -before * width / PANGO_SCALE,
                      -static_cast<double>(pango_layout_get_baseline(layout_.get())) / PANGO_SCALE);
        pango_cairo_show_layout(context_, layout_.get());
        cairo_restore(context_);
    }
    /// Until cairo_restore, (0, 0) is `at` and x points towards a direction.
    void place(const Point& at, double towards) {
        cairo_save(context_);
        cairo_translate(context_, at[0], at[1]);
        cairo_rotate(context_, towards);
    }

    cairo_t* context_;
    OwnedGlib<PangoLayout> layout_;
    std::unique_ptr<PangoFontDescription, FreeFont> font_;
};

}  // namespace

std::string pdf(const std::vector<Sheet>& sheets) {
    const std::string title = sheets.empty() ? "drawing" : sheets.front().title;
    const auto lock = fonts_for(title);
    std::string bytes;
    const OwnedCairo<cairo_surface_t> surface(
        cairo_pdf_surface_create_for_stream(append_bytes, &bytes, Sheet::kWidth * kPointsPerMm, Sheet::kHeight * kPointsPerMm));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // otherwise it is the present time
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
    {
        const OwnedCairo<cairo_t> context(cairo_create(surface.get()));
        cairo_scale(context.get(), kPointsPerMm, kPointsPerMm);
        Painter painter(context.get());
        for (const Sheet& sheet : sheets) {
            painter.draw(sheet);
            cairo_show_page(context.get());
        }
    }
    cairo_surface_finish(surface.get());
    require(cairo_surface_status(surface.get()), title);
    return bytes;
}

}  // namespace fusee::drawing
