// K_SE: the spool that turns a torsion spring as its cable is drawn off.
// @PROVENANCE@
// Open it in OpenSCAD (View > Customizer), change what is below, render with F6, export. From the command line:
//   openscad --hardwarnings --export-format binstl -o k_se.stl k_se.scad
// The path below holds the spring law: it is computed, do not edit it. The facets stay within @CHORDAL_ERROR@ mm of the true surface.

/* [Shaft and hub] */
// Nominal diameter of the bore, 0 for none
bore_diameter = @BORE_DIAMETER@;
// Added to the diameter
bore_clearance = @BORE_CLEARANCE@;
// What keeps the part from turning on its shaft
hub_lock = "@HUB_LOCK@"; // [plain, keyway, d_flat, set_screw]
// Keyway: width and depth above the bore's radius
key_width = @KEY_WIDTH@;
key_depth = @KEY_DEPTH@;
// Flat: how far it stands inside the bore's radius
flat_depth = @FLAT_DEPTH@;
// Set screw: diameter of its radial hole in the boss
screw_diameter = @SCREW_DIAMETER@;
// Boss below the part; a helix has it in its body already and takes these for the cuts only
boss_diameter = @BOSS_DIAMETER@;
boss_height = @BOSS_HEIGHT@;
// Blind bore from below, and the material left above it, measured from the lower flange's inner face
blind = @BLIND@;
web = @WEB@;

/* [Cable and spring] */
// Hole for the cable's end, 0 for none
anchor_diameter = @ANCHOR_DIAMETER@;
anchor_position = @ANCHOR_POSITION@;
anchor_end = @ANCHOR_END@;
// Slot for the spring's leg in the top face, width 0 for none
leg_slot_width = @LEG_SLOT_WIDTH@;
leg_slot_length = @LEG_SLOT_LENGTH@;
leg_slot_radius = @LEG_SLOT_RADIUS@;
leg_slot_depth = @LEG_SLOT_DEPTH@;
// [degrees]
leg_slot_angle = @LEG_SLOT_ANGLE@;

/* [Mark and text] */
// Timing mark at angle 0 in the top face, width 0 for none
mark_width = @MARK_WIDTH@;
mark_depth = @MARK_DEPTH@;
mark_from = @MARK_FROM@;
mark_to = @MARK_TO@;
// Text engraved in the top face, empty for none
label_text = "";
label_size = 3;
label_depth = 0.4;
label_radius = @LABEL_RADIUS@;

/* [Resolution] */
// 1 = as computed; 2, 4, 8 = coarser, for a quick look
detail = 1; // [1, 2, 4, 8]

// The spool: what is left of the body.
difference() {
    body();
    groove_tube();
    bore();
    set_screw();
    anchor_hole();@DOWELS@
    leg_slot();
    timing_mark();
    label();
}

// Two half circles joined by straights, along leg_slot_angle.
module leg_slot() {
    end = leg_slot_width / 2;
    half = (leg_slot_length - leg_slot_width) / 2;
    steps = max(6, ceil(180 / (2 * acos(1 - min(0.5, chord * detail * detail / end)))));
    outline = [for (side = [0, 1]) for (i = [0 : steps]) let (a = -90 + 180 * (side + i / steps))
        [leg_slot_radius + (side == 0 ? half : -half) + end * cos(a), end * sin(a)]];
    if (leg_slot_width > 0) translate([0, 0, z_high - leg_slot_depth]) rotate(leg_slot_angle)
        linear_extrude(leg_slot_depth + 1) polygon(outline);
}

@LIBRARY@
