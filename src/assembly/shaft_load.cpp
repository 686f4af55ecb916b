#include <cmath>

#include "layout.h"

namespace fusee::assembly {

namespace {

constexpr double kBendingShock = 1.5;                       // K_b of a shaft that turns under a steady or gradual load (ASME)
constexpr double kKeyedShare = 0.75;                        // of the allowed stress with a keyway (ASME)
constexpr double kYieldShare = 0.3, kStrengthShare = 0.18;  // allowed shear (ASME)

/// Quenched and tempered, up to 16 mm: Saarstahl's sheets, by EN 10083 (ISO 683).
struct Steel {
    const char* name;
    double yield_MPa, strength_MPa;
};
constexpr std::array kSteels{Steel{"C45+QT (ISO 683-1)", 490.0, 700.0}, Steel{"42CrMo4+QT (ISO 683-2)", 900.0, 1100.0}};

double allowed_MPa(const Steel& steel, bool keyed) {
    return (keyed ? kKeyedShare : 1.0) * std::min(kYieldShare * steel.yield_MPa, kStrengthShare * steel.strength_MPa);
}

/// Keeps the greater stress of a shaft.
void add(ShaftLoad& load, double moment, double torque) {
    const double stress = 16.0 * std::hypot(kBendingShock * moment, torque) / (core::kPi * std::pow(load.diameter, 3));
    if (1e-6 * stress > load.stress_MPa) load.stress_MPa = 1e-6 * stress, load.moment = moment, load.torque = torque;
}

/// Heights of the bearing nearest to K_PE and of its cable, over the side's cables.
struct Overhang {
    double bearing_mm = 0.0, cable_mm = 0.0;
    bool holds_capstan = false;  ///< the bearing is beyond the capstan
};

/// Between K_PE and the capstan where there is room for it, else behind the capstan's collar.
Overhang overhang_of(const Assembly& a, double path_z) {
    const Body &body = *a.find("k_pe_agonist"), &drum = *a.find("capstan_agonist"), &collar = *a.find("shaft_collar_agonist");
    const double cable = (body.rest * Eigen::Vector3d(0.0, 0.0, core::mm_from_m(path_z))).z() - a.plane_mm;
    double near = -INFINITY, face = INFINITY;  // of K_PE and of the drum above it, towards each other
    for (const Prism& p : body.prisms) near = std::max(near, placed(p, body.rest).z_high_mm - a.plane_mm);
    for (const Prism& p : drum.prisms) face = std::min(face, p.z_low_mm);
    const double gap = core::mm_from_m(a.options.gap);
    const double width = bearing_width_mm(core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter));
    if (face - near >= width + 2.0 * gap) return {near + gap + 0.5 * width, cable, false};
    return {collar.prisms.front().z_high_mm, cable, true};
}

}  // namespace

std::array<double, 2> tensions(const cam::Cam& cam) {
    std::array<double, 2> all{INFINITY, 0.0};
    for (const cam::Contact& c : cam.working) all = {std::min(all[0], c.arm.tension), std::max(all[1], c.arm.tension)};
    return all;
}

ShaftLoad motor_shaft_load(const Assembly& a) {
    const solid::Part& part = *a.drive.k_pe;
    ShaftLoad load{part.options.hub.bore_diameter, part.options.hub.lock == solid::HubLock::kKeyway};
    const Eigen::Vector2d pull(std::cos(a.options.k_pe_direction), std::sin(a.options.k_pe_direction));
    for (const double drive : tensions(a.drive.k_se->cam))
        for (const cam::Contact& c : part.cam.working) {
            const Overhang at = overhang_of(a, c.path.z);
            const double held = at.holds_capstan ? drive : 0.0;  // of the drive cable, on this side of the bearing
            const Eigen::Vector2d moment = core::m_from_mm(std::abs(at.bearing_mm - at.cable_mm)) * c.arm.tension * pull +
                                           core::m_from_mm(std::abs(at.bearing_mm)) * held * Eigen::Vector2d::UnitY();
            add(load, moment.norm(), c.arm.tension * c.arm.arm + held * core::m_from_mm(a.capstan_radius_mm));
        }
    return load;
}

ShaftLoad axle_load(const Assembly& a) {
    const solid::HubOptions& hub = a.drive.k_se->options.hub;
    ShaftLoad load{hub.bore_diameter, hub.lock == solid::HubLock::kKeyway};
    const double above = -core::m_from_mm(a.find("axle_sleeve_agonist")->prisms.front().z_high_mm);
    add(load, tensions(a.drive.k_se->cam)[1] * above, 0.0);  // the spring's torque goes into the carriage above
    return load;
}

ShaftLoad joint_shaft_load(const Assembly& a) {
    const solid::HubOptions& hub = a.drive.k_pe->options.hub;
    ShaftLoad load{hub.bore_diameter, hub.lock == solid::HubLock::kKeyway};
    const double bearing = bearing_mm(a, 0);
    const bool link = link_holes(hub, a.joint_radius_mm - 0.5 * a.cable_mm).count > 0;  // the pulley's torque goes straight into it
    for (const double agonist : tensions(a.drive.k_se->cam))
        for (const double antagonist : tensions(a.drive.k_se->cam))
            add(load, core::m_from_mm(agonist * (bearing - a.plane_mm) + antagonist * (bearing + a.plane_mm)),
                link ? 0.0 : std::abs(agonist - antagonist) * core::m_from_mm(a.joint_radius_mm));
    return load;
}

double allowed_shaft_stress_MPa(bool keyed) { return allowed_MPa(kSteels.back(), keyed); }

const char* shaft_steel(const ShaftLoad& load) {
    for (const Steel& steel : kSteels)
        if (load.stress_MPa <= allowed_MPa(steel, load.keyed)) return steel.name;
    return kSteels.back().name;
}

}  // namespace fusee::assembly
