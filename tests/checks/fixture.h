#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/core/units.h"
#include "fusee/spring/coil.h"

/// Parts made by hand with known dimensions: a disc and a helix of constant radius.
namespace fusee::checks {

/// Owns the data of a Design.
struct Fixture {
    solid::Part part;
    spring::BaseSpring spring;
    Cable cable;
    Process process;
    std::vector<Override> overrides;
    [[nodiscard]] Design design() const { return {part, spring, cable, process, overrides}; }
};

inline constexpr double kMm = 1e-3;
inline constexpr double kWorking = 2.0;  // the disc works from psi = -2 to 2
inline constexpr int kRows = 201;        // odd: one of them lies at psi = 0

/// The part's groove as corners only: lip, flank, floor, flank, lip.
inline void cut_groove(Fixture& b) {
    const solid::GrooveOptions& g = b.part.options.groove;
    const double d = b.cable.diameter / kMm, r = g.radius_ratio * d, half = 0.5 * g.throat, depth = g.depth_ratio * d;
    const double flank_offset = r * (1.0 - std::sin(half)), flank_z = r * std::cos(half);
    const double lip_z = flank_z + (depth - flank_offset) * std::tan(half), floor = -0.5 * d;
    b.part.section = {
        {depth + floor, -lip_z}, {flank_offset + floor, -flank_z}, {floor, 0.0}, {flank_offset + floor, flank_z}, {depth + floor, lip_z}};
    const double first = b.part.cam.path(b.part.cam.groove_psi.low).z, last = b.part.cam.path(b.part.cam.groove_psi.high).z;
    const double z_low = std::min(first, last), z_high = std::max(first, last);
    b.part.z_low = z_low - lip_z * kMm - g.rib;
    b.part.z_high = z_high + lip_z * kMm + g.rib;
}

/// Adds a closed box to a mesh [mm].
inline void add_box(solid::Mesh& mesh, const solid::Vec3& low, const solid::Vec3& high) {
    const auto base = static_cast<std::uint32_t>(mesh.points_mm.size());
    for (int i = 0; i < 8; ++i) mesh.points_mm.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
    const solid::Triangle sides[] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const solid::Triangle& t : sides) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

inline solid::Mesh box(const solid::Vec3& low, const solid::Vec3& high) {
    solid::Mesh mesh;
    add_box(mesh, low, high);
    return mesh;
}

/// Contacts at rising psi over [low, high]; the state rises linearly from the preload to `last_state`.
inline void work(Fixture& b, double low, double high, double last_state) {
    b.part.cam.working.clear();
    b.part.cam.working_psi = {low, high};
    for (int i = 0; i < kRows; ++i) {
        const double share = static_cast<double>(i) / (kRows - 1);
        cam::Contact c;
        c.path = b.part.cam.path(low + (high - low) * share);
        const double state = b.spring.preload + (last_state - b.spring.preload) * share;
        c.arm = {1.0, (high - low) * share, c.path.h, c.path.slope, c.path.rho - c.path.h, 50.0, state};
        c.span = 0.1;
        b.part.cam.working.push_back(c);
    }
}

inline void set_cable(Fixture& b, double diameter) {
    b.cable.diameter = b.part.cam.options.cable_diameter = diameter;
    b.cable.breaking_load = 2000e6 * diameter * diameter;
    b.cable.max_pressure = 65e6;
}

/// Gives the wire a modulus with which the coils have the stated rate.
inline void match_rate(Fixture& b) {
    const double share = b.spring.rate / spring::rate_of_coils(b.spring);
    b.spring.youngs_modulus *= share, b.spring.shear_modulus *= share;
}

/// A printed K_SE spool: disc of radius R about (e, 0), so h = R + e cos psi and rho = R.
inline Fixture disc(double radius, double eccentricity) {
    Fixture b;
    set_cable(b, 0.8 * kMm);
    b.spring.rate = 0.02;
    b.spring.preload = 4.0;
    b.spring.max_state = 12.0;
    b.spring.max_load = 0.3;
    b.spring.wire_diameter = 1.2 * kMm;
    b.spring.coil_diameter = 12.0 * kMm;
    b.spring.tensile_strength = 2000e6;
    cam::Cam& cam = b.part.cam;
    cam.kind = cam::PartKind::kSeries;
    cam.options.guide.kind = cam::GuideKind::kPoint;
    cam.options.guide.distance = 0.1;
    cam.path = [=](double psi) {
        return cam::PathPoint{psi, radius + eccentricity * std::cos(psi), -eccentricity * std::sin(psi), radius, 0.0};
    };
    work(b, -kWorking, kWorking, 10.0);
    cam.groove_psi = {-kWorking, -kWorking + 2.0 * core::kPi};
    cam.anchor_psi = -kWorking - cam.options.path.margin + 2.0 * core::kPi;
    b.part.options.hub.bore_diameter = 6.0 * kMm;
    b.part.options.hub.key_fit = solid::KeyFit::kByHand;
    solid::FeatureOptions& f = b.part.options.features;
    f.anchor_edge_radius = 0.5 * kMm;
    f.leg_slot_width = 1.4 * kMm;
    f.leg_slot_length = 2.4 * kMm;
    f.leg_slot_radius = 6.0 * kMm;
    f.leg_slot_depth = 2.0 * kMm;
    const double inside = 0.5 * radius / kMm;
    b.part.mesh = box({-inside, -inside, -2.0}, {inside, inside, 2.0});
    cut_groove(b);
    return b;
}

inline Fixture spool() { return disc(10.0 * kMm, 1.0 * kMm); }

/// A printed K_PE cam: helix of constant radius and pitch, one and a half turns of work, overhung on its boss, its cable clamped outside.
inline Fixture helix(double radius, double pitch) {
    Fixture b;
    set_cable(b, 0.8 * kMm);
    b.spring.kind = spring::BaseKind::kCompression;
    b.spring.rate = 7460.0;
    b.spring.preload = 10.0 * kMm;
    b.spring.max_state = 30.0 * kMm;
    b.spring.free_length = 60.0 * kMm;
    b.spring.active_coils = 8.0;
    b.spring.wire_diameter = 2.0 * kMm;
    b.spring.coil_diameter = 16.0 * kMm;
    b.spring.tensile_strength = 2000e6;
    match_rate(b);
    cam::Cam& cam = b.part.cam;
    cam.kind = cam::PartKind::kParallel;
    cam.rotation_sign = -1;
    cam.options.guide.distance = 0.15;  // of its parallel exit: a round cam has the same arm anywhere
    cam.options.path.kind = cam::PathKind::kHelix;
    cam.options.path.pitch = pitch;
    cam.path = [=](double psi) { return cam::PathPoint{psi, radius, 0.0, radius, pitch * psi / (2.0 * core::kPi)}; };
    work(b, 0.0, 3.0 * core::kPi, 20.0 * kMm);
    const double margin = cam.options.path.margin;
    cam.groove_psi = {-1.6 * margin, 3.0 * core::kPi + 1.6 * margin};
    cam.anchor_psi = -margin;
    solid::HubOptions& hub = b.part.options.hub;
    hub.kind = solid::HubKind::kOverhung;
    hub.key_fit = solid::KeyFit::kByHand;
    hub.bore_diameter = 6.0 * kMm;
    hub.boss_diameter = 14.0 * kMm;
    hub.boss_height = 10.0 * kMm;
    b.part.options.features.anchor_hole_diameter = 0.0;
    const double inside = 0.5 * radius / kMm;
    b.part.mesh = box({-inside, -inside, -2.0}, {inside, inside, 2.0});
    cut_groove(b);
    return b;
}

inline Fixture pusher() { return helix(10.0 * kMm, 4.0 * kMm); }

/// The spool for another process: a rope's throat, and a bore that fits its shaft.
inline Fixture spool_by(ProcessKind kind, double clearance_mm) {
    Fixture b = spool();
    b.process.kind = kind;
    b.cable.max_pressure = 75e6;  // a narrower throat leaves less length for the key
    b.part.options.groove.throat = core::rad_from_deg(45.0);
    b.part.options.hub.bore_clearance = clearance_mm * kMm;
    cut_groove(b);
    return b;
}

inline Fixture resin() { return spool_by(ProcessKind::kSla, 0.2); }
inline Fixture powder() { return spool_by(ProcessKind::kSls, 0.2); }
inline Fixture plates() {
    Fixture b = spool_by(ProcessKind::kEdm, 0.02);
    b.part.options.features.leg_slot_depth = b.part.options.groove.rib;  // the upper plate's
    return b;
}
inline Fixture milled() {  // with a 4th axis: three axes do not reach the groove
    Fixture b = spool_by(ProcessKind::kMill4, 0.03);
    b.part.options.hub.lock = solid::HubLock::kPlain;
    b.part.options.features.leg_slot_radius = 5.85 * kMm;  // the loaded wall is 1.5 mm on both sides
    return b;
}

/// The spool on a boss with a set screw.
inline Fixture with_screw() {
    Fixture b = spool();
    b.process.material.strength = 500e6;  // its thread holds in thin walls
    solid::HubOptions& hub = b.part.options.hub;
    hub.lock = solid::HubLock::kSetScrew;
    hub.screw_diameter = 3.0 * kMm;
    hub.boss_diameter = 14.0 * kMm;
    hub.boss_height = 6.0 * kMm;
    return b;
}

inline core::Findings run_rule(const std::string& id, const Fixture& fixture) {
    const Rule* rule = find_rule(id);
    return rule ? rule->run(fixture.design()) : core::Findings{};
}

/// The rule's worst finding; a pass without text if it has none.
inline core::Finding worst(const std::string& id, const Fixture& fixture) {
    const core::Findings all = run_rule(id, fixture);
    const auto grave = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.severity < b.severity; });
    return grave == all.end() ? core::Finding{} : *grave;
}

}  // namespace fusee::checks
