#include <boost/crc.hpp>
#include <cstdint>

#include "fusee/core/module.h"
#include "fusee/core/text.h"
#include "kernel/kernel.h"

namespace fusee::drawing {

namespace {

/// librsvg and cairo bring 40 libraries: they are loaded when a picture is written.
const Kernel& kernel() {
    static const Kernel& loaded =
        *reinterpret_cast<decltype(&fusee_pictures_kernel)>(core::loaded_function("fusee_pictures.so", "fusee_pictures_kernel"))();
    return loaded;
}

/// A number of `bytes` bytes, the greatest first, as PNG writes all its numbers.
std::string big_endian(std::uint32_t number, int bytes = 4) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(number >> shift & 0xffU);
    return text;
}

/// A chunk of a PNG file: length, type, content, checksum of type and content (PNG, 3rd edition, 5.3).
std::string chunk(const std::string& type, const std::string& content) {
    boost::crc_32_type checksum;
    checksum.process_bytes((type + content).data(), type.size() + content.size());
    return big_endian(static_cast<std::uint32_t>(content.size())) + type + content + big_endian(checksum.checksum());
}

constexpr std::size_t kSignature = 8,
                      kHeader = kSignature + 25;  // bytes of a PNG before its first chunk and after IHDR, which has 13 bytes

/// The compressed pixels of a PNG file: the content of all its chunks IDAT.
std::string pixels_of(const std::string& png) {
    std::string pixels;
    for (std::size_t at = kSignature; at + 12 <= png.size();) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) length = length << 8U | static_cast<unsigned char>(png[at + k]);
        if (png.compare(at + 4, 4, "IDAT") == 0) pixels += png.substr(at + 8, length);
        at += length + 12;
    }
    return pixels;
}

}  // namespace

std::string png(const Picture& picture) { return kernel().png(picture); }

std::string animated_png(const std::vector<Picture>& frames, int frame_ms) {
    const auto count = static_cast<std::uint32_t>(frames.size());
    std::string file;
    std::uint32_t sequence = 0;  // of the chunks fcTL and fdAT (PNG, 3rd edition, 11.3.6)
    for (const Picture& frame : frames) {
        const std::string whole = png(frame), pixels = pixels_of(whole);
        const bool first = file.empty();
        if (first) file = whole.substr(0, kHeader) + chunk("acTL", big_endian(count) + big_endian(0));
        const std::string size = big_endian(static_cast<std::uint32_t>(frame.width)) + big_endian(static_cast<std::uint32_t>(frame.height));
        file += chunk("fcTL", big_endian(sequence++) + size + big_endian(0) + big_endian(0) +
                                  big_endian(static_cast<std::uint32_t>(frame_ms), 2) + big_endian(1000, 2) + std::string(2, '\0'));
        file += first ? chunk("IDAT", pixels) : chunk("fdAT", big_endian(sequence++) + pixels);
    }
    return file + chunk("IEND", "");
}

std::string data_uri(const std::string& png) { return "data:image/png;base64," + core::base64(png); }

std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px) {
    return kernel().png_of_svg(svg, name, longest_px);
}

std::string pdf_of_svgs(const std::vector<std::string>& pages, double width_mm, double height_mm, const std::string& title) {
    return kernel().pdf_of_svgs(pages, width_mm, height_mm, title);
}

std::string pdf(const std::vector<Sheet>& sheets) {
    std::vector<std::string> pages;
    for (const Sheet& sheet : sheets) pages.push_back(svg(sheet));
    return pdf_of_svgs(pages, Sheet::kWidth, Sheet::kHeight, sheets.empty() ? "drawing" : sheets.front().title);
}

}  // namespace fusee::drawing
