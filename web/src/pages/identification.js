// The page of identification.json: a gear's friction (docs/guides/identify-friction.md).
import { general, isKnown, newtonMetres, number, span } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { Plot } from "../kit/plot.js";
import { bulletList, card, grid, paragraph, section } from "../kit/sections.js";
import { num, table } from "../kit/table.js";

const kColours = ["se", "pe", "t", "linear"], kMostDots = 2000;
const stepOf = ({ repeats }) => Math.floor(repeats.length / kMostDots) + 1;
const groupedBy = (rows, nameOf) => {
  const groups = new Map();
  for (const row of rows) groups.set(nameOf(row), [...(groups.get(nameOf(row)) ?? []), row]);
  return [...groups].sort(([a], [b]) => (a < b ? -1 : 1));
};

/** Dots of each motor and direction; for many motors of each direction only. */
function seriesOf(friction) {
  const dots = friction.repeats.filter((_, i) => i % stepOf(friction) === 0), both = groupedBy(dots, (dot) => `${dot.side} ${dot.direction}`);
  return both.length <= kColours.length ? both : groupedBy(dots, (dot) => dot.direction);
}

function addRepeats(plot, friction, of) {
  seriesOf(friction).forEach(([name, dots], i) => plot.points(name, dots.map((dot) => dot.mean_load_Nm), dots.map(of), kColours[i % kColours.length], dots.map((dot) => dot.deviation_Nm)));
  return plot;
}

export function figure8Chart(friction) {
  const { load_Nm, line_Nm, low_Nm, high_Nm } = friction.line_curve;
  const plot = new Plot("Friction over the load at break-away (paper, figure 8)", "load [Nm]", "friction [Nm]").band("95 % of the line", load_Nm, low_Nm, high_Nm, "sum")
    .curve("line", load_Nm, line_Nm, "sum").curve("through zero", load_Nm, load_Nm.map((load) => load * friction.trusted.through_zero_mu), "sum", true);
  return addRepeats(plot, friction, (dot) => dot.mean_friction_Nm).fromZero().svg();
}

/** Residuals over the load: they show a curvature or a step first. */
function residualChart(friction) {
  const { constant_Nm, mu } = friction.trusted;
  return addRepeats(new Plot("Residuals of the line", "load [Nm]", "friction - line [Nm]"), friction, (dot) => dot.mean_friction_Nm - constant_Nm - mu * dot.mean_load_Nm).svg();
}

function sentenceOf(law, line, constant, mu95) {
  if (!law) return "These rows have no law of a gear.";
  const more = constant ? ` and ${newtonMetres(law.gear_friction_constant_Nm)} (${span(line.constant_95_Nm, 3)})` : "";
  return `The gear loses ${number(100 * law.gear_friction, 3)} % of its load to friction (${mu95.map((mu) => number(100 * mu, 3)).join(" to ")} %)${more}.`;
}

function headOf({ law, trusted: line, ...friction }) {
  const constant = law !== null && law.gear_friction_constant_Nm > 0, mu95 = constant ? line.mu_95 : line.through_zero_mu_95;
  return { kind: "fusee identification", title: friction.name, sentence: sentenceOf(law, line, constant, mu95), stamp: `fusee ${friction.fusee}, ${friction.name}, file ${friction.file_sha256.slice(0, 12)}`, tiles: [
    ["Friction over load, mu", law ? number(law.gear_friction) : "none", law ? `95 %: ${span(mu95, 4)}` : "no law of a gear"],
    ["Constant friction", newtonMetres(constant ? law.gear_friction_constant_Nm : 0, 4), `95 %: ${span(line.constant_95_Nm, 4)} Nm`],
    ["Scatter about the line", newtonMetres(line.scatter_Nm)], ["Rows in the fit", line.rows]] };
}

const lineRow = (line) => [line.group, num(String(line.rows)), num(line.mu), num(span(line.mu_95, 4)), num(line.constant_Nm), num(span(line.constant_95_Nm, 4)),
  num(line.through_zero_mu), num(line.robust_mu), num(line.scatter_Nm, 3), num(line.r_squared), num(String(line.outlier_rows.length))];

export function identificationPage(friction) {
  const step = stepOf(friction), rest = step > 1 ? ` Of ${friction.repeats.length} dots one in ${step} is drawn.` : "";
  return { head: headOf(friction), sections: [
    section("Remarks on the data", bulletList(friction.remarks.map(({ text, p }) => text + (isKnown(p) ? ` (p = ${general(p, 2)})` : "")))),
    section("For a profile", friction.profile_lines ? card(html`<pre class="code">${friction.profile_lines}</pre>`) : null),
    section("Figure 8", [paragraph(`Each dot is the mean of the repeats at one motor torque, with their standard deviation.${rest}`), grid(figure8Chart(friction), residualChart(friction))]),
    section("Lines", table("Lines through the rows", ["rows of", "rows", "mu", "95 %", "constant [Nm]", "95 %", "mu through zero", "robust mu", "scatter [Nm]", "R\u00b2", "outliers"], friction.lines.map(lineRow))),
  ] };
}
