#include <fmt/format.h>

#include <cmath>

#include "fusee/checks/thread.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_bearing_load(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    const double bore = core::mm_from_m(assembly.drive.k_pe->options.hub.bore_diameter), rating = bearing_rating(bore);
    if (rating <= 0.0)
        return {core::not_judged("joint.bearing_load", fmt::format("the static load rating of a bearing for {:g} mm is not known", bore),
                                 "k_pe.hub.bore_mm of 3, 4, 5, 6, 8, 10 or 12")};
    core::Findings all;
    for (const FrameLoad::Bearing& bearing : load->bearings) {
        core::Finding f = checks::compare(rating / bearing.force, {allowed("required"), allowed("review")});
        f.what = fmt::format("static safety of the ball bearing of {}: C0 {:.0f} N, load {:.0f} N", bearing.of, rating, bearing.force);
        f.where = "bearings";
        if (const auto larger = bore_of_rating(f.allowed * bearing.force))
            f.suggestion = core::change("k_pe.hub.bore_mm", core::number(*larger));
        f.suggestion.or_else("bearings of a heavier series");
        all.push_back(std::move(f));
    }
    return all;
}

core::Findings measure_joint_frame_screws(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    constexpr double kM3 = 3e-3;
    const FrameLoad::Part& worst =
        *std::max_element(load->parts.begin(), load->parts.end(), [](const auto& a, const auto& b) { return a.screw < b.screw; });
    const checks::Material& material = worst.material;
    const double bears = checks::thread_strength(kM3, core::m_from_mm(kScrewReach_mm), material);
    core::Finding f = checks::compare(bears / worst.screw, {allowed("required"), allowed("review")});
    f.what = fmt::format("safety of the threads M3 of {}, {:g} mm deep in {}: {:.0f} N against a pull of {:.0f} N", worst.name,
                         kScrewReach_mm, material.name, bears, worst.screw);
    f.where = worst.name;
    f.suggestion = fmt::format("inserts for M3 that hold {:.0f} N", f.allowed * worst.screw);
    return {f};
}

core::Findings measure_joint_frame_stiffness(const Assembly& assembly, const Allowed& allowed) {
    if (assembly.find("frame_plate") == nullptr) return {};
    core::Findings all;
    for (const FrameGive& give : frame_gives(assembly)) {
        core::Finding f = checks::compare(100.0 * give.whole * give.rate, {allowed("review")});
        f.what = fmt::format(
            "give of frame and shafts over that of the springs at the {} cables: {:.3g} um/N beside {:.3g} um/N, {:.3g} um/N by the plate",
            give.cables, 1e6 * give.whole, 1e6 / give.rate, 1e6 * give.plate);
        f.where = "frame_plate";
        const double left = 0.01 * f.allowed / give.rate - (give.whole - give.plate);  // for the plate
        f.suggestion = "brackets of metal";
        if (left > 0.0) f.suggestion = core::change("assembly.wall_mm", checks::up(plate_mm(assembly) * std::cbrt(give.plate / left)));
        all.push_back(std::move(f));
    }
    return all;
}

core::Findings measure_joint_frame_strength(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    core::Findings all;
    for (const FrameLoad::Part& part : load->parts) {
        if (part.stress_MPa <= 0.0) continue;
        const double strength = 1e-6 * part.material.strength, permanent = 1e-6 * part.material.permanent;
        core::Finding f = checks::compare(part.stress_MPa, {allowed("required", strength), allowed("review", permanent)});
        f.what = fmt::format("bending stress of {} in {} under the cables", part.name, part.material.name);
        f.where = part.name;
        if (&part == &load->parts.back())
            f.suggestion = core::change("assembly.wall_mm", checks::up(plate_mm(assembly) * std::sqrt(part.stress_MPa / f.allowed)));
        else
            f.suggestion = fmt::format("another material.kind, which bears {} MPa for years", checks::up(part.stress_MPa));
        all.push_back(std::move(f));
    }
    return all;
}

