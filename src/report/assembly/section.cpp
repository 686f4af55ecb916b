#include <fmt/format.h>

#include <cmath>

#include "fusee/assembly/bill.h"
#include "fusee/report/assembly.h"
#include "page/html.h"

namespace fusee::report {

std::string assembly_section(const pipeline::DesignReport& design) {
    if (!design.assembly) return "";
    const assembly::Assembly& a = *design.assembly;
    Rows rows;
    for (const assembly::Cable& cable : a.cables)
        if (cable.side == assembly::Side::kAgonist)
            rows.push_back({plain(std::string(to_string(cable.kind)) + " cable"), num(cable.length_mm), num(cable.cut_mm())});
    const std::string text = fmt::format("The motors' axes are {} mm from the joint's; a carriage travels {} mm.",
                                         number(a.motor_distance_mm), number(a.capstan_radius_mm * a.greatest_turn));
    return section("Building the joint",
                   paragraph(text) + html_table("Lengths of the cables", {"each side", "anchor to anchor [mm]", "cut to [mm]"}, rows) +
                       "<p><a href=\"assembly.md\">Order of assembly, preloads and timing marks</a>, "
                       "<a href=\"bom.csv\">bill of materials</a>, <a href=\"assembly_exploded.svg\">exploded view</a>.</p>");
}

}  // namespace fusee::report
