#include "invariants.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include "dice.h"
#include "fusee/cam/arm.h"
#include "fusee/cam/mirror.h"
#include "fusee/core/error.h"
#include "fusee/core/folder.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/make.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/potential.h"

namespace fusee::random_profiles {

namespace {

using cam::ArmFunction;
using cam::Cam;
using cam::PartKind;

constexpr std::array kParts{PartKind::kSeries, PartKind::kParallel};
constexpr std::size_t kPoints = 41;

/// Another law whose torques are `torque` times those at the same angle.
class Stronger final : public spring::SpringLaw {
public:
    Stronger(spring::SpringLawPtr law, double torque) : law_(std::move(law)), torque_(torque) {}
    [[nodiscard]] core::Range loads() const override { return {law_->loads().low * torque_, law_->loads().high * torque_}; }
    [[nodiscard]] core::Range angles() const override { return law_->angles(); }
    [[nodiscard]] spring::LawPoint at_load(double tau) const override { return times(law_->at_load(tau / torque_)); }
    [[nodiscard]] spring::LawPoint at_angle(double theta) const override { return times(law_->at_angle(theta)); }

private:
    [[nodiscard]] spring::LawPoint times(spring::LawPoint p) const {
        for (double* value : {&p.tau, &p.f_se, &p.f_pe, &p.s, &p.p, &p.s_slope, &p.p_slope, &p.u_se, &p.u_pe}) *value *= torque_;
        return p;
    }
    spring::SpringLawPtr law_;
    double torque_;
};

/// A part of a law: angles and energies begin at its own lowest load.
class Piece final : public spring::SpringLaw {
public:
    Piece(spring::SpringLawPtr law, core::Range loads) : law_(std::move(law)), loads_(loads), begin_(law_->at_load(loads.low)) {}
    [[nodiscard]] core::Range loads() const override { return loads_; }
    [[nodiscard]] core::Range angles() const override { return {0.0, law_->at_load(loads_.high).theta - begin_.theta}; }
    [[nodiscard]] spring::LawPoint at_load(double tau) const override {
        return moved(law_->at_load(std::clamp(tau, loads_.low, loads_.high)));
    }
    [[nodiscard]] spring::LawPoint at_angle(double theta) const override { return moved(law_->at_angle(theta + begin_.theta)); }

private:
    [[nodiscard]] spring::LawPoint moved(spring::LawPoint p) const {
        p.theta -= begin_.theta, p.u_se -= begin_.u_se, p.u_pe -= begin_.u_pe;
        return p;
    }
    spring::SpringLawPtr law_;
    core::Range loads_;
    spring::LawPoint begin_;
};

double largest_arm(const Cam& cam) {
    double most = 0.0;
    for (const cam::Contact& contact : cam.working) most = std::fmax(most, contact.arm.arm);
    return most;
}

/// Largest distance between two contours of equal psi after a turn, a scale and a mirror image, relative to the largest arm.
double difference(const Cam& one, const Cam& other, double scale, double turn, bool mirrored = false) {
    double worst = 0.0;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const double psi = one.working_psi.level(i, kPoints);
        const cam::PathPoint a = one.path(psi), b = other.path((mirrored ? -psi : psi) + turn);
        worst = std::fmax(worst, std::fabs(a.h * scale - b.h) + std::fabs(a.slope * scale - (mirrored ? -b.slope : b.slope)) +
                                     (mirrored || scale != 1.0 ? 0.0 : std::fabs(a.z - b.z)));
    }
    return worst / (largest_arm(one) * scale);
}

/// A design's cam with all that it was made from.
struct Made {
    ArmFunction arm;
    Cam cam;
};
std::optional<Made> make(const ArmFunction& arm, const cam::CamOptions& options) {
    auto cam = cam::synthesize_cam(arm, options);
    if (!cam) return std::nullopt;
    return Made{arm, std::move(cam).value()};
}

double mirror_error(const Made& made) {
    const auto image = cam::synthesize_cam(made.arm, cam::mirrored(made.cam.options));
    if (!image) return core::kNan;
    double worst = difference(made.cam, *image, 1.0, 0.0, true);
    for (std::size_t i = 0; i < made.cam.working.size(); ++i)
        worst = std::fmax(worst, std::fabs(made.cam.working[i].arm.arm - image->working[i].arm.arm) / made.cam.working[i].arm.arm);
    return worst;
}

double scale_error(const Made& made, PartKind kind, const pipeline::ResolvedDesign& design, Dice& dice) {
    const double a = dice.between(0.6, 1.8), b = dice.between(0.5, 2.0);
    spring::BaseSpring base = made.arm.base();
    const bool series = kind == PartKind::kSeries;
    base.rate *= series ? b : b / (a * a);
    base.preload *= series ? 1.0 : a;
    cam::CamOptions options = made.cam.options;
    for (double* length :
         {&options.guide.distance, &options.guide.radius, &options.guide.z, &options.path.pitch, &options.path.min_idle_curvature_radius,
          &options.cable_diameter, &options.roller.radius, &options.roller.base_radius, &options.roller.offset})
        *length *= a;
    cam::Allowance allowance = design.spec(kind).allowance;
    allowance.radius *= a, allowance.cable_axis *= a, allowance.contour *= a;
    allowance.series_compliance /= b, allowance.cable_compliance *= a * a / b;
    const ArmFunction arm(kind, std::make_shared<Stronger>(design.law(), b), base, a * design.profile.rig.capstan_radius, allowance);
    const auto scaled = cam::synthesize_cam(arm, options);
    return scaled ? difference(made.cam, *scaled, a, 0.0) : core::kNan;
}

double cut_error(const Made& made, PartKind kind, const pipeline::ResolvedDesign& design, Dice& dice) {
    const core::Range loads = design.law()->loads();
    const double at = loads.low + dice.between(0.2, 0.8) * loads.width(), radius = design.profile.rig.capstan_radius;
    const cam::ArmPoint there = made.arm.at_load(at);
    spring::BaseSpring further = made.arm.base();
    further.preload = there.state;
    const ArmFunction first(kind, std::make_shared<Piece>(design.law(), core::Range{loads.low, at}), made.arm.base(), radius);
    const ArmFunction second(kind, std::make_shared<Piece>(design.law(), core::Range{at, loads.high}), further, radius);
    double worst = 0.0;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const double tau = loads.level(i, kPoints);
        const cam::ArmPoint whole = made.arm.at_load(tau), part = tau <= at ? first.at_load(tau) : second.at_load(tau);
        const double begun = tau <= at ? 0.0 : there.angle;
        worst = std::fmax(worst, std::fabs(part.arm / whole.arm - 1.0) + std::fabs(part.angle + begun - whole.angle));
    }
    return worst;
}