/// A bore for the next shaft on sale, with its key.
core::Suggestion thicker(const std::string& part, const ShaftLoad& load, double most_MPa) {
    const auto size = checks::shaft_sizes().at_least(core::mm_from_m(load.diameter) * std::cbrt(load.stress_MPa / most_MPa));
    if (!size) return "a nearer bearing: between the parts on the shaft";
    core::Suggestion bore = core::change(part + ".hub.bore_mm", core::number(*size));
    const checks::KeySize* key = checks::key_size(core::m_from_mm(*size));
    if (!load.keyed || key == nullptr) return bore;
    return bore.with(part + ".hub.key_width_mm", core::number(core::mm_from_m(key->width)))
        .with(part + ".hub.key_depth_mm", core::number(core::mm_from_m(key->hub_depth)));
}

core::Finding judged_shaft(const char* shaft, const char* bearing, const std::string& part, const ShaftLoad& load, const Allowed& allowed) {
    const double most = allowed_shaft_stress_MPa(load.keyed);
    core::Finding f = checks::compare(load.stress_MPa, {allowed("required", 2.0 * most), allowed("review", most)});
    f.what = fmt::format("shear stress of the {} of {:g} mm at its bearing, {}, by {:.3g} Nm of bending and {:.3g} Nm of torsion", shaft,
                         core::mm_from_m(load.diameter), bearing, load.moment, load.torque);
    f.where = shaft;
    f.suggestion = thicker(part, load, f.allowed);
    return f;
}

core::Findings measure_joint_shaft_strength(const Assembly& assembly, const Allowed& allowed) {
    core::Findings all{judged_shaft("motor_shaft", "beside k_pe or behind the set collar", "k_pe", motor_shaft_load(assembly), allowed),
                       judged_shaft("axle", "the sleeve in the carriage", "k_se", axle_load(assembly), allowed)};
    if (assembly.find("bearings") != nullptr)
        all.push_back(judged_shaft("joint_shaft", "in joint_tower", "k_pe", joint_shaft_load(assembly), allowed));
    return all;
}

}  // namespace

Rules strength_rules() {
    return {
        {{"joint.bearing_load",
          "a ball bearing that its shaft dents",
          "static load rating C0 (ISO 76) over the largest load of each bearing of the frame",
          "SKF: ball bearings 0.5 at least, 1 for quiet running; C0: SKF, of 6001 NTN",
          {required(kAtLeast, "", 0.5), review(kAtLeast, "", 1.0)}},
         measure_joint_bearing_load},
        {{"joint.frame_screws",
          "a screw of the frame whose thread strips",
          "strength of the thread over the pull of the most loaded screw, by the moment of what hangs on the plate about its edge",
          "shear area 0.875 pi d L of a 60 deg thread; shear strength half of the tensile one (practice); safety 1.45: Pugsley, good "
          "material and analysis, loads that springs bound",
          {required(kAtLeast, "", 1.0), review(kAtLeast, "", checks::kSafety)}},
         measure_joint_frame_screws},
        {{"joint.frame_stiffness",
          "a frame that gives way like a spring",
          "how far plate, rear bracket, tower, posts and shafts follow series and parallel cables as beams, both sides pulled alike, over "
          "the give of the springs behind these cables where they are stiffest",
          "beam theory, without shear; as much as rates of springs scatter: 10 % (EN 15800; springs3d)",
          {review(kAtMost, "%", 10.0)}},
         measure_joint_frame_stiffness},
        {{"joint.frame_strength",
          "a frame that the cables bend for good",
          "bending stress of plate, rear bracket with its arms, tower and posts as beams, under the largest tensions of the working range",
          "beam theory; loads spread at 45 deg (practice); what the parts' material bears for years, and its strength (table 5)",
          {required(kAtMost, "MPa", "the material's strength"), review(kAtMost, "MPa", "the material's permanent stress")}},
         measure_joint_frame_strength},
        {{"joint.shaft_strength",
          "a shaft that bends for good under the cables",
          "16 sqrt((1.5 M)^2 + T^2)/(pi d^3) of motor shaft, spool axle and joint's shaft, at their nearest bearings, over the working "
          "range",
          "ASME code: 0.3 of the yield strength, 0.18 of the tensile strength, a quarter less with a keyway (engineersedge, careerride); "
          "42CrMo4+QT: 900 and 1100 MPa (Saarstahl); twice that breaks the shaft (practice)",
          {required(kAtMost, "MPa", "twice the review limit"), review(kAtMost, "MPa", "198 MPa, 148.5 MPa with a keyway")}},
         measure_joint_shaft_strength},
    };
}

}  // namespace fusee::assembly
