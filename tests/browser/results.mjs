// Small results as their JSON files hold them, with names that have to be escaped and figures that are not known.
const kRad = Math.PI / 180;

function level(tau, exact) {
  return { tau_Nm: tau, linear_rad: 0.1 / tau, exact_rad: exact, measured_rad: 0.11 / tau, covered_measured_rad: null, condition_6: -0.1, joint_stiffness_Nm_per_rad: 2,
    free_joint_stiffness_Nm_per_rad: null, capstan_rad: 0.3, push_torque_Nm: 0.3, full_push_Nm: 0.25, frame_rad: 0.01, noise_rad: [0.1, 0.1, 0.2], built_rad: [0.1, 0.3],
    sensitivity_rad_per_Nm: [[1, 2, 3], [4, 5, 6], [7, 8, 9]] };
}

/** Two levels: at 1 Nm the exact extremes are not covered. */
export function simulation(name = "a<b") {
  return {
    fusee: "0.1", name, made_by: `fusee 0.1, ${name}`, remarks: ["a remark & more"], not_known: ["a gap"], findings: [],
    survey: { arrangement: "pnrvsa", stiffness_Nm_per_rad: [1, 2], free_stiffness_Nm_per_rad: [0.5, null], torque_Nm: 0.15, dead_band_rad: [0.1, 0.2] },
    condition_6: { verdict: "holds", torques_Nm: [0.5, 1], holds_Nm: [[0.5, 1]], values: [-0.2, -0.1] }, levels: [level(0.5, 0.22), level(1, null)],
    measured: [{ tau_Nm: 0.5, linear_rad: 0.2, exact_rad: null, simulated_rad: 0.21, measured_rad: 12 * kRad }], equilibria: [],
    path: { tau_Nm: 1, resting_loads_Nm: [0.8, 1.4], up: [[0, 0, 1, 1], [0.3, 0.2, 1.2, 0.8]], down: [[0, 0.1, 1, 1]] }, loops: [{ tau_Nm: 1, cycle: [[0, 0, 1, 1], [0.1, 0.1, 1, 1]] }],
    break_away: [{ motor_torque_Nm: 0, loads_Nm: [0, 0] }, { motor_torque_Nm: 1, loads_Nm: [0.8, 1.4] }], wraps: [{ part: "k_se", rows: [[0.5, 0.1, 0.3], [1, 0.1, 0.2]] }],
  };
}

export const equilibria = [
  { torques_Nm: [1, 0.9, 0], z_rad: [0.5, 0.25, 1e-17], sensitivity_rad_per_Nm: [[2, 2, 2], [2, 2, 2], [2, 2, 2]], cable_space_sensitivity_m_per_N: [[0.003, 0, 0], [0, 0, 0], [0, 0, 0]],
    joint_stiffness_Nm_per_rad: 2, free_joint_stiffness_Nm_per_rad: 1, dead_band: { linear_rad: 10 * kRad, exact_rad: null, edges_rad: [null, null], condition_5: [1, 2], condition_6: [-1, -2] }, findings: [] },
  { torques_Nm: [5, 1, 0], z_rad: [null, null, null], dead_band: null, findings: [{ rule: "equilibrium.outside", severity: "error", what: "wound beyond", measured: 1.9, bound: "at most", allowed: 1.5, unit: "rad", where: "", suggestion: "" }] },
];

const curves = { tau_Nm: [0, 1], theta_rad: [0, 1], f_se_Nm: [0, 0.6], f_pe_Nm: [0, 0.4], s_Nm_per_rad: [1, 1], p_Nm_per_rad: [1, 2] };

