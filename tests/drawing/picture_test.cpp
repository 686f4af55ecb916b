#include "fusee/drawing/picture.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/drawing/sheet.h"

namespace fusee::drawing {
namespace {

Object box(const solid::Vec3& low, const solid::Vec3& high, Colour colour) {
    Object object;
    object.colour = colour;
    for (int i = 0; i < 8; ++i)
        object.mesh.points_mm.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
    object.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                             {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return object;
}

constexpr Colour kRed{200, 0, 0}, kBlue{0, 0, 200};

std::array<int, 3> pixel(const Picture& picture, double x_mm, double y_mm) {
    const auto x = static_cast<std::size_t>((x_mm - picture.low_mm.x()) / picture.pixel_mm());
    const auto y = static_cast<std::size_t>((picture.high_mm.y() - y_mm) / picture.pixel_mm());
    const std::uint8_t* rgb = &picture.rgb[3 * (y * static_cast<std::size_t>(picture.width) + x)];
    return {rgb[0], rgb[1], rgb[2]};
}

TEST(Draw, ShowsWhatIsInFrontWhateverTheOrder) {
    const Object low = box({-10, -10, 0}, {10, 10, 1}, kRed), high = box({-3, -3, 5}, {3, 3, 6}, kBlue);
    for (const auto& objects : {std::vector{low, high}, std::vector{high, low}}) {
        const Picture picture = draw(objects, {}, 200);
        EXPECT_EQ(pixel(picture, 0.0, 0.0)[0], 0);
        EXPECT_GT(pixel(picture, 0.0, 0.0)[2], 50);
        EXPECT_GT(pixel(picture, 7.0, 7.0)[0], 50);
        EXPECT_EQ(pixel(picture, 10.4, 10.4), (std::array{255, 255, 255}));
    }
}

// 20 x 20 mm, of which 6 x 6 are hidden.
TEST(Draw, CountsThePixelsOfEachObject) {
    const Picture picture = draw(std::vector{box({-10, -10, 0}, {10, 10, 1}, kRed), box({-3, -3, 5}, {3, 3, 6}, kBlue)}, {}, 400);
    const double pixels_per_mm2 = 1.0 / (picture.pixel_mm() * picture.pixel_mm());
    EXPECT_NEAR(static_cast<double>(picture.visible[0].pixels) / (364.0 * pixels_per_mm2), 1.0, 0.01);
    EXPECT_NEAR(static_cast<double>(picture.visible[1].pixels) / (36.0 * pixels_per_mm2), 1.0, 0.03);
    EXPECT_NEAR(picture.visible[0].middle_mm.norm(), 0.0, 0.05);
    EXPECT_NEAR(picture.visible[0].nearest_mm.cwiseAbs().maxCoeff(), 3.0, 0.1);  // its middle is hidden
    EXPECT_EQ(draw(std::vector{box({-1, -1, 0}, {1, 1, 1}, kRed), box({-3, -3, 5}, {3, 3, 6}, kBlue)}, {}, 100).visible[0].pixels, 0U);
}

// One object: the ridge between two faces is an edge; a face of two triangles has none inside.
TEST(Draw, DrawsEdgesBetweenFaces) {
    const Object cube = box({-5, -5, -5}, {5, 5, 5}, {200, 200, 200});
    const Projection view = from_direction(core::rad_from_deg(-45.0), core::rad_from_deg(30.0));
    const Picture picture = draw(std::vector{cube}, view, 300);
    const auto darkest_around = [&](const Eigen::Vector3d& at) {
        int least = 255;
        for (const double d : {-1.0, -0.5, 0.0, 0.5, 1.0})
            least =
                std::min(least, pixel(picture, view.seen(at).x() + d * picture.pixel_mm(), view.seen(at).y() + d * picture.pixel_mm())[0]);
        return least;
    };
    EXPECT_LT(darkest_around({5, -5, 0}), 75);  // between the two faces in front
    EXPECT_GT(darkest_around({5, 0, 0}), 80);
    EXPECT_GT(darkest_around({0, 0, 5}), 80);
}

TEST(Draw, SeesUpAsUp) {
    const Projection view = from_direction(core::rad_from_deg(-90.0), 0.0);
    EXPECT_NEAR((view.seen({1, 2, 3}) - Eigen::Vector2d(1, 3)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((view.right.cross(view.up) - view.towards).norm(), 0.0, 1e-12);
}

TEST(Draw, RefusesASizeThatIsNone) {
    EXPECT_THROW(static_cast<void>(draw({}, {}, 0)), core::InvalidInput);
    EXPECT_EQ(draw({}, {}, 16).visible.size(), 0U);
}

int big_endian(const std::string& bytes, std::size_t at) {
    int value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

TEST(Png, HasTheSizeOfItsPicture) {
    const Picture picture = draw(std::vector{box({-10, -5, 0}, {10, 5, 1}, kRed)}, {}, 100);
    const std::string bytes = png(picture);
    EXPECT_EQ(bytes.substr(1, 3), "PNG");
    EXPECT_EQ(big_endian(bytes, 16), picture.width);
    EXPECT_EQ(big_endian(bytes, 20), picture.height);
    EXPECT_EQ(bytes, png(draw(std::vector{box({-10, -5, 0}, {10, 5, 1}, kRed)}, {}, 100)));
}

// PNG, third edition: the rows as zlib inflates them, each behind a byte for its filter, which is none.
void expect_pixels(const Picture& picture) {
    const std::string bytes = png(picture);
    const std::size_t data = bytes.find("IDAT") + 4, row = 3 * static_cast<std::size_t>(picture.width);
    std::vector<std::uint8_t> rows((row + 1) * static_cast<std::size_t>(picture.height));
    uLongf size = rows.size();
    ASSERT_EQ(
        ::uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(&bytes[data]), static_cast<uLong>(big_endian(bytes, data - 8))),
        Z_OK);
    ASSERT_EQ(size, rows.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
        EXPECT_EQ(rows[y * (row + 1)], 0);
        EXPECT_TRUE(std::equal(&rows[y * (row + 1) + 1], &rows[y * (row + 1) + 1] + row, &picture.rgb[y * row])) << "row " << y;
    }
}

TEST(Png, HoldsThePixels) { expect_pixels(draw(std::vector{box({-10, -5, 0}, {10, 5, 1}, kRed)}, {}, 100)); }

TEST(Png, HoldsPixelsThatHardlyCompress) {
    Picture noise;
    noise.width = 300, noise.height = 200;
    noise.rgb.resize(3 * 300 * 200);
    std::mt19937 random(7);
    for (std::uint8_t& value : noise.rgb) value = static_cast<std::uint8_t>(random() >> 24U);
    EXPECT_GT(png(noise).size(), noise.rgb.size() / 2) << "many times what zlib writes at once";
    expect_pixels(noise);
}

TEST(Png, OfAnSvgHasItsProportions) {
    const std::string bytes = png_of_svg(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 30 10\"><rect width=\"30\" height=\"10\"/></svg>", "a.svg", 300);
    EXPECT_EQ(big_endian(bytes, 16), 300);
    EXPECT_EQ(big_endian(bytes, 20), 100);
    EXPECT_THROW(static_cast<void>(png_of_svg("no svg", "b.svg", 300)), core::IoError);
}

/// What the first page of a PDF draws: its stream, inflated.
std::string first_page(const std::string& pdf) {
    const std::size_t begin = pdf.find("stream\n") + 7, end = pdf.find("\nendstream", begin);
    std::string page(100'000, '\0');
    uLongf size = page.size();
    EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(page.data()), &size, reinterpret_cast<const Bytef*>(&pdf[begin]),
                           static_cast<uLong>(end - begin)),
              Z_OK);
    page.resize(size);
    return page;
}

// Known answer in points of 1/72 in: 1 and 2 in from the left and the top, 2 in long, with the dashes of a hidden edge, 2.4 and 1 mm.
TEST(Pdf, DrawsEachSheetOnAPage) {
    Sheet sheet{"three pages", {{Pen::kHidden, {{25.4, 50.8}, {76.2, 50.8}}}}, {{{50.0, 60.0}, 0.0}}, {{"Groove", {70.0, 80.0}}}};
    const std::string bytes = pdf({sheet, sheet, {}}), page = first_page(bytes);
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_NE(bytes.find("/Count 3"), std::string::npos);
    EXPECT_NE(bytes.find("(three pages)"), std::string::npos);
    EXPECT_EQ(bytes, pdf({sheet, sheet, {}}));
    for (const char* drawn : {"72 144 m 216 144 l S", "[ 6.80315 2.834646] 0 d", "0.708661 w", "(Groove)Tj"})
        EXPECT_NE(page.find(drawn), std::string::npos) << drawn << " in\n" << page;
}

// A box that moves to the right: both frames have the size of the whole motion, and each pixel stands for the same place.
TEST(DrawFrames, ShowAMotionFromOnePlace) {
    const std::vector<Picture> frames = draw_frames({{box({0, 0, 0}, {4, 4, 4}, kRed)}, {box({10, 0, 0}, {14, 4, 4}, kRed)}}, {}, 100);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].width, frames[1].width);
    EXPECT_EQ(frames[0].low_mm, frames[1].low_mm);
    EXPECT_GT(pixel(frames[0], 2.0, 2.0)[0], 50);
    EXPECT_EQ(pixel(frames[0], 12.0, 2.0), (std::array{255, 255, 255}));
    EXPECT_GT(pixel(frames[1], 12.0, 2.0)[0], 50);
}

// PNG, third edition: acTL with the count, fcTL before each frame, the second frame's pixels in fdAT.
TEST(AnimatedPng, HoldsEachFrame) {
    const std::vector<Picture> frames = draw_frames({{box({0, 0, 0}, {4, 4, 4}, kRed)}, {box({10, 0, 0}, {14, 4, 4}, kRed)}}, {}, 100);
    const std::string file = animated_png(frames, 125), first = png(frames[0]);
    std::vector<std::string> types;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) length = length * 256 + static_cast<unsigned char>(file[at + k]);
        types.push_back(file.substr(at + 4, 4));
        at += length + 12;
        if (types.size() == 1) {
            EXPECT_EQ(file.substr(0, at), first.substr(0, at)) << "the header of the first frame";
        }
    }
    EXPECT_EQ(types, (std::vector<std::string>{"IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "IEND"}));
    EXPECT_EQ(file.compare(file.find("acTL") + 4, 8, std::string("\0\0\0\2\0\0\0\0", 8)), 0) << "two frames, for ever";
}

}  // namespace
}  // namespace fusee::drawing
