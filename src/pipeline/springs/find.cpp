#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fusee/checks/check.h"
#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/springs.h"
#include "fusee/spring/coil.h"

namespace fusee::pipeline {

namespace {

using core::m_from_mm;
using core::mm_from_m;

constexpr double kThickest_mm = 5.0, kWidest_mm = 40.0, kCoilStep_mm = 0.5, kTurnStep = 0.25;
constexpr double kMostTurns = 60.0;
constexpr double kLoosest = 16.0, kTightest = 4.0;  // index
constexpr double kRodClearance = 1.1;
constexpr std::array kLegRules = {"assembly.leg_radius", "assembly.leg_width", "assembly.leg_pressure", "assembly.anchor_reach"};

double up_to_step(double value, double step) { return step * std::ceil(value / step - 1e-9); }

bool is_torsion(const spring::BaseSpring& s) { return s.kind == spring::BaseKind::kTorsion; }

/// Judges springs on the cam of the profile's own spring.
class Judge {
public:
    Judge(const ResolvedDesign& design, solid::Part part, const spring::BaseSpring& own, bool accept_reviews)
        : design_(design), part_(std::move(part)), own_(own), accept_reviews_(accept_reviews) {
        for (const cam::Contact& c : part_.cam.working) states_.push_back(c.arm.state);
        for (const checks::Rule& rule : checks::rules())
            if (rule.group() == "spring" || std::find(kLegRules.begin(), kLegRules.end(), std::string_view(rule.id)) != kLegRules.end())
                rules_.push_back(&rule);
    }

    /// Largest state of a spring that stores the energies of the law.
    [[nodiscard]] double largest_state(const spring::BaseSpring& s) const {
        double largest = s.preload;
        for (const double state : states_) largest = std::max(largest, state_of(s, state));
        return largest;
    }

    /// @returns whether every rule passes; counts the rules that do not
    bool passes(const spring::BaseSpring& s) {
        for (std::size_t i = 0; i < states_.size(); ++i) part_.cam.working[i].arm.state = state_of(s, states_[i]);
        const profile::Profile& p = design_.profile;
        const checks::Design judged{part_, s, p.cable, p.process, p.limits};
        ++tried;
        for (const checks::Rule* rule : rules_)
            for (const core::Finding& f : rule->run(judged))
                if (f.severity == core::Severity::kError || (f.severity != core::Severity::kPass && !accepts(f)))
                    return ++broken[rule->id], false;
        return true;
    }

    std::size_t tried = 0;
    std::map<std::string, std::size_t> broken;

private:
    [[nodiscard]] bool accepts(const core::Finding& f) const { return accept_reviews_ && f.severity == core::Severity::kWarning; }
    [[nodiscard]] double state_of(const spring::BaseSpring& s, double state) const {
        return s.state(0.5 * own_.rate * (state * state - own_.preload * own_.preload));
    }

