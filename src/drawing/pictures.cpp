#include <zlib.h>

#include <array>
#include <cstdint>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/module.h"
#include "fusee/core/text.h"
#include "fusee/drawing/picture.h"
#include "kernel/kernel.h"

namespace fusee::drawing {

namespace {

/// librsvg, Pango and cairo bring 40 libraries: they are loaded when one of them draws.
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
    const std::string summed = type + content;
    const auto checksum = ::crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size()));
    return big_endian(static_cast<std::uint32_t>(content.size())) + summed + big_endian(static_cast<std::uint32_t>(checksum));
}

std::string size_of(const Picture& picture) {
    return big_endian(static_cast<std::uint32_t>(picture.width)) + big_endian(static_cast<std::uint32_t>(picture.height));
}

/// Signature and header: 8 bits of red, green and blue.
std::string beginning_of(const Picture& picture) {
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size_of(picture) + std::string{8, 2, 0, 0, 0});
}

/// Of one stream of compressed bytes.
class Deflated {
public:
    explicit Deflated(int level) {
        if (::deflateInit(&stream_, level) != Z_OK) throw core::IoError("picture", "zlib has no memory for its pixels");
    }
    Deflated(const Deflated&) = delete;
    Deflated& operator=(const Deflated&) = delete;
    ~Deflated() { ::deflateEnd(&stream_); }

    void add(const std::uint8_t* bytes, std::size_t count, int flush = Z_NO_FLUSH) {
        stream_.next_in = const_cast<Bytef*>(bytes);  // zlib reads it only
        stream_.avail_in = static_cast<uInt>(count);
        do {
            stream_.next_out = room_.data(), stream_.avail_out = static_cast<uInt>(room_.size());
            ::deflate(&stream_, flush);  // fails for no memory, which it has by now
            bytes_.append(reinterpret_cast<const char*>(room_.data()), room_.size() - stream_.avail_out);
        } while (stream_.avail_out == 0);
    }
    [[nodiscard]] std::string done() && {
        add(nullptr, 0, Z_FINISH);
        return std::move(bytes_);
    }

private:
    ::z_stream stream_{};
    std::array<Bytef, 1U << 15U> room_;
    std::string bytes_;
};

/// The compressed rows. Areas of one colour compress best, and soonest, without a filter.
std::string pixels_of(const Picture& picture) {
    constexpr int kLevel = 3;  // of zlib: the next one takes twice the time
    constexpr std::uint8_t kNoFilter = 0;
    const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
    Deflated pixels(kLevel);
    for (std::size_t at = 0; at < picture.rgb.size(); at += row) pixels.add(&kNoFilter, 1), pixels.add(picture.rgb.data() + at, row);
    return std::move(pixels).done();
}

}  // namespace

std::string png(const Picture& picture) { return beginning_of(picture) + chunk("IDAT", pixels_of(picture)) + chunk("IEND", ""); }

std::string animated_png(const std::vector<Picture>& frames, int frame_ms) {
    const auto count = static_cast<std::uint32_t>(frames.size());
    std::string file = beginning_of(frames.front()) + chunk("acTL", big_endian(count) + big_endian(0));
    std::uint32_t sequence = 0;  // of the chunks fcTL and fdAT (PNG, 3rd edition, 11.3.6)
    for (const Picture& frame : frames) {
        const std::string pixels = pixels_of(frame);
        const bool first = sequence == 0;
        file += chunk("fcTL", big_endian(sequence++) + size_of(frame) + big_endian(0) + big_endian(0) +
                                  big_endian(static_cast<std::uint32_t>(frame_ms), 2) + big_endian(1000, 2) + std::string(2, '\0'));
        file += first ? chunk("IDAT", pixels) : chunk("fdAT", big_endian(sequence++) + pixels);
    }
    return file + chunk("IEND", "");
}

std::string data_uri(const std::string& png) { return "data:image/png;base64," + core::base64(png); }

std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px) {
    return kernel().png_of_svg(svg, name, longest_px);
}

std::string pdf(const std::vector<Sheet>& sheets) { return kernel().pdf(sheets); }

}  // namespace fusee::drawing
