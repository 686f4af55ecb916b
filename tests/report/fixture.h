#pragma once
#include <cmath>
#include <memory>

#include "fusee/core/units.h"
#include "fusee/report/report.h"

namespace fusee::report {

/// Two linear springs: F_SE = 0.1 + 0.2 theta, F_PE = 0.2 + 0.3 theta over 0 to 2 rad, so tau = 0.3 + 0.5 theta and T = 0.4 throughout.
class LinearLaw final : public spring::SpringLaw {
public:
    [[nodiscard]] core::Range loads() const override { return {0.3, 1.3}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, 2.0}; }
    [[nodiscard]] spring::LawPoint at_load(double tau) const override { return at_angle((tau - 0.3) / 0.5); }
    [[nodiscard]] spring::LawPoint at_angle(double x) const override {
        return {0.3 + 0.5 * x, x, 0.1 + 0.2 * x, 0.2 + 0.3 * x, 0.2, 0.3, 0.0, 0.0, 0.1 * x + 0.1 * x * x, 0.2 * x + 0.15 * x * x};
    }
};

inline constexpr double kDiscRadius_mm = 10.0;

/// A closed prism over a regular polygon with `corners` corners on a circle, from z = -2 to 2 mm.
inline solid::Mesh prism(double radius_mm, std::uint32_t corners) {
    solid::Mesh mesh;
    for (const double z : {-2.0, 2.0})
        for (std::uint32_t i = 0; i < corners; ++i) {
            const double a = 2.0 * core::kPi * i / corners;
            mesh.points_mm.push_back({radius_mm * std::cos(a), radius_mm * std::sin(a), z});
        }
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t j = (i + 1) % corners;
        mesh.triangles.push_back({i, j, corners + j});
        mesh.triangles.push_back({i, corners + j, corners + i});
        if (i > 1) mesh.triangles.push_back({0, i, i - 1});
        if (i > 1) mesh.triangles.push_back({corners, corners + i - 1, corners + i});
    }
    return mesh;
}

/// A disc of radius 10 mm about its axis whose pitch curve is its rim; `helix` = one and a half turns that climb 2 mm each.
inline solid::Part disc(cam::PartKind kind, bool helix = false) {
    solid::Part part;
    const double radius = 1e-3 * kDiscRadius_mm, climb = helix ? 2e-3 / (2.0 * core::kPi) : 0.0;
    part.cam.kind = kind;
    part.cam.options.path.kind = helix ? cam::PathKind::kHelix : cam::PathKind::kPlanar;
    part.cam.path = [radius, climb](double psi) { return cam::PathPoint{psi, radius, 0.0, radius, climb * psi}; };
    part.cam.groove_psi = {0.0, (helix ? 3.0 : 2.0) * core::kPi};
    part.cam.working_psi = {0.5, 2.5};
    for (int i = 0; i < 5; ++i) {
        cam::Contact contact;
        contact.arm = {0.3 + 0.25 * i, 0.5 * i, radius, 0.0, 0.0, 5.0 + i, 3.0 + 0.5 * i};
        contact.path = part.cam.path(0.5 + 0.5 * i);
        part.cam.working.push_back(contact);
    }
    part.mesh = prism(kDiscRadius_mm, 256);
    part.z_low = -2e-3;
    part.z_high = 2e-3;
    part.chordal_error_mm = 0.002;
    return part;
}

inline core::Finding finding(const std::string& rule, core::Severity severity, double angle) {
    core::Finding f;
    f.rule = rule;
    f.severity = severity;
    f.what = "the cable bends too sharply & <frays>";
    f.measured = 6.1;
    f.allowed = 8.0;
    f.unit = "mm";
    f.where = "k_se at psi " + std::to_string(angle);
    f.place = core::Place{angle, {kDiscRadius_mm * std::cos(angle), kDiscRadius_mm * std::sin(angle), 0.0}};
    f.suggestion = severity == core::Severity::kPass ? "" : "preload 4.1 rad";
    f.source = "a handbook";
    return f;
}

/// A design with everything in it; the parts live as long as the fixture.
struct Fixture {
    explicit Fixture(std::string name = "disc") {
        design.provenance = {std::move(name), std::string(64, 'a'), "via=cgal"};
        design.law.samples = spring::sample_by_load(law, 41);
        design.law.design_loads = {0.4, 1.3};
        design.law.lead_in_travel = 0.2;
        design.law.stiction_loads = {0.35, 1.25};
        for (int i = 0; i < 5; ++i) {
            actuator::DeadBand d;
            d.tau = 0.4 + 0.1 * i;
            d.linear = 1.0 / d.tau;
            d.exact_width = i < 4 ? 1.2 / d.tau : std::numeric_limits<double>::quiet_NaN();
            d.covered = i < 4;
            d.joint_stiffness = 0.4;
            d.free_joint_stiffness = 0.24;
            design.dead_band.push_back(d);
        }
        design.findings = {finding("law.transmission", core::Severity::kPass, 0.0)};
        for (const solid::Part* part : {&spool, &helix}) {
            PartReport report;
            report.part = {std::shared_ptr<void>(), part};  // lives in the fixture
            report.spring.kind = part == &spool ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
            report.spring.rate = 0.02;
            const std::string stem = cam::to_string(part->cam.kind);
            report.findings = {finding("cable.pressure", core::Severity::kPass, 0.6),
                               finding("cable.bend_ratio", core::Severity::kWarning, 2.4)};
            report.files = {{{stem + ".stl", std::string(64, 'b'), 1020, 0.002}, 51084}};
            report.arm_errors = {{stem + ".stl", "assimp", 400, 2e-4, 1.0, 1e-3}};
            design.parts.push_back(std::move(report));
        }
        design.parts.front().certificate = cam::certify({{{0.0, 6.3},
                                                          true,
                                                          [](const math::Interval& box) {
                                                              cam::ContourJet at;
                                                              at.psi = at.angle = math::Jet::parameter(box);
                                                              at.rho = math::Jet(1e-3 * kDiscRadius_mm);
                                                              return at;
                                                          }}},
                                                        false);
        design.files = {{{"springs.csv", std::string(64, 'c'), 0, 0.0}, 812}};
    }
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

    LinearLaw law;
    solid::Part spool = disc(cam::PartKind::kSeries), helix = disc(cam::PartKind::kParallel, true);
    DesignReport design;
};

}  // namespace fusee::report
