#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/read_back.h"
#include "words.h"

namespace fusee::toolpath {

/// A sphere swept straight from a to b, in the part's body frame [mm]; in a plane, a disc.
struct Capsule {
    std::array<double, 3> a{}, b{};
    double radius = 0.0;
};

namespace {

/// Interval of a ray inside a swept volume, as distances from the axis.
struct SweptInterval {
    double low = 0.0, high = 0.0;
};

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

/// The interval of the line (0, 0, z) + t ray inside the capsule: a single one, since a capsule is convex.
std::optional<SweptInterval> interval_in(const Capsule& capsule, const Vec& ray, double z) {
    const Vec origin{0.0, 0.0, z};
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

/// Overlapping passes, seen from the spindle, remove the same volume: each capsule once.
std::vector<Capsule> once_each(const std::vector<Capsule>& capsules) {
    using Rounded = std::pair<std::array<long, 6>, std::size_t>;  // by its ends; its number
    std::vector<Rounded> all;
    all.reserve(capsules.size());
    for (const Capsule& c : capsules) {
        Rounded rounded{{}, all.size()};
        for (std::size_t i = 0; i < 3; ++i)
            rounded.first[i] = std::lrint(c.a[i] / kSame_mm), rounded.first[i + 3] = std::lrint(c.b[i] / kSame_mm);
        all.push_back(rounded);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(), [](const Rounded& a, const Rounded& b) { return a.first == b.first; }), all.end());
    return core::each<Capsule>(all, [&](const Rounded& one) { return capsules[one.second]; });
}

constexpr double kBelow_mm = 1e-3;      // a shallower move does not count as a cut
constexpr double kTurnStep_deg = 0.25;  // a rotary move's chord: 30 mm (0.0044)^2/8 = 7e-5 mm

/// A half plate as it lies on the machine.
struct PlateFrame {
    std::string name;
    double x = 0.0;
    bool turned = false;
    [[nodiscard]] std::array<double, 3> body(const Pose& p) const { return {p.x - x, turned ? -p.y : p.y, 0.0}; }
};

/// Just below the stock's top the cutter has removed everything that it passed at any depth: there the groove's floor is exposed.
std::vector<Capsule> discs(const Interpreted& program, std::size_t first, std::size_t last, const PlateFrame& frame, double radius) {
    std::vector<Capsule> capsules;
    for (std::size_t i = first; i < last; ++i) {
        const Move& move = program.moves[i];
        if (!move.rapid && std::min(move.from.z, move.to.z) < -kBelow_mm)
            capsules.push_back({frame.body(move.from), frame.body(move.to), radius});
    }
    return capsules;
}

/// Centre of the nose in the body frame: the part is turned back by A; x of the body is the spindle's direction, y against the machine's.
std::array<double, 3> nose_centre(const Pose& tip, double nose, double sign) {
    const double back = -sign * core::rad_from_deg(tip.a), u = tip.z + nose, v = -tip.y;
    return {u * std::cos(back) - v * std::sin(back), u * std::sin(back) + v * std::cos(back), tip.x};
}

std::vector<Capsule> noses(const Interpreted& program, double nose, double sign) {
    std::vector<Capsule> capsules;
    for (const Move& move : program.moves) {
        if (move.rapid) continue;
        const int steps = 1 + static_cast<int>(std::abs(move.to.a - move.from.a) / kTurnStep_deg);
        const auto at = [&](int i) {
            const double s = static_cast<double>(i) / steps;
            const Pose &p = move.from, &q = move.to;
            return nose_centre({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z), p.a + s * (q.a - p.a)}, nose, sign);
        };
        for (int i = 0; i < steps; ++i) capsules.push_back({at(i), at(i + 1), nose});
    }
    return capsules;
}

std::vector<std::string> require_words(const Interpreted& program, const std::string& begin, std::size_t count) {
    auto words = find_words(program, begin, count);
    if (words.empty()) throw core::IoError(program.file, "no comment that begins with \"" + begin + "\" says what is cut");
    return words;
}

}  // namespace

/// The volume that a cutter's end removed, sorted by azimuth.
class CutFloor::Swept {
public:
    explicit Swept(const std::vector<Capsule>& capsules);
    [[nodiscard]] std::optional<double> floor(double azimuth, double z) const;

private:
    struct Near {
        Capsule capsule;
        double least = 0.0;  ///< least distance from the axis [mm]; below 0: it may contain the axis
        std::array<double, 3> middle{};
        double reach = 0.0;  ///< radius of the sphere about the middle that holds it [mm]
    };
    void put(std::uint32_t i);

