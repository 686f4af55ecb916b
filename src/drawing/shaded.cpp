#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/drawing/picture.h"

namespace fusee::drawing {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr int kFine = 2;                            // samples of a pixel in each direction
constexpr double kMargin = 0.03;                    // of the longer side, left white around the objects
constexpr double kEdgeCosine = 0.8660254037844387;  // of 30 degrees between two faces
constexpr double kStep = 8.0;                       // samples by which the depth of one object jumps at an edge
constexpr double kAmbient = 0.42, kDiffuse = 0.58, kEdgeLight = 0.25;
constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

/// Do what std::ceil and std::lround do, which are calls of functions. @pre x >= 0, below 2^31
int ceil_of(double x) {
    const int whole = static_cast<int>(x);
    return whole + (whole < x ? 1 : 0);
}
std::uint8_t rounded(double x) { return static_cast<std::uint8_t>(x + 0.5); }

/// A triangle as seen: its corners among the scene's points.
struct Face {
    solid::Triangle corner;
    std::uint32_t object = 0;
    Vector3d normal;  ///< in the view's frame, z towards the eye
};

/// What the eye can see: x to the right and y up [mm], depth towards the eye.
struct Scene {
    std::vector<Vector3d> points;
    std::vector<Face> faces;  ///< those turned to the eye
};

Scene scene_from(std::span<const Object> objects, const Projection& view) {
    Eigen::Matrix3d turn;
    turn << view.right.transpose(), view.up.transpose(), view.towards.transpose();
    Scene scene;
    std::size_t points = 0, faces = 0;
    for (const Object& object : objects) points += object.mesh.points_mm.size(), faces += object.mesh.triangles.size();
    scene.points.reserve(points);
    scene.faces.reserve(faces);
    for (std::size_t o = 0; o < objects.size(); ++o) {
        const auto first = static_cast<std::uint32_t>(scene.points.size());
        for (const solid::Vec3& p : objects[o].mesh.points_mm) scene.points.emplace_back(turn * Vector3d(p[0], p[1], p[2]));
        for (const solid::Triangle& t : objects[o].mesh.triangles) {
            const solid::Triangle corner{first + t[0], first + t[1], first + t[2]};
            const Vector3d& p = scene.points[corner[0]];
            const Vector3d normal = (scene.points[corner[1]] - p).cross(scene.points[corner[2]] - p);
            if (normal.z() > 0.0) scene.faces.push_back({corner, static_cast<std::uint32_t>(o), normal.normalized()});
        }
    }
    return scene;
}

using Columns = std::array<int, 2>;  ///< first and last, none where the last is less

/// What is nearest to the eye at each sample of a band of rows: the band stays in the processor's cache, which the whole picture exceeds.
class DepthBuffer {
public:
    /// @param points of the scene, x and y in samples @param sample_mm size of one
    DepthBuffer(const std::vector<Vector3d>& points, int width, int rows, double sample_mm)
        : points_(points),
          width_(width),
          rows_(rows),
          sample_(sample_mm),
          drawn_(static_cast<std::size_t>(rows), Columns{0, width - 1}),
          depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows)),
          face_(depth_.size()) {}

    /// Empties the band, which begins at row `top`.
    void begin(int top) {
        top_ = top;
        for (int row = 0; row < rows_; ++row) {
            auto& [first, last] = drawn_[static_cast<std::size_t>(row)];
            if (const auto at = static_cast<std::ptrdiff_t>(index_of(first, top + row)); first <= last) {
                std::fill_n(depth_.begin() + at, last - first + 1, -std::numeric_limits<float>::infinity());
                std::fill_n(face_.begin() + at, last - first + 1, kNothing);
            }
            first = width_, last = -1;
        }
    }
    /// First and last row of a face, which may lie outside the picture.
    [[nodiscard]] std::array<int, 2> rows_of(const Face& face) const {
        const auto [low, high] = std::minmax({points_[face.corner[0]].y(), points_[face.corner[1]].y(), points_[face.corner[2]].y()});
        return {ceil_of(std::max(0.0, low)), static_cast<int>(high)};
    }
    void add(const Face& face, std::uint32_t index) {
        const std::array<const Vector3d*, 3> p{&points_[face.corner[0]], &points_[face.corner[1]], &points_[face.corner[2]]};
        const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
        const auto [left, right] = std::minmax({p[0]->x(), p[1]->x(), p[2]->x()});
        if (ceil_of(std::max(0.0, left)) > right) return;  // between two columns
        const double area = cross((*p[1] - *p[0]).head<2>(), (*p[2] - *p[0]).head<2>());
        if (area == 0.0) return;
        std::array<Vector3d, 3> share;  // of the corner k at (x, y): share . (x, y, 1), 0 on the edge opposite to it
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d &a = *p[(k + 1) % 3], &b = *p[(k + 2) % 3];
            share[k] = Vector3d(a.y() - b.y(), b.x() - a.x(), cross(a.head<2>(), b.head<2>())) / area;
        }
        const Vector3d depth = share[0] * p[0]->z() + share[1] * p[1]->z() + share[2] * p[2]->z();
        const auto [first, last] = rows_of(face);
        for (int y = std::max(top_, first); y <= std::min(top_ + rows_ - 1, last); ++y) fill_row(y, share, depth, index);
    }
    /// @pre the row is one of the band
    [[nodiscard]] std::size_t index_of(int x, int y) const {
        return static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::uint32_t face(std::size_t at) const { return face_[at]; }
    /// Where a row and the next `more` have a face. @pre they are of the band
    [[nodiscard]] Columns drawn(int y, int more) const {
        Columns all{width_, -1};
        for (const Columns& row : std::span(drawn_).subspan(static_cast<std::size_t>(y - top_), static_cast<std::size_t>(more) + 1))
            all = {std::min(all[0], row[0]), std::max(all[1], row[1])};
        return all;
    }
    /// How many pixels from this sample on show what it shows, with the samples beside them and below. @pre `most` have these
    [[nodiscard]] int even_pixels(std::size_t at, int most) const {
        static_assert(kFine == 2);
        const std::uint32_t *row = face_.data() + at, face = *row;
        int samples = 0;
        while (samples <= kFine * most && row[samples] == face && row[samples + width_] == face && row[samples + 2 * width_] == face)
            ++samples;
        return std::max(0, samples - 1) / kFine;
    }
    /// Is there an edge between two neighbouring samples?
    [[nodiscard]] bool edge_between(const std::vector<Face>& faces, std::size_t a, std::size_t b) const {
        if (face_[a] == face_[b]) return false;
        if (face_[a] == kNothing || face_[b] == kNothing) return true;
        const Face &one = faces[face_[a]], &other = faces[face_[b]];
        if (one.object != other.object || one.normal.dot(other.normal) < kEdgeCosine) return true;
        const double steepest = std::max(0.1, std::min(one.normal.z(), other.normal.z()));
        return std::abs(depth_[a] - depth_[b]) > kStep * sample_ / steepest;
    }

private:
    /// The samples of a row at which no share is below 0.
    void fill_row(int y, const std::array<Vector3d, 3>& share, const Vector3d& depth, std::uint32_t index) {
        double low = 0.0, high = width_ - 1;
        for (const Vector3d& s : share) {
            const double at_zero = s.y() * y + s.z();
            if (s.x() > 0.0) low = std::max(low, -at_zero / s.x());
            if (s.x() < 0.0) high = std::min(high, -at_zero / s.x());
            if (s.x() == 0.0 && at_zero < 0.0) return;
        }
        if (high < low) return;
        const int first = ceil_of(low), last = static_cast<int>(high);
        if (last < first) return;
        Columns& drawn = drawn_[static_cast<std::size_t>(y - top_)];
        drawn = {std::min(drawn[0], first), std::max(drawn[1], last)};
        float* const depths = depth_.data() + index_of(0, y);
        std::uint32_t* const faces = face_.data() + index_of(0, y);
        const double along = depth.x(), down = depth.y() * y, start = depth.z();
        for (int x = first; x <= last; ++x) {
            const auto z = static_cast<float>(along * x + down + start);
            if (z > depths[x]) depths[x] = z, faces[x] = index;
        }
    }

    const std::vector<Vector3d>& points_;
    int width_, rows_, top_ = 0;
    double sample_;
    std::vector<Columns> drawn_;  ///< of each row
    std::vector<float> depth_;
    std::vector<std::uint32_t> face_;
};

