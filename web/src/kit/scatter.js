// Designs as points over two figures, with their Pareto front.
import { general, isKnown } from "./format.js";
import { html } from "./markup.js";
import { at, roundTicks } from "./plot.js";

const kWidth = 880, kHeight = 460, kLeft = 70, kRight = 16, kTop = 14, kBottom = 48;

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
  const circle = html`<circle cx="${at(place.x)}" cy="${at(place.y)}" r="${front ? 5 : 3.5}" class="${front && "front"} ${picked && "picked"}" data-row="${point.row}"><title>${point.name}\n${point.words}</title></circle>`;
  return point.href ? html`<a href="${point.href}" tabindex="-1">${circle}</a>` : circle;  // keys: the table's links
}

/**
 * @param points x, y, name, words (of both figures), row, href or null
 * @param front a set of points @param picked row of the marked point or null
 */
export function scatter(points, names, front, picked = null) {
  const shown = points.filter((point) => isKnown(point.x) && isKnown(point.y)), content = [];
  if (shown.length) {
    const x = padded(shown.map((point) => point.x)), y = padded(shown.map((point) => point.y));
    const atX = (value) => kLeft + ((value - x[0]) / (x[1] - x[0])) * (kWidth - kLeft - kRight);
    const atY = (value) => kHeight - kBottom - ((value - y[0]) / (y[1] - y[0])) * (kHeight - kBottom - kTop);
    content.push(
      roundTicks(x, 5).map((tick) => html`<path class="rule" d="M${at(atX(tick))} ${kTop}V${kHeight - kBottom}"/><text x="${at(atX(tick))}" y="${kHeight - kBottom + 18}" text-anchor="middle">${general(tick)}</text>`),
      roundTicks(y, 5).map((tick) => html`<path class="rule" d="M${kLeft} ${at(atY(tick))}H${kWidth - kRight}"/><text x="${kLeft - 8}" y="${at(atY(tick) + 4)}" text-anchor="end">${general(tick)}</text>`),
      [...shown].sort((a, b) => front.has(a) - front.has(b)).map((point) => pointMarkup(point, { x: atX(point.x), y: atY(point.y) }, front.has(point), point.row === picked)));
  }
  const middle = (kHeight - kBottom) / 2;
  return html`<svg viewBox="0 0 ${kWidth} ${kHeight}" role="img" aria-label="${names.y} over ${names.x}; the table below has the values">${content}<text x="${(kLeft + kWidth) / 2}" y="${kHeight - 8}" text-anchor="middle" class="name">${names.x}</text><text transform="translate(16 ${middle}) rotate(-90)" text-anchor="middle" class="name">${names.y}</text></svg>`;
}
