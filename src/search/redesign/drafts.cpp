#include "drafts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/stick_slip.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/spring/potential.h"

namespace fusee::search::redesign {

namespace {

constexpr const char* kSides[] = {"agonist", "antagonist"};

bool same(const std::vector<profile::Edit>& a, const std::vector<profile::Edit>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const profile::Edit& x, const profile::Edit& y) { return x.key == y.key && x.value == y.value; });
}

/// Text that is allowed in a comment of a TOML file.
std::string comment_text(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return text;
}

/// The cover by the findings of the resolved design; a finding that allows another torque than the profile's says that none is covered.
Cover cover_of(const pipeline::ResolvedDesign& design) {
    const profile::Rig& rig = design.profile.rig;
    Cover cover{
        .asked = {rig.least_torque, rig.overdrive_torque}, .law_loads = design.law()->loads(), .rest_loads = design.actuator.loads()};
    for (const core::Finding& f : design.findings) {
        if (f.rule == "law.covers_least" && f.allowed == cover.asked.low) cover.covered.low = std::max(f.measured, f.allowed);
        if (f.rule == "law.covers_greatest" && f.allowed == cover.asked.high) cover.covered.high = std::min(f.measured, f.allowed);
    }
    return cover;
}

/// Coverage and findings as `make` will report them, without passes. @return the law, if there is one
spring::SpringLawPtr judge(const profile::Profile& profile, CorrectedProfile& report) {
    const pipeline::Evaluation made = pipeline::evaluate(profile, pipeline::Depth::kSolid);
    if (made.design) report.cover = cover_of(*made.design);
    report.findings = made.all();
    std::erase_if(report.findings, [](const core::Finding& f) { return !core::is_broken(f); });
    return made.design ? made.design->law() : nullptr;
}

spring::BuildError departure_of_part(const profile::PartSpec& cut_for, const profile::PartSpec& as_is) {
    const spring::BaseSpring drawn = pipeline::pulled_spring(cut_for), is = pipeline::pulled_spring(as_is);
    return {is.rate / drawn.rate - 1.0, as_is.allowance.radius - cut_for.allowance.radius, is.preload - drawn.preload};
}

double torque_error(const spring::Potential& built, const spring::Potential& law) {
    constexpr int kPlaces = 200;
    const double end = std::min(built.domain().high, law.domain().high);
    double worst = 0.0;
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = end * i / kPlaces;
        worst = std::max(worst, std::abs(built.force(x) / law.force(x) - 1.0));
    }
    return worst;
}

}  // namespace

bool Draft::is_for(int side) const { return report.sides == "both" || report.sides == kSides[side]; }

bool can_be_cut(const std::vector<Draft>& drafts) {
    return std::all_of(drafts.begin(), drafts.end(), [](const Draft& d) { return d.report.can_be_cut(); });
}

Drafter::Drafter(const pipeline::ResolvedDesign& original, const std::string& toml, const gap_case::Case& gap_case,
                 const diagnosis::Diagnosis& found, const fs::path& file)
    : profile_(original.profile),
      toml_(toml),
      gap_case_(gap_case),
      file_(file),
      departures_(departures(gap_case, found, rest_deflection(original, gap_case))) {
    as_is_.fill(profile_);
    for (std::size_t i = 0; i < figures().size(); ++i)
        if (departures_[i].any())
            for (const int side : {0, 1})
                profile::set_number(as_is_[side], figures()[i].key, as_built(profile_, figures()[i], departures_[i].on_side[side]));
    for (const int side : {0, 1}) own_[side] = spring_edits(side);
    shared_ = shared_edits();
}

bool Drafter::friction_departs() const {
    for (std::size_t i = 0; i < figures().size(); ++i)
        if (figures()[i].of == Figure::Of::kGear && figures()[i].cut && departures_[i].any()) return true;
    return false;
}

bool Drafter::needs_cams(int side) const {
    const bool law_follows_friction = std::holds_alternative<spring::StictionLawOptions>(profile_.law.curves) ||
                                      std::holds_alternative<profile::DeadBandSpec>(profile_.law.curves);
    return !own_[side].empty() || (friction_departs() && law_follows_friction);
}

std::vector<profile::Edit> Drafter::spring_edits(int side) const {
    Edits edits;
    for (std::size_t i = 0; i < figures().size(); ++i) {
        const std::string key = figures()[i].key;
        if (figures()[i].of != Figure::Of::kSpring || departures_[i].on_side[side] == 0.0) continue;
        edits.push_back(profile::number_edit(profile_, key, profile::number_of(as_is_[side], key), departures_[i].why));
        // The nominal coils do not contradict what was measured.
        if (const std::size_t at = key.find(".spring.rate_"); at != std::string::npos)
            edits.push_back(profile::text_edit(profile_, key.substr(0, at) + ".spring.rate_origin", "measured", ""));
    }
    return edits;
}

/// Figures that both sides share: the mean of both.
std::vector<profile::Edit> Drafter::shared_edits() const {
    Edits edits;
    for (std::size_t i = 0; i < figures().size(); ++i) {
        const Figure& figure = figures()[i];
        if (figure.of == Figure::Of::kSpring || !departures_[i].any()) continue;
        const double first = profile::number_of(as_is_[0], figure.key), second = profile::number_of(as_is_[1], figure.key);
        edits.push_back(profile::number_edit(profile_, figure.key, 0.5 * (first + second),
                                             departures_[i].why + (first == second ? "" : "; the mean of both sides")));
    }
    return edits;
}