    const ResolvedDesign& design_;
    solid::Part part_;
    spring::BaseSpring own_;
    bool accept_reviews_;
    std::vector<double> states_;
    std::vector<const checks::Rule*> rules_;
};

/// The preload with which a spring of another rate bears the same load at the law's beginning.
void keep_first_load(spring::BaseSpring& s, const spring::BaseSpring& own) { s.preload = own.rate * own.preload / s.rate; }

/// The rod that the profile states, else the thickest usual one inside the coils at `state`; 0: none fits.
double rod_inside(const spring::BaseSpring& s, double state, const spring::BaseSpring& own) {
    if (own.rod_diameter > 0.0) return own.rod_diameter;
    const auto rod = checks::shaft_sizes().at_most(mm_from_m(spring::inside_diameter(s, state)) / kRodClearance);
    return rod ? m_from_mm(*rod) : 0.0;
}

/// What a winder states beside wire, coils and turns: rating, length, rod.
void complete(spring::BaseSpring& s, const Judge& judge, const spring::BaseSpring& own) {
    const double state = judge.largest_state(s);
    spring::derive_length_and_rating(s, state);
    s.rod_diameter = rod_inside(s, state, own);
}

double volume_of(const spring::BaseSpring& s) {
    const double outside = s.coil_diameter + s.wire_diameter;
    return 0.25 * core::kPi * outside * outside * s.free_length;
}

/// The coil diameters to try with one wire [mm]: steps, and the one whose leg stands in the part's slot.
std::vector<double> coils_of(double wire_mm, const solid::FeatureOptions& features, bool torsion) {
    std::vector<double> coils;
    for (double coil = up_to_step(kTightest * wire_mm, kCoilStep_mm); coil <= std::min(kLoosest * wire_mm, kWidest_mm);
         coil += kCoilStep_mm)
        coils.push_back(coil);
    const double slot = 2.0 * mm_from_m(features.leg_slot_radius);
    if (torsion && features.leg_slot_width > 0.0 && slot >= kTightest * wire_mm && slot <= kLoosest * wire_mm) coils.push_back(slot);
    return coils;
}

/// The profile's spring without the data of its coils, as the start of every other.
spring::BaseSpring bare(const spring::BaseSpring& own, const SpringSearchOptions& options, const cam::Cam& cam) {
    spring::BaseSpring s = own;
    s.tensile_strength = s.leg_bend_radius = s.free_length = s.max_state = s.max_load = 0.0;
    if (s.wire_class == spring::WireClass::kUnknown) s.wire_class = options.wire_class;
    if (s.cycles <= 0.0) s.cycles = options.cycles;
    if (is_torsion(s)) s.hand = cam.rotation_sign > 0 ? spring::Hand::kLeft : spring::Hand::kRight;
    return s;
}

void try_wound(const spring::BaseSpring& start, const spring::BaseSpring& own, const solid::FeatureOptions& features, double within,
               Judge& judge, std::vector<FoundSpring>& found) {
    for (const double wire_mm : checks::wire_sizes().mm) {
        if (wire_mm > kThickest_mm) break;
        for (const double coil_mm : coils_of(wire_mm, features, is_torsion(own))) {
            spring::BaseSpring s = start;
            s.wire_diameter = m_from_mm(wire_mm);
            s.coil_diameter = m_from_mm(coil_mm);
            s.rate = own.rate;
            s.active_coils = kTurnStep * std::round(spring::turns_for_rate(s) / kTurnStep);
            if (s.active_coils < kTurnStep || s.active_coils > kMostTurns) continue;
            s.rate = spring::rate_of_coils(s);
            if (std::abs(s.rate / own.rate - 1.0) > within) continue;
            keep_first_load(s, own);
            complete(s, judge, own);
            if (judge.passes(s))
                found.push_back({fmt::format("{:g} x {:g} x {:g}", wire_mm, coil_mm, s.active_coils), s, volume_of(s), false});
        }
    }
}

void try_bought(const spring::BaseSpring& start, const spring::BaseSpring& own, const spring::Catalogue& catalogue, Judge& judge,
                std::vector<FoundSpring>& found) {
    for (const spring::CatalogueSpring& row : catalogue.of(own.kind)) {
        spring::BaseSpring s = row.spring;
        s.cycles = start.cycles, s.motion = start.motion, s.hand = start.hand;
        keep_first_load(s, own);
        const double state = judge.largest_state(s);
        if (is_torsion(s)) s.free_length = spring::axial_space(s, state);
        s.rod_diameter = rod_inside(s, state, own);
        if (judge.passes(s)) found.push_back({row.name, s, volume_of(s), true});
    }
}

/// Does a cam for this spring pass the rules that need no mesh? Its contour may lose its convexity, although the spring passes.
bool has_cam(cam::PartKind kind, ResolvedDesign design, const spring::BaseSpring& s) {
    design.profile.part(kind).spring = s;
    try {
        return !core::any_error(evaluate_part(kind, design, Depth::kOutline).findings);
    } catch (const core::InvalidInput&) {  // coils longer than the pins of a follower's arm are apart
        return false;
    }
}

/// The first springs, with a cam if it is asked for.
void keep(std::vector<FoundSpring>& found, cam::PartKind kind, const ResolvedDesign& design, const SpringSearchOptions& options) {
    std::vector<FoundSpring> kept;
    for (FoundSpring& spring : found)
        if (kept.size() < options.most && (!options.with_cam || has_cam(kind, design, spring.spring))) kept.push_back(std::move(spring));
    found = std::move(kept);
}

}  // namespace

core::Outcome<SpringSearch> find_springs(cam::PartKind kind, const ResolvedDesign& design, const spring::Catalogue& catalogue,
                                         const SpringSearchOptions& options) {
    require_one_cable(design.profile, "springs for a cam");
    const profile::PartSpec& spec = design.spec(kind);
    const EvaluatedPart part = evaluate_part(kind, design, Depth::kOutline);
    if (part.reached < Depth::kOutline) return part.findings;
    Judge judge(design, *part.body, spec.spring, options.accept_reviews);
    SpringSearch search;
    search.part = kind;
    search.table = design.profile.table_of(kind);
    search.wanted = spec.spring;
    search.loads = {spec.spring.rate * spec.spring.preload, spec.spring.rate * judge.largest_state(spec.spring)};
    const spring::BaseSpring start = bare(spec.spring, options, *part.cam);
    try_wound(start, spec.spring, spec.solid.features, options.within, judge, search.wound);
    try_bought(start, spec.spring, catalogue, judge, search.bought);
    std::stable_sort(search.wound.begin(), search.wound.end(), [](const auto& a, const auto& b) { return a.volume < b.volume; });
    const double wanted = spec.spring.rate;
    std::stable_sort(search.bought.begin(), search.bought.end(), [wanted](const auto& a, const auto& b) {
        return std::abs(std::log(a.spring.rate / wanted)) < std::abs(std::log(b.spring.rate / wanted));
    });
    keep(search.wound, kind, design, options);
    keep(search.bought, kind, design, options);
    search.tried = judge.tried;
    search.broken.assign(judge.broken.begin(), judge.broken.end());
    std::stable_sort(search.broken.begin(), search.broken.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return search;
}

std::vector<profile::Edit> spring_edits(cam::PartKind part, const FoundSpring& found, const profile::Profile& profile) {
    const bool torsion = part == cam::PartKind::kSeries;
    const spring::BaseSpring& s = found.spring;
    const std::string t = profile.table_of(part) + ".spring.";
    const std::string why = found.bought ? "bought: " + found.name : "wound: " + found.name;
    std::vector<profile::Edit> edits;
    const auto set = [&](const char* leaf, double value) { edits.push_back(profile::number_edit(profile, t + leaf, value, "")); };
    edits.push_back(profile::number_edit(profile, t + (torsion ? "rate_Nm_per_rad" : "rate_N_per_m"), s.rate, why));
    set(torsion ? "preload_rad" : "preload_mm", s.preload);
    set(torsion ? "max_angle_rad" : "max_travel_mm", s.max_state);
    set(torsion ? "max_torque_Nm" : "max_force_N", s.max_load);
    set("wire_mm", s.wire_diameter);
    set("coil_mm", s.coil_diameter);
    set("active_coils", s.active_coils);
    set("free_length_mm", s.free_length);
    set("tensile_strength_MPa", s.tensile_strength);
    edits.push_back(profile::text_edit(profile, t + "wire_class", spring::kWireClassNames.at(static_cast<std::size_t>(s.wire_class)), ""));
    if (torsion) edits.push_back(profile::text_edit(profile, t + "hand", s.hand == spring::Hand::kLeft ? "left" : "right", ""));
    set("rod_mm", s.rod_diameter);
    set("cycles", s.cycles);
    return edits;
}

}  // namespace fusee::pipeline
