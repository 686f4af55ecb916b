// Many designs: a scatter plot of any two figures, and a table to sort and to filter.
import { counted, general, isKnown, kUnknown } from "./format.js";
import { filtered } from "./filter.js";
import { html } from "./markup.js";
import { paretoFront, scatter } from "./scatter.js";
import { section } from "./sections.js";

const kFirstRows = 100, kMoreRows = 500;
const text = (value) => (value === null ? kUnknown : isKnown(value) ? general(value, 5) : value);

/** Rows in the order of a column's values, the unknown ones last. */
export function sortedBy(rows, column, falls) {
  const sign = falls ? -1 : 1;
  return [...rows].sort((a, b) => {
    const x = a.values[column], y = b.values[column];
    if (x === null || y === null) return (x === null) - (y === null);
    return x < y ? -sign : x > y ? sign : 0;
  });
}

/**
 * The sections of an explorer.
 * @param columns name, meaning, text (no number) of each value @param example a condition in the words of these columns @param words what a click on a point does
 */
export function explorerSections(columns, example, words) {
  const names = columns.filter((column) => !column.text).map((column) => html`<option title="${column.meaning}">${column.name}</option>`);
  const better = (id) => html`<label>better<select id="${id}"><option>least</option><option>greatest</option></select></label>`;
  return [
    section("Two figures", html`<div class="controls"><label>x<select id="x">${names}</select></label>${better("bx")}<label>y<select id="y">${names}</select></label>${better("by")}<label><span>Pareto front</span><input type="checkbox" id="front" checked></label></div><div class="held-plot"><figure class="plot" id="plot"></figure><div id="card" class="card" hidden></div></div><p id="unplotted"></p><p>${words}</p>`),
    section("Designs", html`<div class="controls"><label>Filter: a word, or a condition such as <code>${example}</code><input id="filter" spellcheck="false"></label><span id="message" role="alert"></span><span id="count" aria-live="polite"></span></div><div class="scroll" role="group" aria-label="Designs" tabindex="0"><table class="study"><caption>Designs and their figures</caption><thead></thead><tbody></tbody></table></div><p><button id="more">More rows</button></p>`),
  ];
}

/** Columns whose values differ, by their names. @param of rows */
export function varying(columns, rows) {
  return columns.filter((column, i) => !column.text && new Set(rows.map((row) => row.values[i]).filter(isKnown)).size > 1).map((column) => column.name);
}

/** What stands in the card of a design: its outlines, and its figures on both axes. */
function cardMarkup(row, outlines, lines) {
  const drawn = outlines.map((name, i) => [name, row.outlines[i]]).filter(([, path]) => path);
  return html`<b>${row.name}</b>${row.refused && html`<p class="refusal">Refused: ${row.refused}</p>`}<div>${drawn.map(([name, path]) => html`<figure><svg viewBox="-1.1 -1.1 2.2 2.2" role="img" aria-label="Outline of ${name}"><path d="M${path}Z" stroke-width=".03" transform="scale(1,-1)"/></svg><figcaption>${name}</figcaption></figure>`)}</div><dl>${lines.map(([name, value]) => html`<dt>${name}</dt><dd>${value}</dd>`)}</dl>`;
}

const outline = (path) => html`<td>${path && html`<svg viewBox="-1.1 -1.1 2.2 2.2" aria-hidden="true"><path d="M${path}Z" stroke-width=".06" transform="scale(1,-1)"/></svg>`}</td>`;

/**
 * Lets the sections work. @param rows each: name, values in the order of the columns, outlines (paths), href or null, and of a refused design the rule that refused it
 * @param outlines headings of the outlines @param x, y names of the columns shown first @param better what is better of x @param front whether the front is shown first
 */
