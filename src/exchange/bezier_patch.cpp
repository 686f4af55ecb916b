#include "bezier_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fusee::exchange {

namespace {

constexpr int kMost = BezierPatch::kMostPoles;
constexpr int kDeepest = 8;             // divisions
constexpr int kMostSteps = 30;          // of Newton's method
constexpr double kBorder = 1e-7;        // of s and t
constexpr double kOn_mm = 1e-9;         // poles nearer to the line count as on both sides
constexpr double kFound = 1e-14;        // last step of s and t
constexpr double kFarthestStart = 0.5;  // Newton's method may leave its part by as much

/// Distance from the line's vertical plane and from its height, each times the weight.
using Offset = std::array<double, 2>;
using Net = std::array<std::array<Offset, kMost>, kMost>;

struct Interval {
    double low, high;
    void add(double v) { low = std::min(low, v), high = std::max(high, v); }
    [[nodiscard]] bool holds_zero() const { return low <= 0.0 && high >= 0.0; }
};
Interval product(Interval a, Interval b) {
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
}

/// Bernstein polynomials of degree `count` - 1 at x, and their derivatives.
struct Basis {
    Basis(int count, double x) {
        std::array<double, kMost> lower{};
        value[0] = 1.0;
        for (int n = 1; n < count; ++n) {
            lower = value;
            for (int k = n; k >= 0; --k) at(value, k) = (1.0 - x) * at(lower, k) + x * before(lower, k);
        }
        for (int k = 0; k < count; ++k) at(slope, k) = (count - 1) * (before(lower, k) - (k < count - 1 ? at(lower, k) : 0.0));
    }
    std::array<double, kMost> value{}, slope{};

private:
    static double& at(std::array<double, kMost>& a, int k) { return a[static_cast<std::size_t>(k)]; }
    static double before(const std::array<double, kMost>& a, int k) { return k > 0 ? a[static_cast<std::size_t>(k - 1)] : 0.0; }
};

/// A part of the patch: its net and its range of (s, t).
struct Piece {
    Net net{};
    double s = 0.0, t = 0.0, width = 1.0;
};

class Search {
public:
    Search(const BezierPatch& patch, double azimuth, double z_mm) : rows_(patch.rows), columns_(patch.columns) {
        const double nx = -std::sin(azimuth), ny = std::cos(azimuth);
        Piece whole;
        for (int i = 0; i < rows_; ++i)
            for (int j = 0; j < columns_; ++j) {
                const auto& [x, y, z, w] = patch.poles[static_cast<std::size_t>(i * columns_ + j)];
                at(whole.net, i, j) = {nx * x + ny * y, z - w * z_mm};
            }
        search(whole, 0);
    }
    std::vector<PatchPoint> found;

private:
    static Offset& at(Net& net, int i, int j) { return net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; }
    static const Offset& at(const Net& net, int i, int j) { return net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; }

    void search(const Piece& piece, int depth) {
        if (beside(piece.net)) return;
        const bool last = depth == kDeepest;
        if (last || at_most_one(piece.net))
            if (const auto point = newton(piece.net)) return keep(piece, *point);
        if (last) return;
        for (const Piece& half : halves(piece, true))
            for (const Piece& quarter : halves(half, false)) search(quarter, depth + 1);
    }

    [[nodiscard]] bool beside(const Net& net) const {
        for (std::size_t k = 0; k < 2; ++k) {
            Interval range{at(net, 0, 0)[k], at(net, 0, 0)[k]};
            for (int i = 0; i < rows_; ++i)
                for (int j = 0; j < columns_; ++j) range.add(at(net, i, j)[k]);
            if (range.low > kOn_mm || range.high < -kOn_mm) return true;
        }
        return false;
    }

    /// Is every matrix of partial derivatives within their intervals regular? Then the offsets are different at different points.
    [[nodiscard]] bool at_most_one(const Net& net) const {
        std::array<Interval, 2> by_s{}, by_t{};
        for (std::size_t k = 0; k < 2; ++k) {
            const double s = at(net, 1, 0)[k] - at(net, 0, 0)[k], t = at(net, 0, 1)[k] - at(net, 0, 0)[k];
            by_s[k] = {s, s}, by_t[k] = {t, t};
            for (int i = 0; i < rows_; ++i)
                for (int j = 0; j < columns_; ++j) {
                    if (i > 0) by_s[k].add(at(net, i, j)[k] - at(net, i - 1, j)[k]);
                    if (j > 0) by_t[k].add(at(net, i, j)[k] - at(net, i, j - 1)[k]);
                }
        }
        const Interval a = product(by_s[0], by_t[1]), b = product(by_s[1], by_t[0]);
        return !Interval{a.low - b.high, a.high - b.low}.holds_zero();
    }

