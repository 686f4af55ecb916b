// A cam seen from +z in its body frame, to scale: a drawing unit is a millimetre. `drawing` in the JSON: docs/report.md.
import { general } from "./format.js";
import { html } from "./markup.js";
import { at } from "./plot.js";
import { cssOf } from "./sections.js";

/** A line of the JSON, "x,y x,y ...", as points [mm]. */
export const pointsOf = (line) => (line ? line.split(" ").map((point) => point.split(",").map(Number)) : []);

/** SVG's y points down, the body's up. */
const pathData = (line, closed) => pointsOf(line).map(([x, y], i) => `${i ? "L" : "M"}${at(x)} ${at(-y)}`).join("") + (closed && line ? "Z" : "");

/** The square sheet around the drawing. Text and marks scale with its unit. */
function sheetAround(lines) {
  const points = lines.flatMap(pointsOf);
  const ends = [0, 1].map((i) => [points.reduce((low, p) => Math.min(low, p[i]), 0), points.reduce((high, p) => Math.max(high, p[i]), 0)]);
  const centre = ends.map(([low, high]) => 0.5 * (low + high));
  const reach = points.reduce((most, [x, y]) => Math.max(most, Math.hypot(x - centre[0], y - centre[1])), 0), half = 1.36 * reach;  // space for markers and cables
  return { centre, reach, half, unit: half / 50 };
}

/** The cable at one end of the law, from its contact outwards. */
function cableMarkup({ load_Nm, contact_mm: [x, y], direction }, { unit }, css) {
  const end = [x + 26 * unit * direction[0], y + 26 * unit * direction[1]], below = direction[1] <= 0;
  return html`<g class="${css}"><path d="M${at(x)} ${at(-y)}L${at(end[0])} ${at(-end[1])}"/><circle cx="${at(x)}" cy="${at(-y)}" r="${at(0.8 * unit)}"/><text x="${at(end[0])}" y="${at(-end[1] + (below ? 3.2 : -1.2) * unit)}" font-size="${at(2.6 * unit)}" text-anchor="middle">${general(load_Nm, 3)} Nm</text></g>`;
}

/** The roller at one end of the law; on an arm with its pivot, which moves in the body's frame. */
function rollerMarkup({ load_Nm, centre_mm: [x, y], radius_mm: r, pivot_mm: pivot }, { unit }, css) {
  const arm = pivot && html`<path d="M${at(x)} ${at(-y)}L${at(pivot[0])} ${at(-pivot[1])}"/><circle cx="${at(pivot[0])}" cy="${at(-pivot[1])}" r="${at(0.8 * unit)}"/>`;
  return html`<g class="${css}">${arm}<path d="M${at(x - r)} ${at(-y)}a${at(r)} ${at(r)} 0 1 0 ${at(2 * r)} 0a${at(r)} ${at(r)} 0 1 0 ${at(-2 * r)} 0"/><text x="${at(x + (x < 0 ? -1 : 1) * (r + 1.5 * unit))}" y="${at(-y + 0.91 * unit)}" font-size="${at(2.6 * unit)}" text-anchor="${x < 0 ? "end" : "start"}">${general(load_Nm, 3)} Nm</text></g>`;
}

function scaleBar({ centre, half, unit }) {
  const want = 0.4 * half, power = 10 ** Math.floor(Math.log10(want)), length = [5, 2, 1].find((factor) => want >= factor * power) * power;
  const x = centre[0] - half + 3 * unit, y = -centre[1] + half - 3 * unit;
  return html`<g class="scale"><path d="M${at(x)} ${at(y - 1.5 * unit)}v${at(1.5 * unit)}h${at(length)}v${at(-1.5 * unit)}"/><text x="${at(x + length + 1.5 * unit)}" y="${at(y)}" font-size="${at(2.8 * unit)}">${general(length)} mm</text></g>`;
}