export function startExplorer({ columns, rows, outlines = [], x, y, better = "least", front: fronted = true }) {
  const $ = (id) => document.getElementById(id), index = new Map(columns.map((column, i) => [column.name, i]));
  const state = { column: -1, falls: false, rows, shown: kFirstRows, picked: null };
  const columnOf = (name) => (name === "name" ? (row) => row.name : index.has(name) ? (row) => row.values[index.get(name)] : undefined);

  const chosen = () => {
    $("message").textContent = "";
    try {
      const kept = filtered(rows, $("filter").value, columnOf, (row) => [row.name, ...row.values.filter((value) => typeof value === "string")]);
      if (kept.length) return kept;
      $("message").textContent = `No design fulfils this: all ${rows.length} are shown.`;
      return rows;
    } catch (problem) {
      if (typeof problem !== "string") throw problem;
      $("message").textContent = `${problem}: all ${rows.length} are shown.`;
      return rows;
    }
  };
  const heading = ({ name, meaning }, i) => {
    const here = state.column === i, sign = here ? (state.falls ? " \u2193" : " \u2191") : "";
    return html`<th title="${meaning}" scope="col" aria-sort="${here ? (state.falls ? "descending" : "ascending") : "none"}"><button type="button" data-column="${i}">${name}${sign}</button></th>`;
  };
  const line = (row) => html`<tr class="${row === state.picked && "picked"}"><td>${row.href ? html`<a href="${row.href}">${row.name}</a>` : row.name}</td>${outlines.map((_, i) => outline(row.outlines[i]))}${columns.map((column, i) => html`<td class="${!column.text && "num"}">${text(row.values[i])}</td>`)}</tr>`;
  const drawTable = () => {
    document.querySelector(".study thead").innerHTML = html`<tr>${["design", ...outlines].map((name) => html`<th scope="col">${name}</th>`)}${columns.map(heading)}</tr>`;
    document.querySelector(".study tbody").innerHTML = html`${state.rows.slice(0, state.shown).map(line)}`;
    $("count").textContent = `${state.rows.length} of ${rows.length} designs`;
    $("more").hidden = state.rows.length <= state.shown;
  };
  const drawPlot = () => {
    const names = { x: $("x").value, y: $("y").value }, [kx, ky] = [index.get(names.x), index.get(names.y)];
    const points = state.rows.map((row) => ({ x: row.values[kx], y: row.values[ky], name: row.name, row: rows.indexOf(row), href: row.href, refused: Boolean(row.refused) }));
    const made = points.filter((point) => !point.refused && isKnown(point.x) && isKnown(point.y)), front = $("front").checked ? paretoFront(made, { x: $("bx").value, y: $("by").value }) : new Set();
    const lost = points.filter((point) => !isKnown(point.x) && !isKnown(point.y)).length, crosses = points.filter((point) => point.refused).length - points.filter((point) => point.refused && !isKnown(point.x) && !isKnown(point.y)).length;
    $("unplotted").textContent = [crosses ? "Crosses: refused designs; on the edge, if they lack a figure." : "", lost ? `${counted(lost, "design")} without both figures: not in the picture.` : ""].filter(Boolean).join(" ");
    $("card").hidden = true;
    $("plot").innerHTML = scatter(points, names, front, state.picked ? rows.indexOf(state.picked) : null);
  };
  const update = () => {
    state.rows = state.column < 0 ? chosen() : sortedBy(chosen(), state.column, state.falls);
    drawTable();
    drawPlot();
  };

  document.querySelector(".study thead").onclick = (event) => {
    const column = event.target.dataset.column;
    if (column === undefined) return;
    state.falls = state.column === Number(column) && !state.falls;
    state.column = Number(column);
    update();
    document.querySelector(`.study [data-column="${column}"]`).focus();
  };
  $("plot").onclick = (event) => {
    const row = rows[event.target.dataset.row];
    if (!row || row.href) return;
    state.picked = row;
    state.rows = [row, ...state.rows.filter((other) => other !== row)];
    drawTable();
    drawPlot();
  };
  const keys = varying(columns, rows);
  const show = (event) => {
    const row = rows[event.target.dataset.row], card = $("card");
    card.hidden = !row;
    if (!row) return;
    const lines = [...new Set([$("x").value, $("y").value, ...keys.filter((name) => rows.every((other) => isKnown(other.values[index.get(name)])))])].slice(0, 8).map((name) => [name, text(row.values[index.get(name)])]);
    card.innerHTML = cardMarkup(row, outlines, lines);
    const box = $("plot").getBoundingClientRect(), mark = event.target.getBoundingClientRect(), left = mark.left + mark.width / 2 - box.left;
    card.style.left = `${Math.max(0, Math.min(box.width - card.offsetWidth, left < box.width / 2 ? left + 14 : left - card.offsetWidth - 14))}px`;
    card.style.top = `${Math.max(0, Math.min(box.height - card.offsetHeight, mark.top - box.top - card.offsetHeight / 2))}px`;
  };
  $("plot").onpointerover = show;
  $("plot").onpointerleave = () => { $("card").hidden = true; };
  for (const option of document.querySelectorAll("#x option, #y option")) {
    option.value = option.textContent;
    if (!keys.includes(option.value)) option.textContent += " (does not vary)";
  }
  $("bx").value = better;
  $("front").checked = fronted;
  $("x").value = x;
  if (y) $("y").value = y;
  for (const id of ["x", "y", "bx", "by", "front"]) $(id).onchange = drawPlot;
  $("filter").oninput = () => { state.shown = kFirstRows; update(); };
  $("more").onclick = () => { state.shown += kMoreRows; drawTable(); };
  update();
}
