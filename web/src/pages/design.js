// The page of report.json (docs/report.md).
import { findingsSection, notJudgedText, numbered, passedSection } from "../kit/findings.js";
import { counted, number, span } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { paragraph, section, verdictTag } from "../kit/sections.js";
import { num, table } from "../kit/table.js";
import { budgetSection } from "./design/budget.js";
import { exportedSection, filesSection, readBackSection } from "./design/files.js";
import { deadBandSection, lawSection, tableSection } from "./design/law.js";
import { partSection } from "./design/parts.js";
import { jointSection, tellScene } from "./joint.js";

const kVerdicts = { error: "Must be changed", warning: "Can be made once the warnings are accepted" };

function headOf(design, findings) {
  const { law, headline, verdict } = design, open = notJudgedText(findings), count = (severity) => findings.filter((finding) => finding.severity === severity).length;
  const tiles = headline.figures.map(({ value, label }) => [value, label]);
  if (law.loads_Nm) tiles.push([`${span(law.loads_Nm)} Nm`, law.covers_stiction ? "loads of the law: all that stiction allows" : "loads of the law: not all that stiction allows"]);
  tiles.push([`${counted(count("error"), "error")}, ${counted(count("warning"), "warning")}`, `errors must be changed, warnings reviewed and accepted${open && `; ${open}`}`]);
  return { kind: "fusee design report", title: design.name, verdict: verdictTag(verdict, (kVerdicts[verdict] ?? "Can be made") + (open && `; ${open.split(":")[0]}`)), stamp: design.made_by, tiles };
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
  return section("Building the joint", [
    paragraph(`The motors' axes are ${number(assembly.motor_distance_mm)} mm from the joint's; a carriage travels ${number(assembly.carriage_travel_mm)} mm.`),
    table("Lengths of the cables", ["each side", "anchor to anchor [mm]", "cut to [mm]"], rows),
    html`<p><a href="assembly.md">Order of assembly, preloads and timing marks</a>, <a href="bom.csv">bill of materials</a>, <a href="assembly_exploded.svg">exploded view</a>.</p>`]);
}

export function designPage(design, data) {
  const findings = findingsOf(design), { assembly, no_assembly: refusal } = design;
  const viewer = assembly ? jointSection(data("plan")) : section("The joint in 3D", refusal ? paragraph(`Not shown. ${refusal}`) : null);
  return {
    head: headOf(design, findings),
    sections: [viewer, buildingSection(design), lawSection(design.law), deadBandSection(design.dead_band), tableSection(design.law), budgetSection(design.headline.budget), findingsSection(findings),
      ...design.parts.map((part) => partSection(part, findings)), passedSection(findings), readBackSection(design), exportedSection(design.as_exported), filesSection(design)],
    start: () => tellScene({ places: placesOf(findings) }),
  };
}