double light_on(const Face& face) {
    static const Vector3d kLight = Vector3d(-0.45, 0.65, 0.75).normalized();
    return kAmbient + kDiffuse * std::max(0.0, face.normal.dot(kLight));
}

/// Colours pixels: the mean of their samples, those beside an edge dark.
class Painter {
public:
    Painter(const DepthBuffer& buffer, const std::vector<Face>& faces, std::span<const Object> objects, int width, int height)
        : buffer_(buffer), faces_(faces), objects_(objects), width_(width), height_(height) {}

    [[nodiscard]] Colour even(std::uint32_t face) const {
        if (face == kNothing) return {255, 255, 255};
        const Colour own = objects_[faces_[face].object].colour;
        const double light = light_on(faces_[face]);
        return {rounded(light * own[0]), rounded(light * own[1]), rounded(light * own[2])};
    }
    [[nodiscard]] Colour mixed(int px, int py) const {
        Vector3d sum = Vector3d::Zero();
        for (int k = 0; k < kFine * kFine; ++k) sum += sample(px * kFine + k % kFine, py * kFine + k / kFine);
        sum /= kFine * kFine;
        return {rounded(sum[0]), rounded(sum[1]), rounded(sum[2])};
    }

private:
    [[nodiscard]] Vector3d sample(int x, int y) const {
        const std::size_t at = buffer_.index_of(x, y);
        const bool edge = (x + 1 < width_ && buffer_.edge_between(faces_, at, buffer_.index_of(x + 1, y))) ||
                          (y + 1 < height_ && buffer_.edge_between(faces_, at, buffer_.index_of(x, y + 1)));
        const std::uint32_t face = buffer_.face(at);
        const Colour own = face == kNothing ? Colour{255, 255, 255} : objects_[faces_[face].object].colour;
        return (edge ? kEdgeLight : face == kNothing ? 1.0 : light_on(faces_[face])) * Vector3d(own[0], own[1], own[2]);
    }

