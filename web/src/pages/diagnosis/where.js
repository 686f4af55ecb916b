// Where the gap lies: a strip for each experiment, before and after, and the contributions.
import { isKnown, number, percent, span } from "../../kit/format.js";
import { heatCell, heatLegend, kGap } from "../../kit/heat.js";
import { html } from "../../kit/markup.js";
import { at } from "../../kit/plot.js";
import { foldedSection, grid, paragraph, subheading } from "../../kit/sections.js";
import { num, shareCell, table } from "../../kit/table.js";
import { columnName, experimentName } from "./words.js";

// Drawing units, 520 wide like the charts of the page.
const kWidth = 520, kLeastLeft = 110, kMostLeft = 240, kRight = 24, kStrip = 30, kRow = 56, kTop = 6, kLabelDrop = 14, kRangeLetter = 6, kNameLetter = 6.6, kNameGap = 20;
const kMostCells = 8;  // of a strip: narrower cells are too small for their figures

/** The cells of each experiment and variable, by rising range, in rows of at most kMostCells. */
function stripsOf(map) {
  const strips = new Map();
  for (const { experiment, region, ...gaps } of map) {
    const key = JSON.stringify([experiment, region.variable]);
    if (!strips.has(key)) strips.set(key, { experiment, variable: region.variable, cells: [] });
    strips.get(key).cells.push({ low: region.from, high: region.to, ...gaps });
  }
  const rows = [];
  for (const { cells, ...name } of strips.values()) {
    cells.sort((a, b) => a.low - b.low);
    for (let i = 0; i < cells.length; i += kMostCells) rows.push({ ...name, cells: cells.slice(i, i + kMostCells) });
  }
  const letters = Math.max(0, ...rows.map((strip) => Math.max(experimentName(strip.experiment).length, columnName(strip.variable).length)));
  return { rows, left: Math.max(kLeastLeft, Math.min(kMostLeft, kNameLetter * letters + kNameGap)) };
}

/** True if the ranges follow each other without a gap: their edges are labelled, else each range. */
const isContiguous = (cells) => cells.every((cell, i) => i === 0 || Math.abs(cell.low - cells[i - 1].high) <= 1e-6 * (cell.high - cells[i - 1].low));

/** Labels below a strip, as many as fit. */
function rangeLabels({ cells }, left, width, y) {
  const labels = [], edges = isContiguous(cells);
  let free = 0;
  const add = (x, text) => {
    const half = (kRangeLetter * text.length) / 2;
    if (x - half < free) return;
    labels.push(html`<text class="note" x="${at(x)}" y="${at(y)}" text-anchor="middle">${text}</text>`);
    free = x + half;
  };
  cells.forEach(({ low, high }, i) => (edges ? add(left + width * i, number(low, 3)) : add(left + width * (i + 0.5), high > low ? `${number(low, 2)}\u2013${number(high, 2)}` : number(low, 3))));
  if (edges) add(kWidth - kRight, number(cells[cells.length - 1].high, 3));
  return labels;
}

function stripMarkup(strip, left, top, key) {
  const width = (kWidth - left - kRight) / strip.cells.length;
  const cells = strip.cells.map((cell, i) => heatCell({ x: left + width * i, y: top, width, height: kStrip }, cell[key], number(cell[key], 2), kGap));
  return html`<text class="name" x="0" y="${at(top + 13)}">${experimentName(strip.experiment)}</text><text class="note" x="0" y="${at(top + 28)}">${columnName(strip.variable)}</text>${cells}${rangeLabels(strip, left, width, top + kStrip + kLabelDrop)}`;
}

function mapMarkup({ rows, left }, title, key) {
  return html`<figure class="plot"><figcaption>${title}</figcaption><svg viewBox="0 0 ${kWidth} ${kTop + kRow * rows.length}" role="img" aria-label="${title}">${rows.map((strip, i) => stripMarkup(strip, left, kTop + kRow * i, key))}</svg></figure>`;
}

function gapMap(map) {
  if (!map.length) return null;
  const strips = stripsOf(map);
  return [subheading("Gap map"), paragraph("Each strip is an experiment over the range below it. Each figure is the root mean square of (measured - predicted) / sigma in that part of the range; about 1 is noise and tolerance alone."),
    grid(mapMarkup(strips, "Before: the nominal model", "before"), mapMarkup(strips, "After: with the effects found", "after"), html`<div class="wide">${heatLegend(kGap)}</div>`)];
}

export function whereSection({ map, where }) {
  const rows = where.map(({ share, experiment, region: { variable, from, to }, component = "" }) => (
    [shareCell(share, percent(share)), num(experimentName(experiment)), columnName(variable), num(variable && isKnown(from) ? span([from, to]) : ""), component]));
  if (!map.length && !rows.length) return null;
  return foldedSection("Where the gap lies", where.slice(0, 2).map(({ share, experiment }) => `${percent(share)} ${experimentName(experiment)}`).join(", "), [gapMap(map), table("Contributions to the gap", ["share of the gap", "experiment", "over", "range", "largest in"], rows)]);
}