double rotate_error(const Made& made, Dice& dice) {
    const double turn = dice.between(-3.0, 3.0);
    cam::CamOptions options = made.cam.options;
    options.guide.direction += turn;
    options.roller.direction += turn;
    const auto turned = cam::synthesize_cam(made.arm, options);
    if (!turned) return core::kNan;
    const double shift = turned->working_psi.low - made.cam.working_psi.low;
    const double whole = std::remainder(shift - turn, 2.0 * core::kPi);
    return std::fabs(whole) + difference(made.cam, *turned, 1.0, shift);
}

double units_error(const profile::Profile& profile, const std::array<std::optional<Made>, 2>& made) {
    const std::string text = profile::to_toml(profile);
    const profile::Profile again = profile::parse_profile(text, profile.file);
    if (profile::to_toml(again) != text) return core::kNan;
    const auto design = pipeline::resolve(again);
    if (!design) return core::kNan;
    double worst = 0.0;
    for (const PartKind kind : kParts) {
        const auto& before = made[static_cast<std::size_t>(kind)];
        if (!before) continue;
        const auto cam = pipeline::design_cam(kind, *design);
        worst = cam ? std::fmax(worst, difference(before->cam, *cam, 1.0, 0.0)) : core::kNan;
    }
    return worst;
}

