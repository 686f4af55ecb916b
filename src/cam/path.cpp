#include "path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fusee/cam/contact.h"
#include "scan.h"

namespace fusee::cam {

WorkingArc::WorkingArc(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts)
    : arm_(arm), options_(options) {
    for (const Contact& c : contacts) entries_.push_back({c.path.psi, c.arm.tau});
    if (entries_.front().psi > entries_.back().psi) std::reverse(entries_.begin(), entries_.end());
}

PathPoint WorkingArc::at(double psi) const {
    constexpr std::size_t kMostKnown = 1U << 16U;  // 4 MB; an export asks for a few thousand
    psi = std::clamp(psi, entries_.front().psi, entries_.back().psi);
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = known_.find(psi); found != known_.end()) return found->second;
    }
    const PathPoint point = solved(psi);
    const std::lock_guard lock(mutex_);
    if (known_.size() < kMostKnown) known_.emplace(psi, point);
    return point;
}

PathPoint WorkingArc::solved(double psi) const {
    const auto after = std::upper_bound(entries_.begin() + 1, entries_.end() - 1, psi, [](double v, const Entry& e) { return v < e.psi; });
    const Entry &low = *(after - 1), &high = *after;
    const double tau = solve_between([&](double t) { return touch(arm_.kind(), arm_.at_load(t), options_).path.psi - psi; },
                                     std::min(low.tau, high.tau), std::max(low.tau, high.tau));
    PathPoint point = touch(arm_.kind(), arm_.at_load(tau), options_).path;
    point.psi = psi;
    return point;
}

Height::Height(const CamOptions& options, const std::vector<Contact>& contacts) : lead_(options.path.lead) {
    if (options.path.kind == PathKind::kPlanar) return;
    std::vector<Contact> rising = contacts;
    if (rising.front().path.psi > rising.back().path.psi) std::reverse(rising.begin(), rising.end());
    if (options.path.lead == Lead::kConstantPitch) {
        const double slope = options.path.pitch / (2.0 * core::kPi), low = rising.front().path.psi;
        for (const Contact& c : rising) entries_.push_back({c.path.psi, slope * (c.path.psi - low), slope});
        return;
    }
    // Along the free cable psi moves with the torque's sign; from the wound end on, z_guide - z decays with the integral of rho/span.
    if (options.torque_sign < 0) std::reverse(rising.begin(), rising.end());
    const double guide_z = options.guide.z;
    double decay = 0.0, earlier = 0.0;
    for (std::size_t i = 0; i < rising.size(); ++i) {
        const double rate = rising[i].path.rho / rising[i].span;
        if (i > 0) decay += 0.5 * (rate + earlier) * std::abs(rising[i].path.psi - rising[i - 1].path.psi);
        earlier = rate;
        const double gap = guide_z * std::exp(-decay);
        entries_.push_back({rising[i].path.psi, guide_z - gap, options.torque_sign * rate * gap});
    }
    if (options.torque_sign < 0) std::reverse(entries_.begin(), entries_.end());
}

double Height::at(double psi) const {
    if (entries_.empty()) return 0.0;
    psi = std::clamp(psi, entries_.front().psi, entries_.back().psi);
    const auto after = std::upper_bound(entries_.begin() + 1, entries_.end() - 1, psi, [](double v, const Entry& e) { return v < e.psi; });
    const Entry &a = *(after - 1), &b = *after;
    const double width = b.psi - a.psi, s = (psi - a.psi) / width;  // cubic Hermite: the slopes are known exactly
    return (1 + 2 * s) * (1 - s) * (1 - s) * a.z + s * (1 - s) * (1 - s) * width * a.slope + s * s * (3 - 2 * s) * b.z -
           s * s * (1 - s) * width * b.slope;
}

double Height::slope_at(bool high_end) const { return entries_.empty() ? 0.0 : high_end ? entries_.back().slope : entries_.front().slope; }

namespace {

/// One piece of a cubic with known slopes at both ends, over its share s. Its derivative is a parabola in Bernstein's form (each term is
/// positive, and the hull of the coefficients is a bound too); the second derivative is linear.
Height::AxialSlope axial_slope_between(const math::Interval& rise, const math::Interval& from, const math::Interval& to,
                                       const math::Interval& width, const math::Interval& s) {
    using boost::numeric::hull;
    const math::Interval amid = 3.0 * rise / width - from - to, rest = 1.0 - s;
    const math::Interval parabola = rest * rest * from + 2.0 * s * rest * amid + s * s * to;
    return {math::common(parabola, hull(hull(from, to), amid)), 2.0 * (rest * (amid - from) + s * (to - amid)) / width};
}

}  // namespace

Height::AxialSlope Height::over(const math::Interval& psi) const {
    using boost::numeric::hull;
    if (entries_.empty()) return {0.0, 0.0};
    if (lead_ == Lead::kConstantPitch) return {entries_.front().slope, 0.0};
    if (!(psi.upper() >= entries_.front().psi && psi.lower() <= entries_.back().psi)) return {math::whole_line(), math::whole_line()};
    auto b = std::lower_bound(entries_.begin() + 1, entries_.end() - 1, psi.lower(), [](const Entry& e, double v) { return e.psi < v; });
    std::optional<AxialSlope> all;
    for (; b != entries_.end() && (b - 1)->psi <= psi.upper(); ++b) {
        const Entry& a = *(b - 1);
        const math::Interval width = math::Interval(b->psi) - a.psi;
        const math::Interval share = math::common((psi - a.psi) / width, math::Interval(0.0, 1.0));
        const AxialSlope piece = axial_slope_between(math::Interval(b->z) - a.z, a.slope, b->slope, width, share);
        all = all ? AxialSlope{hull(all->first, piece.first), hull(all->second, piece.second)} : piece;
    }
    return *all;
}

namespace {

constexpr double kMostTwist = 0.35;  // of a run-out's groove: keeps 1/sqrt(1 + 0.35^2) = 94 % of its least radius in the plane

/// Angle over which the radius of a constant pitch changes: the groove's direction turns by dz/dpsi rho'/rho^2 per radian of arc.
double easing(const PathPoint& end, double axial_slope, Lead lead) {
    if (lead == Lead::kAimedAtGuide) return 0.0;
    const double least = std::min(end.rho, end.h);
    return std::abs(axial_slope * (end.h - end.rho)) / (kMostTwist * least * least);
}

}  // namespace

// Below the low end the arc runs backwards: with -psi for psi, h' changes its sign.
RunOut::RunOut(const PathPoint& end, int direction, double width, double axial_slope, Lead lead)
    : end_(end),
      direction_(direction),
      axial_slope_(axial_slope),
      lead_(lead),
      arc_(IdleArc::run_out({end.h, direction * end.slope, end.rho}, width, end.h, easing(end, axial_slope, lead))) {}

Height::AxialSlope RunOut::over(const math::Jet& rho) const {
    if (lead_ == Lead::kConstantPitch) return {axial_slope_, 0.0};
    const math::Interval share = math::Interval(axial_slope_) / end_.rho;
    return {share * rho.value, share * rho.slope};
}

PathPoint RunOut::at(double psi) const {
    const double x = direction_ * (psi - end_.psi);
    const SupportState s = arc_.at(x);
    const double gone = lead_ == Lead::kConstantPitch ? x : arc_.length(x) / end_.rho;
    return {psi, s.h, direction_ * s.slope, s.rho, end_.z + direction_ * axial_slope_ * gone};
}

}  // namespace fusee::cam
