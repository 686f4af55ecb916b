/* [Hidden] */
// What follows is the part itself. Lengths in mm; z is the cam's axis; psi is the direction of the cable's normal.

// The cable's centreline, one row per column: [psi in radians, h, dh/dpsi, z]. Its point is h n + h' t with
// n = (cos psi, sin psi), t = (-sin psi, cos psi); a curve parallel to it at distance `offset` is (h + offset) n + h' t.
path = @PATH@;

// The groove's section, from the lower lip over the floor to the upper lip: [offset from the centreline along n, height above it].
groove = @GROOVE@;

closed = @CLOSED@;                // a planar groove goes round once; a helix begins and ends
chord = @CHORD@;                  // facets stay this close to the true curve
z_low = @Z_LOW@;                  // outer faces of the flanges
z_high = @Z_HIGH@;
rib = @RIB@;                      // thickness of the lower flange
lower_proud = @LOWER_PROUD@;      // how far the flanges stand beyond the lips
upper_proud = @UPPER_PROUD@;
core_radius = @CORE_RADIUS@;      // circle that the lower flange has to hold (boss), 0 = none

// A helix starts from its body without groove, bore and holes. Empty for a planar part.
skin_points = @SKIN_POINTS@;
skin_faces = @SKIN_FACES@;

lip = groove[0][0];
flat = len(groove) == 3;           // a roller's rim has no groove
half_width = groove[len(groove) - 1][1];
columns = closed ? [for (i = [0 : detail : len(path) - 1]) path[i]]
                 : concat([for (i = [0 : detail : len(path) - 2]) path[i]], [path[len(path) - 1]]);

function degrees(radians) = radians * 180 / PI;
function sides(radius) = max(3, ceil(360 / (2 * acos(1 - min(0.5, chord * detail * detail / radius)))));

// ---- outlines ----

// Point of the outline at distance `offset`, widened to hold a circle about the axis (p-sum of the two support functions).
firey = 8;
function support(row, offset, core) =
    core > 0 ? pow(pow(row[1] + offset, firey) + pow(core, firey), 1 / firey) : row[1] + offset;
function outline_point(row, offset, core) =
    let (c = cos(degrees(row[0])), s = sin(degrees(row[0])), h = support(row, offset, core),
         slope = core > 0 ? pow((row[1] + offset) / h, firey - 1) * row[2] : row[2])
    [h * c - slope * s, h * s + slope * c];

module slab(offset, core, from, to)
    translate([0, 0, from]) linear_extrude(to - from) polygon([for (row = columns) outline_point(row, offset, core)]);

// The part before anything is cut from it.
module body() {
    if (closed) {
        slab(lip, 0, z_low, z_high);
        // Flanges that stand beyond the lips reach to the middle: the tube's own face becomes their inner face.
        if (lower_proud > 0) slab(lip + lower_proud, core_radius, z_low, flat ? z_low + rib : 0);
        if (upper_proud > 0) slab(lip + upper_proud, 0, 0, z_high);
        if (boss_height > 0) translate([0, 0, z_low - boss_height])
            cylinder(r = boss_diameter / 2, h = boss_height + rib / 2, $fn = sides(boss_diameter / 2));
    } else {
        polyhedron(skin_points, skin_faces, convexity = 20);
    }
}

// ---- the groove: one tube swept along the path ----

// How far the widest flange stands beyond the lips, and a little more.
flange_reach = 1 + max([for (row = columns) support(row, lip + lower_proud, core_radius) - row[1] - lip]);

// The tube has to end outside the part. From flush lips it leaves along its own flank, beside a flange along the flange's inner face; a helix leaves
// its lips by next to nothing, since its neighbouring turns are near.
function past(lip_point, flank_point, proud) =
    !closed ? [lip_point + [detail > 1 ? 0.05 : 0.0001, 0], lip_point]
    : proud > 0 ? [lip_point + [flange_reach, 0], lip_point]
    : let (out = lip_point + (lip_point - flank_point) / norm(lip_point - flank_point))
      lower_proud > 0 ? [[lip_point[0] + flange_reach, out[1]], out] : [out];

function reversed(list) = [for (i = [len(list) - 1 : -1 : 0]) list[i]];

tube_section = let (n = len(groove))
    concat(past(groove[0], groove[1], lower_proud), [for (k = [1 : n - 2]) groove[k]],
           reversed(past(groove[n - 1], groove[n - 2], upper_proud)));

function groove_point(row, s) = concat(outline_point(row, s[0], 0), row[3] + s[1]);

module groove_tube() {
    n = len(columns);
    m = len(tube_section);
    last = closed ? n - 1 : n - 2;
    points = [for (row = columns) for (s = tube_section) groove_point(row, s)];
    walls = [for (i = [0 : last]) for (k = [0 : m - 1])
        let (a = i * m, b = (i + 1) % n * m, next = (k + 1) % m)
        each [[a + k, b + k, b + next], [a + k, b + next, a + next]]];
    end = (n - 1) * m;  // both ends are convex: fans of triangles, since a polygon of rounded points is not flat
    caps = closed ? [] : [for (k = [1 : m - 2]) each [[0, k, k + 1], [end, end + k + 1, end + k]]];
    if (!flat) polyhedron(points, concat(walls, caps), convexity = 20);
}

// ---- cutters ----

function arc(radius, from, to) =
    let (steps = max(3, ceil((to - from) / (2 * acos(1 - min(0.5, chord * detail * detail / radius))))))
    [for (i = [0 : steps]) let (a = from + (to - from) * i / steps) radius * [cos(a), sin(a)]];

// The bore; key and flat point towards +x, where the timing mark is.
module bore_outline() {
    radius = (bore_diameter + bore_clearance) / 2;
    if (hub_lock == "keyway") {
        open = asin(key_width / 2 / radius);
        polygon(concat([[radius + key_depth, -key_width / 2], [radius + key_depth, key_width / 2]], arc(radius, open, 360 - open)));
    } else if (hub_lock == "d_flat") {
        open = acos(1 - flat_depth / radius);
        polygon(arc(radius, open, 360 - open));
    } else {
        circle(radius, $fn = sides(radius));
    }
}

module bore() {
    bottom = z_low - boss_height - 1;
    top = blind ? z_low + rib - web : z_high + 1;
    if (bore_diameter > 0) translate([0, 0, bottom]) linear_extrude(top - bottom) bore_outline();
}

module set_screw()
    if (hub_lock == "set_screw" && screw_diameter > 0) translate([0, 0, z_low - boss_height / 2]) rotate([90, 0, 90])
        cylinder(d = screw_diameter, h = boss_diameter / 2 + 1, $fn = sides(screw_diameter / 2));

module anchor_hole()
    if (anchor_diameter > 0) translate(anchor_position)
        cylinder(d = anchor_diameter, h = anchor_end - anchor_position[2], $fn = sides(anchor_diameter / 2));

module timing_mark()
    if (mark_width > 0) translate([mark_from, -mark_width / 2, z_high - mark_depth])
        cube([mark_to - mark_from, mark_width, mark_depth + 1]);

module label()
    if (len(label_text) > 0) translate([-label_radius, 0, z_high - label_depth]) rotate(90)
        linear_extrude(label_depth + 1) text(label_text, size = label_size, halign = "center", valign = "center");