/// The spring that the arms found in a part's first file make.
spring::PotentialPtr found_spring(const pipeline::PartReport& part, const pipeline::ResolvedDesign& design) {
    std::vector<cam::FoundArm> arms;
    const auto& found = part.arm_errors.front().arms_mm;
    for (std::size_t i = 0; i < found.size(); ++i) arms.push_back({part.part->cam.working[i].arm.angle, core::m_from_mm(found[i])});
    return cam::spring_of_arms(part.part->cam.kind, arms, part.spring, design.profile.rig.capstan_radius);
}

std::optional<double> fixed_point_error(profile::Profile profile) {
    profile.outputs = {.formats = {"stl"}, .pair = false, .plate = false};
    const core::TemporaryFolder folder;
    core::OutputFolder output(folder.path() / "parts", {.command = "make", .source = profile.file});
    const auto made = pipeline::make_figures(profile, &output);
    if (!made || made->report.parts.size() != 2) return std::nullopt;
    for (const PartKind kind : kParts) {  // an elastic cable or a compensated rig: the arms are not those of the law alone
        const cam::Allowance& allowance = made->resolved.spec(kind).allowance;
        if (allowance.on_arms() != 0.0 || allowance.series_compliance != 0.0 || allowance.cable_compliance != 0.0) return std::nullopt;
    }
    const auto& parts = made->report.parts;
    const auto& law = made->resolved.law();
    const core::Range loads = law->loads();
    const spring::PotentialPtr series = found_spring(parts[0], made->resolved), parallel = found_spring(parts[1], made->resolved);
    // The springs end where the last row ends; the torques found there are a read-back error apart.
    const auto again = spring::make_pair_law(series, parallel, loads.low * 1.01, loads.high * 0.99);
    if (!again) return core::kNan;
    double worst = 0.0;
    for (const pipeline::PartReport& part : parts) {
        const PartKind kind = part.part->cam.kind;
        const ArmFunction before = made->resolved.arm(kind);
        spring::BaseSpring base = part.spring;
        base.preload = before.at_load((*again)->loads().low).state;
        const ArmFunction after(kind, *again, base, made->resolved.profile.rig.capstan_radius);
        for (std::size_t i = 0; i < kPoints; ++i) {
            const double tau = (*again)->loads().level(i, kPoints);
            worst = std::fmax(worst, std::fabs(after.at_load(tau).arm / before.at_load(tau).arm - 1.0));
        }
    }
    return worst;
}

}  // namespace

Shown try_invariants(const std::string& toml, std::uint64_t seed, int number, bool files) {
    Shown shown;
    Dice dice(seed ^ 0x5bd1e995U, number);
    const profile::Profile profile = profile::parse_profile(toml, "random.toml");
    const auto design = pipeline::resolve(profile);
    if (!design) return shown;
    const auto note = [&](Invariant which, double error) {
        auto& worst = shown.error[which];
        if (!worst || !(error <= *worst)) worst = error;  // NaN stays
    };
    std::array<std::optional<Made>, 2> all;
    for (const PartKind kind : kParts) {
        auto& made = all[static_cast<std::size_t>(kind)];
        try {
            made = make(design->arm(kind), design->spec(kind).cam);
        } catch (const core::InvalidInput&) {  // a spool that no compliance allows
            continue;
        }
        if (!made) continue;
        note(kMirror, mirror_error(*made));
        note(kScale, scale_error(*made, kind, *design, dice));
        const cam::Allowance& allowance = design->spec(kind).allowance;
        if (allowance.on_arms() == 0.0 && allowance.series_compliance == 0.0 && allowance.cable_compliance == 0.0)
            note(kCut, cut_error(*made, kind, *design, dice));
        note(kRotate, rotate_error(*made, dice));
    }
    if (all[0] || all[1]) note(kUnits, units_error(profile, all));
    if (files && all[0] && all[1])
        if (const auto error = fixed_point_error(profile)) note(kFixedPoint, *error);
    return shown;
}

}  // namespace fusee::random_profiles
