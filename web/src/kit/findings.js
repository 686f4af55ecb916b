// Findings of a design: numbered by severity, as a list, and as marks on the drawings.
import { capitalised, counted, general, number, withUnit } from "./format.js";
import { html } from "./markup.js";
import { partName, withPartNames } from "./names.js";
import { cssOf, foldedSection, linkTo, paragraph, subheading, tag } from "./sections.js";
import { cell, code, num, table } from "./table.js";

const kColumns = ["#", "", "rule", "finding", "measured", "allowed", "where"];
const kSeverities = ["error", "warning", "not judged", "pass"];
const kCards = ["k_se", "k_pe", "cam_back", "cam"];  // parts that have a drawing

/** Errors first, numbered in that order. @param groups pairs of a part ("law", "k_se", "k_se mirrored") and its findings */
export function numbered(groups) {
  const all = groups.flatMap(([part, findings]) => findings.map((finding) => ({ part, ...finding })));
  all.sort((a, b) => kSeverities.indexOf(a.severity) - kSeverities.indexOf(b.severity));
  return all.map((finding, i) => ({ number: i + 1, ...finding }));
}

/** A finding as a terminal shows it. */
export function findingLine(f) {
  const where = f.where ? ` (${f.where})` : "";
  if (f.severity === "not judged") return `not judged: ${f.rule}: ${f.what}${where}; missing: ${f.suggestion}`;
  const value = (figure) => withUnit(number(figure), f.unit), fix = f.suggestion ? `; nearest feasible: ${f.suggestion}` : "";
  return `${f.severity}: ${f.rule}: ${f.what}: measured ${value(f.measured)}, allowed ${f.bound} ${value(f.allowed)}${where}${fix}`;
}

/** The section of what a finding is about. */
function sectionOf({ part, rule }) {
  const drawn = kCards.find((name) => part.startsWith(name));
  return drawn ?? (rule.startsWith("assembly.") ? "joint-3d" : "spring-law");
}

/** A link to the mark on the drawing, or to the section where the place is no point of a part. */
function whereCell(finding) {
  const id = finding.place && kCards.includes(finding.part) ? `place-${finding.number}` : sectionOf(finding);
  return cell(linkTo(id, withPartNames(finding.where) || partName(finding.part)), "faint");
}

/** "199 mm^2" has a raised two. */
const amount = (value, unit, digits = 4) => withUnit(number(value, digits), unit.replace(/\^2$/, "\u00b2"));

function findingRow(f) {
  const what = html`${f.what}${f.suggestion && html`<br><span class="fix">${f.suggestion}</span>`}${f.source && html`<br><span class="faint">${f.source}</span>`}`;
  return [cell(f.number, "num", `finding-${f.number}`), tag(f.severity, f.severity), code(f.rule), what, num(amount(f.measured, f.unit)),
    num(`${f.bound === "at most" ? "\u2264" : "\u2265"} ${amount(f.allowed, f.unit)}`), whereCell(f)];
}

const groupOf = ({ rule }) => rule.split(".")[0];

/** Numbers of findings by group of rules, the most first: [["spring", 26], ...] */
function countByGroup(findings) {
  const counts = new Map();
  for (const finding of findings) counts.set(groupOf(finding), (counts.get(groupOf(finding)) ?? 0) + 1);
  return [...counts];
}

/** "31 rules not judged: spring 26, cable 4"; "" if all were judged. */
export function notJudgedText(findings) {
  const open = findings.filter(({ severity }) => severity === "not judged");
  if (!open.length) return "";
  const groups = countByGroup(open).sort((a, b) => b[1] - a[1]);
  return `${counted(open.length, "rule")} not judged: ${groups.map(([group, count]) => `${group} ${count}`).join(", ")}`;
}

/** Rules that were not judged, by group, with the keys that they need. */
function notJudgedBlock(findings) {
  const open = findings.filter(({ severity }) => severity === "not judged");
  if (!open.length) return null;
  const rows = countByGroup(open).flatMap(([group]) => open.filter((f) => groupOf(f) === group))
    .map((f) => [cell(tag(f.severity, "not judged"), "", `finding-${f.number}`), code(f.rule), f.what, code(f.suggestion), whereCell(f)]);
  return html`${subheading("Not judged")}${paragraph(`${notJudgedText(open)}. The profile lacks the data of these rules: these failures are neither found nor excluded.`)}${table("Rules that were not judged", ["", "rule", "guards against", "missing", "where"], rows, "cards")}`;
}

const isBroken = ({ severity }) => severity === "error" || severity === "warning";

