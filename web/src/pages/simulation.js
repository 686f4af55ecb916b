// The page of simulation.json (docs/simulation.md).
import { findingLine } from "../kit/findings.js";
import { change, counted, deg, degrees, isKnown, newtonMetres, number, span } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { kCoContraction, Plot } from "../kit/plot.js";
import { bulletList, card, facts, foldedSection, grid, paragraph, section, verdictTag } from "../kit/sections.js";
import { compared, num, table } from "../kit/table.js";

const isPnrvsa = (s) => s.survey.arrangement === "pnrvsa";
const kVerdicts = {
  holds: ["pass", "Co-contraction reduces the stiction at the joint"],
  fails: ["error", "Co-contraction increases the stiction at the joint"],
  "holds in part": ["warning", "Co-contraction reduces the stiction at the joint in a part of its range"],
  "within rounding": ["warning", "Co-contraction leaves the stiction at the joint as it is"],
};

const conditionTag = ({ verdict }) => verdictTag(...(kVerdicts[verdict] ?? ["warning", "Whether co-contraction reduces the stiction at the joint is not known"]));

/** What co-contraction does to the dead-band, in a sentence; the exact one where the springs reach its edges at both ends. */
function sentenceOf({ levels }) {
  const ends = [levels[0], levels[levels.length - 1]], exact = ends.every((level) => isKnown(level.exact_rad)), [first, last] = ends.map((level) => degrees(exact ? level.exact_rad : level.linear_rad));
  if (levels.length < 2 || !isKnown(first) || !isKnown(last)) return "";
  return `The ${exact ? "" : "linear "}dead-band ${last < first ? "falls" : "rises"} from ${number(first, 3)} to ${number(last, 3)} deg as co-contraction rises from ${number(ends[0].tau_Nm, 3)} to ${newtonMetres(ends[1].tau_Nm)}.`;
}

function headOf(s) {
  const first = s.levels[0], last = s.levels[s.levels.length - 1], levels = `${span([first.tau_Nm, last.tau_Nm])} Nm`;
  const over = (key) => `${change(degrees(first[key]), degrees(last[key]))} deg`;
  const tiles = [
    ["Linear dead-band", over("linear_rad"), levels],
    ["Joint stiffness", `${span(s.survey.stiffness_Nm_per_rad)} Nm/rad`, "capstans held"],
    ["Largest torque outside", newtonMetres(s.survey.torque_Nm), "at the joint, within the springs' laws"],
  ];
  if (isPnrvsa(s)) tiles.unshift(["Dead-band by push and release", over("measured_rad"), levels]);
  return { kind: "fusee simulation", title: s.name, verdict: isPnrvsa(s) ? conditionTag(s.condition_6) : null, sentence: sentenceOf(s), stamp: s.made_by, tiles };
}

const kBodies = ["theta_1", "theta_2", "q"], kFigures = 5;

function equilibriumFacts({ z_rad: z, dead_band: band, ...row }) {
  const angle = (rad) => number(Math.abs(rad) < 1e-12 ? 0 : rad, kFigures);  // a residual of the root search
  const sides = (values) => `agonist ${number(values[0], kFigures)}, antagonist ${number(values[1], kFigures)}`;
  const list = [
    ["equilibrium", `theta_1 = ${angle(z[0])} rad, theta_2 = ${angle(z[1])} rad, q = ${angle(z[2])} rad (${angle(degrees(z[2]))} deg)`],
    ["stiffness of the joint", `${number(row.joint_stiffness_Nm_per_rad, kFigures)} Nm/rad capstans held, ${number(row.free_joint_stiffness_Nm_per_rad, kFigures)} Nm/rad free`]];
  if (!band) return [...list, ["dead-band", "defined without joint torque only"]];
  const exact = isKnown(band.exact_rad) ? `exact ${deg(band.exact_rad, kFigures)} deg, q from ${angle(degrees(band.edges_rad[0]))} to ${angle(degrees(band.edges_rad[1]))} deg`
    : "exact unknown: a spring leaves its law before an edge";
  return [...list, ["dead-band", `linear ${deg(band.linear_rad, kFigures)} deg; ${exact}`],
    ["condition (5), own torque raised", sides(band.condition_5)], ["condition (6), both torques raised", sides(band.condition_6)]];
}

function equilibriaSection(s) {
  const matrix = (title, rows) => table("Sensitivities", [title, "tau_1", "tau_2", "tau_q"], rows.map((row, i) => [kBodies[i], ...row.map((value) => num(value, kFigures))]));
  const rows = s.equilibria.map((row) => {
    const [one, two, q] = row.torques_Nm;
    const rests = () => html`${card(facts(equilibriumFacts(row)))}${grid(matrix("sensitivity (2) [rad/Nm]", row.sensitivity_rad_per_Nm), matrix("in cable space [m/N]", row.cable_space_sensitivity_m_per_N))}`;
    return html`<h3>tau_1 = ${one} Nm, tau_2 = ${two} Nm, tau_q = ${q} Nm</h3>${row.findings.length ? row.findings.map((finding) => paragraph(findingLine(finding))) : rests()}`;
  });
  return section("Requested equilibria", rows.length ? html`${paragraph("Capstan angles and torques are positive when they wind the capstan's own cable; joint angle and torque are positive when they stretch the agonist's cable. Matrices: d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q), paper (2).")}<div class="stack">${rows}</div>` : null);
}

