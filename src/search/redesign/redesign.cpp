#include "fusee/search/redesign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drafts.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"

namespace fusee::search::redesign {

namespace {

constexpr int kHalvings = 6;          // of the way that C may go
constexpr double kAsPromised = 0.01;  // of the dead-band

/// The dead-bands of a rig with the old cams and with those of any drafts.
class Comparison {
public:
    Comparison(const pipeline::ResolvedDesign& original, const std::array<profile::Profile, 2>& as_is, int levels)
        : old_{&original.profile, original.law()}, as_is_(as_is), push_torque_(original.profile.simulate.push_torque) {
        const profile::Profile& profile = original.profile;
        for (int i = 0; i < levels; ++i)
            torques_.push_back(std::lerp(profile.rig.least_torque, profile.rig.overdrive_torque, static_cast<double>(i) / (levels - 1)));
        promised_ = widths({old_, old_}, {profile, profile});
    }

    /// Relative excess of the dead-band with new cams over the promised one, mean over the levels; 0 if unknown.
    [[nodiscard]] double wider(const std::vector<Draft>& drafts) const {
        const std::vector<DeadBandWidths> fresh = widths(cams_of(drafts), as_is_);
        double sum = 0.0;
        int known = 0;
        for (std::size_t i = 0; i < torques_.size(); ++i)
            if (const double share = fresh[i].measured_width / promised_[i].measured_width - 1.0; std::isfinite(share)) {
                sum += share;
                ++known;
            }
        return known > 0 ? sum / known : 0.0;
    }
    void fill(const std::vector<Draft>& drafts, Redesign& redesign) const {
        const std::array<Cams, 2> old{old_, old_}, cams = cams_of(drafts);
        const bool known = cams[0].law && cams[1].law;
        const std::vector<DeadBandWidths> with_old = widths(old, as_is_),
                                          with_new = known ? widths(cams, as_is_) : decltype(with_old)(torques_.size());
        for (std::size_t i = 0; i < torques_.size(); ++i) redesign.levels.push_back({torques_[i], promised_[i], with_old[i], with_new[i]});
        redesign.peak = at_peak(old, cams, known);
        redesign.torque_error_old = torque_error(old, as_is_);
        if (known) redesign.torque_error_new = torque_error(cams, as_is_);
        redesign.push_torque = push_torque_;
    }

private:
    /// The cams of each side's draft, else the old ones.
    [[nodiscard]] std::array<Cams, 2> cams_of(const std::vector<Draft>& drafts) const {
        std::array<Cams, 2> cams{old_, old_};
        for (const Draft& draft : drafts)
            for (const int side : {0, 1})
                if (draft.is_for(side)) cams[side] = {&draft.profile, draft.law};
        return cams;
    }
    [[nodiscard]] Level at_peak(const std::array<Cams, 2>& old, const std::array<Cams, 2>& cams, bool known) const {
        const double tau = old_.profile->rig.peak_torque;
        const auto width = [&](const std::array<Cams, 2>& of, const std::array<profile::Profile, 2>& rig) {
            return dead_band_widths(joint_as_built(of, rig), tau, push_torque_);
        };
        return {tau, width(old, {*old_.profile, *old_.profile}), width(old, as_is_), known ? width(cams, as_is_) : DeadBandWidths{}};
    }
    [[nodiscard]] std::vector<DeadBandWidths> widths(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is) const {
        const actuator::Joint joint = joint_as_built(cams, as_is);
        return core::each<DeadBandWidths>(torques_, [&](const double tau) { return dead_band_widths(joint, tau, push_torque_); });
    }

