// The page of paper.json: the paper's figures and tables (docs/guides/paper.md).
import { change, degrees, deg, isKnown, newtonMetres, number, span } from "../kit/format.js";
import { Plot } from "../kit/plot.js";
import { bulletList, grid, paragraph, section } from "../kit/sections.js";
import { code, compared, num, table } from "../kit/table.js";
import { figure8Chart } from "./identification.js";
import { camsSection, costsSection, springsSection } from "./search.js";
import { jointCharts, OverLevels, pushCharts, subsystemCharts } from "./simulation.js";

const svgs = (charts) => grid(charts.map((chart) => chart.svg()));

function headOf({ table_1, table_2, figure_8, figure_9, made_by }) {
  const widths = ({ simulation: { levels } }) => `${change(degrees(levels[0].linear_rad), degrees(levels[levels.length - 1].linear_rad))} deg`;
  return { kind: "fusee: the paper reproduced", title: "Stiction compensation in agonist-antagonist variable stiffness actuators", stamp: made_by, tiles: [
    ["First prototype", widths(table_1), "linear dead-band over the torques of table I"], ["New springs", widths(table_2), "linear dead-band over the torques of table II"],
    ["Friction over load, mu", number(figure_8.mu), "of the synthetic example"], ["Cost of the springs found", number(figure_9.cost)]] };
}

function overviewSection({ claims }) {
  return section("Overview", [paragraph("The paper states neither its springs, its radii nor the data of figure 8. The designs here are of the same kind."),
    table("The paper's statements, and the results here", ["piece", "paper", "here"], claims.map((claim) => [claim.piece, claim.paper, claim.here]))]);
}

const kMostVariance = 4;  // without a spring to ground only c holds the motor, which would flatten the other curves

/** Figure 1 over the logarithm of c, which spans decades. */
function noiseSection({ figure_1: all }) {
  const name = "log10 of c in Nm/rad", joint = new Plot("Variance of the joint", name, "variance [rad^2]");
  const motor = new Plot(`Variance of the motor, up to ${number(kMostVariance)} rad^2`, name, "variance [rad^2]");
  all.filter((curve) => !curve.refusal).forEach((curve, i) => {
    const x = curve.c_Nm_per_rad.map(Math.log10), css = ["sum", "se", "pe", "linear"][i % 4];
    joint.curve(curve.noise, x, curve.joint_variance_rad2, css);
    motor.curve(curve.noise, x, curve.motor_variance_rad2.map((value) => (value <= kMostVariance ? value : null)), css);
  });
  return section("Figure 1: passive noise rejection", [
    paragraph("White torque noise. Unless stated otherwise: inertias 1 kg m^2, a = b = 1 Nm/rad, dampers 0.5 Nms/rad, densities 1 (Nm)^2 s; the paper states none. The last section shows the whole actuator."),
    grid(joint.fromZero().svg(), motor.fromZero().svg()), all.filter((curve) => curve.refusal).map((curve) => paragraph(`${curve.noise}: ${curve.refusal}`))]);
}

function hillSection({ figure_2: hill }) {
  const muscle = new Plot("Force of a muscle with linear springs", "stretch [rad]", "force [Nm]"), { rows, passive } = hill;
  [...new Set(rows.map((row) => row.active_Nm))].forEach((active, i) => {
    const level = rows.filter((row) => row.active_Nm === active);
    muscle.curve(`series, active ${newtonMetres(active, 2)}`, level.map((row) => row.length_rad), level.map((row) => row.series_Nm), ["se", "t", "pe"][i % 3]);
  });
  muscle.points("parallel", rows.map((row) => row.length_rad), rows.map((row) => row.parallel_Nm), "sum");
  const tension = new Plot("Passive tension of the nonlinear springs, both in series", "stretch [rad]", "force [Nm]").curve("F_PE of the parallel arrangement", passive.length_rad, passive.force_Nm, "pe");
  const springs = (m) => `K_SE ${number(m.k_se_Nm_per_rad, 3)} and K_PE ${number(m.k_pe_Nm_per_rad, 3)} Nm/rad`;
  return section("Figure 2: Hill's muscle", [
    paragraph(`The series arrangement has ${springs(hill.series)}, the first prototype's values at peak torque. The equivalent parallel arrangement has ${springs(hill.parallel)}. With nonlinear springs only the passive tension has a parallel arrangement.`),
    grid(muscle.svg(), tension.svg())]);
}

function tableSection(title, { profile, implied_travel_rad, rows, simulation }) {
  const row = (r) => [num(r.tau_Nm), num(deg(r.paper_rad)), ...[r.linear_rad, r.exact_rad, r.measured_rad].map((rad) => compared(rad, r.paper_rad)), num(r.implied_parallel_Nm_per_rad, 2)];
  return section(title, [
    paragraph(`Profile ${profile}. Full widths at the joint; in brackets the difference from the paper. The implied K_PE would give the paper's width if the dead-band were linear; its capstan would turn by at most ${number(implied_travel_rad, 2)} rad over the table.`),
    table("Dead-bands of the paper and computed", ["tau [Nm]", "paper [deg]", "linear [deg]", "exact [deg]", "push and release [deg]", "implied K_PE [Nm/rad]"], rows.map(row)),
    bulletList(simulation.remarks), svgs(jointCharts(simulation, new OverLevels(simulation.levels)))]);
}

function relativesSection({ relatives }) {
  const width = ([low, high]) => (isKnown(high) ? span([degrees(low), degrees(high)]) : "everywhere");
  const rows = relatives.map(({ arrangement, profiled: own, torque_control: alone }) => [code(arrangement), num(span(own.stiffness_Nm_per_rad)), num(own.torque_Nm, 3),
    num(span(alone.free_stiffness_Nm_per_rad)), num(width(alone.dead_band_rad)), num(span(own.free_stiffness_Nm_per_rad)), num(width(own.dead_band_rad))]);
  return section("Related arrangements", [
    paragraph("The arrangements that the paper names, with equal springs and gears: under torque control as in the paper, and with the motor position loops of their profiles."),
    table("Stiffness, torque and dead-band of each arrangement", ["arrangement", "held [Nm/rad]", "torque [Nm]", "free [Nm/rad]", "dead-band [deg]", "free, loops", "dead-band, loops"], rows)]);
}

export function paperPage(paper) {
  const { table_1, table_2, figure_9 } = paper;
  return { head: headOf(paper), sections: [
    overviewSection(paper), noiseSection(paper), hillSection(paper),
    section("Figure 6: dead-band", [paragraph("The first prototype at its peak torque rests at different angles after a push up and after a push down."), svgs(pushCharts(table_1.simulation))]),
    section("Figure 8: friction of a gear", [paragraph("Synthetic break-away rows from a random generator: the paper does not state its rows."), figure8Chart(paper.figure_8.identification)]),
    section("Figure 9: the search for springs", paragraph(`Algorithm 1, ${figure_9.name}. Lines: the other two variables at the optimum. Dots: the lowest cost of all designs of the search, as in the paper.`)),
    costsSection(figure_9), springsSection(figure_9), camsSection(figure_9, false),
    tableSection("Table I: first prototype", table_1), tableSection("Table II: new springs", table_2), relativesSection(paper),
    section("Subsystems and noise of the new springs", [paragraph("Motor: the gear alone. Frame: masses in place of motors. Noise: moving gears."), svgs(subsystemCharts(table_2.simulation, new OverLevels(table_2.simulation.levels)))]),
  ] };
}