function measuredSection(s) {
  const rows = s.measured.map((r) => [num(r.tau_Nm), num(deg(r.measured_rad)), ...[r.linear_rad, r.exact_rad, r.simulated_rad].map((rad) => compared(rad, r.measured_rad))]);
  return section("Comparison with the measured table", rows.length ? [paragraph("Full widths in degrees; in brackets the difference from the measured width."),
    table("Measured and computed widths", ["tau [Nm]", "measured", "linear", "exact", "push and release"], rows)] : null);
}

/** Curves over the co-contraction. */
export class OverLevels {
  constructor(levels) { Object.assign(this, { levels, tau: levels.map((level) => level.tau_Nm) }); }
  plot(title, name, curves) {
    const plot = new Plot(title, kCoContraction, name);
    for (const [label, of, css, dashed] of curves) plot.curve(label, this.tau, this.levels.map(of), css, dashed);
    return plot.fromZero();
  }
}

export function jointCharts(s, over) {
  const width = (key) => (level) => degrees(level[key]), exact = width("exact_rad");
  const band = over.plot("Dead-band at the joint, edge to edge", "dead-band [deg]", [["linear", width("linear_rad"), "linear", true], ["exact", exact, "exact"],
    ["push and release", width("measured_rad"), "se"], ["push within the laws", width("covered_measured_rad"), "se", true]]);
  if (s.measured.length) band.points("measured", s.measured.map((row) => row.tau_Nm), s.measured.map((row) => degrees(row.measured_rad)), "pe");
  const condition = over.plot("Condition (6): below 0 stiction at the joint decreases", "d(T tau_f)/dtau [1]", [["d(T tau_f)/dtau", (level) => level.condition_6, "t"]]);
  const stiffness = over.plot("Stiffness of the joint", "stiffness [Nm/rad]", [["capstans held", (level) => level.joint_stiffness_Nm_per_rad, "se"],
    ["capstans free", (level) => level.free_joint_stiffness_Nm_per_rad, "sum", true]]);
  const charts = [band, condition, stiffness];
  if (s.levels.some((level) => isKnown(level.built_rad[1])))
    charts.push(over.plot("Exact dead-band: nominal, and of 90 % of joints as built", "dead-band [deg]", [["nominal", exact, "exact"]])
      .band("5 to 95 %", over.tau, s.levels.map((level) => degrees(level.built_rad[0])), s.levels.map((level) => degrees(level.built_rad[1])), "exact"));
  return charts;
}

const kPush = "joint torque [Nm]";

export function pushCharts(s) {
  const charts = [], torque = (points) => points.map((p) => p[0]), angle = (points) => points.map((p) => degrees(p[1]));
  if (s.path) {
    const { up, down, tau_Nm: tau, resting_loads_Nm: [low, high] } = s.path, whole = [...up, ...down], step = whole.map((_, i) => (4 * i) / (whole.length - 1));
    charts.push(new Plot(`A push-and-release test at ${number(tau)} Nm`, kPush, "joint angle [deg]")
      .curve("up and released", torque(up), angle(up), "se").curve("down and released", torque(down), angle(down), "pe"));
    charts.push(new Plot(`Loads of both capstans at ${number(tau)} Nm: push up, release, push down, release`, "stroke", "load [Nm]")
      .curve("agonist", step, whole.map((p) => p[2]), "se").curve("antagonist", step, whole.map((p) => p[3]), "pe")
      .curve("least at rest", [0, 4], [low, low], "sum", true).curve("greatest at rest", [0, 4], [high, high], "sum", true));
  }
  if (s.loops.length) {
    const loops = new Plot("Joint torque cycled, motor torques held", kPush, "joint angle [deg]");
    s.loops.forEach((loop, i) => loops.curve(newtonMetres(loop.tau_Nm), torque(loop.cycle), angle(loop.cycle), ["linear", "t", "pe", "se"][i % 4]));
    charts.push(loops);
  }
  return charts;
}

export function subsystemCharts(s, over) {
  const charts = [], rows = s.break_away, low = rows.map((row) => row.loads_Nm[0]), high = rows.map((row) => row.loads_Nm[1]);
  if (rows.length) {
    const motor = rows.map((row) => row.motor_torque_Nm);
    charts.push(new Plot("Motor subsystem: loads at which the capstan breaks away", "motor torque at the capstan [Nm]", "load [Nm]")
      .curve("lowered", motor, low, "se").curve("raised", motor, high, "pe").fromZero());
    charts.push(new Plot("Motor subsystem: friction over load (figure 8)", "load at break-away [Nm]", "friction [Nm]")
      .curve("raised", high, high.map((load, i) => load - motor[i]), "pe").fromZero());
  }
  charts.push(over.plot("Frame subsystem: dead-band with masses in place of motors", "dead-band [deg]", [["bearing only", (level) => degrees(level.frame_rad), "se"],
    ["with gears", (level) => degrees(level.measured_rad), "sum", true]]));
  charts.push(over.plot("Passive noise rejection: standard deviation under white torque noise", "standard deviation [deg]", [["joint", (level) => degrees(level.noise_rad[2]), "se"],
    ["capstans", (level) => degrees(level.noise_rad[0]), "pe", true]]));
  return charts;
}