    Cams old_;
    const std::array<profile::Profile, 2>& as_is_;
    double push_torque_;
    std::vector<double> torques_;
    std::vector<DeadBandWidths> promised_;
};

/// The drafts with the chosen C.
struct Choice {
    std::vector<Draft> drafts;
    bool refused_nearer = false;  ///< cams nearer to the promise could not be cut
};

/// Lowers C until the dead-band is the promised one or the cams can no longer be cut; never raises it.
Choice choose(const Drafter& drafter, const Comparison& comparison) {
    Choice choice{drafter.drafts(0.0)};
    if (!drafter.has_choice() || !can_be_cut(choice.drafts)) return choice;
    double wider = comparison.wider(choice.drafts), share = 0.0, step = 1.0;
    for (int i = 0; i < kHalvings && wider > kAsPromised; ++i) {
        step *= 0.5;
        std::vector<Draft> next = drafter.drafts(share + step);
        if (!can_be_cut(next)) {
            choice.refused_nearer = true;
            continue;
        }
        const double now = comparison.wider(next);
        if (now < -kAsPromised) continue;
        choice.drafts = std::move(next);
        wider = now;
        share += step;
    }
    choice.refused_nearer = choice.refused_nearer && wider > kAsPromised;
    return choice;
}

std::vector<std::string> remarks(const Redesign& redesign, const Drafter& drafter, const diagnosis::Diagnosis& found,
                                 const Choice& choice) {
    std::vector<std::string> all;
    if (found.verdict == diagnosis::VerdictKind::kAmbiguous)
        all.emplace_back("The diagnosis is ambiguous: do the next experiment before you cut cams.");
    if (found.verdict == diagnosis::VerdictKind::kInconclusive)
        all.emplace_back(
            "The diagnosis is inconclusive: effects of a usual size may be there. Do the next experiment before you cut cams.");
    if (found.verdict == diagnosis::VerdictKind::kPartlyExplained)
        all.emplace_back("The diagnosis explains a part of the gap: find the rest before you cut cams.");
    if (found.verdict == diagnosis::VerdictKind::kUnknown)
        all.emplace_back("The cause of the gap is unknown: find it before you cut cams.");
    if (redesign.profiles.empty()) all.emplace_back("No figure of the profile changes: the profile stays.");
    if (!redesign.profiles.empty() && !redesign.new_cams_needed) all.emplace_back("Only the model changes: the cams stay.");
    const double first = pipeline::gear_friction(drafter.as_is()[0]).mu(), second = pipeline::gear_friction(drafter.as_is()[1]).mu();
    if (first != second)
        all.push_back(
            fmt::format("The gears' friction at a load of 1 Nm is {:.4g} Nm on the agonist and {:.4g} Nm on the antagonist; both "
                        "sides share one law, made for the mean.",
                        first, second));
    if (redesign.profiles.size() == 1 && redesign.profiles.front().sides != "both")
        all.push_back(fmt::format("Only the cams of the {} are cut again; those of the other side stay.", redesign.profiles.front().sides));
    if (choice.refused_nearer)
        all.emplace_back(
            "C is at the lowest value at which the cams can be cut; the dead-band stays wider than promised. fusee design finds "
            "springs for this friction.");
    return all;
}

/// Mean of |width - promised|/promised over the levels at which both were read.
double mean_off(const std::vector<Level>& levels, DeadBandWidths Level::*which) {
    double sum = 0.0;
    int known = 0;
    for (const Level& level : levels) {
        const double off = std::abs((level.*which).measured_width / level.promised.measured_width - 1.0);
        if (!std::isfinite(off)) continue;
        sum += off;
        ++known;
    }
    return known > 0 ? sum / known : diagnosis::kNoFigure;
}

constexpr double kRounding = 1e-3;  // of figures that a case writes with few digits

/// Requires equal figures, in the profile's unit.
void require_equal(const profile::Profile& profile, const std::string& key, const std::string& what, double own, double of_case,
                   double tolerance) {
    const double allowed = std::max(kSameRig * tolerance, kRounding);
    if (std::abs(own - of_case) <= allowed * std::abs(of_case)) return;
    throw core::InvalidInput(
        profile.place_of(key), fmt::format("{}{:.5g}", what, own),
        fmt::format("the case's {:.5g} within {:.2g} %: profile and case must be of the same rig", of_case, 100.0 * allowed));
}

using AtLoad = gap_case::NominalRig::SpringRow;
/// The springs of a case at one load of the capstan, both springs seeing the capstan's angle.
AtLoad at_load(const std::vector<gap_case::NominalRig::SpringRow>& rows, double load) {
    const auto total = [](const gap_case::NominalRig::SpringRow& row) { return row.se_torque + row.pe_torque; };
    auto above = std::find_if(rows.begin() + 1, rows.end() - 1, [&](const auto& row) { return total(row) >= load; });
    const auto below = above - 1;
    const double share = (load - total(*below)) / (total(*above) - total(*below));
    return {std::lerp(below->deflection, above->deflection, share), std::lerp(below->se_torque, above->se_torque, share),
            std::lerp(below->pe_torque, above->pe_torque, share)};
}

/// Requires the same springs, for any origin of their deflection: the share of K_SE at each load, and the travel between loads.
pipeline::ResolvedDesign require_same_springs(const profile::Profile& profile, const gap_case::Case& gap_case) {
    constexpr int kPlaces = 24;
    auto design = pipeline::resolve(profile);
    if (!design) throw core::InvalidInput(profile.place_of("law.kind"), "refused", core::to_line(design.refusal().front()));
    const spring::SpringLaw& law = *design->law();
    const std::vector<gap_case::NominalRig::SpringRow>& rows = gap_case.rig.springs;
    core::Range loads = design->design_loads;
    loads.high = std::min(loads.high, rows.back().se_torque + rows.back().pe_torque);
    const double first_angle = law.at_load(loads.low).theta, first_deflection = at_load(rows, loads.low).deflection;
    for (int i = 0; i <= kPlaces; ++i) {
        const double load = std::lerp(loads.low, loads.high, static_cast<double>(i) / kPlaces);
        const spring::LawPoint own = law.at_load(load);
        const AtLoad of_case = at_load(rows, load);
        require_equal(profile, "law.kind", fmt::format("at a load of {:.4g} Nm F_SE [Nm] = ", load), own.f_se, of_case.se_torque,
                      gap_case.tolerance.spring_rate);
        if (i == kPlaces)
            require_equal(profile, "law.kind", fmt::format("travel [rad] from {:.4g} to {:.4g} Nm = ", loads.low, load),
                          own.theta - first_angle, of_case.deflection - first_deflection, gap_case.tolerance.spring_rate);
    }
    return std::move(design).value();
}

}  // namespace

Redesign plan_redesign(const profile::Profile& profile, const std::string& toml, const gap_case::Case& gap_case,
                       const diagnosis::Diagnosis& found, const RedesignOptions& options) {
    core::require_within("levels", options.levels, 2, 1000);
    const pipeline::ResolvedDesign original = require_same_rig(profile, gap_case);
    const Drafter drafter(original, toml, gap_case, found, options.file);
    Redesign result;
    result.profile_name = profile.name;
    result.case_name = gap_case.name;
    result.case_sha256 = gap_case.sha256;
    for (const effects::Cause& cause : not_mended(gap_case, found)) result.not_mended.push_back({cause, instead_of_cams(cause.id)});
    Choice choice;
    if (drafter.changes_anything()) {
        const Comparison comparison(original, drafter.as_is(), options.levels);
        choice = choose(drafter, comparison);
        comparison.fill(choice.drafts, result);
        result.new_cams_needed = drafter.needs_cams(0) || drafter.needs_cams(1);
        for (const Draft& draft : choice.drafts) result.profiles.push_back(draft.report);
    }
    result.remarks = remarks(result, drafter, found, choice);
    return result;
}

double Redesign::off_with_old_cams() const { return mean_off(levels, &Level::old_cams); }
double Redesign::off_with_new_cams() const { return mean_off(levels, &Level::new_cams); }

void write_profiles(const Redesign& redesign, bool force) {
    for (const CorrectedProfile& profile : redesign.profiles) {
        core::make_folder(fs::absolute(profile.file).parent_path());
        core::require_new_file(profile.file, force);
    }
    for (const CorrectedProfile& profile : redesign.profiles) core::write_file(profile.file, profile.toml);
}

double rest_deflection(const pipeline::ResolvedDesign& design, const gap_case::Case& gap_case) {
    return at_load(gap_case.rig.springs, design.law()->loads().low).deflection;
}

pipeline::ResolvedDesign require_same_rig(const profile::Profile& profile, const gap_case::Case& gap_case) {
    pipeline::require_joint(profile, "a diagnosis");
    pipeline::require_parts(profile);
    const gap_case::Tolerance& t = gap_case.tolerance;
    const gap_case::NominalRig& rig = gap_case.rig;
    constexpr double kMm = 1e3;
    if (!profile.rig.gear_friction_table.file.empty())
        throw core::InvalidInput(profile.place_of("rig.gear_friction_table"), "given",
                                 "friction in proportion to the load: a case's nominal gear has no other");
    require_equal(profile, "rig.capstan_radius_mm", "", kMm * profile.rig.capstan_radius, kMm * rig.capstan_radius, t.radii);
    require_equal(profile, "rig.joint_radius_mm", "", kMm * profile.rig.joint_radius, kMm * rig.joint_radius, t.radii);
    require_equal(profile, "rig.gear_friction", "", profile.rig.rest_friction(), rig.gear_load_friction, t.gear_load_friction);
    require_equal(profile, "k_se.spring.rate_Nm_per_rad", "", profile.k_se.spring.rate, rig.se_torsion_rate, t.spring_rate);
    require_equal(profile, "k_pe.spring.rate_N_per_m", "", profile.k_pe.spring.rate, rig.pe_compression_rate, t.spring_rate);
    return require_same_springs(profile, gap_case);
}

}  // namespace fusee::search::redesign
