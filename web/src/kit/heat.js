// Colour scales in steps, from light to dark in one hue: their order survives grey print and colour-blind eyes.
// ColorBrewer's YlOrBr and Blues in 8 classes, both marked "colour-blind safe" (colorbrewer2.org).
import { isKnown, kUnknown } from "./format.js";
import { html } from "./markup.js";
import { at } from "./plot.js";

const kFirstDark = 6;  // white figures have more contrast from here on
const kKey = 76, kKeyHeight = 22;

/** Level i holds bounds[i - 1] <= value < bounds[i]. */
export const kGap = { name: "gap [sigma]", bounds: [1, 1.5, 2, 3, 5, 10, 20], fills: ["#ffffe5", "#fff7bc", "#fee391", "#fec44f", "#fe9929", "#ec7014", "#cc4c02", "#8c2d04"] };
export const kSimilarity = { name: "similarity of signatures [%]", bounds: [10, 30, 50, 70, 80, 90, 95], fills: ["#f7fbff", "#deebf7", "#c6dbef", "#9ecae1", "#6baed6", "#4292c6", "#2171b5", "#084594"] };

export const levelOf = ({ bounds }, value) => bounds.filter((bound) => bound <= value).length;
/** Colour of figures on a level: dark on light, white on dark levels. */
export const inkOf = (level) => (level < kFirstDark ? "#15151a" : "#ffffff");

/** A cell with its figure in the middle; an empty frame with a dash for null. @param marked drawn with a strong outline */
export function heatCell({ x, y, width, height }, value, text, scale, marked = false) {
  const empty = !isKnown(value), level = empty ? 0 : levelOf(scale, value);
  const border = marked ? html`stroke="#d02670" stroke-width="2"` : html`stroke="#8b8a85" stroke-width=".5"`;
  return html`<rect x="${at(x)}" y="${at(y)}" width="${at(width)}" height="${at(height)}" fill="${empty ? "none" : scale.fills[level]}" ${border}/><text x="${at(x + width / 2)}" y="${at(y + height / 2 + 4)}" text-anchor="middle"${!empty && html` style="fill:${inkOf(level)}"`}>${empty ? kUnknown : text}</text>`;
}

/** Every level with its bounds, as a separate figure. */
export function heatLegend(scale) {
  const { bounds, fills, name } = scale, width = kKey * fills.length, last = bounds.length;
  const cells = fills.map((_, i) => {
    const low = i === 0 ? 0 : bounds[i - 1], text = i === 0 ? `below ${bounds[0]}` : i === last ? `${low} or more` : `${low} to ${bounds[i]}`;
    return heatCell({ x: kKey * i, y: 1, width: kKey, height: kKeyHeight }, low, text, scale);
  });
  return html`<figure class="plot" style="max-width:${width + 26}px"><figcaption>${name}</figcaption><svg viewBox="0 0 ${width} ${kKeyHeight + 2}" role="img" aria-label="scale">${cells}</svg></figure>`;
}
