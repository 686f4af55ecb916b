#include "fusee/assembly/assembly.h"

#include <cmath>
#include <map>

#include "fusee/core/lists.h"
#include "fusee/drawing/inspection.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

constexpr double kMostRange = 1.75 * core::kPi;  // of the joint: less than a turn with the dead wrap and the anchor

/// The integral of the arm by its values and slopes, row by row (Hermite: the error is of fourth order in the step).
std::vector<Travel> travels(const cam::Cam& cam) {
    std::vector<Travel> all{{0.0, 0.0}};
    for (std::size_t i = 1; i < cam.working.size(); ++i) {
        const cam::ArmPoint &a = cam.working[i - 1].arm, &b = cam.working[i].arm;
        const double step = b.angle - a.angle;
        const double length = 0.5 * step * (a.arm + b.arm) + step * step / 12.0 * (a.slope - b.slope);
        all.push_back({b.angle, all.back().length_mm + core::mm_from_m(length)});
    }
    return all;
}

/// Length of cable on the cam at the lowest load: K_SE's is wound most then, K_PE's least.
double wound_mm(const cam::Cam& cam) {
    const drawing::CableLength length = drawing::cable_length(cam);
    return core::mm_from_m(length.to_anchor + (cam.kind == cam::PartKind::kSeries ? length.working : 0.0));
}

double span_mm(const cam::Contact& contact) { return core::mm_from_m(contact.span / std::cos(contact.fleet)); }

/// Of both mirror images of an overhung K_PE one has its boss towards its capstan from above: then the motor would be below all else.
bool stands_above(const solid::Part& k_pe) { return k_pe.options.hub.kind == solid::HubKind::kOverhung && k_pe.cam.rotation_sign > 0; }

core::Findings refusals(const Drive& drive) {
    core::Findings all;
    for (const auto* part : {&drive.k_se, &drive.k_pe}) {
        const cam::CamOptions& options = (*part)->cam.options;
        core::Finding f;
        f.where = to_string((*part)->cam.kind);
        f.severity = core::Severity::kNotJudged;
        f.measured = f.allowed = std::nan("");
        if (options.family == cam::Family::kRoller)
            f.rule = "joint.roller", f.what = "an assembly with a roller on the cam is not modelled",
            f.suggestion = core::change(f.where + ".family", core::quoted("cable"));
        else if (options.guide.kind == cam::GuideKind::kParallel)
            f.rule = "joint.guide", f.what = "a parallel cable exit has no place for its guide: the assembly is not modelled",
            f.suggestion = core::change(f.where + ".guide.kind", core::quoted("point")).noted(" and " + f.where + ".guide.distance_mm");
        else
            continue;
        all.push_back(std::move(f));
    }
    return all;
}

void add_cables(Assembly& a, const Layout& l) {
    const double on_joint = l.joint * (kDeadWrap + 0.5 * a.joint_range), on_capstan = l.capstan * kDeadWrap;
    const double drive = l.spool_axis.y() - l.carriage_rear - l.motor_axis.y();
    const cam::Cam &series = a.drive.k_se->cam, &parallel = a.drive.k_pe->cam;
    const double idler = l.idler > 0.0 ? l.idler * 0.5 * core::kPi : 0.0;  // around it, at most a quarter turn
    const double to_joint = wound_mm(series) + span_mm(series.working.front()) + idler - l.k_se_guide.y() + on_joint;
    const double spring = std::max(l.k_pe_spring_length, 0.0) + kCap_mm;
    const double to_spring = wound_mm(parallel) + span_mm(parallel.working.front()) + l.wall + spring;
    for (const Side side : {Side::kAgonist, Side::kAntagonist}) {
        const std::string of = std::string("_") + to_string(side);
        a.cables.push_back({CableKind::kDrive, side, on_capstan + drive, "capstan" + of, "carriage" + of});
        a.cables.push_back({CableKind::kSeries, side, to_joint, "k_se" + of, "joint_pulley"});
        a.cables.push_back({CableKind::kParallel, side, to_spring, "k_pe" + of, "k_pe_cap" + of});
    }
}

/// A shaft up to the same plate from cables that are lower.
void lengthen(Body& shaft, double by_mm) {
    Extrusion& top = shaft.shapes.back();
    top.length_mm += by_mm;
    shaft.prisms.back() = prism_of(top, Eigen::Isometry3d::Identity());
}

void add_bodies(Assembly& a, const Layout& l) {
    const Eigen::Isometry3d up(Eigen::Translation3d(0.0, 0.0, a.plane_mm)), down(Eigen::Translation3d(0.0, 0.0, -a.plane_mm));
    for (const Body& body : side_bodies(l, a.drive))
        for (Body placed : {body, mirrored(body)}) {
            placed.rest = (placed.side == Side::kAgonist ? up : down) * placed.rest;
            placed.name += std::string("_") + to_string(placed.side);
            if (l.frame && placed.name == "motor_shaft_antagonist") lengthen(placed, 2.0 * a.plane_mm);
            a.bodies.push_back(std::move(placed));
        }
    a.bodies.push_back(joint_pulley(l, a.drive.k_pe->options.hub, a.joint_range));
    if (auto pin = stop_pin(l)) a.bodies.push_back(std::move(*pin));
    a.bodies.push_back(joint_stops(l, a.joint_range));
    for (Body& body : frame_bodies(l, a.drive, a.joint_range, a.frame_holes)) a.bodies.push_back(std::move(body));
}

