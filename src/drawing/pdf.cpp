#include <cairo-pdf.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <memory>
#include <mutex>

#include "fusee/core/error.h"
#include "fusee/drawing/svg.h"

namespace fusee::drawing {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;  // PDF's unit

struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(GError* error) const { g_error_free(error); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

[[noreturn]] void fail(const std::string& sheet, GError* error) {
    const Owned<GError> owned(error);
    throw core::IoError(sheet, fmt::format("librsvg: {}", error ? error->message : "no reason given"));
}

void draw_page(cairo_t* context, const Sheet& sheet) {
    const std::string text = svg(sheet);
    GError* error = nullptr;
    const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(text.data()), text.size(), &error));
    if (!handle) fail(sheet.title, error);
    const RsvgRectangle page{0.0, 0.0, Sheet::kWidth * kPointsPerMm, Sheet::kHeight * kPointsPerMm};
    if (!rsvg_handle_render_document(handle.get(), context, &page, &error)) fail(sheet.title, error);
    cairo_show_page(context);
}

}  // namespace

std::string pdf(const std::vector<Sheet>& sheets) {
    static std::mutex one_at_a_time;  // the whole process shares the tables of fonts
    const std::scoped_lock lock(one_at_a_time);
    std::string bytes;
    const Owned<cairo_surface_t> surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, Sheet::kWidth * kPointsPerMm, Sheet::kHeight * kPointsPerMm));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // otherwise it is the present time
    if (!sheets.empty()) cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, sheets.front().title.c_str());
    const Owned<cairo_t> context(cairo_create(surface.get()));
    for (const Sheet& sheet : sheets) draw_page(context.get(), sheet);
    cairo_surface_finish(surface.get());
    if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
        throw core::IoError(sheets.empty() ? "drawing" : sheets.front().title, fmt::format("cairo: {}", cairo_status_to_string(status)));
    return bytes;
}

}  // namespace fusee::drawing
