// The page of design.json: springs that a search found (docs/guides/design-springs.md).
import { camDrawing } from "../kit/drawing.js";
import { findingsSection, markersOf, numbered, remedyList } from "../kit/findings.js";
import { capitalised, counted, degrees, isKnown, millimetres, number, span, withUnit } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { partName, withPartNames } from "../kit/names.js";
import { kCoContraction, Plot } from "../kit/plot.js";
import { bulletList, card, foldedSection, grid, paragraph, section, verdictTag } from "../kit/sections.js";
import { num, table } from "../kit/table.js";

const kMeanings = { k: "of the series spring's stiffness, k tau\u00b2", u: "how fast co-contraction shrinks the dead-band", C: "constant of the law" };
const named = (name, unit) => (unit ? `${name} [${unit}]` : name);
const canBeCut = (search) => search.cams.every((cam) => cam.can_be_cut) && !search.findings.some(({ severity }) => severity === "error");

function verdictOf(search) {
  if (!search.cams.length) return verdictTag("pass", "Springs found");
  return canBeCut(search) ? verdictTag("pass", "Springs found; their cams can be made") : verdictTag("warning", "Springs found; these base springs cannot carry them");
}

function headOf(search) {
  return { kind: "fusee spring design", title: search.name, verdict: verdictOf(search), stamp: search.made_by, more: remedyList(openFindings(search)),
    tiles: [...search.variables.map(({ name, unit, found }) => [name, withUnit(number(found), unit), kMeanings[name]]), ["Cost", number(search.cost), "less is better"],
      ["Evaluations", search.evaluations, `${counted(search.generations, "generation")}${search.interrupted ? ", stopped early" : ""}, seed ${search.seed}`]] };
}

function comparisonSection({ variables, figures, remarks }) {
  const rows = [...variables.map((v) => [v.name, num(v.found, 5), num(v.own, 5), v.unit, num(span(v.box, 4))]), ...figures.map((f) => [f.name, num(f.found, 5), num(f.own, 5), f.unit, ""])];
  return section("Result", [table("Variables and figures, found and of the profile", ["", "found", "profile", "unit", "searched"], rows), bulletList(remarks.map(withPartNames))]);
}

function costChart({ variable, unit, value, cost, feasible, candidates, lowest_cost: lowest, optimum }) {
  const least = Math.min(...cost.filter(isKnown)), most = least + Math.max(0.5, Math.abs(least));  // infeasible springs would flatten the curve
  const shown = (figure) => (isKnown(figure) && figure <= most ? figure : null), infeasible = cost.map((figure, i) => (feasible[i] ? null : shown(figure)));
  const plot = new Plot(`Cost over ${variable}`, named(variable, unit), "cost").curve("the other variables as found", value, cost.map((figure, i) => (feasible[i] ? shown(figure) : null)), "exact");
  if (infeasible.some(isKnown)) plot.curve("infeasible", value, infeasible, "pe", true);
  if (lowest.length) plot.points("lowest of the search", candidates, lowest.map(shown), "linear");
  return plot.mark(optimum, "found").svg();
}

export function costsSection({ costs, history }) {
  const best = new Plot("Best cost of each generation", "generation", "cost").curve("best cost", history.map((_, i) => i), history, "exact");
  return foldedSection("Cost", `over ${costs.map(({ variable }) => variable).join(", ")} and the generations`, grid(costs.map(costChart), best.svg()));
}

export function springsSection(search) {
  const torques = new Plot("Both springs over the capstan angle", "capstan angle [rad]", "torque [Nm]");
  const band = new Plot("Linear dead-band at the joint, edge to edge", kCoContraction, "dead-band [deg]");
  const add = (springs, levels, whose, dashed) => {
    torques.curve(`F_SE${whose}`, springs.theta_rad, springs.f_se_Nm, "se", dashed).curve(`F_PE${whose}`, springs.theta_rad, springs.f_pe_Nm, "pe", dashed);
    band.curve(whose ? "profile" : "found", levels.map((level) => level.tau_Nm), levels.map((level) => degrees(level.linear_rad)), "linear", dashed);
  };
  add(search.springs, search.dead_band, "", false);
  if (search.own_springs.theta_rad.length) add(search.own_springs, search.own_dead_band, ", profile", true);
  return section("Springs", [paragraph("Solid lines: the springs found; dashed: the springs of the profile."), grid(torques.fromZero().svg(), band.fromZero().svg())], "spring-law");
}

/** Findings that did not pass. A cam without a drawing shows no places. */
function openFindings({ findings, cams }) {
  const open = (all) => all.filter(({ severity }) => severity !== "pass");
  return numbered([["law", open(findings)], ...cams.map((cam) => [cam.part, open(cam.findings).map(({ place, ...finding }) => (cam.drawing ? { place, ...finding } : finding))])]);
}

/** @param marked false on a page without the findings, to which the marks on the drawings would lead */
export function camsSection(search, marked = true) {
  if (!search.cams.length) return section("Cams", paragraph("Not judged: the profile has no parts, or the law is refused."));
  const findings = openFindings(search);
  const arms = search.cams.map(({ part, arms: { angle_rad, arm_m } }) => new Plot(`Lever arm of the ${partName(part)}`, "cam angle [deg]", "arm [mm]")
    .curve("arm", angle_rad.map(degrees), arm_m.map(millimetres), part === "k_se" ? "se" : "pe").fromZero().svg());
  const drawings = search.cams.map(({ part, drawing }) => card(html`<h3 id="${part}">${capitalised(partName(part))}</h3>`,
    drawing ? camDrawing(drawing, marked ? markersOf(findings, part) : []) : paragraph("It cannot be cut for this base spring: see the findings.")));
  return section("Cams", grid(arms, drawings));
}

export function searchPage(search) {
  return { head: headOf(search), sections: [comparisonSection(search), costsSection(search), springsSection(search), camsSection(search), findingsSection(openFindings(search))] };
}
