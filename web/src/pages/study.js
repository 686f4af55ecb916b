// The page of a study: its designs as the index holds them (docs/study.md).
import { counted, isKnown } from "../kit/format.js";
import { explorerSections, startExplorer, varying } from "../kit/explorer.js";
import { faultOfLine } from "../kit/findings.js";
import { verdictTag } from "../kit/sections.js";

/** The widest table of figures: dead-bands of the law, not those of built joints and of files. */
const isWidth = (name) => name.startsWith("dead_band_") && !name.includes("built") && !name.includes("error");

/** Figures that tell designs apart where their dead-bands are equal, the first that varies. */
const kTelling = ["torque_error_built_percent", "mass_g", "shop_arm_error_percent", "volume_cm3"];

const kMade = "made", kUnknownRule = "an unknown rule";
const columnOf = (columns, name) => columns.findIndex((column) => column.name === name);

/** Of the refused designs what refused them in words, its rule, and how many, the most first. */
function refusals({ columns, rows }) {
  const [outcome, rule, finding] = ["outcome", "worst_rule", "worst_finding"].map((name) => columnOf(columns, name)), by = new Map();
  for (const [, values] of rows) {
    if (values[outcome] === kMade) continue;
    const id = values[rule] ?? kUnknownRule, own = by.get(id) ?? { id, fault: (values[finding] && faultOfLine(values[finding])) || id, count: 0 };
    by.set(id, { ...own, count: own.count + 1 });
  }
  return [...by.values()].sort((a, b) => b.count - a.count);
}

/** "83 made, 37 refused, 17 of them: fatigue safety of the wire" */
export function outcomeSentence(study) {
  const by = refusals(study), refused = by.reduce((sum, { count }) => sum + count, 0), made = `${study.rows.length - refused} made`;
  return refused ? `${made}, ${refused} refused${by.length > 1 ? `, ${by[0].count} of them` : ""}: ${by[0].fault}` : `${made}, none refused`;
}

const withRule = ({ id, fault }) => (fault === id ? id : `${fault} (${id})`);
const kMostRules = 3;

/** What refused the others: "Refused also by the anchor hole (solid.anchor): 10; 2 other rules: 4." */
export function otherRefusals(study) {
  const others = refusals(study).slice(1), rest = others.slice(kMostRules);
  const parts = others.slice(0, kMostRules).map((own) => `${withRule(own)}: ${own.count}`);
  if (rest.length) parts.push(`${counted(rest.length, "other rule")}: ${rest.reduce((sum, { count }) => sum + count, 0)}`);
  return others.length ? `Refused also by ${parts.join("; ")}.` : "";
}

/** Figures that differ between the designs: a dead-band over what varies, and over a key where designs were refused, since those have no figures. */
export function firstAxes({ columns, rows }) {
  const all = rows.map(([name, values]) => ({ name, values })), outcome = columnOf(columns, "outcome"), differ = varying(columns, all), index = (name) => columnOf(columns, name);
  const keys = differ.filter((name) => all.every(({ values }) => isKnown(values[index(name)]))), refused = all.some(({ values }) => values[outcome] !== kMade);
  const y = differ.filter(isWidth).pop() ?? kTelling.find((name) => differ.includes(name) && !keys.includes(name)) ?? differ.filter((name) => !keys.includes(name)).pop() ?? differ[1], first = refused && keys.length ? keys[0] : differ.includes("mass_g") && y !== "mass_g" ? "mass_g" : differ.find((name) => name !== y);
  const x = first ?? columns.find((column) => !column.text).name;
  return { x, y: y ?? x, front: !(refused && keys.includes(x)) };
}

export function studyPage(study) {
  const { columns, rows, count } = study, outcome = columnOf(columns, "outcome"), rule = columnOf(columns, "worst_rule");
  const rest = count > rows.length ? `${counted(count, "design")}. This page shows the first ${rows.length} of them; index.csv and index.sqlite hold all.` : "";
  const hasReport = (values) => study.has_reports && values[outcome] === kMade, click = study.has_reports ? "A click on a point opens its design's report; a refused design moves to the top of the table." : "A click on a point moves its design to the top of the table.";
  const by = refusals(study), faults = new Map(by.map((own) => [own.id, withRule(own)])), ofJoints = columnOf(columns, "k_se_x_mm") >= 0;  // a study of single springs has one part
  return {
    head: { kind: "fusee study", title: study.name, verdict: verdictTag(by.length ? "warning" : "pass", outcomeSentence(study)), sentence: [otherRefusals(study), rest].filter(Boolean).join(" "), stamp: `fusee ${study.fusee}` },
    sections: explorerSections(columns, 'mass_g < 20 && outcome == "made"', `${click} The pointer on a point shows ${ofJoints ? "the outlines of its parts" : "its outline"}.`),
    start: () => startExplorer({
      columns, outlines: ofJoints ? ["K_SE", "K_PE"] : ["part"], ...firstAxes(study),
      rows: rows.map(([name, values, ...outlines]) => ({ name, values, outlines: ofJoints ? outlines : [outlines[0] ?? outlines[1]], href: hasReport(values) ? `designs/${encodeURIComponent(name)}/report.html` : null, refused: values[outcome] === kMade ? "" : faults.get(values[rule] ?? kUnknownRule) })),
    }),
  };
}
