// The page of a study: its designs as the index holds them (docs/study.md).
import { counted } from "../kit/format.js";
import { explorerSections, startExplorer } from "../kit/explorer.js";

/** The widest table of figures: dead-bands of the law, not those of built joints and of files. */
const isWidth = ({ name }) => name.startsWith("dead_band_") && !name.includes("built") && !name.includes("error");

export function studyPage(study) {
  const { columns, rows, count } = study, outcome = columns.findIndex((column) => column.name === "outcome");
  const rest = count > rows.length ? ` This page shows the first ${rows.length} of them; index.csv and index.sqlite hold all.` : "";
  const hasReport = (values) => study.has_reports && values[outcome] === "made";
  return {
    head: { kind: "fusee study", title: study.name, sentence: `${counted(count, "design")}.${rest}`, stamp: `fusee ${study.fusee}` },
    sections: explorerSections(columns, 'mass_g < 20 && outcome == "made"'),
    start: () => startExplorer({
      columns, outlines: ["K_SE", "K_PE"],
      rows: rows.map(([name, values, ...outlines]) => ({ name, values, outlines, href: hasReport(values) ? `designs/${encodeURIComponent(name)}/report.html` : null })),
      x: columns.some((column) => column.name === "mass_g") ? "mass_g" : columns[1].name, y: columns.filter(isWidth).pop()?.name,
    }),
  };
}