export function search(cams = true) {
  return {
    fusee: "0.1", name: "arm<1>-design", made_by: "fusee 0.1", generations: 2, seed: 5, evaluations: 24, interrupted: false, cost: -1.25,
    variables: [{ name: "k", unit: "1/(Nm rad)", box: [0.1, 0.3], found: 0.225, own: null }], figures: [{ name: "capstan travel", unit: "deg", found: 60, own: 61 }],
    dead_band: [{ tau_Nm: 1, linear_rad: 0.9, exact_rad: null }], own_dead_band: [], springs: curves, own_springs: { theta_rad: [] },
    costs: [{ variable: "u", unit: "Nm", value: [-0.1, 0, 0.1], cost: [1e9, -1.25, -1], feasible: [false, true, true], candidates: [-0.05, 0.05], lowest_cost: [null, -1], optimum: 0 }], history: [3, 1, -1.25],
    cams: cams ? [{ part: "k_se", can_be_cut: false, arms: { angle_rad: [0, 0.1], arm_m: [0.02, 0.021] }, drawing: null, findings: [{ rule: "cam.convexity", severity: "error", what: "no <convex> contour",
      measured: -1, bound: "at least", allowed: 0, unit: "mm", where: "", place: { angle_rad: 0, point_mm: [1, 0, 0] }, suggestion: "law.end_torque_Nm = 1.8", source: "a handbook" }] }] : [], findings: [], remarks: ["u & C are at bounds"],
  };
}

export const front = {
  name: "front", made_by: "fusee 0.1", against: "travel", loads_Nm: [0.5, 1.5], torques_Nm: [0.5, 1], dropped: 1, dropped_by: ["cam.convexity"], evaluations: 24, generations: 2, population: 8, seed: 5, interrupted: true,
  points: [0.2, 0.3].map((figure_rad, i) => ({ profile: `pareto/0${i}.toml`, figure_rad, dead_band_rad: [figure_rad, i ? null : 0.1], travel_rad: 2 - i, stiffness_Nm_per_rad: [1, 2], radius_mm: 20, capstan_radius_mm: 10, limited_by: "radius <max>" })),
};

/** Friction of 0.25 times the load. */
export function identification(sides) {
  const repeats = sides.flatMap((side) => [0.2, 0.5].flatMap((torque) => ["drive", "backdrive"].map((direction) => (
    { side, direction, motor_torque_Nm: torque, rows: 2, mean_load_Nm: torque, mean_friction_Nm: 0.25 * torque, deviation_Nm: 0.01 }))));
  const line = { group: "all", rows: 8, mu: 0.25, mu_95: [0.2, 0.3], constant_Nm: 0, constant_95_Nm: [-0.1, 0.1], scatter_Nm: 0.01, r_squared: 0.9, through_zero_mu: 0.25, through_zero_mu_95: [0.2, 0.3], robust_mu: 0.25, outlier_rows: [] };
  return { fusee: "0.1", name: "break_away", file_sha256: "0123456789abcdef", law: { gear_friction: 0.25, gear_friction_constant_Nm: 0 }, profile_lines: "[rig]\ngear_friction = 0.25\n",
    remarks: [{ id: "constant", text: "no constant", p: 0.0123 }, { id: "other", text: "other", p: null }], lines: [line], trusted: line, line_curve: { load_Nm: [0, 1], line_Nm: [null, 0.25], low_Nm: [0, 0.2], high_Nm: [0.1, 0.3] }, repeats };
}

const width = { stiffness_Nm_per_rad: [1, 2], free_stiffness_Nm_per_rad: [1, 2], torque_Nm: 1, dead_band_rad: [0.1, 0.2] };
const paperTable = { profile: "arm<1>", implied_travel_rad: 0.5, simulation: simulation("arm<1>"), rows: [{ tau_Nm: 0.5, paper_rad: 0.5, linear_rad: 0.6, exact_rad: null, measured_rad: 0.5, implied_parallel_Nm_per_rad: 0.125 }] };