    std::vector<Near> near_;                        ///< nearest first
    std::vector<std::vector<std::uint32_t>> bins_;  ///< by azimuth: numbers of near_, ascending
};

CutFloor::Swept::Swept(const std::vector<Capsule>& capsules) : bins_(kBins) {
    for (const Capsule& c : once_each(capsules)) {
        const Vec axis = minus(c.b, c.a), middle{0.5 * (c.a[0] + c.b[0]), 0.5 * (c.a[1] + c.b[1]), 0.5 * (c.a[2] + c.b[2])};
        const double reach = 0.5 * std::sqrt(dot(axis, axis)) + c.radius;
        near_.push_back({c, std::hypot(middle[0], middle[1]) - reach, middle, reach});
    }
    std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) { return a.least < b.least; });
    for (std::uint32_t i = 0; i < near_.size(); ++i) put(i);
}

void CutFloor::Swept::put(std::uint32_t i) {
    const Near& c = near_[i];
    const double half = c.least > 0.0 ? std::asin(c.reach / (c.least + c.reach)) : kTurn / 2.0;
    const auto bins = static_cast<long>(kBins);
    const long first = static_cast<long>(std::floor((std::atan2(c.middle[1], c.middle[0]) - half) / kTurn * kBins)) - 1;
    const long count = std::min(bins, static_cast<long>(2.0 * half / kTurn * kBins) + 4);
    for (long k = first; k < first + count; ++k) bins_[static_cast<std::size_t>((k % bins + bins) % bins)].push_back(i);
}

std::optional<double> CutFloor::Swept::floor(double azimuth, double z) const {
    const double share = azimuth / kTurn - std::floor(azimuth / kTurn);
    const auto later = [](const SweptInterval& a, const SweptInterval& b) { return a.low > b.low; };
    std::priority_queue<SweptInterval, std::vector<SweptInterval>, decltype(later)> beyond(later);
    const Vec ray{std::cos(azimuth), std::sin(azimuth), 0.0};
    double bore = 0.0;  // open length from the axis on
    for (const std::uint32_t i : bins_[std::min(kBins - 1, static_cast<std::size_t>(share * kBins))]) {
        if (!beyond.empty() && near_[i].least > beyond.top().low) break;  // nor does any later one extend as far inwards
        const Near& one = near_[i];
        const double beside = one.middle[0] * ray[1] - one.middle[1] * ray[0], above = one.middle[2] - z;
        if (beside * beside + above * above > one.reach * one.reach) continue;
        if (one.middle[0] * ray[0] + one.middle[1] * ray[1] + one.reach <= bore) continue;  // within the bore
        if (const auto s = interval_in(one.capsule, ray, z); s && s->high > 0.0) beyond.push(*s);
        for (; !beyond.empty() && beyond.top().low <= bore; beyond.pop()) bore = std::max(bore, beyond.top().high);
    }
    return beyond.empty() ? std::nullopt : std::optional(beyond.top().low);
}

std::optional<double> CutFloor::radius(double azimuth, double z_mm) const { return swept_->floor(azimuth, z_mm); }

std::vector<CutFloor> cut_floors(const Interpreted& program) {
    const std::string cuts = require_words(program, "cuts", 2)[1];
    const double radius = 0.5 * number_in(program, require_words(program, "cutter", 3), 2);
    std::vector<CutFloor> floors;
    if (cuts == "wrap") {
        const double sign = number_in(program, require_words(program, "rotary", 2), 1);
        floors.push_back(CutFloor("wrap", std::make_shared<CutFloor::Swept>(noses(program, radius, sign))));
    } else if (cuts == "floor") {
        std::vector<std::pair<std::size_t, PlateFrame>> plates;
        for (const Note& note : program.notes)
            if (const auto w = core::words_of(note.text); w.size() == 5 && w[0] == "plate" && w[2] == "at")
                plates.emplace_back(note.before, PlateFrame{w[1], number_in(program, w, 3), w[4] == "turned"});
        for (std::size_t i = 0; i < plates.size(); ++i) {
            const std::size_t last = i + 1 < plates.size() ? plates[i + 1].first : program.moves.size();
            const PlateFrame& frame = plates[i].second;
            floors.push_back(CutFloor(frame.name, std::make_shared<CutFloor::Swept>(discs(program, plates[i].first, last, frame, radius))));
        }
    }
    return floors;
}

}  // namespace fusee::toolpath
