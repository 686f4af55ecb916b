// The errors of joints as a shop builds them (docs/report.md).
import { fixed, newtonMetres } from "../../kit/format.js";
import { Plot } from "../../kit/plot.js";
import { folded, foldedSection, grid, paragraph } from "../../kit/sections.js";
import { faint, num, table } from "../../kit/table.js";

function bandChart({ part, places }, sampled) {
  const series = part === "k_se", css = series ? "se" : "pe", x = places.map((place) => place.travel_deg), of = (key, i) => places.map((place) => place[key][i]);
  const both = (key) => [...of(key, 0), null, ...of(key, 1)], twice = [...x, null, ...x];  // one curve with a gap, named once
  const plot = new Plot(`${series ? "K_SE" : "K_PE"}: torque of joints as built`, "capstan travel [deg]", "error [%]")
    .band("5 to 95 %", x, of("band_percent", 0), of("band_percent", 1), css).curve("first order, 5 and 95 %", twice, both("band_percent"), css);
  if (sampled) plot.curve("sampled joints", twice, both("sampled_percent"), "t", true);
  return plot.svg();
}

function sourceRow(source, { parts, dead_bands: widths, percentile }) {
  const ofPart = (part) => {
    const sigma = part.places[part.worst_place].sigma_percent[source];
    return [part.limits[source] === null ? faint("-") : num(part.limits[source]), source === "friction" ? faint("-") : num(`${fixed(percentile * sigma, 2)} %`)];
  };
  return [source, ...parts.flatMap(ofPart), ...widths.map((width) => (width.nominal_deg === null ? faint("-") : num(`${fixed(percentile * width.sigma_deg[source], 2)} deg`)))];
}

export function budgetSection(budget) {
  if (!budget) return null;
  const { draws, parts, dead_bands: widths } = budget, sampled = draws > 0;
  const head = ["source", "limit, K_SE", "+- torque, K_SE", "limit, K_PE", "+- torque, K_PE", ...widths.map((width) => `+- dead-band, ${newtonMetres(width.tau_Nm)}`)];
  const words = `Errors of 5 to 95 % of joints as a shop builds them, at the place where the torque is least certain. Limits are two standard deviations: the contour by the process, the others by [budget] of the profile.${sampled ? ` Dashed: ${draws} sampled joints with shifted, grown cams and moved guides.` : ""}`;
  const rows = Object.keys(parts[0].places[0].sigma_percent).map((source) => sourceRow(source, budget));
  return foldedSection("As the shop builds it", sampled ? `${draws} sampled joints` : "first order", [grid(parts.map((part) => bandChart(part, sampled))), paragraph(words), folded("Errors by source", table("Errors by source", head, rows))]);
}
