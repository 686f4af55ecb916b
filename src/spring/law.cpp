#include "fusee/spring/law.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/spring/enclosure.h"
#include "rules.h"

namespace fusee::spring {

namespace {

constexpr std::size_t kScanPoints = 801;

/// One condition "margin above 0" on every point of a law.
struct Condition {
    const char* rule;
    const char* what;
    const char* unit;
    core::Bound bound;
    double allowed;
    std::function<double(const LawPoint&)> measure;
    [[nodiscard]] double margin(const LawPoint& p) const {
        return bound == core::Bound::kAtLeast ? measure(p) - allowed : allowed - measure(p);
    }
    [[nodiscard]] bool broken(const LawPoint& p) const { return !(margin(p) > 0.0); }
};

std::optional<core::Finding> judge(const Condition& condition, const std::vector<LawPoint>& points) {
    std::size_t first = points.size(), last = 0, worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (condition.margin(points[i]) < condition.margin(points[worst])) worst = i;
        if (!condition.broken(points[i])) continue;
        first = std::min(first, i);
        last = i;
    }
    if (first == points.size()) return std::nullopt;
    core::Finding finding = core::error_finding(condition.rule, condition.what, condition.measure(points[worst]), condition.bound,
                                                condition.allowed, condition.unit);
    finding.where = fmt::format("law at {:.4g} Nm first, worst at {:.4g} Nm", points[first].tau, points[worst].tau);
    finding.suggestion = nearest_feasible(points, first, last);
    finding.source = "docs/theory/springs.md, eq. 3";
    return finding;
}

/// The conditions on stiffnesses alone come first.
const std::vector<Condition>& conditions() {
    using core::Bound;
    static const std::vector<Condition> all = {
        {"law.transmission", "the transmission T = S/(S+P) must stay above 0", "", Bound::kAtLeast, 0.0, &LawPoint::transmission},
        {"law.transmission", "the transmission T = S/(S+P) must stay below 1", "", Bound::kAtMost, 1.0, &LawPoint::transmission},
        {"law.stiffness", "the series stiffness S must stay above 0", "Nm/rad", Bound::kAtLeast, 0.0, &LawPoint::s},
        {"law.stiffness", "the parallel stiffness P must stay above 0", "Nm/rad", Bound::kAtLeast, 0.0, &LawPoint::p},
        {"law.torque", "the series torque must stay above 0: a cable cannot push", "Nm", Bound::kAtLeast, 0.0, &LawPoint::f_se},
        {"law.torque", "the parallel torque must stay above 0: a cable cannot push", "Nm", Bound::kAtLeast, 0.0, &LawPoint::f_pe},
    };
    return all;
}
constexpr std::size_t kOfStiffnesses = 3;

core::Findings judge_all(const std::vector<LawPoint>& points, std::span<const Condition> rules) {
    core::Findings findings;
    for (const Condition& condition : rules)
        if (auto finding = judge(condition, points)) findings.push_back(std::move(*finding));
    return findings;
}

}  // namespace

std::vector<LawPoint> sample_by_load(const SpringLaw& law, std::size_t count) {
    if (count < 2) throw core::InvalidInput("count", fmt::format("{}", count), "at least 2 points");
    const core::Range loads = law.loads();
    std::vector<LawPoint> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.push_back(law.at_load(loads.level(i, count)));
    return points;
}

core::Findings check_law(const SpringLaw& law) {
    core::Findings findings = judge_all(sample_by_load(law, kScanPoints), conditions());
    for (core::Finding& f : findings)
        if (f.suggestion.changes().empty()) f.suggestion.or_else("one spring alone, which may have any torque: kind = \"spring\"");
    return findings;
}

core::Range require_torques(double start, double end) {
    core::require_positive("law.start_torque_Nm", start, "Nm");
    core::require_positive("law.end_torque_Nm", end, "Nm");
    if (end <= start)
        throw core::InvalidInput("law.end_torque_Nm", fmt::format("{:g}", end), fmt::format("above start_torque = {:g} Nm", start));
    return {start, end};
}

core::Findings check_stiffnesses(const std::vector<LawPoint>& points) {
    return judge_all(points, std::span(conditions()).first(kOfStiffnesses));
}

core::Suggestion nearest_feasible(const std::vector<LawPoint>& points, std::size_t first, std::size_t last) {
    constexpr double kUseful = 0.2;  // share of its loads: less of a law is another law
    const double least = kUseful * (points.back().tau - points.front().tau);
    if (first > 1 && points[first - 1].tau - points.front().tau >= least)
        return core::change("law.end_torque_Nm", core::number(points[first - 1].tau, 4));
    if (last + 2 < points.size() && points.back().tau - points[last + 1].tau >= least)
        return core::change("law.start_torque_Nm", core::number(points[last + 1].tau, 4));
    return first > 1 || last + 2 < points.size() ? "another law: less than a fifth of this one is feasible"
                                                 : "another law: no part of this one is feasible";
}

std::vector<double> scan_loads(core::Range loads) {
    std::vector<double> result;
    for (std::size_t i = 0; i < kScanPoints; ++i) result.push_back(loads.level(i, kScanPoints));
    return result;
}

std::vector<LawSegment> segments(const SpringLaw& law) {
    const auto* enclosed = dynamic_cast<const EnclosedLaw*>(&law);
    return enclosed ? enclosed->segments() : std::vector<LawSegment>{};
}

std::vector<double> cuts(core::Range range, const std::vector<double>& places) {
    std::vector<double> all{range.low, range.high};
    std::copy_if(places.begin(), places.end(), std::back_inserter(all), [range](double at) { return range.low < at && at < range.high; });
    return core::sorted_unique(std::move(all));
}

}  // namespace fusee::spring
