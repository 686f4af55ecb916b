#include "fusee/spring/law.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/mirror.h"
#include "fusee/math/statistics.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/coil.h"

namespace fusee::pipeline {

namespace {

/// The profiles of both cables of a single spring, each alone: first of the one that pulls forth; the angle of the other counts down. Both
/// stand on one shaft whose key is at angle 0 of both bodies: the world of the way back is turned by the law's travel (docs/theory/cams.md,
/// eq. 23).
/// @param travel of the law [rad]
std::array<profile::Profile, 2> each_way(const profile::Profile& both, double travel) {
    using Way = profile::OneSpring::TwoCables::Way;
    std::array<profile::Profile, 2> ways{both, both};
    const auto set = [](profile::Profile& p, Way way) { std::get<profile::OneSpring>(p.law.curves).two_cables.way = way; };
    set(ways[0], Way::kForth);
    set(ways[1], Way::kBack);
    const auto& two = std::get<profile::OneSpring>(both.law.curves).two_cables;
    profile::PartSpec& back = ways[1].k_pe;
    if (two.back_preload > 0.0) back.spring.preload = two.back_preload;
    const double direction = back.cam.guide.direction + two.back_turned + back.cam.torque_sign * travel;
    back.cam = cam::mirrored(back.cam);
    back.cam.guide.direction = std::remainder(direction, core::kTurn);
    return ways;
}

std::atomic<std::size_t> g_resolved = 0;

/// The co-contraction nearest to `wanted` whose whole dead-band lies inside the law; none if there is no such co-contraction.
std::optional<double> covered_torque(const actuator::Actuator& joint, double wanted) {
    constexpr int kScan = 200;
    const auto covered = [&](double tau) { return actuator::dead_band(joint, tau).covered; };
    if (covered(wanted)) return wanted;
    const core::Range loads = joint.law->loads();
    // The motor torques at which a resting capstan's least and greatest load are the law's ends.
    const core::Range torques{loads.low + joint.gear_friction.at_rest(loads.low), loads.high - joint.gear_friction.at_rest(loads.high)};
    std::optional<double> nearest;
    for (int i = 0; i <= kScan; ++i) {
        const double tau = torques.low + torques.width() * i / kScan;
        if (covered(tau) && (!nearest || std::abs(tau - wanted) < std::abs(*nearest - wanted))) nearest = tau;
    }
    if (!nearest) return std::nullopt;
    double inside = *nearest, outside = wanted;
    for (int i = 0; i < 40; ++i) (covered(0.5 * (inside + outside)) ? inside : outside) = 0.5 * (inside + outside);
    return inside;
}

/// The edge of a dead-band lies about this share beyond the load at rest (docs/theory/dead_band.md).
constexpr double kBeyondRest = 0.06;

core::Finding covers(const actuator::Actuator& joint, const char* side, double torque, core::Bound bound) {
    const bool low = bound == core::Bound::kAtMost;
    const core::Range loads = joint.law->loads(), needed = joint.loads();
    const std::optional<double> covered = covered_torque(joint, torque);
    core::Finding f;
    f.rule = low ? "law.covers_least" : "law.covers_greatest";
    f.bound = bound;
    f.unit = "Nm";
    f.where = "law";
    f.source = "a capstan at motor torque tau rests at loads from tau/(1+mu) to tau/(1-mu) (docs/theory/dead_band.md)";
    if (!covered) {
        f.what = fmt::format("at no co-contraction do the springs carry every load that stiction can hold; the law's {} load", side);
        f.measured = low ? loads.low : loads.high;
        f.allowed = low ? (1.0 - kBeyondRest) * needed.low : (1.0 + kBeyondRest) * needed.high;
        f.suggestion = core::change(low ? "law.start_torque_Nm" : "law.end_torque_Nm", core::number(f.allowed, 3));
        return core::judged(f, core::Severity::kWarning);
    }
    f.what = fmt::format("{} co-contraction at which the springs carry every load that stiction can hold, against that in use", side);
    f.measured = *covered;
    f.allowed = torque;
    // The load that a law must reach grows about as the torque.
    f.suggestion = low ? core::change("rig.least_torque_Nm", core::number(1.005 * *covered, 3)).or_else("law.lead_in_deg larger")
                       : core::change("law.end_torque_Nm", core::number(1.01 * loads.high * torque / *covered, 3))
                             .or_else(core::change("rig.overdrive_torque_Nm", core::number(0.995 * *covered, 3)));
    return core::judged(f, core::Severity::kWarning);
}

/// Turns, lengths and ratings that the profile does not state. K_PE's cable takes a part of the energy that its spring need not hold.
/// @param series, parallel the most that the springs hold above their energy at the law's start [J]
void complete_springs(profile::Profile& profile, double series, double parallel) {
    for (const auto& [spec, energy] : {std::pair{&profile.k_se, series}, {&profile.k_pe, parallel}}) {
        spring::BaseSpring& s = spec->spring;
        spring::derive_coils(s);
        if (!spring::coil_known(s) || energy < 0.0) continue;
        spring::derive_length_and_rating(s, pulled_spring(*spec).load(energy) / s.rate);
    }
}

/// @param law lead-in included @param design_loads without it
ResolvedDesign with_law(profile::Profile profile, const spring::SpringLawPtr& law, core::Range design_loads) {
    const spring::LawPoint low = law->at_load(law->loads().low), high = law->at_load(law->loads().high);
    complete_springs(profile, high.u_se - low.u_se, high.u_pe - low.u_pe);
    actuator::Actuator joint = actuator_of(profile, law);
    return {std::move(profile), std::move(joint), design_loads, {}};
}

/// The energy of a single spring over its law, above that at the first angle [J].
core::Range energies(const spring::SpringLaw& law) {
    constexpr std::size_t kSamples = 801;
    core::Range held;
    for (const spring::LawPoint& p : spring::sample_by_load(law, kSamples))
        held = {std::min(held.low, p.u_pe), std::max(held.high, p.u_pe)};
    return held;
}

/// What the spring holds at the first angle against what the law takes out of it.
core::Finding holds_energy(const spring::BaseSpring& s, double taken, const std::string& table) {
    constexpr double kJoulePerMillijoule = 1e-3, kReserve = 1.05;  // of the preload: a spring without load gives no torque
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    core::Finding f;
    f.rule = "law.energy";
    f.what = "energy of the preloaded spring at the law's first angle, against what the law takes out of it";
    f.measured = 0.5 * s.rate * s.preload * s.preload / kJoulePerMillijoule;
    f.bound = core::Bound::kAtLeast;
    f.allowed = taken / kJoulePerMillijoule;
    f.unit = "mJ";
    f.where = table;
    const double preload = kReserve * std::sqrt(2.0 * taken / s.rate);
    f.suggestion = core::change(fmt::format("{}.spring.{}", table, torsion ? "preload_rad" : "preload_mm"),
                                core::number(torsion ? preload : core::mm_from_m(preload), 4));
    f.source = "docs/theory/cams.md, table 1: the spring's energy is that of the law";
    return core::judged(std::move(f), core::Severity::kError);
}

/// Measured rows beside the torque that was smoothed from them: a jump or a kink is rounded, and its rows lie farther off than noise does.
core::Finding follows_rows(const std::vector<double>& angles, const std::vector<double>& torques, const spring::TableOptions& smoothing,
                           std::string where) {
    constexpr double kShare = 0.02;              // of the largest torque: what a shop's cam is off anyhow
    constexpr double kScatter = 6.0 * 1.482602;  // times the median distance: normal noise has one row in 5e8 beyond it
    const spring::PotentialPtr law = spring::make_tabulated(angles, torques, smoothing);
    std::vector<double> differences;
    double greatest = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        differences.push_back(law->force(angles[i]) - torques[i]);
        greatest = std::max(greatest, std::abs(torques[i]));
    }
    const Misfit misfit = misfit_of(differences);
    core::Finding f;
    f.rule = "law.rows";
    f.what = "distance of a measured row from the torque smoothed from all: jumps and kinks are rounded";
    f.measured = std::abs(misfit.largest);
    f.allowed = std::max(kShare * greatest, kScatter * misfit.median);
    f.bound = core::Bound::kAtMost;
    f.unit = "Nm";
    f.where = fmt::format("{} at {:.4g} deg", where, core::deg_from_rad(angles[misfit.row - 1]));
    f.suggestion = core::Suggestion("a greater law.knots and law.smoothing = 0, or rows without the jump");
    f.source = "docs/guides/one-spring.md";
    return core::judged(std::move(f), core::Severity::kWarning);
}

/// That of each measured curve of the law.
core::Findings follow_rows(const profile::LawSpec& law) {
    if (const auto* pair = std::get_if<profile::TablePair>(&law.curves))
        return {follows_rows(pair->angle, pair->series, pair->smoothing, "law, series_Nm"),
                follows_rows(pair->angle, pair->parallel, pair->smoothing, "law, parallel_Nm")};
    if (const auto* one = std::get_if<profile::OneSpring>(&law.curves); one != nullptr && one->kind == profile::OneSpring::Kind::kTable)
        return {follows_rows(one->rows.x, one->rows.y, one->smoothing, "law")};
    return {};
}

core::Outcome<ResolvedDesign> resolve_one(profile::Profile profile);

/// The whole law, and the design of each cable.
core::Outcome<ResolvedDesign> resolve_both_ways(profile::Profile profile, const spring::SpringLawPtr& law) {
    std::vector<ResolvedDesign> ways;
    for (profile::Profile& way : each_way(profile, law->angles().width())) {
        auto design = resolve_one(std::move(way));
        if (!design) return design;
        ways.push_back(std::move(design).value());
    }
    actuator::Actuator alone{law, profile.rig.capstan_radius, profile.rig.capstan_radius, gear_friction(profile)};
    return ResolvedDesign{std::move(profile), std::move(alone), law->loads(), {}, std::move(ways)};
}

core::Outcome<ResolvedDesign> resolve_one(profile::Profile profile) {
    const auto law = spring_law(profile);
    if (!law) return law.refusal();
    if (profile.has_two_cables()) return resolve_both_ways(std::move(profile), *law);
    const cam::PartKind kind = profile.part_kinds().front();
    const core::Range held = energies(**law);
    core::Findings findings;
    if (profile.part(kind).cam.family == cam::Family::kRoller) {  // of a cable no energy is taken: it cannot push, which its arm shows
        findings = {holds_energy(profile.part(kind).spring, -held.low, profile.table_of(kind))};
        if (core::any_error(findings)) return findings;
    }
    complete_springs(profile, held.high, held.high);
    actuator::Actuator alone{*law, profile.rig.capstan_radius, profile.rig.capstan_radius, gear_friction(profile)};
    return ResolvedDesign{std::move(profile), std::move(alone), (*law)->loads(), std::move(findings)};
}

}  // namespace