export const paper = {
  fusee: "0.1", made_by: "fusee 0.1", claims: [{ piece: "figure 1", paper: "noise & both", here: "monotone" }],
  figure_1: [{ noise: "noise & both", c_Nm_per_rad: [1, 2], motor_variance_rad2: [0.5, 9], joint_variance_rad2: [0.5, 0.25] }, { noise: "floating", refusal: "error: noise.unbounded" }],
  figure_2: { series: { k_se_Nm_per_rad: 0.2, k_pe_Nm_per_rad: 0.3 }, parallel: { k_se_Nm_per_rad: 0.08, k_pe_Nm_per_rad: 0.12 }, rows: [0, 1].map((length_rad) => ({ active_Nm: 0, length_rad, series_Nm: 0.1, parallel_Nm: 0.1 })), passive: { length_rad: [0, 1], force_Nm: [0.1, 0.3] } },
  figure_8: { mu: 0.25, identification: identification(["a"]) }, figure_9: search(), table_1: paperTable, table_2: paperTable,
  relatives: [{ arrangement: "series_elastic", profiled: width, torque_control: { ...width, dead_band_rad: [null, null] } }],
};

export const study = {
  fusee: "0.1", name: "small<study>", has_reports: true, count: 3,
  columns: [{ name: "outcome", meaning: "what became of it", text: true }, { name: "mass_g", meaning: "mass <both>", text: false }, { name: "dead_band_at_peak_deg", meaning: "width", text: false }, { name: "key", meaning: "a key", text: false }, { name: "worst_rule", meaning: "rule", text: true }, { name: "worst_finding", meaning: "finding", text: true }],
  rows: [["left", ["made", 12, 20, 1, null, null], "0,0 1,0 1,1", null], ["right", ["refused", null, null, 2, "cam.<arm>", "error: cam.<arm>: no <convex> contour (k_se): measured -2 mm"], null, null]],
};

const kFinding = { measured: 6.1, bound: "at least", allowed: 8, unit: "mm", where: "k_se at psi 2.4", suggestion: "", source: "a handbook", what: "the cable bends too sharply & <frays>", place: { angle_rad: 2.4, point_mm: [-7, 7, 0] } };
const kPassed = { ...kFinding, rule: "cable.pressure", severity: "pass" }, kWarning = { ...kFinding, rule: "cable.bend_ratio", severity: "warning", suggestion: "preload 4.1 rad" };
export const open = { rule: "spring.stress", severity: "not judged", what: "the wire yielding", measured: 0, bound: "at most", allowed: 0, unit: "", where: "", suggestion: "k_se.spring.wire_mm", source: "" };

const file = (name) => ({ name, bytes: 51084, sha256: "b".repeat(64), triangles: 1020, chordal_error_mm: 0.002 });
const kSquare = "10,10 -10,10 -10,-10 10,-10";

function part(name, path) {
  const spring = path === "planar" ? { kind: "torsion", rate_Nm_per_rad: 0.02, preload_rad: 1, states_rad: [1, 2], torques_Nm: [0.02, 0.04] } : { kind: "compression", rate_N_per_m: 900, preload_m: 0.01, states_m: [0.01, 0.02], forces_N: [9, 18] };
  return {
    part: name, spring, findings: [kPassed, kWarning], files: [file(`${name}.stl`)],
    cam: { path, cable_diameter_mm: 1, arms_mm: [10, 10], travel_rad: 2, working_psi_rad: [0.5, 2.5], least_curvature_radius_mm: 10, tensions_N: [5, 9], stretch: { tension_N: 9, length_mm: 0.1, capstan_rad: 0.01, capstan_travel_rad: 1, share: 0.01 } },
    certificate: { convex: "proven", ordered: "not proven", boxes: 12, open: "somewhere", least_proven_mm: 10 },
    mesh: { triangles: 1020, volume_mm3: 1256, box_mm: [[-10, -10, -2], [10, 10, 2]], chordal_error_mm: 0.002, shortest_edge_mm: 0.2, smallest_angle_deg: 1.5 },
    read_back: [{ file: `${name}.stl`, reader: "assimp", rows: 400, worst_relative: 2e-4, worst_angle_rad: 1, allowed: 1e-3, passed: true, severity: "pass" }],
    arms: { angle_rad: [0, 1, 2], arm_mm: [10, 10, 10], z_mm: [0, 1, 2] },
    drawing: { part: name, closed: path === "planar", body: [kSquare], boss: [kSquare], floor: kSquare, pitch: kSquare, working: "10,10 -10,10", around: "",
      ends: [{ load_Nm: 0.3, contact_mm: [10, 0], direction: [0, 1] }, { load_Nm: 1.3, contact_mm: [0, 10], direction: [-1, 0] }] },
  };
}

