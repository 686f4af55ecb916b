#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "fusee/core/base64.h"
#include "fusee/core/error.h"
#include "fusee/render/picture.h"

namespace fusee::render {

namespace {

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

std::string png_of(cairo_surface_t* surface, const std::string& name) {
    std::string bytes;
    if (const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, &bytes); status != CAIRO_STATUS_SUCCESS)
        throw core::IoError(name, fmt::format("cairo: {}", cairo_status_to_string(status)));
    return bytes;
}

[[noreturn]] void fail(const std::string& name, GError* error) {
    const Owned<GError> owned(error);
    throw core::IoError(name, fmt::format("librsvg: {}", error ? error->message : "no reason given"));
}

}  // namespace

std::string png(const Picture& picture) {
    const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
    cairo_surface_flush(surface.get());
    unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    if (pixels == nullptr)
        throw core::IoError("picture", fmt::format("cairo has no memory for {} x {} pixels", picture.width, picture.height));
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
    for (std::size_t y = 0; y < height; ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(pixels + y * stride);
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t* rgb = &picture.rgb[3 * (y * width + x)];
            row[x] = static_cast<std::uint32_t>(rgb[0]) << 16U | static_cast<std::uint32_t>(rgb[1]) << 8U | rgb[2];
        }
    }
    cairo_surface_mark_dirty(surface.get());
    return png_of(surface.get(), "picture");
}

std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px) {
    static std::mutex one_at_a_time;  // the whole process shares the tables of fonts
    const std::scoped_lock lock(one_at_a_time);
    GError* error = nullptr;
    const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) fail(name, error);
    gboolean has_width = FALSE, has_height = FALSE, has_box = FALSE;
    RsvgLength ignored_width, ignored_height;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle.get(), &has_width, &ignored_width, &has_height, &ignored_height, &has_box, &box);
    if (!has_box || box.width <= 0.0 || box.height <= 0.0) throw core::IoError(name, "the SVG has no viewBox");
    const double scale = longest_px / std::max(box.width, box.height);
    const int columns = std::max(1, static_cast<int>(std::lround(box.width * scale)));
    const int rows = std::max(1, static_cast<int>(std::lround(box.height * scale)));
    const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
    const Owned<cairo_t> context(cairo_create(surface.get()));
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    const RsvgRectangle page{0.0, 0.0, static_cast<double>(columns), static_cast<double>(rows)};
    if (!rsvg_handle_render_document(handle.get(), context.get(), &page, &error)) fail(name, error);
    return png_of(surface.get(), name);
}

std::string data_uri(const std::string& png) { return "data:image/png;base64," + core::base64(png); }

}  // namespace fusee::render