function levelSection(s) {
  return foldedSection("Levels of co-contraction", counted(s.levels.length, "level"), table("Dead-band and stiffness at each level",
    ["tau [Nm]", "linear [deg]", "exact [deg]", "measured [deg]", "within the laws [deg]", "condition (6)", "held [Nm/rad]", "free [Nm/rad]", "push [Nm]", "full push [Nm]"],
    s.levels.map((d) => [num(d.tau_Nm), ...[d.linear_rad, d.exact_rad, d.measured_rad, d.covered_measured_rad].map((rad) => num(deg(rad))), num(d.condition_6, 3),
      num(d.joint_stiffness_Nm_per_rad), num(d.free_joint_stiffness_Nm_per_rad), num(d.push_torque_Nm, 3), num(d.full_push_Nm, 3)])));
}

/** Equilibrium (1) and sensitivity (2) at equal co-contraction: the joint stays at 0, both capstans turn equally. */
function equilibriumSection(s) {
  const rows = s.levels.map(({ tau_Nm, capstan_rad, sensitivity_rad_per_Nm: m }) => [num(tau_Nm), num(capstan_rad), ...[m[0][0], m[0][1], m[0][2], m[2][0], m[2][2]].map((value) => num(value, 3))]);
  return foldedSection("Equilibrium and sensitivity", counted(rows.length, "level"), [paragraph("At equal co-contraction the joint stays at 0 and both capstans at theta. Sensitivities are the paper's matrix (2) in rad/Nm; the other entries follow by symmetry."),
    table("Sensitivities at each level", ["tau [Nm]", "theta [rad]", "d theta_1/d tau_1", "d theta_1/d tau_2", "d theta_1/d tau_q", "d q/d tau_1", "d q/d tau_q"], rows)]);
}

function wrapSection(s) {
  if (!s.wraps.length) return null;
  const elongation = new Plot("Additional deflection of each spring from cable elongation", "load at the capstan [Nm]", "deflection [deg]");
  const width = new Plot("Hysteresis width of each spring", "load at the capstan [Nm]", "width [deg]");
  for (const { part, rows } of s.wraps) {
    const css = part === "k_se" ? "se" : "pe", column = (i) => rows.map((row) => (i ? degrees(row[i]) : row[0]));
    elongation.curve(`${part}, load rising`, column(0), column(1), css).curve(`${part}, falling`, column(0), column(2), css, true);
    width.curve(part, column(0), rows.map((row) => degrees(row[2] - row[1])), css);
  }
  return section("Hysteresis of the cables", [paragraph("A cable that creeps on its cam under changing tension is longer during unloading. The results name the energy that it dissipates."),
    grid(elongation.fromZero().svg(), width.fromZero().svg())]);
}

function surveySection({ survey }) {
  return foldedSection("Summary of the arrangement", survey.arrangement, card(facts([
    ["arrangement", survey.arrangement], ["stiffness, capstans held", `${span(survey.stiffness_Nm_per_rad)} Nm/rad`],
    ["stiffness, capstans free", `${span(survey.free_stiffness_Nm_per_rad)} Nm/rad`], ["joint torque within the laws", newtonMetres(survey.torque_Nm)],
    ["linear dead-band", `${span(survey.dead_band_rad.map(degrees))} deg`]])));
}

function chartsSection(title, text, charts) {
  return section(title, charts.length ? [paragraph(text), grid(charts.map((chart) => chart.svg()))] : null);
}

export function simulationPage(s) {
  const over = new OverLevels(s.levels), results = section("Results", bulletList([...s.remarks, ...s.not_known.map((gap) => `Unknown: ${gap}`)]));
  if (!isPnrvsa(s)) return { head: headOf(s), sections: [results, equilibriaSection(s), surveySection(s), levelSection(s)] };
  return { head: headOf(s), sections: [results, equilibriaSection(s), measuredSection(s),
    chartsSection("The joint over co-contraction", "Linear: paper (3)-(4). Exact: the distance of the outermost positions in which gear friction can hold the joint. Push and release: the width that a test measures; it depends on the path.", jointCharts(s, over)),
    levelSection(s), equilibriumSection(s),
    chartsSection("Pushed and released", "Friction acts on each capstan as a play: the capstan stays until its load leaves the limits.", pushCharts(s)),
    chartsSection("Subsystems and noise", "Motor: the gear alone. Frame: the joint with masses in place of motors. Noise: moving gears, so without stiction; inertia, drag and noise as in [dynamics].", subsystemCharts(s, over)),
    wrapSection(s), surveySection(s)] };
}