    /// The root within the part, or at most kBorder outside. None if the method leaves the part or does not converge.
    [[nodiscard]] std::optional<PatchPoint> newton(const Net& net) const {
        PatchPoint p{0.5, 0.5};
        for (int step = 0; step < kMostSteps; ++step) {
            const Basis s(rows_, p.s), t(columns_, p.t);
            Offset value{}, by_s{}, by_t{};
            for (int i = 0; i < rows_; ++i)
                for (int j = 0; j < columns_; ++j) {
                    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
                    for (std::size_t k = 0; k < 2; ++k) {
                        const double offset = net[a][b][k];
                        value[k] += s.value[a] * t.value[b] * offset;
                        by_s[k] += s.slope[a] * t.value[b] * offset;
                        by_t[k] += s.value[a] * t.slope[b] * offset;
                    }
                }
            const double det = by_s[0] * by_t[1] - by_s[1] * by_t[0];
            if (det == 0.0) return std::nullopt;
            const double ds = (value[0] * by_t[1] - value[1] * by_t[0]) / det, dt = (by_s[0] * value[1] - by_s[1] * value[0]) / det;
            p.s -= ds, p.t -= dt;
            if (!(std::abs(p.s - 0.5) < 0.5 + kFarthestStart && std::abs(p.t - 0.5) < 0.5 + kFarthestStart)) return std::nullopt;
            if (std::abs(ds) + std::abs(dt) > kFound && step + 1 < kMostSteps) continue;
            const auto inside = [](double x) { return x >= -kBorder && x <= 1.0 + kBorder; };
            return inside(p.s) && inside(p.t) && std::abs(ds) + std::abs(dt) < kBorder ? std::optional(p) : std::nullopt;
        }
        return std::nullopt;
    }

    /// Keeps a root of a part, once only: neighbouring parts share their borders.
    void keep(const Piece& piece, const PatchPoint& point) {
        const PatchPoint p{std::clamp(piece.s + piece.width * point.s, 0.0, 1.0), std::clamp(piece.t + piece.width * point.t, 0.0, 1.0)};
        const auto same = [&](const PatchPoint& q) { return std::abs(p.s - q.s) + std::abs(p.t - q.t) < kBorder; };
        if (std::none_of(found.begin(), found.end(), same)) found.push_back(p);
    }

    /// Both halves along s or t by de Casteljau's algorithm. The half along s keeps its width until it is halved along t too.
    [[nodiscard]] std::array<Piece, 2> halves(const Piece& piece, bool along_s) const {
        std::array<Piece, 2> half{piece, piece};
        const int count = along_s ? rows_ : columns_, lines = along_s ? columns_ : rows_;
        const auto pole = [along_s](Net& net, int k, int line) -> Offset& { return along_s ? at(net, k, line) : at(net, line, k); };
        for (int line = 0; line < lines; ++line)
            for (int n = 1; n < count; ++n) {
                // After n rounds the first half holds the first n + 1 of its poles; the second half holds the round's means.
                for (int k = 0; k < count - n; ++k)
                    for (std::size_t c = 0; c < 2; ++c)
                        pole(half[1].net, k, line)[c] = 0.5 * (pole(half[1].net, k, line)[c] + pole(half[1].net, k + 1, line)[c]);
                pole(half[0].net, n, line) = pole(half[1].net, 0, line);
            }
        (along_s ? half[1].s : half[1].t) += 0.5 * piece.width;
        if (!along_s) half[0].width = half[1].width = 0.5 * piece.width;
        return half;
    }

    int rows_, columns_;
};

}  // namespace

std::vector<PatchPoint> crossings(const BezierPatch& patch, double azimuth, double z_mm) {
    return std::move(Search(patch, azimuth, z_mm).found);
}

}  // namespace fusee::exchange
