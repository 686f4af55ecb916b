#include "springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fix/judge.h"
#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/springs.h"
#include "fusee/spring/coil.h"
#include "search.h"

namespace fusee::search::init {

namespace {

// The largest springs that are tried for a first profile: as `fusee springs` winds them.
constexpr double kThickestWire_mm = 5.0, kWidestCoil = 40e-3, kMostCoils = 60.0, kLoosestIndex = 16.0;

/// Energy of a spring at its largest state or load [J].
double capacity(const spring::BaseSpring& s) {
    const double by_load = s.max_load > 0.0 ? s.max_load / s.rate : INFINITY, by_state = s.max_state > 0.0 ? s.max_state : INFINITY;
    const double state = std::min(by_load, by_state);
    return 0.5 * s.rate * state * state;
}

/// Energy of the largest spring that is wound of this wire [J].
double capacity_of_wire(spring::BaseKind kind, double wire) {
    spring::BaseSpring s;
    s.kind = kind;
    s.wire_diameter = wire;
    s.coil_diameter = std::min(kLoosestIndex * wire, kWidestCoil);
    s.active_coils = kMostCoils;
    s.wire_class = spring::WireClass::kSh;
    s.rate = spring::rate_of_coils(s);
    s.max_load = spring::allowed_share(s) * spring::tensile_strength(s) / spring::wire_stress(s, 1.0);
    return capacity(s);
}

constexpr std::size_t kMost = 1000;                    // springs of each kind: all of them
constexpr double kPlausible = 4.0;                     // times the limit of a rule of review: more is no first design
constexpr double kSlotOverWire = 0.1e-3;               // leg slot over the wire: rule assembly.leg_width allows 0 to 0.5 mm
constexpr double kSlotStep = 0.1e-3;                   // [m]
constexpr double kSlotLength = 1.8, kSlotDepth = 2.3;  // in wire diameters

/// Where the slot of K_SE has to be so that the spring's other leg stands to the left of a cable that leaves upwards (joint.leg_phase).
double slot_angle(const profile::PartSpec& k_se, const spring::BaseSpring& s) {
    const double turn = spring::leg_turn(s, s.preload);  // a left-hand coil rises clockwise
    return std::remainder(k_se.cam.guide.direction + 0.5 * core::kPi + (s.hand == spring::Hand::kRight ? -turn : turn), 2.0 * core::kPi);
}

/// A slot for the leg of this spring.
void cut_slot(profile::PartSpec& k_se, const spring::BaseSpring& s, double least_width) {
    solid::FeatureOptions& features = k_se.solid.features;
    features.leg_slot_angle = slot_angle(k_se, s);
    features.leg_slot_width = std::max(kSlotStep * std::ceil((s.wire_diameter + kSlotOverWire) / kSlotStep - 1e-9), least_width);
    features.leg_slot_length = std::max(kSlotLength * s.wire_diameter, features.leg_slot_width);
    features.leg_slot_depth = kSlotDepth * s.wire_diameter;
    features.leg_slot_radius = 0.5 * s.coil_diameter;
}

/// Does the coil stand around the bore, so that its leg finds a slot?
bool stands_around(const spring::BaseSpring& s, const profile::Profile& p) {
    const solid::HubOptions& hub = p.k_se.solid.hub;
    const double wall = checks::process_limits(p.process).loaded_wall;
    return 0.5 * s.coil_diameter - 0.5 * kSlotLength * s.wire_diameter >= 0.5 * (hub.bore_diameter + hub.bore_clearance) + wall;
}

profile::Profile with(const profile::Profile& profile, cam::PartKind part, const spring::BaseSpring& s, bool slot) {
    profile::Profile p = profile;
    (part == cam::PartKind::kSeries ? p.k_se : p.k_pe).spring = s;
    if (slot) cut_slot(p.k_se, s, checks::process_limits(p.process).detail);
    return profile::rounded(p, kSpringDigits);
}

core::Finding no_spring(cam::PartKind part, const pipeline::SpringSearch& search) {
    std::string rules;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, search.broken.size()); ++i)
        rules += fmt::format("{}{} ({} springs)", i == 0 ? "" : ", ", search.broken[i].first, search.broken[i].second);
    core::Finding f = core::error_finding(
        "init.spring",
        fmt::format("no spring of {:.4g} {} that carries {:.4g} to {:.4g} {} can be wound; most of those tried break {}",
                    search.wanted.rate, part == cam::PartKind::kSeries ? "Nm/rad" : "N/m", search.loads.low, search.loads.high,
                    part == cam::PartKind::kSeries ? "Nm" : "N", rules),
        0.0, core::Bound::kAtLeast, 1.0, "springs");
    f.where = search.table;
    return f;
}

