#pragma once
#include <cairo.h>
#include <glib-object.h>

#include <memory>
#include <mutex>
#include <string>

namespace fusee::drawing {

struct DestroyGlib {
    template <class Object>
    void operator()(Object* object) const {
        g_object_unref(object);
    }
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

/// One picture at a time: the whole process shares the tables of fonts. GLib ends the program where it cannot start their threads.
/// @throws core::IoError naming `name`
[[nodiscard]] std::unique_lock<std::mutex> fonts_for(const std::string& name);

/// Called by cairo: adds to the std::string at `bytes`.
cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length);

/// @throws core::IoError naming `name` unless the status is success
void require(cairo_status_t status, const std::string& name);

}  // namespace fusee::drawing
