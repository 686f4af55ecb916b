// Tables. A row is a list of cells; a cell is a text, markup or one of the functions below.
import { deg, degrees, isKnown, kUnknown, number } from "./format.js";
import { html, isEmpty } from "./markup.js";

class Cell {
  constructor(content, css = "", id = "") { Object.assign(this, { content, css, id }); }
}
export const cell = (content, css, id) => new Cell(content, css, id);
export const faint = (text) => new Cell(text, "faint");
export const code = (text) => new Cell(text, "code");
/** A figure, or a text in figures' type. null is an en dash. */
export const num = (value, digits = 4) => new Cell(typeof value === "string" ? value : number(value, digits), "num");
export const strong = (text) => new Cell(text === "" ? "" : html`<b>${text}</b>`, "num");

/** A computed angle with its difference from another one: "20.1 (+1.2)", in degrees. */
export function compared(computed_rad, measured_rad) {
  if (!isKnown(computed_rad) || !isKnown(measured_rad)) return num(deg(computed_rad));
  const difference = degrees(computed_rad - measured_rad);
  return num(`${deg(computed_rad)} (${difference < 0 ? "" : "+"}${difference.toFixed(1)})`);
}

/** A share of 1 as a bar with a text next to it. */
export function shareCell(share, text) {
  if (!isKnown(share)) return num(kUnknown);
  const width = 90 * Math.min(1, Math.max(0, share));
  return new Cell(html`<span style="display:flex;align-items:center;gap:10px"><svg width="90" height="12" viewBox="0 0 90 12"><rect width="90" height="12" style="fill:var(--body)"/><rect width="${width}" height="12" style="fill:var(--se)"/></svg>${text}</span>`, "num");
}

/** Nothing, or a figure that is not known. */
function isBlank(value) {
  const { content } = value instanceof Cell ? value : { content: value };
  return isEmpty(content) || content === kUnknown;
}

function cellMarkup(value, label) {
  const { content, css, id } = value instanceof Cell ? value : new Cell(value);
  return html`<td${css && html` class="${css}"`}${id && html` id="${id}"`}${label && html` data-label="${label}"`}>${content}</td>`;
}

/**
 * A table, or nothing without rows. A column that tells nothing in any row is left out.
 * @param caption read aloud and not shown: a heading stands above it
 * @param head a text for each column, "" for none
 * @param kind "", "dense": small type, "cards": rows become cards on a phone
 */
export function table(caption, allHeads, allRows, kind = "") {
  if (!allRows.length) return null;
  const told = allHeads.map((_, i) => i === 0 || allRows.some((row) => !isBlank(row[i]))), kept = (cells) => cells.filter((_, i) => told[i]);
  const head = kept(allHeads), rows = allRows.map(kept);
  const titles = head.map((name) => (name ? html`<th scope="col">${name}</th>` : html`<td></td>`));
  const lines = rows.map((row) => html`<tr>${row.map((value, i) => cellMarkup(value, kind === "cards" ? head[i] : ""))}</tr>`);
  return html`<div class="scroll ${kind}" role="group" aria-label="${caption}" tabindex="0"><table><caption>${caption}</caption><thead><tr>${titles}</tr></thead><tbody>${lines}</tbody></table></div>`;
}