/// How many times a figure is beyond its limit.
double overshoot(const core::Finding& f) {
    const double ratio = f.bound == core::Bound::kAtMost ? f.measured / f.allowed : f.allowed / f.measured;
    return ratio > 0.0 ? ratio : 0.0;
}

/// How good a profile is for one part: no finding that is broken, or no error.
bool judged_good(const profile::Profile& profile, cam::PartKind part, bool accept_reviews) {
    const auto design = pipeline::resolve(profile);
    if (!design) return false;
    const pipeline::EvaluatedPart seen = pipeline::evaluate_part(part, *design, pipeline::Depth::kOutline);
    for (const core::Finding& f : seen.findings) {
        if (f.severity == core::Severity::kError) return false;
        const bool of_spring = f.rule.starts_with("spring.") || f.rule.starts_with("assembly.");
        if (of_spring && f.severity == core::Severity::kWarning && overshoot(f) > kPlausible) return false;
        if (of_spring && f.severity != core::Severity::kPass && !(accept_reviews && f.severity == core::Severity::kWarning)) return false;
    }
    return true;
}

/// The first spring with a cam that is good. @param slot of K_SE for its leg
std::optional<profile::Profile> first_good(const profile::Profile& profile, const pipeline::SpringSearch& search, bool slot,
                                           bool accept_reviews) {
    for (const pipeline::FoundSpring& found : search.wound) {
        if (slot && !stands_around(found.spring, profile)) continue;
        const profile::Profile p = with(profile, search.part, found.spring, slot);
        if (fix::if_allowed([&] { return judged_good(p, search.part, accept_reviews); }).value_or(false)) return p;
    }
    return std::nullopt;
}

}  // namespace

std::vector<Store> stores_of(const Answers& answers, const spring::Catalogue& catalogue) {
    const auto design = pipeline::resolve_for_search(scaled("init", answers, start_of(answers)));
    if (!design) return {};
    const spring::SpringLaw& law = *design->law();
    const spring::LawPoint low = law.at_load(design->design_loads.low), high = law.at_load(design->design_loads.high);
    std::vector<Store> stores;
    for (const cam::PartKind part : pipeline::kBothParts) {
        const bool series = part == cam::PartKind::kSeries;
        const spring::BaseSpring& wanted = design->spec(part).spring;
        Store store{part, series ? high.u_se - low.u_se : high.u_pe - low.u_pe, 0.5 * wanted.rate * wanted.preload * wanted.preload};
        for (const double mm : checks::wire_sizes().mm) {
            if (mm > kThickestWire_mm) break;
            store.largest = capacity_of_wire(wanted.kind, core::m_from_mm(mm));
            if (store.largest < store.energy()) continue;
            store.least_wire = core::m_from_mm(mm);
            break;
        }
        store.offered = catalogue.of(wanted.kind).size();
        for (const spring::CatalogueSpring& row : catalogue.of(wanted.kind))
            if (capacity(row.spring) >= store.energy()) store.bought.push_back(row.name);
        stores.push_back(std::move(store));
    }
    return stores;
}

core::Findings not_held(const std::vector<Store>& stores) {
    core::Findings findings;
    for (const Store& store : stores) {
        if (store.least_wire > 0.0) continue;
        core::Finding f =
            core::error_finding("init.energy", "work of the law and preload, against the largest spring that is wound: wire of 5 mm",
                                store.energy(), core::Bound::kAtMost, store.largest, "J");
        f.where = to_string(store.part);
        f.source = "docs/theory/coils.md, eq. 1-4";
        findings.push_back(std::move(f));
    }
    return findings;
}

core::Outcome<profile::Profile> with_spring(const profile::Profile& profile, cam::PartKind part) {
    const auto design = pipeline::resolve(profile);
    if (!design) return design.refusal();
    const bool series = part == cam::PartKind::kSeries;
    core::Findings refusal;
    for (const bool accept_reviews : {false, true}) {
        const auto search = pipeline::find_springs(part, *design, {}, {.most = kMost, .accept_reviews = accept_reviews, .with_cam = false});
        if (!search) return search.refusal();
        for (const bool slot : {true, false}) {
            if (slot && !series) continue;
            if (auto p = first_good(profile, *search, slot, accept_reviews)) return *std::move(p);
        }
        refusal = {no_spring(part, *search)};
    }
    return refusal;
}

core::Outcome<profile::Profile> with_springs(const profile::Profile& profile) {
    profile::Profile around = profile;  // the coil stands around the spool's shaft, if such a spring can be wound
    around.k_se.spring.rod_diameter = profile.k_se.solid.hub.bore_diameter;
    auto series = with_spring(around, cam::PartKind::kSeries);
    if (!series) series = with_spring(profile, cam::PartKind::kSeries);
    if (!series) return series;
    return with_spring(*series, cam::PartKind::kParallel);
}

}  // namespace fusee::search::init
