#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "data/json.h"
#include "fusee/assembly/assembly.h"
#include "fusee/assembly/motion.h"
#include "fusee/checks/limits.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/export.h"
#include "fusee/report/assembly.h"
#include "fusee/solid/cutters.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

constexpr const char* kSheet = "_inspection.csv";

/// Names of the sheets for the inspection of the parts, as far as they were written.
std::vector<std::string> inspection_sheets(const pipeline::DesignReport& design) {
    std::vector<std::string> names;
    for (const pipeline::PartReport* part : design.sides())
        for (const pipeline::FileRow& row : part->files)
            if (row.entry.name.ends_with(kSheet)) names.push_back(row.entry.name);
    return names;
}

/// Parts that fusee makes name the sheet by which they are inspected.
std::vector<assembly::BillRow> rows_of(const pipeline::DesignReport& design) {
    const std::vector<std::string> sheets = inspection_sheets(design);
    std::vector<assembly::BillRow> rows = assembly::bill_of(*design.assembly);
    for (assembly::BillRow& row : rows)
        if (std::find(sheets.begin(), sheets.end(), row.item + kSheet) != sheets.end())
            row.note += fmt::format("; inspected with {}{}", row.item, kSheet);
    return rows;
}

/// The bill of materials as a section of Markdown, for paper.
std::string bill_table(const pipeline::DesignReport& design) {
    std::string table = "\n## Bill of materials\n| item | count | size | note |\n|---|---|---|---|\n";
    for (const assembly::BillRow& row : rows_of(design))
        table += fmt::format("| {} | {} | {} | {} |\n", row.item, row.count, row.size, row.note);
    return table;
}

using assembly::Assembly, assembly::Body;
using core::deg_from_rad, core::mm_from_m;

/// Direction of a part's timing mark at rest, seen along the joint's axis [deg].
double mark_deg(const Assembly& a, const char* body) {
    const solid::Part& part = a.find(body)->base_name() == "k_se" ? *a.drive.k_se : *a.drive.k_pe;
    const double sign = solid::mark_angle(part) > 0.0 ? -1.0 : 1.0;
    const Eigen::Vector3d mark = a.find(body)->rest.linear() * (sign * Eigen::Vector3d::UnitX());
    return std::round(10.0 * deg_from_rad(std::atan2(mark.y(), mark.x()))) / 10.0 + 0.0;
}

bool is_turned_over(const Assembly& a, const char* body) { return a.find(body)->rest.linear()(2, 2) < 0.0; }

std::string places(const Assembly& a) {
    std::string rows = "| | x | y | z |\n|---|---|---|---|\n";
    const auto row = [&](const char* name, const Eigen::Vector3d& p) {
        rows += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} |\n", name, p.x(), p.y(), p.z());
    };
    row("joint's axis", Eigen::Vector3d::Zero());
    row("motor's axis", a.motor_axis_mm);
    row("K_SE's axis at the lowest load", a.spool_axis_mm);
    row("hole of K_SE's cable on the carriage, at the lowest load", a.k_se_guide_mm);
    row("hole of K_PE's cable in its seat", a.k_pe_guide_mm);
    return rows;
}

/// The holes of the frame's plate, by which it is drilled where no DXF is cut; "" without a frame.
std::string frame_holes(const Assembly& a) {
    if (a.frame_holes.empty()) return "";
    std::string rows = "## Holes of the frame's plate\n| x | y | diameter | for |\n|---|---|---|---|\n";
    for (const assembly::FrameHole& hole : a.frame_holes)
        rows += fmt::format("| {:.2f} | {:.2f} | {:g} | {} |\n", hole.x_mm, hole.y_mm, hole.diameter_mm, hole.holds);
    return rows + "\n";
}

std::string cables(const Assembly& a) {
    std::string rows = "| cable | from | to | anchor to anchor [mm] | cut to [mm] |\n|---|---|---|---|---|\n";
    for (const assembly::Cable& cable : a.cables)
        if (cable.side == assembly::Side::kAgonist)
            rows += fmt::format("| {} | {} | {} | {:.1f} | {:.0f} |\n", to_string(cable.kind), cable.from, cable.to, cable.length_mm,
                                cable.cut_mm());
    return rows;
}

/// What is not seen on the part: which face is below, and which of both mirror images it is where K_PE's stand on the other sides.
std::string remark(const Assembly& a, const std::string& body) {
    std::string text = is_turned_over(a, body.c_str()) ? "its top face is below" : "";
    if (a.drive.k_pe_mirrored && body.starts_with("k_pe"))
        text += std::string(text.empty() ? "" : "; ") + "it is the part " + (body == "k_pe_agonist" ? "k_pe_mirrored" : "k_pe");
    return text;
}

std::string marks(const Assembly& a) {
    std::string rows = "| part | mark at the lowest load [deg] | |\n|---|---|---|\n";
    for (const char* body : {"k_se_agonist", "k_se_antagonist", "k_pe_agonist", "k_pe_antagonist"})
        rows += fmt::format("| {} | {:.1f} | {} |\n", body, mark_deg(a, body), remark(a, body));
    return rows;
}