    const DepthBuffer& buffer_;
    const std::vector<Face>& faces_;
    std::span<const Object> objects_;
    int width_, height_;
};

/// Neighbouring pixels of a row whose first samples show one object.
struct Run {
    int y, first, last;
    std::uint32_t object;
};

/// Finds what is visible. @param runs in the order of the pixels
void find_visible(Picture& picture, const std::vector<Run>& runs, std::size_t objects) {
    const double pixel = picture.pixel_mm();
    const auto middle = [&](double x, int y) {
        return Vector2d(picture.low_mm.x() + (x + 0.5) * pixel, picture.high_mm.y() - (y + 0.5) * pixel);
    };
    picture.visible.assign(objects, {});
    for (const Run& run : runs) {
        Visible& v = picture.visible[run.object];
        const int pixels = run.last - run.first + 1;
        v.pixels += static_cast<std::size_t>(pixels), v.middle_mm += pixels * middle(0.5 * (run.first + run.last), run.y);
    }
    for (Visible& v : picture.visible)
        if (v.pixels > 0) v.middle_mm /= static_cast<double>(v.pixels), v.nearest_mm.setConstant(std::numeric_limits<double>::infinity());
    for (const Run& run : runs) {
        Visible& v = picture.visible[run.object];
        const double x = std::round((v.middle_mm.x() - picture.low_mm.x()) / pixel - 0.5);
        const Vector2d p = middle(std::clamp<double>(x, run.first, run.last), run.y);
        if ((p - v.middle_mm).squaredNorm() < (v.nearest_mm - v.middle_mm).squaredNorm()) v.nearest_mm = p;
    }
}

/// The faces of each band of so many rows, in their order.
std::vector<std::vector<std::uint32_t>> by_band(const DepthBuffer& buffer, const std::vector<Face>& faces, int height, int rows) {
    std::vector<std::vector<std::uint32_t>> bands(static_cast<std::size_t>((height + rows - 1) / rows));
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto [first, last] = buffer.rows_of(faces[i]);
        if (first > last) continue;
        for (int band = std::max(0, first - 1) / rows; band * rows <= std::min(last, height - 1); ++band)
            bands[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(i));
    }
    return bands;
}