function axes({ unit }) {
  const of = (count) => at(count * unit), size = of(2.4);
  return html`<g class="axis"><path d="M${of(-2)} 0H${of(7)}M0 ${of(2)}V${of(-7)}"/><text x="${of(7.4)}" y="${of(0.8)}" font-size="${size}">x</text><text x="${of(0.8)}" y="${of(-7.4)}" font-size="${size}">y</text></g>`;
}

/** Angles [rad], at least `least` apart around the circle, in the order of the wanted ones. */
export function spreadAngles(wanted, least) {
  const turn = 2 * Math.PI, n = wanted.length, angles = [...wanted];
  if (n < 2) return angles;
  const apart = Math.min(least, (0.999 * turn) / n), order = angles.map((_, i) => i).sort((a, b) => angles[a] - angles[b]);
  for (let pass = 0; pass < 400; ++pass)  // each pass halves what a pair lacks
    for (let i = 0; i < n; ++i) {
      const a = order[i], b = order[(i + 1) % n], lack = apart - (angles[b] - angles[a] + (i + 1 === n ? turn : 0));
      if (lack <= 0) continue;
      angles[a] -= 0.5 * lack;
      angles[b] += 0.5 * lack;
    }
  return angles;
}

/** A rule that passed has a dot at its place and no disc. */
function passedMarkup({ number, title, x, y }, size) {
  return html`<g class="place pass" id="place-${number}"><title>${title}</title><circle cx="${at(x)}" cy="${at(-y)}" r="${at(0.28 * size)}"/></g>`;
}

function discMarkup({ number, severity, title, x, y }, disc, size) {
  return html`<a class="place ${cssOf(severity)}" href="#finding-${number}" id="place-${number}" aria-label="${title}"><title>${title}</title><path class="leader" d="M${at(x)} ${at(-y)}L${at(disc[0])} ${at(-disc[1])}"/><circle cx="${at(x)}" cy="${at(-y)}" r="${at(0.28 * size)}"/><circle class="disc" cx="${at(disc[0])}" cy="${at(-disc[1])}" r="${at(size)}"/><text x="${at(disc[0])}" y="${at(-disc[1] + 0.42 * size)}" font-size="${at(1.2 * size)}" text-anchor="middle">${number}</text></a>`;
}

/** Numbered discs around the part, with lines to the places. */
function markersMarkup(markers, { centre, reach, unit }) {
  const radius = reach + 6.5 * unit, size = 2.1 * unit, open = markers.filter(({ severity }) => severity !== "pass");
  const angles = spreadAngles(open.map(({ x, y }) => Math.atan2(y - centre[1], x - centre[0])), (2.3 * size) / radius);
  return [markers.filter(({ severity }) => severity === "pass").map((marker) => passedMarkup(marker, size)),
    open.map((marker, i) => discMarkup(marker, [centre[0] + radius * Math.cos(angles[i]), centre[1] + radius * Math.sin(angles[i])], size))];
}

/** @param markers of kit/findings.js */
export function camDrawing(drawing, markers) {
  const { part, closed, body, boss, floor, pitch, working, around, ends } = drawing, rings = (lines) => lines.map((line) => pathData(line, true)).join("");
  const sheet = sheetAround([...body, ...boss, pitch, around]), { centre, half } = sheet;
  const touching = (end, css) => (end.radius_mm === undefined ? cableMarkup : rollerMarkup)(end, sheet, css);
  return html`<svg class="cam ${part}" width="${at(2 * half)}mm" height="${at(2 * half)}mm" viewBox="${at(centre[0] - half)} ${at(-centre[1] - half)} ${at(2 * half)} ${at(2 * half)}" role="group" aria-label="${part} to scale, with the places of its findings"><path class="body" d="${rings(body)}"/><path class="boss" d="${rings(boss)}"/><path class="floor" d="${pathData(floor, closed)}"/><path class="pitch" d="${pathData(pitch, closed)}"/><path class="working" d="${pathData(working, false)}"/>${axes(sheet)}${touching(ends[0], "cable")}${touching(ends[1], "cable end")}${markersMarkup(markers, sheet)}${scaleBar(sheet)}</svg>`;
}
