#include "scale.h"

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/pipeline/design.h"
#include "start.h"

namespace fusee::search::init {

namespace {

using core::m_from_mm;

constexpr double kStartShaft = 6e-3;       // of the start design [m]
constexpr double kStartRho = 2.9e-3;       // least radius of curvature of its K_PE [m]
constexpr double kStartSpoolRho = 5.5e-3;  // of its K_SE

const double kGuidingThroat = core::rad_from_deg(45.0);  // of the ropes' makers: rule groove.throat; a printer needs 90 deg
constexpr double kEdge = 0.5;                            // rounded edge of an anchor hole, in cable diameters: rule cable.anchor_edge
constexpr double kHole = 1.5;                            // anchor hole, in cable diameters: the cable is threaded, its knot is not
constexpr double kIdleBend = 2.5, kIdleShare = 0.25;     // radius over the cable's diameter: at least; over its critical D/d
constexpr double kBoss = 2.7, kBossLength = 2.1, kThickBoss = 1.6;  // over the shaft
constexpr double kLargerShare = 0.75;                               // of the greatest load, on the part that carries more of it
constexpr double kLeastCable = 0.5e-3;                              // [m]
constexpr int kDigits = 6;

const profile::Profile& start_design() {
    static const profile::Profile start = profile::parse_profile(std::string(kStart), "pnrvsa.toml");
    return start;
}

void set_rig(profile::Profile& p, const Answers& answers, const Scale& scale) {
    profile::Rig& rig = p.rig;
    rig.capstan_radius *= scale.capstan * scale.k_se;
    rig.joint_radius = answers.ratio * rig.capstan_radius;
    rig.gear_friction = answers.friction;
    rig.gear_friction_constant = answers.friction_constant;
    rig.least_torque = answers.least_torque();
    rig.peak_torque = answers.peak_torque();
    rig.overdrive_torque = answers.overdrive_torque();
    p.assembly.joint_range = answers.joint_range;
}

/// k that a stated joint stiffness asks for, 2 g^2 k tau^2; else that of the start design.
double k_of(const profile::Profile& p, const Answers& answers, double own, double torques, double softness) {
    const double g = answers.ratio;
    if (answers.joint_stiffness > 0.0) return answers.joint_stiffness / (2.0 * g * g * std::pow(p.rig.peak_torque, 2));
    return own / (torques * softness);
}

/// A pair of springs from its least to its greatest load.
struct LawSize {
    double angle = 0.0;                             ///< of the capstan [rad]
    double series_work = 0.0, parallel_work = 0.0;  ///< that the springs take up [J]
};

LawSize size_of(const spring::LawPoint& low, const spring::LawPoint& high) {
    return {high.theta - low.theta, high.u_se - low.u_se, high.u_pe - low.u_pe};
}

const LawSize& start_size() {
    static const LawSize size = [] {
        const auto start = pipeline::resolve(start_design());
        const spring::SpringLaw& law = *start->law();
        return size_of(law.at_load(start_design().law.start_torque), law.at_load(start_design().law.end_torque));
    }();
    return size;
}

/// The law's size by trapezia over the rows between two loads; noise averages out.
LawSize size_of(const profile::TablePair& rows, core::Range loads) {
    LawSize size;
    for (std::size_t i = 1; i < rows.angle.size(); ++i) {
        const double load = 0.5 * (rows.series[i - 1] + rows.parallel[i - 1] + rows.series[i] + rows.parallel[i]);
        if (load < loads.low || load > loads.high) continue;
        const double step = rows.angle[i] - rows.angle[i - 1];
        size.angle += step;
        size.series_work += 0.5 * step * (rows.series[i - 1] + rows.series[i]);
        size.parallel_work += 0.5 * step * (rows.parallel[i - 1] + rows.parallel[i]);
    }
    return size;
}

/// Ratios of a law to that of the start design.
LawSize relative(const LawSize& size) {
    const LawSize& start = start_size();
    return {size.angle / start.angle, size.series_work / start.series_work, size.parallel_work / start.parallel_work};
}

/// A law of the paper's kind.
LawSize set_stiction_law(profile::Profile& p, const Answers& answers, const Scale& scale, const spring::FrictionLaw& friction,
                         double torques) {
    auto& law = std::get<spring::StictionLawOptions>(p.law.curves);
    const double own = law.k;
    law.mu = friction.mu();
    law.k = k_of(p, answers, own, torques, scale.softness);
    // T tau_f = mu C + u^2/tau, here at the start; for tau_f = mu tau: T = C/tau + u^2/(mu tau^2)
    const double passed = scale.transmission * friction.at_rest(p.law.start_torque);
    law.c = (1.0 - scale.u_share) * passed / law.mu;
    law.u = std::sqrt(scale.u_share * passed * p.law.start_torque);
    law.start_torque = p.law.start_torque;
    law.end_torque = p.law.end_torque;
    const double angle = own / (torques * law.k);
    return {angle, torques * angle, torques * angle};
}

/// @returns ratios to the law of the start design
LawSize set_law(profile::Profile& p, const Answers& answers, const Scale& scale, double torques) {
    const spring::FrictionLaw friction = pipeline::gear_friction(p);
    p.law.start_torque = scale.start * friction.resting_loads(p.rig.least_torque).low;
    p.law.end_torque = scale.end * friction.resting_loads(p.rig.overdrive_torque).high;
    if (!answers.law) return set_stiction_law(p, answers, scale, friction, torques);
    if (scale.asked.high > 0.0) {
        p.law.start_torque = std::max(scale.start * scale.asked.low, scale.carried.low);
        p.law.end_torque = std::min(scale.end * scale.asked.high, scale.carried.high);
    }
    p.law.curves = *answers.law;
    p.columns = columns_of_law(answers.columns);
    return relative(size_of(*answers.law, {p.law.start_torque, p.law.end_torque}));
}

void set_springs(profile::Profile& p, const Scale& scale, const LawSize& law) {
    for (spring::BaseSpring* s : {&p.k_se.spring, &p.k_pe.spring}) {
        s->max_state = s->max_load = s->wire_diameter = s->coil_diameter = s->active_coils = s->free_length = s->rod_diameter = 0.0;
    }
    const double turn = law.angle * scale.capstan, travel = law.angle * scale.k_pe;
    p.k_se.spring.rate *= law.series_work / (turn * turn);
    p.k_se.spring.preload *= turn * scale.preload_se;
    p.k_pe.spring.rate *= law.parallel_work / (travel * travel);
    p.k_pe.spring.preload *= travel * scale.preload_pe;
}

/// Least diameter of a printed boss that carries a torque between its layers: the safety of 2 that rule structure.layer_strength asks for,
/// with Tresca's stress of torsion alone and half of the material's strength.
double carrying_boss(double torque, const solid::HubOptions& hub, const checks::Process& process) {
    if (process.kind != checks::ProcessKind::kFdm) return 0.0;
    constexpr double kShear = 0.125;  // of the strength: half of it, over the safety, over Tresca's 2
    const double solid = 16.0 * torque / (core::kPi * kShear * checks::material_of(process).strength);
    const double hole = 2.0 * std::hypot(0.5 * hub.bore_diameter + hub.key_depth, 0.5 * hub.key_width);
    double diameter = std::cbrt(solid) + hole;
    for (int i = 0; i < 30; ++i) diameter = std::cbrt(solid + std::pow(hole, 4) / diameter);  // D^3 - hole^4/D = solid
    return diameter;
}

/// @param torque on the part [Nm]
void set_hub(solid::HubOptions& hub, double shaft, double torque, const checks::Process& process) {
    const core::Range fit = checks::process_limits(process).fit;
    hub.bore_diameter = shaft;
    hub.bore_clearance = 0.5 * (fit.low + fit.high);
    if (const checks::KeySize* key = checks::key_size(shaft)) {
        hub.key_width = key->width;
        hub.key_depth = key->hub_depth;
    } else {
        hub.lock = solid::HubLock::kDFlat;  // DIN 6885-1 has no key for this shaft
        hub.flat_depth = 0.12 * shaft;
    }
    if (hub.kind != solid::HubKind::kOverhung) return;
    hub.boss_diameter = std::max({kBoss * std::min(shaft, kStartShaft), kThickBoss * shaft, carrying_boss(torque, hub, process)});
    hub.boss_height = kBossLength * shaft;
}

/// The cable rests on the idle arc on its way to the anchor and does not bend to and fro there.
double idle_radius(const Answers& answers) {
    return std::max(kIdleBend, kIdleShare * checks::cable_limits(answers.construction).critical) * answers.cable;
}

}  // namespace

void set_parts(profile::Profile& p, const Answers& answers, const Scale& scale) {
    p.cable.construction = answers.construction;
    p.cable.diameter = answers.cable;
    p.cable.breaking_load = answers.breaking_load > 0.0 ? answers.breaking_load : checks::usual_cable(answers.construction, answers.cable);
    if (!checks::cable_limits(answers.construction).is_fibre()) p.cable.termination = checks::Termination::kCrimp;
    p.process = checks::Process{};
    p.process.kind = answers.process;
    p.process.material.kind = answers.material;
    p.process.build_x = p.process.build_y = answers.bed;
    const double least_hole = checks::process_limits(p.process).hole;
    for (profile::PartSpec* part : {&p.k_se, &p.k_pe}) {
        const double size = part == &p.k_se ? scale.k_se : scale.k_pe;
        part->cam.cable_diameter = answers.cable;
        part->cam.guide.distance *= std::max(1.0, size);
        part->cam.path.min_idle_curvature_radius = idle_radius(answers);
        part->solid.features.anchor_hole_diameter = std::max(least_hole, kHole * answers.cable);
        part->solid.features.anchor_edge_radius = kEdge * answers.cable;
        part->solid.features.leg_slot_width = 0.0;
        if (answers.process != checks::ProcessKind::kFdm) part->solid.groove.throat = kGuidingThroat;
        set_hub(part->solid.hub, answers.shaft, kLargerShare * p.law.end_torque, p.process);
    }
}

namespace {

std::vector<std::string> formats_of(checks::ProcessKind process) {
    std::vector<std::string> formats = profile::Profile().outputs.formats;
    if (process == checks::ProcessKind::kMill || process == checks::ProcessKind::kMill4) formats.insert(formats.end() - 1, "ngc");
    return formats;
}

}  // namespace

Sizes least_sizes(const Answers& answers) {
    const double ratio = checks::cable_limits(answers.construction).recommended;
    const double rho = 0.5 * (ratio + 1.0) * std::max(answers.cable, kLeastCable);
    const double shaft = answers.shaft / kStartShaft;
    return {rho / kStartRho, std::max(shaft, rho / kStartSpoolRho)};
}

profile::Profile scaled(const std::string& name, const Answers& answers, const Scale& scale) {
    profile::Profile p = start_design();
    const profile::Profile untouched;
    p.name = name;
    p.algorithm_1 = untouched.algorithm_1;
    p.outputs.formats = formats_of(answers.process);
    const double torques = answers.peak_torque() / p.rig.peak_torque;
    set_rig(p, answers, scale);
    const LawSize law = set_law(p, answers, scale, torques);
    p.law.lead_in_travel *= law.angle;
    set_springs(p, scale, law);
    set_parts(p, answers, scale);
    p = profile::rounded(p, kDigits);
    if (auto* kind = std::get_if<spring::StictionLawOptions>(&p.law.curves)) {  // complete: the torques of its profile
        kind->mu = pipeline::gear_friction(p).mu();
        kind->start_torque = p.law.start_torque;
        kind->end_torque = p.law.end_torque;
    }
    return p;
}

double chosen_stiffness(const Answers& answers) {
    Answers free = answers;
    free.joint_stiffness = 0.0;
    const profile::Profile p = scaled("init", free, {});
    return 2.0 * std::pow(answers.ratio * p.rig.peak_torque, 2) * std::get<spring::StictionLawOptions>(p.law.curves).k;
}

core::CsvMapping columns_of_law(core::CsvMapping columns) {
    for (const char* of_friction : {"side", "direction", "motor_torque_Nm", "load_torque_Nm"}) columns.columns.erase(of_friction);
    return columns;
}

core::CsvMapping columns_of_friction(core::CsvMapping columns) {
    for (const char* of_law : {"angle_rad", "series_Nm", "parallel_Nm"}) columns.columns.erase(of_law);
    return columns;
}

}  // namespace fusee::search::init