const source = { contour: 1, rate: 2, friction: 0 };
const budget = { draws: 200, percentile: 1.645, parts: ["k_se", "k_pe"].map((name) => ({ part: name, worst_place: 0, limits: { contour: "0.1 mm", rate: "5 %", friction: name === "k_se" ? null : "10 %" },
  places: [0, 10].map((travel_deg) => ({ travel_deg, torque_Nm: 1, sigma_percent: source, band_percent: [-5, 5], sampled_percent: [-6, 6] })) })), dead_bands: [{ tau_Nm: 1, nominal_deg: 20, sigma_deg: source }, { tau_Nm: 2, nominal_deg: null, sigma_deg: source }] };

export function design(more = {}) {
  return {
    fusee: "0.1", name: "disc<1>", made_by: "fusee 0.1, via=cgal", verdict: "warning",
    headline: { figures: [{ name: "Dead-band, 0.4 to 0.8 Nm", value: "75 to 20 deg", line: "as built & more", label: "exact dead-band" }], budget: null },
    law: { loads_Nm: [0.3, 1.3], angles_rad: [0, 2], design_loads_Nm: [0.4, 1.3], lead_in_travel_rad: 0.2, least_feasible_start_Nm: null, stiction_loads_Nm: [0.35, 1.25], covers_stiction: true, curves },
    dead_band: [{ tau_Nm: 0.4, linear_rad: 2.5, exact_rad: 3, joint_stiffness_Nm_per_rad: 0.4, free_joint_stiffness_Nm_per_rad: 0.2 }, { tau_Nm: 0.8, linear_rad: 1.2, exact_rad: null, joint_stiffness_Nm_per_rad: 0.4, free_joint_stiffness_Nm_per_rad: 0.2 }],
    as_exported: { tau_Nm: [], nominal_dead_band_rad: [], joints: [] }, findings: [{ ...kPassed, rule: "law.transmission" }], parts: [part("k_se", "planar"), part("k_pe", "helix")], mirrored: [], plate: [], files: [file("springs.csv")],
    assembly: null, no_assembly: "", ...more,
  };
}

/** What a design may have beyond that. */
export const whole = {
  assembly: { motor_distance_mm: 60, carriage_travel_mm: 12, cables: [{ kind: "drive", length_mm: 50, cut_mm: 80 }] },
  as_exported: { tau_Nm: [0.4, 0.8], nominal_dead_band_rad: [1, null], joints: [{ reader: "assimp", binding: true, refusal: "", k_se: { file: "k_se.stl", worst_arm_relative: 1e-4, worst_law_relative: 2e-4 }, k_pe: { file: null }, dead_band_rad: [1.001, null] },
    { reader: "perimeters", binding: false, refusal: "load <falls>", k_se: { file: null }, k_pe: { file: null }, dead_band_rad: [null, null] }] },
  table: { file: "law.csv", series: { rms_Nm: 0.001, largest_Nm: 0.002, largest_in_row: 2 }, parallel: { rms_Nm: 0.001, largest_Nm: 0.002, largest_in_row: 1 }, rows: [[0, 0.1, 0.1, 0.2, 0.2], [1, 0.3, 0.3, 0.4, 0.4]] },
  budget,
};