actuator::Actuator actuator_of(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::Rig& rig = profile.rig;
    actuator::Actuator joint{
        law, rig.capstan_radius, rig.joint_radius, gear_friction(profile), rig.least_torque, rig.peak_torque, rig.overdrive_torque};
    actuator::validate(joint);
    return joint;
}

core::Outcome<ResolvedDesign> resolve_for_search(profile::Profile profile) {
    if (profile.is_spring()) return resolve_one(std::move(profile));
    const auto bare = spring_law(profile);
    if (!bare) return bare.refusal();
    const auto law = spring::with_lead_in(*bare, profile.law.lead_in_travel);
    if (!law) return law.refusal();
    return with_law(std::move(profile), *law, (*bare)->loads());
}

core::Outcome<ResolvedDesign> resolve(profile::Profile profile) {
    ++g_resolved;
    if (profile.is_spring()) {
        auto one = resolve_one(std::move(profile));
        if (!one) return one;
        ResolvedDesign design = std::move(one).value();
        core::append(design.findings, follow_rows(design.profile.law));
        return design;
    }
    const auto bare = spring_law(profile);
    if (!bare) return bare.refusal();
    if (core::Findings broken = spring::check_law(**bare); core::any_error(broken)) return broken;
    const auto law = spring::with_lead_in(*bare, profile.law.lead_in_travel);
    if (!law) return law.refusal();
    if (core::Findings broken = spring::check_law(**law); core::any_error(broken)) return broken;
    ResolvedDesign design = with_law(std::move(profile), *law, (*bare)->loads());
    const actuator::Actuator& joint = design.actuator;
    design.findings = {covers(joint, "least", joint.least_torque, core::Bound::kAtMost),
                       covers(joint, "greatest", joint.overdrive_torque, core::Bound::kAtLeast)};
    core::append(design.findings, follow_rows(design.profile.law));
    return design;
}