std::vector<profile::Edit> Drafter::law_edits(double share) const {
    const auto* law = std::get_if<spring::StictionLawOptions>(&profile_.law.curves);
    if (law == nullptr || !friction_departs() || share == 0.0 || law->c == 0.0) return {};
    const double measured = 0.5 * (pipeline::gear_friction(as_is_[0]).mu() + pipeline::gear_friction(as_is_[1]).mu());
    return {profile::number_edit(profile_, "law.c_Nm", law->c * std::pow(pipeline::gear_friction(profile_).mu() / measured, share),
                                 "the promised dead-band, under the measured friction")};
}

std::string Drafter::head(const std::string& sides) const {
    return fmt::format("# {} corrected for the measured rig by fusee diagnose of {} ({}); for the cams of {}.", profile_.name,
                       comment_text(gap_case_.name), gap_case_.sha256.substr(0, 12), sides == "both" ? "both sides" : "the " + sides);
}

Draft Drafter::draft(const std::string& sides, const Edits& own, double share, bool of_two) const {
    const std::string suffix = sides == "both" ? "-redesign" : "-redesign-" + sides;
    const std::string name = profile::derived_name(profile_.name, suffix);
    Draft draft;
    draft.report.sides = sides;
    draft.report.file = file_;
    if (of_two && sides == kSides[1]) draft.report.file.replace_filename(file_.stem().string() + "-" + sides + file_.extension().string());
    Edits edits{profile::text_edit(profile_, "name", name, "new cams next to the old ones")};
    for (profile::Edit& edit : law_edits(share)) {
        edit.origin = fmt::format("for the friction measured, case {}", comment_text(gap_case_.name));
        edits.push_back(std::move(edit));
    }
    for (const Edits& more : {shared_, own})
        for (profile::Edit edit : more) {
            edit.origin = fmt::format("measured, case {}", comment_text(gap_case_.name));
            edits.push_back(std::move(edit));
        }
    draft.report.changes = edits;
    // Judged as if it were next to the old one: the new folder may not exist yet, and the files that it names are the same.
    draft.profile = profile::parse_profile(profile::with_edits(toml_, profile_, edits), profile_.file.parent_path() / file_.filename());
    const Edits files = profile::file_edits(profile_, fs::absolute(file_).parent_path());
    edits.insert(edits.end(), files.begin(), files.end());
    draft.report.toml = profile::with_edits(toml_, profile_, edits, head(sides));
    draft.law = judge(draft.profile, draft.report);
    return draft;
}

std::vector<Draft> Drafter::drafts(double share) const {
    if (needs_cams(0) != needs_cams(1)) {
        const int side = needs_cams(0) ? 0 : 1;
        return {draft(kSides[side], own_[side], share, false)};
    }
    if (same(own_[0], own_[1])) return {draft("both", own_[0], share, false)};
    return {draft(kSides[0], own_[0], share, true), draft(kSides[1], own_[1], share, true)};
}

spring::PotentialPtr series_as_built(const Cams& cams, const profile::Profile& as_is) {
    const profile::PartSpec& cut_for = cams.profile->k_se;
    const double radius = as_is.rig.capstan_radius;
    const spring::PotentialPtr spool =
        spring::with_compliance(spring::resampled(spring::series_spring(cams.law)), -cut_for.allowance.behind_spool(radius));
    const spring::PotentialPtr built = spring::make_built_spring(spool, cut_for.spring, radius, departure_of_part(cut_for, as_is.k_se));
    return spring::resampled(spring::with_compliance(built, as_is.k_se.allowance.behind_spool(radius)));
}

spring::PotentialPtr parallel_as_built(const Cams& cams, const profile::Profile& as_is) {
    const profile::PartSpec& cut_for = cams.profile->k_pe;
    return spring::resampled(spring::make_built_spring(spring::resampled(spring::parallel_spring(cams.law)),
                                                       pipeline::pulled_spring(cut_for), as_is.rig.capstan_radius,
                                                       departure_of_part(cut_for, as_is.k_pe)));
}

actuator::Joint joint_as_built(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is) {
    const profile::Rig& rig = as_is[0].rig;
    actuator::Joint joint =
        actuator::antagonist(parallel_as_built(cams[0], as_is[0]), series_as_built(cams[0], as_is[0]), series_as_built(cams[1], as_is[1]),
                             parallel_as_built(cams[1], as_is[1]), {pipeline::gear_friction(as_is[0]), pipeline::gear_friction(as_is[1])},
                             rig.capstan_radius, rig.joint_radius);
    joint.output_friction = rig.joint_friction;
    return joint;
}

double torque_error(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is) {
    double worst = 0.0;
    for (const int side : {0, 1}) {
        worst = std::max(worst, torque_error(*series_as_built(cams[side], as_is[side]), *spring::series_spring(cams[side].law)));
        worst = std::max(worst, torque_error(*parallel_as_built(cams[side], as_is[side]), *spring::parallel_spring(cams[side].law)));
    }
    return worst;
}

DeadBandWidths dead_band_widths(const actuator::Joint& joint, double tau, double push_torque) {
    return {actuator::joint_dead_band(joint, tau, tau).exact_width,
            actuator::release_test(joint, tau, {.push_torque = push_torque, .find_full_push = false}).width()};
}

}  // namespace fusee::search::redesign