/** A loop: load up, unload, load down, unload. */
export function loopTrace(label) {
  const trace = { experiment: "joint_stiffness", label, x_name: "joint_torque_Nm", y_name: "q_rad", rows: 81, explained: 100, x: [], measured: [], before: [], after: [], sigma: [] };
  for (let i = 0; i <= 80; ++i) {
    const phase = i / 20, x = 4 * (phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4), way = phase < 1 || phase > 3 ? 1 : -1, after = 0.08 * x - 0.05 * way;
    trace.x.push(x);
    trace.before.push(0.08 * x - 0.02 * way);
    trace.after.push(after);
    trace.measured.push(after + 0.008 * Math.sin(7 * i));
    trace.sigma.push(0.006);
  }
  return trace;
}

/** A trace of which only x, after and sigma 0.1 matter. */
export const traceOf = (x, after, more = {}) => ({ experiment: "log", label: "l", x_name: "t_s", y_name: "y_m_s", rows: x.length, explained: 1, x, measured: after, before: [], after, sigma: x.map(() => 0.1), ...more });

const gap = { before: 9.12, after: 1.04, noise_floor: 1, heldout_before: 9.31, heldout_after: 1.06, heldout_after_95: [0.97, 1.17] };
const coulomb = { id: "gear.coulomb", side: "agonist" }, radius = { id: "se.radius", side: "both" };
const newtonMetre = (value) => ({ value, ci95: [0.9 * value, 1.1 * value], unit: "Nm" });
const cellOf = (experiment, variable, from, to, before, after) => ({ experiment, region: { variable, from, to }, before, after, rows: 5 });

/** A full case: friction in the agonist's gear and a spool cut too deep. */
export function diagnosis(more = {}) {
  return {
    fusee: "0.1", case: "open-07", case_sha256: "0123456789abcdef", verdict: "identified", sentence: "The rig has 2 effects & more.", probability: 0.934, unknown_term: null, term_units: [], doubts: [], transfer: [], power: [],
    effects: [{ ...coulomb, probability: 0.981, parameter: { value: 0.0512, ci95: [0.0473, 0.0551], unit: "Nm" } }, { ...radius, probability: 0.934, parameter: { value: -2.1e-4, ci95: [-2.6e-4, -1.6e-4], unit: "m" }, extra: { v_s: 0.02 } }],
    meanings: Object.fromEntries(["gear.coulomb", "se.radius", "gear.stribeck"].map((id) => [id, { meaning: `What <${id}> does.`, law: "x = y", of_joint: true }])),
    alternatives: [{ effects: [{ id: "gear.stribeck", side: "agonist" }], probability: 0.041 }, { effects: [], probability: 0.0002 }],
    where: [{ experiment: "dead_band", share: 0.62, region: { variable: "cocontraction_Nm", from: 0.12, to: 0.5 }, component: "agonist, push up" }, { experiment: "log", share: 0.3, region: { variable: "", from: null, to: null } }], gap,
    next_experiment: "Hold the motor.", next: [{ text: "Hold the motor.", experiment: "breakaway", variable: "motor_torque_Nm", set_points: [0.02, 0.05], information_bit: 1.72, cost_min: 12 }],
    build: { "se_radius agonist": { value: 1.2e-5, ci95: [-3e-5, 5e-5], unit: "m" } }, experiments: [{ experiment: "breakaway", rows: 24, gap, forecast: 1.05, held_out: "8 <torques>", in_unit: { before: 0.124, after: 0.0121, heldout_after: 0.0148, unit: "Nm" } }, { experiment: "log", rows: 9, gap: { ...gap, heldout_after: null, heldout_after_95: [null, null] }, forecast: null }],
    map: [cellOf("dead_band", "cocontraction_Nm", 0.3, 0.5, 2.4, 1.1), cellOf("dead_band", "cocontraction_Nm", 0.1, 0.3, 27, null)],
    ranking: [{ effects: [radius, coulomb], log_evidence: 0, probability: 0.9, chi2: 310, left_out: null, parameters: [newtonMetre(0.05), newtonMetre(0.06)] }, { effects: [], log_evidence: null, probability: 0.01, chi2: 900, left_out: 5, parameters: [] }],
    isolability: { causes: [coulomb, radius, { id: "joint.coulomb", side: "none" }], signature_similarity: [[1, 0.984, 0.1], [0.984, 1, null], [0.1, null, 1]], detectable: [0.004, 1e-4, null], units: ["Nm", "m", "Nm"], classes: [[0, 1]] },
    traces: [loopTrace("q over torque at 0.5 Nm"), loopTrace("q over torque at 1 Nm"), traceOf([0, 1, 2], [1, 2, 3]), traceOf([0, 1], [1, 2]), traceOf([0, 1], [3, 4], { explained: 0 })], remarks: ["Leaving out the time log does not change it."],
    ...more,
  };
}

