#include <cairo-pdf.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/drawing/sheet.h"

namespace fusee::drawing {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;  // PDF's unit

std::mutex one_at_a_time;  // the whole process shares the tables of fonts

struct DestroyGlib {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(GError* error) const { g_error_free(error); }
};
template <class T>
using OwnedGlib = std::unique_ptr<T, DestroyGlib>;

struct DestroyCairo {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <class T>
using OwnedCairo = std::unique_ptr<T, DestroyCairo>;

/// Called by cairo: adds to the std::string at `bytes`.
cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

[[noreturn]] void fail(const std::string& name, GError* error) {
    const OwnedGlib<GError> owned(error);
    throw core::IoError(name, fmt::format("librsvg: {}", error ? error->message : "no reason given"));
}

/// GLib ends the program where it cannot start the threads of its tables of fonts. @throws core::IoError
void require_threads(const std::string& name) {
    try {
        const std::jthread one([] {}), other([] {});
    } catch (const std::system_error& e) {
        throw core::IoError(name, "no thread can be started to draw it, by a limit of memory or processes (ulimit): " + e.code().message());
    }
}

OwnedGlib<RsvgHandle> read(const std::string& svg, const std::string& name) {
    require_threads(name);
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
    const std::scoped_lock lock(one_at_a_time);
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
    if (const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes);
        status != CAIRO_STATUS_SUCCESS)
        throw core::IoError(name, fmt::format("cairo: {}", cairo_status_to_string(status)));
    return bytes;
}

std::string pdf_of_svgs(const std::vector<std::string>& pages, double width_mm, double height_mm, const std::string& title) {
    const std::scoped_lock lock(one_at_a_time);
    const double width = width_mm * kPointsPerMm, height = height_mm * kPointsPerMm;
    std::string bytes;
    const OwnedCairo<cairo_surface_t> surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width, height));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // otherwise it is the present time
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
    const OwnedCairo<cairo_t> context(cairo_create(surface.get()));
    for (const std::string& page : pages) {
        draw(read(page, title).get(), context.get(), width, height, title);
        cairo_show_page(context.get());
    }
    cairo_surface_finish(surface.get());
    if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
        throw core::IoError(title, fmt::format("cairo: {}", cairo_status_to_string(status)));
    return bytes;
}

}  // namespace fusee::drawing
