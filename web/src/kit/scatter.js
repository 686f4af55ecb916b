// Designs as points over two figures, with their Pareto front, and refused designs as crosses: on the edge of the picture where they lack a figure.
import { general, isKnown } from "./format.js";
import { html } from "./markup.js";
import { at, roundTicks } from "./plot.js";

const kWidth = 880, kHeight = 460, kLeft = 70, kRight = 16, kTop = 14, kBottom = 48, kRail = 20, kCross = 5;

/** The points that no other one beats in both figures. @param x, y "least" or "greatest": what is better */
export function paretoFront(points, { x, y }) {
  const signX = x === "least" ? 1 : -1, signY = y === "least" ? 1 : -1;
  let best = Infinity;
  return new Set([...points].sort((a, b) => signX * (a.x - b.x) || signY * (a.y - b.y)).filter((point) => {
    if (signY * point.y >= best) return false;
    best = signY * point.y;
    return true;
  }));
}

/** Range of the values with a margin. */
function padded(values) {
  const low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - margin, high + margin];
}

function pointMarkup(point, place, front, picked) {
  const circle = html`<circle cx="${at(place.x)}" cy="${at(place.y)}" r="${front ? 5 : 3.5}" class="${front && "front"} ${picked && "picked"}" data-row="${point.row}"/>`;
  return point.href ? html`<a href="${point.href}" aria-label="${point.name}" aria-hidden="true" tabindex="-1">${circle}</a>` : circle;  // keys: the table's links
}

/** A cross with a target of 24 px around it. */
function crossMarkup({ row }, { x, y }, picked) {
  const arm = (sign) => `M${at(x - kCross)} ${at(y - sign * kCross)}L${at(x + kCross)} ${at(y + sign * kCross)}`;
  return html`<g class="refused ${picked && "picked"}" data-row="${row}"><rect x="${at(x - 12)}" y="${at(y - 12)}" width="24" height="24" data-row="${row}"/><path d="${arm(1)}${arm(-1)}" data-row="${row}"/></g>`;
}

const rangeOr = (values, rest) => (values.length ? padded(values) : rest.length ? padded(rest) : null);

/**
 * @param points x, y, name, row, href or null, refused
 * @param front a set of points @param picked row of the marked point or null
 */
export function scatter(points, names, front, picked = null) {
  const shown = points.filter((point) => isKnown(point.x) && isKnown(point.y)), crosses = points.filter((point) => point.refused && isKnown(point.x) !== isKnown(point.y)), content = [];
  const known = (axis) => points.map((point) => point[axis]).filter(isKnown), x = rangeOr(known("x"), [0, 1]), y = rangeOr(known("y"), [0, 1]);
  if (!shown.length) content.push(html`<text class="name" x="${kWidth / 2}" y="${kHeight / 2 - 20}" text-anchor="middle">No design has both figures: choose others.</text>`);
  if (shown.length || crosses.length) {
    const atX = (value) => kLeft + kRail + ((value - x[0]) / (x[1] - x[0])) * (kWidth - kLeft - kRight - kRail);
    const atY = (value) => kHeight - kBottom - kRail - ((value - y[0]) / (y[1] - y[0])) * (kHeight - kBottom - kTop - kRail);
    const place = (point) => ({ x: isKnown(point.x) ? atX(point.x) : kLeft + kRail / 2, y: isKnown(point.y) ? atY(point.y) : kHeight - kBottom - kRail / 2 });
    content.push(
      roundTicks(x, 5).map((tick) => html`<path class="rule" d="M${at(atX(tick))} ${kTop}V${kHeight - kBottom}"/><text x="${at(atX(tick))}" y="${kHeight - kBottom + 18}" text-anchor="middle">${general(tick)}</text>`),
      roundTicks(y, 5).map((tick) => html`<path class="rule" d="M${kLeft} ${at(atY(tick))}H${kWidth - kRight}"/><text x="${kLeft - 8}" y="${at(atY(tick) + 4)}" text-anchor="end">${general(tick)}</text>`),
      [...crosses, ...shown.filter((point) => point.refused)].map((point) => crossMarkup(point, place(point), point.row === picked)),
      shown.filter((point) => !point.refused).sort((a, b) => front.has(a) - front.has(b)).map((point) => pointMarkup(point, place(point), front.has(point), point.row === picked)));
  }
  const middle = (kHeight - kBottom) / 2;
  return html`<svg viewBox="0 0 ${kWidth} ${kHeight}" role="group" aria-label="${names.y} over ${names.x}; the table below has the values">${content}<text x="${(kLeft + kWidth) / 2}" y="${kHeight - 8}" text-anchor="middle" class="name">${names.x}</text><text transform="translate(16 ${middle}) rotate(-90)" text-anchor="middle" class="name">${names.y}</text></svg>`;
}
