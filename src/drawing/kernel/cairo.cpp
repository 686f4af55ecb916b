#include "cairo.h"

#include <fmt/format.h>

#include <system_error>
#include <thread>

#include "fusee/core/error.h"

namespace fusee::drawing {

std::unique_lock<std::mutex> fonts_for(const std::string& name) {
    static std::mutex one_at_a_time;
    std::unique_lock lock(one_at_a_time);
    try {
        const std::jthread one([] {}), other([] {});
    } catch (const std::system_error& e) {
        throw core::IoError(name, "no thread can be started to draw it, by a limit of memory or processes (ulimit): " + e.code().message());
    }
    return lock;
}

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status, const std::string& name) {
    if (status != CAIRO_STATUS_SUCCESS) throw core::IoError(name, fmt::format("cairo: {}", cairo_status_to_string(status)));
}

}  // namespace fusee::drawing