std::string preloads(const Assembly& a) {
    const spring::BaseSpring &torsion = a.drive.k_se_spring, &pressed = a.drive.k_pe_spring;
    const double force = pressed.rate * pressed.preload;
    return fmt::format(
        "- **K_SE**: put the spring's axial leg into the slot of the spool and the radial one into the slot of the carriage's post, which "
        "is at {:.0f} deg\n  from +x about the spool's axis. Wind the spool {} by {:.0f} deg ({:.2f} turns; {:.3f} Nm), seen from above on "
        "the agonist's side:\n  it is then at its timing mark. Clamp the series cable where it leaves the carriage, and knot it.\n"
        "- **K_PE**: push the cap towards the seat by {:.2f} mm ({:.1f} N) and clamp it. Then knot the parallel cable, so that it is just "
        "taut.\n",
        std::fmod(deg_from_rad(a.leg_post_angle) + 360.0, 360.0), a.drive.k_se->cam.rotation_sign > 0 ? "counter-clockwise" : "clockwise",
        deg_from_rad(torsion.preload), torsion.preload / (2.0 * core::kPi), torsion.rate * torsion.preload, mm_from_m(pressed.preload),
        force);
}

/// What holds the axle: an overhung spool is bonded to it.
const char* axle_step(const Assembly& a) {
    if (a.drive.k_se->options.hub.kind == solid::HubKind::kThrough) return "close it with both retaining rings";
    return "bond the axle into the spool's blind bore, close it below with its retaining ring";
}

/// From where a body comes to its place.
const char* comes_from(const Eigen::Vector3d& along) {
    if (std::abs(along.z()) > 0.5) return along.z() > 0.0 ? "from below" : "from above";
    return along.y() > 0.0 ? "from the motors' side" : "from the joint's side";
}

/// Numbered lines, and how many.
struct Order {
    std::string text;
    int count = 0;
    void add(const std::string& line) { text += fmt::format("{}. {}.\n", ++count, line); }
};

/// Without a frame the user's own decides on the order of what it holds.
Order order_without_frame(const Assembly& a) {
    Order order;
    order.add(fmt::format("Set the bearings and the joint's pulley into the frame; the motors' axes are {:.2f} mm from the joint's",
                          a.motor_distance_mm));
    order.add(
        "Lock the capstan and K_PE on each motor's shaft, as bom.csv states; K_PE's boss is towards the capstan. The set collar holds the "
        "capstan; bond an overhung K_PE to its shaft");
    order.add(
        fmt::format("Press the sleeve into each carriage, put the axle with the spool and its spring in it, {}. Push the rods through the "
                    "closed bushes of each carriage, and only then screw them into the frame",
                    axle_step(a)));
    return order;
}

/// The line of a step: to what, which bodies, from where.
std::string line_of(const assembly::Step& step, bool whole) {
    std::vector<std::string> names;  // each once
    for (const assembly::Piece& piece : step.pieces)
        if (std::find(names.begin(), names.end(), piece.body) == names.end()) names.push_back(piece.body);
    std::string line = step.subassembly.empty() ? "Joint" : step.subassembly == "carriage" ? "Each carriage" : "On " + step.subassembly;
    line += whole ? fmt::format(": {} with all that is on it", names.front()) : fmt::format(": {}", fmt::join(names, ", "));
    if (step.along.norm() > 0.0) line += std::string(" ") + comes_from(step.along);
    return step.how.empty() ? line : line + ": " + step.how;
}

/// By the steps of which the path of each is free (assembly_steps).
Order order_of(const Assembly& a) {
    const std::vector<assembly::Step> steps = assembly::assembly_steps(a);
    if (steps.empty()) return order_without_frame(a);
    Order order;
    for (const assembly::Step& step : steps) {
        const bool whole = step.subassembly.empty() && std::any_of(steps.begin(), steps.end(), [&](const assembly::Step& s) {
                               return s.subassembly == step.pieces.front().body;
                           });
        if (step.subassembly.empty() || step.along.norm() > 0.0) order.add(line_of(step, whole));
    }
    return order;
}

/// Of the capstans; "" where the bill says who stops them.
std::string capstan_stops(const Assembly& a) {
    if (a.find("capstan_pin_agonist") == nullptr) return "";
    return fmt::format(
        " Each capstan is stopped {:.1f} deg beyond both ends of its range: its pin meets posts in frame_rear (capstan_stops).",
        deg_from_rad(a.spare_turn));
}

std::string stops(const Assembly& a) {
    if (a.find("joint_stops")->prisms.size() == 1)
        return "The joint turns nearly a whole turn: a pin in the pulley meets the one post of the frame (joint_stops) from both sides.";
    return fmt::format(
        "The joint's stops are at {:.1f} deg on both sides of its middle: a pin in the pulley meets two posts of the frame (joint_stops).",
        0.5 * deg_from_rad(a.joint_range));
}

