#include "key.h"

namespace fusee::profile {

std::vector<Key> drawing_keys() {
    return {
        text_line("drawing.owner", "legal owner, ISO 7200", FIELD(title.owner)),
        text_line("drawing.number", "identification number of the design; each part's has its name behind it: \"4711-k_se\"",
                  FIELD(title.number)),
        text_line("drawing.revision", "index of the revision", FIELD(title.revision)),
        text_line("drawing.date", "of issue, as it is to be printed; a drawing has no other date", FIELD(title.date)),
        text_line("drawing.created_by", "creator, ISO 7200", FIELD(title.created_by)),
        text_line("drawing.approved_by", "approval person, ISO 7200", FIELD(title.approved_by)),
    };
}

std::vector<Key> compensation_keys() {
    const std::string t = "compensation.";
    const Limits shrink = within(-10, 10);
    return {
        number(t + "shrink_x_percent", shrink, "measured shrinkage of a length along x; k_xx_compensated.* are larger by it",
               FIELD(compensation.shrink[0])),
        number(t + "shrink_y_percent", shrink, "the same along y", FIELD(compensation.shrink[1])),
        number(t + "shrink_z_percent", shrink, "the same along z, the part's axis", FIELD(compensation.shrink[2])),
        number(t + "bore_offset_mm", within(-2, 2),
               "measured loss of a bore's diameter without shrinkage; bores of k_xx_compensated.* are wider by it",
               FIELD(compensation.bore_offset)),
        number(t + "cable_axis_mm", within(-10, 10),
               "distance of the cable's neutral axis from the floor beyond d/2: both cams are cut with arms smaller by it",
               FIELD(k_se.allowance.cable_axis)),
        number(t + "k_se_contour_mm", within(-2, 2),
               "measured excess of K_SE's contour along its normal, from its inspection sheet; the cam is cut with arms smaller by it",
               FIELD(k_se.allowance.contour)),
        number(t + "k_pe_contour_mm", within(-2, 2), "the same of K_PE", FIELD(k_pe.allowance.contour)),
    };
}

#define OF(member) \
    [](auto& p) -> auto& { return p.machining.member; }

std::vector<Key> machining_keys() {
    const std::string t = "machining.";
    const std::vector<std::string> methods{"stack", "wrap"};
    const Limits feed = within(0, 1e5), rpm = above(0, 1e6), length = within(0.01, 100);
    return {
        choice(t + "controller", {"linuxcnc"}, "reader of the G-code", OF(controller)),
        choice(t + "k_se", methods, "groove of a planar K_SE: two half plates on three axes, or one piece on a rotary axis", OF(k_se)),
        choice(t + "k_pe", methods, "the same of K_PE; a helix is always wrapped", OF(k_pe)),
        number(t + "tool_diameter_mm", length, "flat end mill for outlines, bores and half plates", OF(tool_diameter)),
        number(t + "feed_mm_per_min", feed, "of the end mill; 0: by chip load of material and cutter", OF(feed)),
        number(t + "plunge_feed_mm_per_min", feed, "straight down, and down a helix; 0: a third of the feed", OF(plunge_feed)),
        number(t + "spindle_rpm", rpm, "with the end mill", OF(spindle_rpm)),
        number(t + "depth_per_pass_mm", length, "of the end mill", OF(depth_per_pass)),
        number(t + "terrace_mm", length, "height of the steps of a plate's half groove", OF(terrace)),
        number(t + "wrap_feed_mm_per_min", feed, "of the groove's cutter along the part; 0: by chip load", OF(wrap_feed)),
        number(t + "wrap_rpm", rpm, "with the groove's cutter", OF(wrap_rpm)),
        number(t + "wrap_depth_mm", length, "of one pass of the groove's cutter", OF(wrap_depth)),
        number(t + "safe_height_mm", within(0.1, 1000), "above stock and clamps: rapids across stay there", OF(safe_height)),
        number(t + "breakthrough_mm", within(0, 100), "below the stock, into the board under it", OF(breakthrough)),
        number(t + "tolerance_mm", within(1e-4, 0.1), "largest distance between contour and G-code", OF(tolerance)),
        number(t + "spindle_max_rpm", rpm, "of the machine", OF(spindle_max_rpm)),
        integer(t + "flutes", within(1, 8), "teeth of each cutter", OF(flutes)),
        number(t + "flute_length_mm", length, "of the end mill", OF(flute_length)),
        number(t + "stick_out_mm", within(1, 100), "of every cutter below its holder", OF(stick_out)),
        number(t + "holder_diameter_mm", within(1, 100), "of the holder; 19: nut of an ER11 collet", OF(holder_diameter)),
        number(t + "chuck_diameter_mm", within(1, 500), "of the rotary axis; 42: nut of an ER25 collet chuck", OF(chuck_diameter)),
        number(t + "chuck_grip_mm", length, "length of the boss inside the chuck", OF(chuck_grip)),
        number(t + "dowel_diameter_mm", or_zero(0.1, 20),
               "of the two pins that register half plates, and of a blank's index pin, ISO 8734; 0: none", OF(dowel_diameter)),
        integer(t + "tabs", within(0, 12),
                "that hold a plate in its sheet, or the ring around a turned blank; 0: none, for the ring a skin", OF(tabs)),
        number(t + "tab_width_mm", length, "of a tab along the outline", OF(tab_width)),
        number(t + "tab_height_mm", length, "of a tab above the sheet's lower face", OF(tab_height)),
        sign(t + "rotary_sign", "1: a positive A turns the part by the right-hand rule about +X; -1: the other way", OF(rotary_sign)),
    };
}

#undef OF

}  // namespace fusee::profile