/// Draws band by band.
void paint(Picture& picture, Scene scene, std::span<const Object> objects) {
    constexpr int kBand = 16;  // rows of pixels
    const int width = picture.width * kFine, height = picture.height * kFine;
    const double sample = picture.pixel_mm() / kFine;
    for (Vector3d& p : scene.points)
        p.head<2>() = Vector2d(p.x() - picture.low_mm.x(), picture.high_mm.y() - p.y()) / sample - Vector2d(0.5, 0.5);
    DepthBuffer buffer(scene.points, width, kBand * kFine + 1, sample);  // edges ask for a row below
    const auto bands = by_band(buffer, scene.faces, height, kBand * kFine);
    const Painter painter(buffer, scene.faces, objects, width, height);
    picture.rgb.assign(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 255);
    std::vector<Run> runs;
    const auto draw_row = [&](int y) {
        const auto [left, right] = buffer.drawn(y * kFine, kFine);
        const int first = std::max(0, left / kFine - 1), last = std::min(picture.width - 1, right / kFine);
        std::uint8_t* const row = picture.rgb.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
        std::uint8_t* rgb = row + 3 * static_cast<std::ptrdiff_t>(first);
        const int inner = (y + 1) * kFine < height ? std::min(last + 1, (width - 1) / kFine) : 0;  // these have samples beside and below
        for (int x = first, end = first; x <= last; x = end) {
            const std::size_t at = buffer.index_of(x * kFine, y * kFine);
            const std::uint32_t face = buffer.face(at);
            const int even = x < inner ? buffer.even_pixels(at, inner - x) : 0;
            const Colour colour = even > 0 ? painter.even(face) : painter.mixed(x, y);
            for (end = x + std::max(1, even); rgb != row + 3 * static_cast<std::ptrdiff_t>(end); rgb += 3)
                std::copy(colour.begin(), colour.end(), rgb);
            if (face == kNothing) continue;
            const std::uint32_t object = scene.faces[face].object;
            if (runs.empty() || runs.back().y != y || runs.back().last != x - 1 || runs.back().object != object)
                runs.push_back({y, x, x, object});
            runs.back().last = end - 1;
        }
    };
    for (std::size_t band = 0; band < bands.size(); ++band) {
        const int top = static_cast<int>(band) * kBand;
        buffer.begin(top * kFine);
        for (const std::uint32_t i : bands[band]) buffer.add(scene.faces[i], i);
        for (int y = top; y < std::min(top + kBand, picture.height); ++y) draw_row(y);
    }
    find_visible(picture, runs, objects.size());
}

/// Where objects are seen [mm], empty without any.
using Extent = Eigen::AlignedBox2d;

Extent extent_of(const Scene& scene) {
    Extent extent;
    for (const Face& face : scene.faces)
        for (const std::uint32_t corner : face.corner) extent.extend(scene.points[corner].head<2>());
    return extent;
}

Picture draw_within(const Extent& extent, Scene scene, std::span<const Object> objects, int longest_px) {
    if (longest_px < 16 || longest_px > 8000) throw core::InvalidInput("longest_px", std::to_string(longest_px), "16 to 8000");
    Vector2d low = Vector2d::Zero(), high = Vector2d::Ones();
    if (!extent.isEmpty()) low = extent.min(), high = extent.max();
    const double margin = kMargin * (high - low).maxCoeff();
    low.array() -= margin, high.array() += margin;
    const double pixel = (high - low).maxCoeff() / longest_px;
    Picture picture;
    picture.width = std::max(1, static_cast<int>(std::lround((high.x() - low.x()) / pixel)));
    picture.height = std::max(1, static_cast<int>(std::lround((high.y() - low.y()) / pixel)));
    picture.low_mm = low, picture.high_mm = low + pixel * Vector2d(picture.width, picture.height);
    paint(picture, std::move(scene), objects);
    return picture;
}

}  // namespace

Projection from_direction(double azimuth, double elevation) {
    Projection view;
    view.right = {-std::sin(azimuth), std::cos(azimuth), 0.0};
    view.towards = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
    view.up = view.towards.cross(view.right);
    return view;
}

Picture draw(std::span<const Object> objects, const Projection& view, int longest_px) {
    Scene scene = scene_from(objects, view);
    const Extent extent = extent_of(scene);
    return draw_within(extent, std::move(scene), objects, longest_px);
}

std::vector<Picture> draw_frames(const std::vector<std::vector<Object>>& frames, const Projection& view, int longest_px) {
    Extent all;
    for (const std::vector<Object>& objects : frames) all.extend(extent_of(scene_from(objects, view)));
    std::vector<Picture> pictures;
    pictures.reserve(frames.size());
    for (const std::vector<Object>& objects : frames) pictures.push_back(draw_within(all, scene_from(objects, view), objects, longest_px));
    return pictures;
}

}  // namespace fusee::drawing