/// The sheets by which the parts are measured before they are mounted; "" without the format "drawing".
std::string inspection(const pipeline::DesignReport& design) {
    std::string sheets;
    for (const std::string& name : inspection_sheets(design)) sheets += fmt::format("{}[{}]({})", sheets.empty() ? "" : ", ", name, name);
    if (sheets.empty()) return "";
    return fmt::format(
        "## Inspection\nMeasure the parts before they are mounted, and fill in their sheets: {}.\n`fusee calibrate` reads a sheet and "
        "states "
        "what to change ([drawing](k_se_drawing.svg): the rows are numbered there).\n\n",
        sheets);
}

/// What holds the cable on a cam without an anchor hole.
std::string clamped_ends(const Assembly& a) {
    std::string text;
    for (const solid::Part* part : {a.drive.k_se.get(), a.drive.k_pe.get()})
        if (part->options.features.anchor_hole_diameter <= 0.0)
            text += fmt::format(
                " {} has no hole for its cable: drill one beside the end of its groove, and hold the cable there under a screw and washer.",
                to_string(part->cam.kind));
    return text;
}

}  // namespace

std::string assembly_guide(const pipeline::DesignReport& design) {
    const Assembly& a = *design.assembly;
    const Order order = order_of(a);
    return fmt::format(
        "# Assembly of {}\n"
        "Frame: z is the joint's axis, the motors are at -y, the agonist is at +x; the antagonist's side is the mirror image x -> -x, with "
        "its cables\n{:.2f} mm lower. Lengths in mm. [bom.csv](bom.csv) lists the pieces; the motors and the fasteners are not "
        "modelled.\n\n"
        "![Exploded view](assembly_exploded.svg)\n\n![Seen along the joint's axis](assembly_plan.svg)\n\n"
        "{}## Places, agonist\n{}\n{}"
        "## Order\n{}"
        "{}. Turn every part to its timing mark, and preload the springs as below.\n"
        "{}. Lay the cables: K_PE to its spring, K_SE through its hole to the pulley, the carriage to the capstan. Their ends go through "
        "the holes in the outer flanges of capstan and pulley; the {} lies outside.{}\n"
        "{}. Remove the clamps. Each motor now holds the lowest load of its springs.\n\n"
        "## Cables, each side\n{}\nEach end has {:g} mm for its {}.\n\n"
        "## Timing marks\nAngles are from +x, counter-clockwise seen from above.\n\n{}\n"
        "## Preloads\n{}\n"
        "## Range\nA capstan turns by {:.1f} deg from the lowest load; its carriage then has travelled {:.1f} mm. K_SE pays out at most "
        "{:.1f} mm. {}{}\n",
        design.provenance.name, 2.0 * a.plane_mm, inspection(design), places(a), frame_holes(a), order.text, order.count + 1,
        order.count + 2, checks::to_string(a.drive.cable.termination), clamped_ends(a), order.count + 3, cables(a), assembly::kCableEnd_mm,
        checks::to_string(a.drive.cable.termination), marks(a), preloads(a), deg_from_rad(a.greatest_turn),
        a.capstan_radius_mm * a.greatest_turn, a.greatest_payout_mm, stops(a), capstan_stops(a));
}

std::vector<pipeline::FileRow> write_assembly(const pipeline::DesignReport& design, const std::filesystem::path& folder) {
    std::vector<pipeline::FileRow> rows;
    const auto write = [&](const std::string& name, const std::string& bytes) {
        core::write_file(folder / name, bytes);
        rows.push_back(pipeline::file_row(folder / name));
    };
    const Assembly& a = *design.assembly;
    const std::string guide = assembly_guide(design);
    const std::string json = assembly_json(design);
    const auto [view, exploded] = assembly_pictures(a);
    const Json svgs{{"assembly_plan", assembly_plan(a)}, {"assembly_view", view}, {"assembly_exploded", exploded}};
    write("assembly.json", json);
    write("assembly.md", guide);
    write("bom.csv", bill_csv(design));
    for (const char* name : {"assembly_plan", "assembly_view", "assembly_exploded"})
        write(std::string(name) + ".svg", svgs[name].get_ref<const std::string&>());
    const std::string paper = guide + bill_table(design);
    write("assembly.html", page_file({"assembly",
                                      "Assembly of " + design.provenance.name,
                                      paper,
                                      {{"result", json}, {"guide", Json(paper).dump()}, {"pictures", svgs.dump(-1, ' ', true), true}}}));
    return rows;
}

std::string bill_csv(const pipeline::DesignReport& design) {
    std::string csv = "item,count,size,note\n";
    for (const assembly::BillRow& row : rows_of(design))
        csv += fmt::format("{},{},{},{}\n", core::csv_cell(row.item), row.count, core::csv_cell(row.size), core::csv_cell(row.note));
    return csv;
}

}  // namespace fusee::report
