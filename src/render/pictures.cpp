#include "fusee/core/module.h"
#include "fusee/core/text.h"
#include "kernel/kernel.h"

namespace fusee::render {

namespace {

/// librsvg and cairo bring 40 libraries: they are loaded when a picture is written.
const Kernel& kernel() {
    static const Kernel& loaded =
        *reinterpret_cast<decltype(&fusee_pictures_kernel)>(core::loaded_function("fusee_pictures.so", "fusee_pictures_kernel"))();
    return loaded;
}

}  // namespace

std::string png(const Picture& picture) { return kernel().png(picture); }

std::string data_uri(const std::string& png) { return "data:image/png;base64," + core::base64(png); }

std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px) {
    return kernel().png_of_svg(svg, name, longest_px);
}

std::string pdf_of_svgs(const std::vector<std::string>& pages, double width_mm, double height_mm, const std::string& title) {
    return kernel().pdf_of_svgs(pages, width_mm, height_mm, title);
}

}  // namespace fusee::render