const form = { id: "term.motor.ripple", side: "antagonist", probability: 0.97, parameter: newtonMetre(0.04), extra: { per_rad: 1.91 }, port: "motor", depends_on: "angle", law: "A ripple.", sentence: "The motor ripples 12 times a turn.",
  curve: { x_name: "capstan_rad", y_name: "torque_Nm", x: [0, 1, 2], y: [0.01, -0.02, 0.03] } };
export const unknown = { verdict: "unknown", effects: [], probability: null, unknown_term: { ...form, second: { ...form, id: "term.other" } }, term_units: [["1/rad"], []] };

const widths = (value) => ({ measured_rad: value, exact_rad: null });
export const redesign = { torque_error_old: 0.106, torque_error_new: 1e-6, off_with_old_cams: 0.175, off_with_new_cams: 0.025, at_peak: { tau_Nm: 1, promised: widths(0.3), old_cams: widths(0.33), new_cams: widths(0.31) },
  dead_band: [{ tau_Nm: 0.8, promised: widths(0.4), old_cams: widths(0.5), new_cams: widths(0.42) }], not_mended: [{ id: "joint.coulomb", side: "none", instead: "look at the bearing" }], remarks: ["Only the agonist's cams < are new."],
  profiles: [{ file: "dir/arm <new>.toml", can_be_cut: false, coverage: "covers all", changes: [{ key: "rig.gear_friction", was: "0.28", is: "0.364", why: "gear.load_friction <b>" }], findings: [{ ...kWarning, severity: "error", rule: "cam.arm" }] }] };

const share = (hits, of) => ({ hits, of, value: of ? hits / of : null, wilson95: [0.1, 0.9] });
const kFigures = ["effect_named", "effect_and_side", "none_on_null", "both_of_two", "intervals_hold", "held_out_halved", "unknown_called_unknown", "known_called_unknown"];
export function score(model = null) {
  return {
    fusee: "0.1", seal: "sha256:0123abcd", cases: 3, model, seconds: { median: 1.5, worst: null },
    figures: Object.fromEntries(kFigures.map((key, i) => [key, { name: `figure ${i} <${key}>`, ...share(i ? 1 : 0, i ? 2 : 0), wanted: [[0.95, 1], [0.9, 0.99], [0, 0.05], [1, 1], [0, 1]][i % 5], shuffled: null, shuffled95: [null, null] }])),
    confusion: { none: { none: 1 }, "gear.coulomb": { "<wrongly>": 1 } }, calibration: [{ ...share(1, 2), stated: [0.95, 0.99], mean_stated: 0.97 }, { ...share(0, 0), stated: [0, 0.5], mean_stated: null }],
    coverage: { "pe.radius": share(1, 1) }, shrink: [{ case: "case0", claimed: 0.1, measured: 0.2 }],
    misses: [{ case: "case1", what: "another effect", truth: [{ ...coulomb, size: 0.05 }], answer: { verdict: "identified", effects: [{ id: "<wrongly>", side: "both", value: 1, ci95: [0.5, 1.5] }], alternatives: [{ effects: [coulomb, radius], probability: 0.3 }, { effects: [], probability: 0.1 }], held_out_before: 8, held_out_after: 1 } },
      { case: "case2", what: "no diagnosis", truth: [], answer: { verdict: "failed", effects: [], alternatives: [], held_out_before: null, held_out_after: null } }],
  };
}
