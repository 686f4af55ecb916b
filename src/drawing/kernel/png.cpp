#include <cairo.h>
#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/drawing/picture.h"
#include "surface.h"

namespace fusee::drawing {

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

std::string png_of(cairo_surface_t* surface, const std::string& name) {
    std::string bytes;
    if (const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append_bytes, &bytes); status != CAIRO_STATUS_SUCCESS)
        throw core::IoError(name, fmt::format("cairo: {}", cairo_status_to_string(status)));
    return bytes;
}

std::string png(const Picture& picture) {
    const OwnedCairo<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
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

}  // namespace fusee::drawing
