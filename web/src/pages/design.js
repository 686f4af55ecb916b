// The page of report.json (docs/report.md).
import { findingsSection, numbered, passedSection, remedyList } from "../kit/findings.js";
import { counted, number } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { foldedSection, paragraph, section, verdictTag } from "../kit/sections.js";
import { num, table } from "../kit/table.js";
import { budgetSection } from "./design/budget.js";
import { exportedSection, filesSection, readBackSection } from "./design/files.js";
import { deadBandSection, lawSection, oneSpringSection, tableSection, torqueChart } from "./design/law.js";
import { partSection } from "./design/parts.js";
import { jointSection, tellScene } from "./joint.js";

const kHeadFigures = 3;  // of the cards; the fourth card says what is left to accept

/** What is left to accept, and the verdict in one sentence. */
function judged({ verdict }, findings) {
  const count = (severity) => findings.filter((finding) => finding.severity === severity).length, errors = count("error"), warnings = count("warning"), open = count("not judged");
  const left = errors ? counted(errors, "error") : counted(warnings, "warning"), rest = open ? `${counted(open, "rule")} not judged` : "";
  const sentence = errors || verdict === "error" ? `Must be changed: ${left}` : warnings ? `Can be made once ${warnings === 1 ? "its warning is" : `its ${left} are`} accepted` : "Can be made";
  return { sentence: sentence + (rest && `; ${rest}`), card: [errors ? "Left to change" : "Left to accept", errors || warnings ? left : "nothing", rest || "every rule was judged"] };
}

function headOf(design, findings) {
  const { sentence, card } = judged(design, findings), tiles = design.headline.figures.slice(0, kHeadFigures).map(({ name, value, line }) => [name, value, line]);
  return { kind: "fusee design report", title: design.name, verdict: verdictTag(design.verdict, sentence), stamp: design.made_by, tiles: [...tiles, card], more: remedyList(findings), folds: true };
}

/** Findings of the law, of both parts and of their mirror images, numbered. */
export function findingsOf({ findings, parts, mirrored }) {
  return numbered([["law", findings], ...parts.map((part) => [part.part, part.findings]), ...mirrored.map((part) => [`${part.part} mirrored`, part.findings])]);
}

/** The places of findings on the cams, for the joint in 3D: "k_se" is the agonist's, "k_se mirrored" the antagonist's. */
function placesOf(findings) {
  return findings.filter(({ place, part }) => place && part.startsWith("k_")).map(({ number: index, part, rule, severity, what, place }) => (
    { number: index, body: part.slice(0, 4) + (part.endsWith("mirrored") ? "_antagonist" : "_agonist"), rule, severity, what, point_mm: place.point_mm, angle_rad: place.angle_rad }));
}

function buildingSection({ assembly }) {
  if (!assembly) return null;
  const rows = assembly.cables.map((cable) => [`${cable.kind} cable`, num(cable.length_mm), num(cable.cut_mm)]);
  return foldedSection("Building the joint", `motors ${number(assembly.motor_distance_mm)} mm from the joint`, [
    paragraph(`The motors' axes are ${number(assembly.motor_distance_mm)} mm from the joint's; a carriage travels ${number(assembly.carriage_travel_mm)} mm.`),
    table("Lengths of the cables", ["each side", "anchor to anchor [mm]", "cut to [mm]"], rows),
    html`<p><a href="assembly.md">Order of assembly, preloads and timing marks</a>, <a href="bom.csv">bill of materials</a>, <a href="assembly_exploded.svg">exploded view</a>.</p>`]);
}

export function designPage(design, data) {
  const findings = findingsOf(design), { assembly, no_assembly: refusal } = design;
  const viewer = assembly ? jointSection(data("plan")) : design.law.spring ? null : section("The joint in 3D", refusal ? paragraph(`Not shown. ${refusal}`) : null);
  const condition = design.headline.figures[kHeadFigures], parts = design.parts.map((part, i) => partSection(part, findings, design.law.spring && i === 0 ? torqueChart(design.law) : null));
  return {
    head: headOf(design, findings),
    sections: [viewer, ...(design.law.spring ? [...parts, oneSpringSection(design.law)] : []), findingsSection(findings), design.law.spring ? null : lawSection(design.law, condition), deadBandSection(design.dead_band), tableSection(design.law), budgetSection(design.headline.budget), buildingSection(design),
      ...(design.law.spring ? [] : parts), passedSection(findings), readBackSection(design), exportedSection(design.as_exported), filesSection(design)],
    start: () => tellScene({ places: placesOf(findings) }),
  };
}