void note_missing(Assembly& a) {
    const auto note = [&](const char* part, const char* missing) {
        a.notes.push_back(core::not_judged("joint.spring_space", "the space that the spring takes is not known", missing));
        a.notes.back().where = part;
    };
    if (a.find("k_se_spring_agonist") == nullptr) note("k_se", "k_se.spring.wire_mm, k_se.spring.coil_mm and k_se.spring.active_coils");
    if (a.find("k_pe_spring_agonist") == nullptr) note("k_pe", "k_pe.spring.wire_mm, k_pe.spring.coil_mm and k_pe.spring.free_length_mm");
}

}  // namespace

const char* to_string(Motion motion) {
    static constexpr std::array kNames{"fixed", "capstan", "carriage", "spool", "spring_end", "joint"};
    return kNames.at(static_cast<std::size_t>(motion));
}
const char* to_string(Side side) {
    static constexpr std::array kNames{"agonist", "antagonist", "joint"};
    return kNames.at(static_cast<std::size_t>(side));
}
const char* to_string(CableKind kind) {
    static constexpr std::array kNames{"drive", "series", "parallel"};
    return kNames.at(static_cast<std::size_t>(kind));
}

std::string Body::base_name() const { return side == Side::kBoth ? name : name.substr(0, name.rfind('_')); }

std::array<std::uint8_t, 3> colour_of(const Body& body) {
    using Colour = std::array<std::uint8_t, 3>;
    static constexpr Colour kSeries{63, 127, 208}, kParallel{208, 96, 63}, kDrum{154, 165, 177}, kShaft{125, 134, 144}, kRod{185, 191, 198},
        kPlate{217, 210, 195}, kSpring{121, 181, 138}, kBrass{196, 168, 90}, kFrame{172, 188, 205};
    static const std::map<std::string, Colour> kColours{{"k_se", kSeries},
                                                        {"k_pe", kParallel},
                                                        {"capstan", kDrum},
                                                        {"joint_pulley", kDrum},
                                                        {"axle", kShaft},
                                                        {"motor_shaft", kShaft},
                                                        {"rods", kRod},
                                                        {"carriage", kPlate},
                                                        {"k_pe_seat", kPlate},
                                                        {"k_pe_cap", kPlate},
                                                        {"k_se_spring", kSpring},
                                                        {"k_pe_spring", kSpring},
                                                        {"shaft_collar", kRod},
                                                        {"axle_sleeve", kBrass},
                                                        {"axle_rings", kRod},
                                                        {"frame_plate", kFrame},
                                                        {"frame_front", kFrame},
                                                        {"frame_rear", kFrame},
                                                        {"joint_tower", kFrame},
                                                        {"k_pe_posts", kFrame},
                                                        {"bearings", kRod},
                                                        {"joint_shaft", kShaft},
                                                        {"bushes", kRod},
                                                        {"joint_stops", kRod},
                                                        {"stop_pin", kRod},
                                                        {"capstan_pin", kRod},
                                                        {"capstan_stops", kRod},
                                                        {"leg_in_k_se", kSpring},
                                                        {"leg_in_carriage", kSpring},
                                                        {"spring_arbor", kBrass}};
    return kColours.at(body.base_name());
}

double Cable::cut_mm() const { return std::ceil(length_mm + 2.0 * kCableEnd_mm); }

solid::Mesh Body::mesh() const {
    if (cam) return *cam;
    solid::Mesh whole;
    for (const Extrusion& shape : shapes) {
        const solid::Mesh shell = mesh_of(shape);
        const auto first = static_cast<std::uint32_t>(whole.points_mm.size());
        whole.points_mm.insert(whole.points_mm.end(), shell.points_mm.begin(), shell.points_mm.end());
        for (const solid::Triangle& t : shell.triangles) whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return whole;
}

const Body* Assembly::find(const std::string& name) const { return core::find_by(bodies, &Body::name, name); }

core::Outcome<Assembly> assemble(Drive drive, double capstan_radius, double joint_radius, const AssemblyOptions& options) {
    if (core::Findings findings = refusals(drive); !findings.empty()) return findings;
    Assembly a;
    a.drive = std::move(drive), a.options = options;
    if (stands_above(*a.drive.k_pe))
        a.drive.k_pe = std::make_shared<const solid::Part>(solid::mirrored(*a.drive.k_pe)), a.drive.k_pe_mirrored = true;
    a.k_se = travels(a.drive.k_se->cam), a.k_pe = travels(a.drive.k_pe->cam);
    a.greatest_turn = a.k_pe.back().angle, a.greatest_payout_mm = a.k_se.back().length_mm;
    const Layout l = lay_out(a.drive, capstan_radius, joint_radius, options, a.greatest_turn);
    a.capstan_radius_mm = l.capstan, a.joint_radius_mm = l.joint, a.cable_mm = l.cable;
    a.motor_distance_mm = -l.motor_axis.y(), a.carriage_rear_mm = l.carriage_rear;
    a.plane_mm = l.plane, a.spare_turn = l.spare;
    a.leg_post_mm = l.leg_post, a.leg_post_angle = l.leg_post_angle, a.leg_slot = l.leg_slot, a.spring_low_mm = l.spring_low;
    a.joint_range = 2.0 * l.capstan * a.greatest_turn / l.joint;  // one capstan at each end of its range
    a.joint_range = std::min(a.joint_range, options.joint_range > 0.0 ? options.joint_range : kMostRange);
    const Eigen::Vector3d up(0.0, 0.0, a.plane_mm);
    a.spool_axis_mm = l.spool_axis + up, a.motor_axis_mm = l.motor_axis + up;
    a.k_se_guide_mm = l.k_se_guide + up, a.k_pe_guide_mm = l.k_pe_guide + up;
    add_bodies(a, l);
    add_cables(a, l);
    note_missing(a);
    return a;
}

}  // namespace fusee::assembly
