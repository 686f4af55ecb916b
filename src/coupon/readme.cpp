#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fusee/coupon/sheet.h"

namespace fusee::coupon {

namespace {

/// Values with their numbers: "0: 6, 1: 6.1".
std::string counted(const std::vector<double>& values, int first) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("{}{}: {:.4g}", i == 0 ? "" : ", ", static_cast<int>(i) + first, values[i]);
    return text;
}

}  // namespace

std::string readme(const Drawn& drawn, const std::string& provenance) {
    std::string text = fmt::format("# Coupons\n{}\n\n", provenance);
    text +=
        "Make them like the cams: same machine, material, settings and direction (z up). Print the files as they are: "
        "they\n"
        "are not compensated, and the scaling of the slicer must be off. Let them cool, deburr them, measure them and fill "
        "`COUPON.csv`.\n\n"
        "| file | content |\n|---|---|\n";
    text += fmt::format(
        "| `bores_and_lengths` | an L with a tower on its corner. Along x and y: {:.4g} mm (width of an arm) and {:.4g} mm (its length); "
        "heights {:.4g} and {:.4g} mm. Holes by the number of notches beside them, diameters in mm: {} |\n",
        drawn.x_mm.front(), drawn.x_mm.back(), drawn.z_mm.front(), drawn.z_mm.back(), counted(drawn.bores_mm, 0));
    text += fmt::format(
        "| `groove_ladder` | grooves for the cable of {:g} mm, counted from the wide foot; floor radius over cable diameter: {} |\n",
        drawn.cable_diameter_mm, counted(drawn.groove_ratios, 1));
    text += fmt::format(
        "| `disc` | the profile's groove on a floor of {:g} mm radius, {:g} turns; `disc.json` states its arm like that of any part |\n\n",
        drawn.disc_floor_mm, drawn.disc_turns);
    text += "| row of the sheet | given | fill in | how |\n|---|---|---|---|\n";
    for (const ItemKind& kind : item_kinds())
        text += fmt::format("| `{}` | {} | {} | {} |\n", kind.name, kind.given_unit, kind.unit, kind.how);
    text +=
        "\nThe disc: fix the cable in its hole, lay it into the groove and load it with the tension of the joint. `disc_pull`: turn it by "
        "the "
        "given\n"
        "turns from any start and note the length of moved cable; the first row is 0. `disc_torque`: a lever with a scale on its "
        "shaft.\n"
        "`series_spring`: the disc in place of the spool on K_SE's torsion spring, force by a scale in the cable.\n\n"
        "Rows that you cannot measure stay empty; `fusee calibrate` lists the unknown values.\n";
    return text;
}

}  // namespace fusee::coupon
