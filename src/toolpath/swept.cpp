#include "swept.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "fusee/core/turn.h"
#include "fusee/core/vector.h"

namespace fusee::toolpath {

namespace {

constexpr std::size_t kBins = 2048;
constexpr double kSame_mm = 1e-6;  // a hundredth of the interpreter's last digit
using core::kTurn;

using Vec = std::array<double, 3>;
using core::dot;
using core::minus;

void widen(std::optional<SweptInterval>& interval, double low, double high) {
    if (!interval)
        interval = SweptInterval{low, high};
    else
        *interval = {std::min(interval->low, low), std::max(interval->high, high)};
}

/// Roots of a t^2 - 2 b t + c = 0, the lower first.
std::optional<SweptInterval> roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0 || a <= 0.0) return std::nullopt;
    const double s = std::sqrt(discriminant);
    return SweptInterval{(b - s) / a, (b + s) / a};
}

}  // namespace

std::optional<SweptInterval> interval_in(const Capsule& capsule, double azimuth, double z) {
    const Vec ray{std::cos(azimuth), std::sin(azimuth), 0.0}, origin{0.0, 0.0, z};
    std::optional<SweptInterval> within;
    for (const Vec& end : {capsule.a, capsule.b}) {
        const Vec to = minus(end, origin);
        if (const auto r = roots(1.0, dot(ray, to), dot(to, to) - capsule.radius * capsule.radius)) widen(within, r->low, r->high);
    }
    const Vec axis = minus(capsule.b, capsule.a), from = minus(origin, capsule.a);
    const double length2 = dot(axis, axis);
    if (length2 == 0.0) return within;
    // |from + t ray|^2 - ((from + t ray).axis)^2/length2 = radius^2, and the foot on the axis within [0, length2].
    const double r = dot(ray, axis), f = dot(from, axis);
    const auto tube = roots(1.0 - r * r / length2, -(dot(from, ray) - f * r / length2),
                            dot(from, from) - f * f / length2 - capsule.radius * capsule.radius);
    if (!tube) return within;
    double low = tube->low, high = tube->high;
    if (r != 0.0) {
        const double first = -f / r, second = (length2 - f) / r;
        low = std::max(low, std::min(first, second));
        high = std::min(high, std::max(first, second));
    } else if (f < 0.0 || f > length2) {
        return within;
    }
    if (low <= high) widen(within, low, high);
    return within;
}

CutFloor::Swept::Swept(std::vector<Capsule> capsules) : bins_(kBins) {
    // Overlapping passes, seen from the spindle, remove the same volume.
    const auto key = [](const Capsule& c) {
        std::array<long long, 6> rounded{};
        for (std::size_t i = 0; i < 3; ++i) rounded[i] = std::llround(c.a[i] / kSame_mm), rounded[i + 3] = std::llround(c.b[i] / kSame_mm);
        return rounded;
    };
    std::sort(capsules.begin(), capsules.end(), [&](const Capsule& a, const Capsule& b) { return key(a) < key(b); });
    capsules.erase(std::unique(capsules.begin(), capsules.end(), [&](const Capsule& a, const Capsule& b) { return key(a) == key(b); }),
                   capsules.end());
    for (const Capsule& c : capsules) {
        const double x = 0.5 * (c.a[0] + c.b[0]), y = 0.5 * (c.a[1] + c.b[1]),
                     half = 0.5 * std::sqrt(dot(minus(c.b, c.a), minus(c.b, c.a)));
        near_.push_back({c, std::hypot(x, y) - half - c.radius, std::atan2(y, x), half + c.radius});
    }
    std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) { return a.least < b.least; });
    for (std::uint32_t i = 0; i < near_.size(); ++i) put(i);
}

void CutFloor::Swept::put(std::uint32_t i) {
    const Near& c = near_[i];
    const double half = c.least > 0.0 ? std::asin(c.reach / (c.least + c.reach)) : kTurn / 2.0;
    const auto bins = static_cast<long>(kBins);
    const long first = static_cast<long>(std::floor((c.azimuth - half) / kTurn * kBins)) - 1;
    const long count = std::min(bins, static_cast<long>(2.0 * half / kTurn * kBins) + 4);
    for (long k = first; k < first + count; ++k) bins_[static_cast<std::size_t>((k % bins + bins) % bins)].push_back(i);
}

std::optional<double> CutFloor::Swept::floor(double azimuth, double z) const {
    const double share = azimuth / kTurn - std::floor(azimuth / kTurn);
    const auto later = [](const SweptInterval& a, const SweptInterval& b) { return a.low > b.low; };
    std::priority_queue<SweptInterval, std::vector<SweptInterval>, decltype(later)> beyond(later);
    double bore = 0.0;  // open length from the axis on
    for (const std::uint32_t i : bins_[std::min(kBins - 1, static_cast<std::size_t>(share * kBins))]) {
        if (!beyond.empty() && near_[i].least > beyond.top().low) break;  // nor does any later one extend as far inwards
        if (const auto s = interval_in(near_[i].capsule, azimuth, z); s && s->high > 0.0) beyond.push(*s);
        for (; !beyond.empty() && beyond.top().low <= bore; beyond.pop()) bore = std::max(bore, beyond.top().high);
    }
    return beyond.empty() ? std::nullopt : std::optional(beyond.top().low);
}

}  // namespace fusee::toolpath
