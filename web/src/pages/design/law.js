// The spring law of a design, its measured table, and the dead-band of the joint.
import { deg, degrees, isKnown, newtonMetres, number, span } from "../../kit/format.js";
import { html } from "../../kit/markup.js";
import { kCoContraction, Plot } from "../../kit/plot.js";
import { facts, foldedSection, grid } from "../../kit/sections.js";

const kAngle = "angle [deg]";
const wideCard = (...content) => html`<div class="card wide">${content}</div>`;

function lawCharts({ curves, design_loads_Nm, lead_in_travel_rad, stiction_loads_Nm }) {
  const { tau_Nm: tau, theta_rad: theta, f_se_Nm: se, f_pe_Nm: pe, s_Nm_per_rad: s, p_Nm_per_rad: p } = curves;
  const angle = "capstan angle [rad]", load = "capstan load [Nm]", leadIn = [tau[0], design_loads_Nm[0]];
  return [
    new Plot("Spring torques over the capstan's angle", angle, "torque [Nm]").shade([0, lead_in_travel_rad], "lead-in").curve("F_SE", theta, se, "se").curve("F_PE", theta, pe, "pe").curve("sum", theta, tau, "sum", true),
    new Plot("Spring torques over the load", load, "torque [Nm]").shade(leadIn, "lead-in").mark(stiction_loads_Nm[0], "stiction, low").mark(stiction_loads_Nm[1], "stiction, high").curve("F_SE", tau, se, "se").curve("F_PE", tau, pe, "pe"),
    new Plot("Stiffness", load, "stiffness [Nm/rad]").shade(leadIn, "lead-in").curve("S", tau, s, "se").curve("P", tau, p, "pe"),
    new Plot("T = S/(S+P): share of stiction that reaches the joint", load, "T [1]").shade(leadIn, "lead-in").curve("T", tau, s.map((value, i) => (isKnown(value) ? value / (value + p[i]) : null)), "t"),
  ].map((plot) => plot.fromZero().svg());
}

function lawFacts({ loads_Nm: loads, angles_rad, ...law }, condition) {
  const leadIn = [loads[0], law.design_loads_Nm[0]], travel = angles_rad[1];
  const pairs = [["loads, lead-in included", `${span(loads, 4)} Nm`], ["loads of the law", `${span(law.design_loads_Nm, 4)} Nm`], ["capstan travel", `${number(travel)} rad (${deg(travel)} deg)`],
    ["lead-in", law.lead_in_travel_rad > 0 ? `${deg(law.lead_in_travel_rad)} deg of capstan, ${span(leadIn, 4)} Nm` : "none"],
    ["loads of stuck capstans", span(law.stiction_loads_Nm, 4) + (law.covers_stiction ? " Nm: covered" : " Nm: not covered")]];
  if (isKnown(law.least_feasible_start_Nm)) pairs.push(["least feasible start", newtonMetres(law.least_feasible_start_Nm, 4)]);
  if (condition) pairs.push([condition.name, condition.value]);
  return wideCard(html`<h3>The law</h3>${facts(pairs)}`);
}

/** @param condition the head figure of condition (6), if the design has one */
export const lawSection = (law, condition) => (law.curves.tau_Nm.length ? foldedSection("Spring law", `${span(law.loads_Nm)} Nm over ${deg(law.angles_rad[1], 3)} deg of the capstan`, grid(lawCharts(law), lawFacts(law, condition))) : null);

/** A single spring: its torque as wanted and as found in its first file. */
export function torqueChart({ spring }) {
  const { angle_rad: angle, torque_Nm: torque, cam_angle_rad: cam, read_back_Nm: found, cables } = spring, last = angle.length - 1;
  const share = cam[cam.length - 1] > 0 ? (angle[last] - angle[0]) / cam[cam.length - 1] : 0, turned = cam.map((value) => degrees(value + angle[0]));
  const torques = new Plot("Torque over the angle", kAngle, "torque [Nm]").curve("law", angle.map(degrees), torque, "pe");
  const turnsWithIt = Math.abs(share - 1) < 1e-9;  // a spool turns by an angle of its own
  if (found.length && turnsWithIt) torques.curve("read back from the file", turned, found, "sum", true);
  if (cables) torques.curve("cable that pulls forth", turned, cables.forth_Nm, "se").curve("cable that pulls back", turned, cables.back_Nm, "t");
  return torques.fromZero().svg();
}

export function oneSpringSection({ spring }) {
  const { angle_rad: angle, stiffness_Nm_per_rad: stiffness, energy_J: energy } = spring, x = angle.map(degrees);
  return foldedSection("Stiffness and energy", `over ${span([x[0], x[x.length - 1]])} deg`, grid(new Plot("Stiffness", kAngle, "stiffness [Nm/rad]").curve("dF/dx", x, stiffness, "se").fromZero().svg(), new Plot("Energy above that at the first angle", kAngle, "energy [J]").curve("U", x, energy, "t").fromZero().svg()), "spring-law");
}

export function deadBandSection(levels) {
  if (!levels.length) return null;
  const tau = levels.map((level) => level.tau_Nm), of = (key) => levels.map((level) => level[key]);
  const band = new Plot("Dead-band at the joint, edge to edge", kCoContraction, "dead-band [deg]").curve("linear: 2 mu tau / (g P)", tau, of("linear_rad").map(degrees), "linear", true).curve("exact", tau, of("exact_rad").map(degrees), "exact");
  const stiffness = new Plot("Stiffness of the joint", kCoContraction, "stiffness [Nm/rad]").curve("capstans held", tau, of("joint_stiffness_Nm_per_rad"), "se").curve("capstans free", tau, of("free_joint_stiffness_Nm_per_rad"), "sum", true);
  return foldedSection("Dead-band and stiffness of the joint", `${span([tau[0], tau[tau.length - 1]])} Nm of co-contraction`, grid(band.fromZero().svg(), stiffness.fromZero().svg()));
}

/** Rows of a measured table and the springs smoothed from it. */
export function tableSection({ table }) {
  if (!table) return null;
  const column = (i) => table.rows.map((row) => row[i]), residual = (i) => table.rows.map((row) => 1e3 * (row[i + 1] - row[i])), angle = column(0), name = "capstan angle in the file [rad]";
  const torques = new Plot("Rows of the table and smoothed springs", name, "torque [Nm]").points("F_SE, measured", angle, column(1), "se").points("F_PE, measured", angle, column(3), "pe")
    .curve("F_SE, smoothed", angle, column(2), "se").curve("F_PE, smoothed", angle, column(4), "pe");
  const residuals = new Plot("Residuals: smoothed minus measured", name, "residual [mNm]").points("F_SE", angle, residual(1), "se").points("F_PE", angle, residual(3), "pe");
  const words = ({ rms_Nm, largest_Nm, largest_in_row }) => `rms ${number(1e3 * rms_Nm, 3)} mNm, largest ${number(1e3 * largest_Nm, 3)} mNm in row ${largest_in_row} at ${number(angle[largest_in_row - 1])} rad`;
  return foldedSection("Measured table and smoothed law", `${table.rows.length} rows`, grid(torques.fromZero().svg(), residuals.fromZero().svg(),
    wideCard(facts([["file", `${table.file}, ${table.rows.length} rows`], ["F_SE", words(table.series)], ["F_PE", words(table.parallel)]]))));
}
