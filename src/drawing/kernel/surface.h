#pragma once
#include <cairo.h>

#include <memory>
#include <string>

namespace fusee::drawing {

struct DestroyCairo {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <class T>
using OwnedCairo = std::unique_ptr<T, DestroyCairo>;

/// Called by cairo: adds to the std::string at `bytes`.
cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length);
/// @throws IoError naming `name`
std::string png_of(cairo_surface_t* surface, const std::string& name);

}  // namespace fusee::drawing
