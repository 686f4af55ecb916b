// The page of pareto.json: a front of designs (docs/guides/co-design.md).
import { counted, degrees, general } from "../kit/format.js";
import { explorerSections, startExplorer } from "../kit/explorer.js";
import { html } from "../kit/markup.js";
import { kCoContraction, Plot } from "../kit/plot.js";
import { bulletList, grid, paragraph, section, verdictTag } from "../kit/sections.js";

function columnsOf(front) {
  const [low, high] = front.loads_Nm;
  const column = (name, meaning, of, text = false) => ({ name, meaning, of, text });
  return [
    column("dead_band_deg", "exact dead-band at the joint that was minimised", (point) => degrees(point.figure_rad)),
    ...front.torques_Nm.map((torque, i) => column(`at_${general(torque)}_Nm_deg`, `exact dead-band at ${general(torque)} Nm`, (point) => degrees(point.dead_band_rad[i]))),
    column("travel_rad", `capstan travel from ${general(low)} to ${general(high)} Nm`, (point) => point.travel_rad),
    column("soft_Nm_per_rad", "least stiffness of the joint, capstans held", (point) => point.stiffness_Nm_per_rad[0]),
    column("stiff_Nm_per_rad", "greatest stiffness of the joint, capstans held", (point) => point.stiffness_Nm_per_rad[1]),
    column("radius_mm", "largest contour radius of both cams", (point) => point.radius_mm),
    column("capstan_radius_mm", "radius of the capstan", (point) => point.capstan_radius_mm),
    column("limited_by", "limits that bind", (point) => point.limited_by, true),
  ];
}

/** Every fourth design, so that the curves can be distinguished. */
function levelsChart({ points, torques_Nm }) {
  const levels = new Plot("Dead-band of each design", kCoContraction, "exact dead-band at the joint [deg]"), last = points.length - 1;
  points.forEach((point, i) => {
    const end = i === 0 || i === last;
    if (end || i % 4 === 0) levels.curve(point.profile, torques_Nm, point.dead_band_rad.map(degrees), i === 0 ? "se" : i === last ? "pe" : "linear", !end);
  });
  return levels.fromZero().svg();
}

export function paretoPage(front) {
  const columns = columnsOf(front), { points } = front;
  const dropped = front.dropped_by.length ? html`${paragraph("Rules that the dropped designs break:")}${bulletList(front.dropped_by)}` : null;
  return {
    head: { kind: "fusee front of designs", title: front.name, verdict: verdictTag("pass", "Every design shown was made and read back"), stamp: front.made_by,
      tiles: [["Designs", points.length], ["Dropped", front.dropped, "could not be made"],
        ["Evaluations", front.evaluations, `${counted(front.generations, "generation")} of ${front.population}${front.interrupted ? ", stopped early" : ""}, seed ${front.seed}`]] },
    sections: [...explorerSections(columns, "travel_rad < 2 && dead_band_deg < 20", "A click on a point opens the profile of its design."), section("Levels of co-contraction", grid(levelsChart(front))), section("Dropped designs", dropped)],
    start: () => startExplorer({
      columns, rows: points.map((point) => ({ name: point.profile, values: columns.map((column) => column.of(point)), outlines: [], href: point.profile, refused: "" })),
      x: front.against === "size" ? "radius_mm" : "travel_rad", y: "dead_band_deg", better: front.against === "size" ? "least" : "greatest",
    }),
  };
}