const kUnits = { N_per_m: "N/m", Nm_per_rad: "Nm/rad", mm: "mm", deg: "deg", rad: "rad", N: "N", Nm: "Nm" };

/** "k_pe.spring.rate_N_per_m" and 4682 are "rate 4682 N/m". */
function keyInWords([key, value]) {
  const [, name, unit] = key.split(".").pop().match(/^(.*?)(?:_(N_per_m|Nm_per_rad|mm|deg|rad|N|Nm))?$/);
  return withUnit(`${name.replaceAll("_", " ")} ${value}`, kUnits[unit]);
}

/** The nearest remedy alone: "Set cable.diameter_mm = 0.633", "Set spring: rate 4682 N/m, preload 18.4 mm" (several keys, in words: the part stands beside them and
 * the row has the keys), "Turn on supports, 189 mm\u00b2"; "" without one. */
export function remedyOf({ changes = [], suggestion }) {
  const keys = Object.entries(changes[0] ?? {}), tables = new Set(keys.map(([key]) => key.split(".").slice(0, -1).pop())), [own] = tables;
  if (keys.length === 1) return `Set ${keys[0][0]} = ${keys[0][1]}`;
  if (keys.length) return `Set ${tables.size === 1 && own ? `${own}: ` : ""}${keys.map(keyInWords).join(", ")}`;
  const first = suggestion.split(/; |, or /)[0].replaceAll("^2", "\u00b2");
  return /^[a-z_.]+ = /i.test(first) ? `Set ${first}` : capitalised(first);
}

const upToDetail = (text) => text.split(/[,:]| \(| at \d/)[0].trim();  // "2T/(D d)" is whole

/** "error: cable.bend_ratio: D/d at the cable's sharpest bend, rho 1.9 mm: measured ..." is "D/d at the cable's sharpest bend". */
export const faultOfLine = (line) => upToDetail(line.split(": ").slice(2).join(": "));

/** What was found, up to the first detail, and its figure: "loss of the arm at rest: 3.66 %, at most 2 %"; a count of which none is allowed stands in the words. */
function briefly(f) {
  const what = upToDetail(f.what), counts = f.allowed === 0 && f.bound === "at most" && what.startsWith(`${f.measured} `);
  return counts ? what : `${what}: ${amount(f.measured, f.unit, 3)}, ${f.bound} ${number(f.allowed)}`;
}

/** Errors and warnings in one line each, the remedy first; findings with the same remedy share a line. A line leads to its row, and joint.js to its place. */
export function remedyList(findings) {
  const lines = new Map();
  for (const finding of findings.filter(isBroken)) {
    const remedy = remedyOf(finding), key = `${finding.rule} ${remedy}`;
    lines.set(key, [...(lines.get(key) ?? []), finding]);
  }
  if (!lines.size) return null;
  return html`<ul class="remedies">${[...lines.values()].map((own) => html`<li><a class="remedy ${cssOf(own[0].severity)}" href="#finding-${own[0].number}" data-finding="${own[0].number}"><i>${own.map((f) => f.number).join(", ")}</i><b>${remedyOf(own[0]) || capitalised(own[0].what)}</b><span>${[...new Set(own.map((f) => partName(f.part)))].join(" and ")}: ${briefly(own[0])}</span></a></li>`)}</ul>`;
}

/** Errors, warnings and rules that were not judged, each with a link to its place. */
export function findingsSection(findings) {
  if (!findings.length) return null;
  const broken = findings.filter(isBroken);
  const list = broken.length ? [paragraph("The numbers are those on the drawings. Each rule names the source of its limit."), table("Errors and warnings", kColumns, broken.map(findingRow), "cards")]
    : paragraph("No error and no warning.");
  const count = (severity) => broken.filter((finding) => finding.severity === severity).length, said = [["error", count("error")], ["warning", count("warning")]].filter(([, own]) => own).map(([name, own]) => counted(own, name));
  return foldedSection("Findings", said.join(", ") || "no error and no warning", [list, notJudgedBlock(findings)]);
}

/** Rules that passed, folded. */
export function passedSection(findings) {
  const passed = findings.filter(({ severity }) => severity === "pass");
  return passed.length ? foldedSection("Rules passed", general(passed.length), [paragraph("The profile can set the limits of cable, springs and process."), table("Rules passed", kColumns, passed.map(findingRow), "dense")]) : null;
}

/** The places of a part's findings, for its drawing. */
export function markersOf(findings, part) {
  return findings.filter((f) => f.part === part && f.place).map(({ number: index, severity, place, rule, what }) => (
    { number: index, severity, x: place.point_mm[0], y: place.point_mm[1], title: `${index}. ${rule}: ${what}` }));
}
