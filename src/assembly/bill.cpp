#include "fusee/assembly/bill.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "layout.h"

namespace fusee::assembly {

namespace {

using core::mm_from_m;

/// Deep-groove ball bearings, ISO 15, the series of usual use.
struct Bearing {
    double bore_mm;
    const char* name;
};
constexpr std::array kBearings{
    Bearing{3, "623, 3 x 10 x 4 mm"},    Bearing{4, "624, 4 x 13 x 5 mm"},    Bearing{5, "625, 5 x 16 x 5 mm"},
    Bearing{6, "626, 6 x 19 x 6 mm"},    Bearing{8, "608, 8 x 22 x 7 mm"},    Bearing{10, "6000, 10 x 26 x 8 mm"},
    Bearing{12, "6001, 12 x 28 x 8 mm"}, Bearing{15, "6002, 15 x 32 x 9 mm"}, Bearing{20, "6004, 20 x 42 x 12 mm"}};

std::string bearing_of(double bore_mm) {
    for (const Bearing& bearing : kBearings)
        if (std::abs(bearing.bore_mm - bore_mm) < 0.05) return std::string("ISO 15 ") + bearing.name;
    return fmt::format("bore {:g} mm: none of the usual sizes", bore_mm);
}

std::string sleeve_of(double bore_mm) {
    return fmt::format("{:g} x {:g} mm, as long as the carriage's plate is thick", bore_mm, sleeve_mm(bore_mm));
}

std::string stated(double value, const char* unit) { return value > 0.0 ? fmt::format("{:g}{}", value, unit) : "not stated"; }

std::string torsion_size(const spring::BaseSpring& s) {
    return fmt::format("{:g} Nm/rad, wire {}, mean coil {}, coils {}", s.rate, stated(mm_from_m(s.wire_diameter), " mm"),
                       stated(mm_from_m(s.coil_diameter), " mm"), stated(s.active_coils, ""));
}
std::string compression_size(const spring::BaseSpring& s) {
    return fmt::format("{:g} N/m, wire {}, mean coil {}, active coils {}, free length {}", s.rate,
                       stated(mm_from_m(s.wire_diameter), " mm"), stated(mm_from_m(s.coil_diameter), " mm"), stated(s.active_coils, ""),
                       stated(mm_from_m(s.free_length), " mm"));
}

double length_of(const Assembly& a, const char* body) {
    const Body& found = *a.find(body);
    double low = INFINITY, high = -INFINITY;
    for (const Prism& prism : found.prisms) low = std::min(low, prism.z_low_mm), high = std::max(high, prism.z_high_mm);
    return high - low;
}

void add_keys(const solid::Part& part, std::vector<BillRow>& rows) {
    const solid::HubOptions& hub = part.options.hub;
    if (hub.lock != solid::HubLock::kKeyway) return;
    const double length = hub.kind == solid::HubKind::kOverhung ? mm_from_m(hub.boss_height) : mm_from_m(part.z_high - part.z_low);
    rows.push_back({"key", 2, fmt::format("DIN 6885-1, {:g} mm wide, {:.1f} mm long", mm_from_m(hub.key_width), length),
                    std::string("in ") + to_string(part.cam.kind)});
}

void add_shafts(const Assembly& a, std::vector<BillRow>& rows) {
    const double shaft = mm_from_m(a.drive.k_pe->options.hub.bore_diameter), axle = mm_from_m(a.drive.k_se->options.hub.bore_diameter);
    rows.push_back({"motor shaft", 2, fmt::format("{:g} mm, {:.1f} mm long", shaft, length_of(a, "motor_shaft_agonist")), ""});
    rows.push_back({"spool axle", 2, fmt::format("{:g} mm, {:.1f} mm long", axle, length_of(a, "axle_agonist")), ""});
    rows.push_back({"joint shaft", 1, fmt::format("{:g} mm", shaft), "its length depends on the frame"});
    rows.push_back({"ball bearing", 6, bearing_of(shaft), "two for each motor shaft and the joint"});
    rows.push_back({"sleeve bearing", 2, sleeve_of(axle), "ISO 2795, one for each spool axle, in the carriage"});
    rows.push_back({"retaining ring", 4, fmt::format("DIN 471, {:g} x {:g} mm", axle, ring_mm(axle)), "two for each spool axle"});
    const Collar collar = collar_of(shaft);
    rows.push_back({"set collar", 2, fmt::format("DIN 705, {:g} x {:g} x {:g} mm", shaft, collar.outside_mm, collar.width_mm),
                    "on each motor shaft, beside the capstan"});
    rows.push_back({"stop pin", 3, fmt::format("ISO 2338, {:g} mm", 2.0 * kStop_mm), "one in the joint's pulley, two in the frame"});
    rows.push_back(
        {"carriage rod", 4, fmt::format("6 mm, {:.1f} mm long", a.find("rods_agonist")->shapes.front().length_mm), "hardened, h6"});
    rows.push_back({"linear bush", 8, "ISO 10285, 6 x 12 x 19 mm", "in the carriages"});
}

}  // namespace

std::vector<BillRow> bill_of(const Assembly& a) {
    std::vector<BillRow> rows;
    for (const char* name : {"k_se", "k_pe"})
        for (const char* end : {"", "_mirrored"}) rows.push_back({std::string(name) + end, 1, "", "made by fusee"});
    for (const char* name : {"capstan", "carriage", "k_pe_seat", "k_pe_cap"})
        if (a.find(std::string(name) + "_agonist") != nullptr)
            rows.push_back({name, 2, "as modelled", "one is the mirror image of the other"});
    rows.push_back({"joint_pulley", 1, "as modelled", ""});
    rows.push_back({"torsion spring", 2, torsion_size(a.drive.k_se_spring), "one of each hand; ends: straight legs"});
    rows.push_back({"compression spring", 2, compression_size(a.drive.k_pe_spring), "ends closed and ground"});
    for (const Cable& cable : a.cables)
        if (cable.side == Side::kAgonist)
            rows.push_back({std::string(to_string(cable.kind)) + " cable", 2,
                            fmt::format("{:g} mm, cut to {:.0f} mm", a.cable_mm, cable.cut_mm()),
                            fmt::format("{:.1f} mm from anchor to anchor, {:g} mm for each end", cable.length_mm, kCableEnd_mm)});
    add_shafts(a, rows);
    add_keys(*a.drive.k_se, rows);
    add_keys(*a.drive.k_pe, rows);
    return rows;
}

}  // namespace fusee::assembly