std::size_t resolve_count() { return g_resolved; }

Misfit misfit_of(const std::vector<double>& differences) {
    Misfit misfit;
    std::vector<double> distances;
    double squares = 0.0;
    for (const double difference : differences) {
        squares += difference * difference;
        distances.push_back(std::abs(difference));
        if (misfit.row == 0 || distances.back() > std::abs(misfit.largest)) misfit.largest = difference, misfit.row = distances.size();
    }
    misfit.rms = std::sqrt(squares / static_cast<double>(differences.size()));
    misfit.median = math::median(std::move(distances));
    return misfit;
}

std::vector<AskedPart> parts_of(const ResolvedDesign& design) {
    std::vector<AskedPart> parts;
    for (const ResolvedDesign& way : design.ways) parts.push_back({&way, cam::PartKind::kParallel});
    if (parts.empty())
        for (const cam::PartKind kind : design.profile.part_kinds()) parts.push_back({&design, kind});
    return parts;
}

spring::BaseSpring pulled_spring(const profile::PartSpec& spec) {
    if (spec.spring.kind == spring::BaseKind::kTorsion) return spec.spring;
    return spring::in_series_with_cable(spec.spring, spec.allowance.cable_compliance);
}

cam::ArmFunction ResolvedDesign::arm(cam::PartKind kind) const {
    return {kind, law(), spec(kind).spring, profile.rig.capstan_radius, spec(kind).allowance};
}

design::DrawnJoint ResolvedDesign::drawn_joint() const { return {actuator, profile.k_se.spring, pulled_spring(profile.k_pe)}; }

}  // namespace fusee::pipeline
