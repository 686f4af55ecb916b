// What the experiments of a case can distinguish.
import { counted, number, percent } from "../../kit/format.js";
import { heatCell, heatLegend, kSimilarity } from "../../kit/heat.js";
import { html } from "../../kit/markup.js";
import { at } from "../../kit/plot.js";
import { bulletList, faintParagraph, foldedSection, paragraph, subheading } from "../../kit/sections.js";
import { num, table } from "../../kit/table.js";
import { causeName, causesName } from "./causes.js";
import { forReading } from "./words.js";

const kCell = 25, kCauseLetter = 6.4, kFoot = 20, kMargin = 4;
const kMostCauses = 72;  // a picture of about 250 kB

const similarity = ({ signature_similarity: rows }, a, b) => rows[a]?.[b] ?? null;
const isSameClass = ({ classes }, a, b) => classes.some((members) => members.includes(a) && members.includes(b));

/** Members of each class next to each other, then the other causes. */
const byClass = ({ causes, classes }) => [...new Set([...classes.flat().filter((i) => i < causes.length), ...causes.keys()])];

/** The lower triangle; the diagonal holds each cause's number. */
function matrix(isolability, order) {
  const shown = order.slice(0, kMostCauses), names = shown.map((i) => causeName(isolability.causes[i]));
  const left = kCauseLetter * (Math.max(...names.map((name) => name.length)) + 4), bottom = kMargin + kCell * shown.length, width = left + kCell * shown.length + kMargin;
  const numberAt = (x, y, index) => html`<text class="key" x="${at(x)}" y="${at(y)}" text-anchor="middle">${index}</text>`;
  const rows = shown.map((cause, row) => {
    const top = kMargin + kCell * row, middle = left + kCell * (row + 0.5);
    const cells = shown.slice(0, row).map((other, column) => {
      const share = similarity(isolability, cause, other), value = share === null ? null : 100 * share;
      return heatCell({ x: left + kCell * column, y: top, width: kCell - 1, height: kCell - 1 }, value, number(value === null ? null : Math.round(value)), kSimilarity, isSameClass(isolability, cause, other));
    });
    return html`<text class="key" x="${at(left - 6)}" y="${at(top + kCell / 2 + 4)}" text-anchor="end">${names[row]} ${row + 1}</text>${cells}${numberAt(middle, top + kCell / 2 + 4, row + 1)}${numberAt(middle, bottom + 14, row + 1)}`;
  });
  return html`<figure class="plot matrix" style="width:${at(width + 26)}px"><figcaption>Similarity of two signatures, in per cent; outlined: not distinguished</figcaption><svg viewBox="0 0 ${at(width)} ${at(bottom + kFoot)}" role="img" aria-label="Similarity of the signatures of ${shown.length} causes; the table below names the most similar one of each">${rows}</svg></figure>`;
}

function classList({ causes, classes }) {
  if (!classes.length) return paragraph("These experiments distinguish all of these causes.");
  return [paragraph("These experiments do not distinguish (outlined in the matrix):"), bulletList(classes.map((members) => causesName(members.filter((i) => i < causes.length).map((i) => causes[i]), ", ")))];
}

/** The cause with the signature most similar to that of `i`; `i` itself if there is no other. */
function nearest(isolability, i) {
  let best = i, most = -1;
  isolability.causes.forEach((_, j) => {
    const value = similarity(isolability, i, j);
    if (j !== i && value !== null && value > most) [best, most] = [j, value];
  });
  return best;
}

function sizeTable(isolability, order) {
  const { causes, detectable, units } = isolability;
  if (!detectable.length) return null;
  const rows = order.map((i, n) => {
    const other = nearest(isolability, i), size = forReading({ value: detectable[i] ?? null, unit: units[i] ?? "" });
    return [num(String(n + 1)), causeName(causes[i]), num(size.value, 2), size.unit, other === i ? "" : causeName(causes[other]), num(other === i ? "" : percent(similarity(isolability, i, other)))];
  });
  return [subheading("Detectable size"), paragraph("The least size of each cause that shows at 3 sigma, build tolerances included."),
    table("Least size of each cause that shows", ["", "cause", "least size", "unit", "most similar cause", "similarity"], rows, "dense")];
}

export function isolabilitySection({ isolability }) {
  if (!isolability.causes.length) return null;
  const order = byClass(isolability), rest = order.length > kMostCauses ? faintParagraph(`The first ${kMostCauses} of ${order.length} causes.`) : null;
  return foldedSection("What these experiments can distinguish", `${counted(order.length, "cause")}, similarity of their signatures`, [
    paragraph("Similarity is |cosine| of the signatures of two causes in the measurements, in sigma, without what build tolerances can imitate: 100 cannot be distinguished, 0 has nothing in common."),
    classList(isolability), html`<div class="stack">${heatLegend(kSimilarity)}<div class="scroll" role="group" aria-label="Similarity matrix" tabindex="0">${matrix(isolability, order)}</div></div>`, rest, sizeTable(isolability, order)]);
}
