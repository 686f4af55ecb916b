#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>

#include "cairo.h"
#include "fusee/core/error.h"
#include "fusee/drawing/sheet.h"

namespace fusee::drawing {

namespace {

[[noreturn]] void fail(const std::string& name, GError* error) {
    const OwnedGlib<GError> owned(error);
    throw core::IoError(name, fmt::format("librsvg: {}", error ? error->message : "no reason given"));
}

OwnedGlib<RsvgHandle> read(const std::string& svg, const std::string& name) {
    GError* error = nullptr;
    OwnedGlib<RsvgHandle> handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) fail(name, error);
    return handle;
}

void draw(RsvgHandle* handle, cairo_t* context, double width, double height, const std::string& name) {
    const RsvgRectangle page{0.0, 0.0, width, height};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle, context, &page, &error)) fail(name, error);
}

}  // namespace

std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px) {
    const auto lock = fonts_for(name);
    const OwnedGlib<RsvgHandle> handle = read(svg, name);
    gboolean has_width = FALSE, has_height = FALSE, has_box = FALSE;
    RsvgLength ignored_width, ignored_height;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle.get(), &has_width, &ignored_width, &has_height, &ignored_height, &has_box, &box);
    if (!has_box || box.width <= 0.0 || box.height <= 0.0) throw core::IoError(name, "the SVG has no viewBox");
    const double scale = longest_px / std::max(box.width, box.height);
    const int columns = std::max(1, static_cast<int>(std::lround(box.width * scale)));
    const int rows = std::max(1, static_cast<int>(std::lround(box.height * scale)));
    const OwnedCairo<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
    const OwnedCairo<cairo_t> context(cairo_create(surface.get()));
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    draw(handle.get(), context.get(), columns, rows, name);
    std::string bytes;
    require(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes), name);
    return bytes;
}

}  // namespace fusee::drawing
