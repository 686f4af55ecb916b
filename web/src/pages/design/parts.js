// A part of a design: its drawing, its lever arm and its figures.
import { camDrawing } from "../../kit/drawing.js";
import { markersOf } from "../../kit/findings.js";
import { deg, degrees, general, isKnown, number, span } from "../../kit/format.js";
import { html } from "../../kit/markup.js";
import { Plot } from "../../kit/plot.js";
import { card, facts, faintParagraph, folded, foldedSection, section } from "../../kit/sections.js";

/** Bounds are rounded outwards, so that the printed value is proven too. */
function certificateText({ convex, ordered, boxes, open, least_proven_mm: least }, roller) {
  const bound = isKnown(least) ? `\u2265 ${(Math.floor(1e4 * least) / 1e4).toFixed(4)} mm on the whole contour, ` : "";
  return `${bound}convex: ${convex}, ${roller ? "contact moves" : "cable unrolls"} in order: ${ordered} (${boxes} boxes)${open ? `; ${open}` : ""}`;
}

/** The cable or roller on the part, and its force. */
function partner({ roller, cable_diameter_mm: cable, tensions_N }) {
  const forces = `${span(tensions_N)} N`;
  const on = roller?.arm ? ` on an arm of ${number(roller.arm.arm_mm)} mm, pivot at ${roller.arm.pivot_mm.map((x) => number(x)).join(", ")} mm` : "";
  return roller ? ["roller", `${number(roller.radius_mm)} mm radius${on}, ${forces}, pressure angle up to ${deg(roller.greatest_pressure_angle_rad, 3)} deg`] : ["cable", `${number(cable)} mm, ${forces}`];
}

function springFacts({ kind, ...spring }) {
  if (kind === "torsion")
    return [["base spring", `${number(spring.rate_Nm_per_rad)} Nm/rad`], ["spring winding", `${span(spring.states_rad, 4)} rad`], ["spring torque", `${span(spring.torques_Nm, 4)} Nm`]];
  return [["base spring", `${number(spring.rate_N_per_m)} N/m`], ["spring travel", `${span(spring.states_m.map((m) => 1e3 * m), 4)} mm`], ["spring force", `${span(spring.forces_N, 4)} N`]];
}

const elongationText = (s) => `${general(s.length_mm, 3)} mm at ${general(s.tension_N, 3)} N: ${general(degrees(s.capstan_rad), 3)} of the capstan's ${general(degrees(s.capstan_travel_rad), 3)} deg, ${general(100 * s.share, 2)} %`;

function partFacts({ cam, certificate, spring, mesh }) {
  const [low, high] = mesh.box_mm, [first, last] = cam.working_psi_rad;
  return card(facts([
    ["path", cam.path === "planar" ? "planar, closed" : "helix"], ["lever arm", `${span(cam.arms_mm, 4)} mm`], ["cam travel", `${deg(cam.travel_rad)} deg`],
    ["working arc", `${number((last - first) / (2 * Math.PI), 3)} turns`], ["least radius of curvature", `${number(cam.least_curvature_radius_mm)} mm`],
    ["by interval arithmetic", certificateText(certificate, cam.roller)], partner(cam), ...springFacts(spring),
    ["box", `${high.map((value, i) => number(value - low[i])).join(" x ")} mm`], ["volume", `${number(mesh.volume_mm3)} mm\u00b3`],
    ["mesh", `${mesh.triangles} triangles, within ${number(mesh.chordal_error_mm)} mm`],
    ["smallest angle, shortest edge", `${number(mesh.smallest_angle_deg, 2)} deg, ${number(mesh.shortest_edge_mm, 2)} mm`],
    ...(cam.stretch ? [["cable elongation, compensated", elongationText(cam.stretch)]] : [])]));
}

/** How one of two spools stands on the shaft. */
function onShaft({ first_rad: first, sense, height_mm: height }) {
  const place = sense > 0 ? "Both parts are on one key, as their files stand" : `On the same key, ${number(height)} mm above the other part`;
  return `Cam angle 0, where its preload is, is ${deg(first)} deg of the law; it counts ${sense > 0 ? "up" : "down"}. ${place}.`;
}

/** @param torque of a single spring its chart, which stands beside the drawing: its figures are folded */
export function partSection(report, findings, torque = null) {
  const { part, cam, arms, drawing, shaft } = report, series = report.spring.kind === "torsion", own = part.startsWith("cam"), angle = arms.angle_rad.map(degrees);
  const arm = new Plot("Lever arm", "cam angle [deg]", "arm [mm]").curve("arm", angle, arms.arm_mm, series ? "se" : "pe");
  const height = cam.path === "helix" ? new Plot("Height of the cable on the helix", "cam angle [deg]", "z [mm]").curve("z", angle, arms.z_mm, "sum").svg() : null;
  const ends = own ? "the first and (dashed) last angle" : "the lowest and (dashed) highest load";
  const legend = cam.roller ? `coloured: working arc of the rim; circles: roller at ${ends}${cam.roller.arm ? ", lines: its arm to the pivot" : ""}` : `coloured: cable centreline on the working arc; thin: groove floor; straight: cable at ${ends}`;
  const caption = shaft?.sense < 0 ? "Drawn as the part above." : `View from +z at cam angle 0, to scale. Filled: section just below the top face; ${legend}; numbers: findings; dots: places of rules that passed.`;
  const content = html`<div class="part"><figure class="card">${camDrawing(drawing, markersOf(findings, part))}${faintParagraph(caption)}</figure><div class="stack">${torque}${arm.svg()}${height}${own ? null : partFacts(report)}</div></div>${own && folded("Figures of the part", partFacts(report))}`;
  if (shaft) return section(shaft.sense > 0 ? "The part that pulls forth" : "The part that pulls back", [content, faintParagraph(onShaft(shaft))], part);
  return part === "cam" ? section("The part", content, part) : foldedSection(series ? "Series spool" : "Parallel cam", `${part}, arms ${span(cam.arms_mm, 3)} mm`, content, part);
}
