#include "fusee/cam/arm.h"

#include "fusee/core/error.h"

namespace fusee::cam {

const char* to_string(PartKind kind) { return kind == PartKind::kSeries ? "k_se" : "k_pe"; }

ArmFunction::ArmFunction(PartKind kind, spring::SpringLawPtr law, spring::BaseSpring base, double capstan_radius)
    : kind_(kind), law_(std::move(law)), base_(base), capstan_radius_(capstan_radius) {
    const auto wanted = kind == PartKind::kSeries ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
    const std::string part = to_string(kind);
    if (base_.kind != wanted)
        throw core::InvalidInput(part + ".spring", "wrong kind", kind == PartKind::kSeries ? "a torsion spring" : "a compression spring");
    core::require_positive(part + ".spring.rate", base_.rate);
    core::require_within(part + ".spring.preload", base_.preload, 0.0, 1e6);
    core::require_positive("rig.capstan_radius", capstan_radius_, "m");
}

ArmFunction ArmFunction::on(const spring::BaseSpring& base) const { return {kind_, law_, base, capstan_radius_}; }

// docs/theory/cams.md, table 1. Primes are by the cam's own angle: phi for the spool, theta for the cam.
ArmPoint ArmFunction::at_load(double tau) const {
    const spring::LawPoint p = law_->at_load(tau);
    ArmPoint a;
    a.tau = tau;
    if (kind_ == PartKind::kSeries) {
        const double force = p.f_se / capstan_radius_;                                          // U' of the cable [N]
        const double rate = p.s / (capstan_radius_ * capstan_radius_);                          // U'' [N/m]
        const double rise = p.s_slope / (capstan_radius_ * capstan_radius_ * capstan_radius_);  // U''' [N/m^2]
        a.state = base_.state(p.u_se);
        a.angle = a.state - base_.preload;
        a.arm = base_.rate * a.state / force;
        a.slope = (base_.rate - rate * a.arm * a.arm) / force;
        a.bend = -a.arm * (rise * a.arm * a.arm + 3.0 * rate * a.slope) / force;
        a.tension = force;
    } else {
        a.state = base_.state(p.u_pe);
        a.angle = p.theta;
        a.tension = base_.rate * a.state;
        a.arm = p.f_pe / a.tension;
        a.slope = (p.p - base_.rate * a.arm * a.arm) / a.tension;
        a.bend = (p.p_slope - 3.0 * base_.rate * a.arm * a.slope) / a.tension;
    }
    return a;
}

}  // namespace fusee::cam
