// Every chart of a page becomes one that zooms and tells its values. Its SVG stays for print.
import uPlot from "uplot";
import { readChart } from "./curves.js";
import { axisTexts } from "./format.js";

const kAxis_px = 52, kAxisGap_px = 14, kLetter_px = 7;
const kStep = 0.01, kZoom = 0.6, kNear_px = 10;  // of the width, by the keyboard; of the range, by a button
const kStart_px = 220, kLeast_px = 150;          // height of a chart before its figure is measured, and the least
const style = (element, name) => getComputedStyle(element)[name];
const variable = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const text = (value) => String(Number(value.toPrecision(4)));

function interpolated([xs, ys], x) {
  if (x < xs[0] || x > xs[xs.length - 1]) return null;
  const i = xs.findIndex((v) => v >= x);
  return i <= 0 || xs[i] === x ? ys[Math.max(i, 0)] : ys[i - 1] + ((x - xs[i - 1]) / (xs[i] - xs[i - 1])) * (ys[i] - ys[i - 1]);
}

/** Values of a curve at x, or of the dot nearest to it. */
function valuesAt(key, x, near) {
  if (key.runs) return key.runs.map((run) => interpolated(run, x)).filter((v) => v !== null);
  const best = key.points.reduce((a, b) => (Math.abs(b[0] - x) < Math.abs(a[0] - x) ? b : a), key.points[0]);
  return best && Math.abs(best[0] - x) <= near ? [best[1]] : [];
}

/** A hidden element shows no colour of its own: colours are read while the SVG is laid out, and again when light or dark changes. */
function readColours(chart, svg) {
  const hidden = svg.style.display;
  svg.style.display = "block";
  for (const key of chart.curves) key.colour = style(key.element, "stroke");
  for (const key of chart.dots) key.colour = style(key.element, "fill");
  for (const item of chart.drawn) item.look = { fill: style(item.element, "fill"), stroke: style(item.element, "stroke"), alpha: style(item.element, "opacity") };
  svg.style.display = hidden;
}

/** From drawing units of the SVG to pixels of the canvas, at the present zoom. */
function matrixOf(u, { x, y, box }) {
  const [left, top, right, bottom] = box, at = (value, scale) => u.valToPos(value, scale, true);
  const a = (at(x[1], "x") - at(x[0], "x")) / (right - left), d = (at(y[0], "y") - at(y[1], "y")) / (bottom - top);
  return new DOMMatrix([a, 0, 0, d, at(x[0], "x") - a * left, at(y[1], "y") - d * top]);
}

/** Bands, shades, marks and error bars below the curves. */
function drawShapes(u, chart) {
  const { ctx, bbox } = u, matrix = matrixOf(u, chart);
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  for (const { path, look } of chart.drawn) {
    const moved = new Path2D();
    moved.addPath(path, matrix);
    ctx.globalAlpha = Number(look.alpha);
    if (look.fill !== "none") { ctx.fillStyle = look.fill; ctx.fill(moved); }
    if (look.stroke !== "none") { ctx.strokeStyle = look.stroke; ctx.lineWidth = devicePixelRatio; ctx.stroke(moved); }
  }
  ctx.globalAlpha = 1;
  ctx.fillStyle = variable("--faint");
  ctx.font = `${11 * devicePixelRatio}px sans-serif`;
  for (const note of chart.texts) {
    const at = matrix.transformPoint({ x: note.at[0], y: note.at[1] }), low = note.at[1] > chart.box[3] / 2;
    ctx.save();
    ctx.translate(at.x, low ? bbox.top + bbox.height - 6 : bbox.top + 5);
    ctx.rotate(-Math.PI / 2);
    ctx.textAlign = low ? "left" : "right";
    ctx.fillText(note.text, 0, 0);
    ctx.restore();
  }
  ctx.restore();
}

function options(chart, size) {
  const grid = { stroke: () => variable("--line"), width: 1 }, axis = (label, more) => ({ label, values: (u, splits) => axisTexts(splits), stroke: () => variable("--soft"), grid, ticks: grid, font: "12px sans-serif", labelFont: "12px sans-serif", labelSize: 20, ...more });
  const series = [...chart.curves.flatMap((key) => key.runs.map(() => ({ label: key.label, stroke: () => key.colour, width: 2, dash: key.dashed ? [6, 4] : undefined, points: { show: false } }))),
    ...chart.dots.map((key) => ({ label: key.label, stroke: () => key.colour, paths: () => null, points: { show: true, size: 5, fill: () => key.colour, stroke: () => key.colour } }))];
  // uPlot asks for the range of y before it applies that of x.
  let shown = chart.x;
  const whole = () => shown[0] <= chart.x[0] && shown[1] >= chart.x[1];
  // Lines on whole pixels would have steps.
  return {
    ...size, pxAlign: 0, legend: { show: false }, series: [{}, ...series], cursor: { points: { size: 7 }, drag: { x: true, y: false } },
    scales: { x: { time: false, range: (u, low, high) => (shown = low === null ? chart.x : [low, high]) },
      y: { range: (u, low, high) => (low === null || whole() ? chart.y : uPlot.rangeNum(low, high, 0.1, true)) } },
    axes: [axis(chart.names[0], { size: 30, grid: { show: false } }), axis(chart.names[1], { size: (u, texts) => Math.max(kAxis_px, kAxisGap_px + kLetter_px * Math.max(0, ...(texts ?? []).map((one) => one?.length ?? 0))) })],
    hooks: { drawAxes: [(u) => drawShapes(u, chart)] },
  };
}

/** One line for each curve: its sign, its name and its value at the cursor. */
function legendOf(chart, root) {
  const list = document.createElement("ul");
  list.className = "keys";
  const keys = [...chart.curves, ...chart.dots].map((key) => {
    const item = document.createElement("li"), sign = document.createElement("i"), value = document.createElement("b");
    sign.className = key.points ? "dot" : key.dashed ? "dashed" : "";
    item.append(sign, key.label + " ", value);
    list.append(item);
    return { key, sign, value };
  });
  const at = document.createElement("li"), paint = () => { for (const k of keys) k.sign.style.color = k.key.colour; };
  at.className = "at";
  list.append(at);
  root.append(list);
  paint();
  const tell = (u) => {
    const x = u.cursor.left >= 0 ? u.posToVal(u.cursor.left, "x") : null;
    const near = Math.abs(u.posToVal(kNear_px, "x") - u.posToVal(0, "x"));
    at.textContent = x === null ? "" : `${chart.names[0]}: ${text(x)}`;
    for (const { key, value } of keys) value.textContent = x === null ? "" : valuesAt(key, x, near).map(text).join(", ");
  };
  return { paint, tell };
}

function zoom(u, chart, factor) {
  const { min, max } = u.scales.x, middle = u.cursor.left >= 0 ? u.posToVal(u.cursor.left, "x") : (min + max) / 2;
  const [low, high] = factor ? [middle - (middle - min) * factor, middle + (max - middle) * factor] : chart.x;
  u.setScale("x", { min: Math.max(low, chart.x[0]), max: Math.min(high, chart.x[1]) });
}

function controls(u, chart, figure, root) {
  const bar = document.createElement("div");
  bar.className = "zoom";
  for (const [name, label, factor] of [["+", "Zoom in", kZoom], ["\u2212", "Zoom out", 1 / kZoom], ["\u2922", "Show all", 0]]) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: name, title: label, onclick: () => zoom(u, chart, factor) });
    button.setAttribute("aria-label", `${label}: ${figure.querySelector("figcaption").textContent}`);
    bar.append(button);
  }
  figure.prepend(bar);
  root.addEventListener("keydown", (event) => {
    const { width, height } = u.over.getBoundingClientRect(), step = { ArrowLeft: -1, ArrowRight: 1 }[event.key], factor = { "+": kZoom, "-": 1 / kZoom, 0: 0 }[event.key];
    if (step) u.setCursor({ left: Math.min(width, Math.max(0, (u.cursor.left >= 0 ? u.cursor.left : width / 2) + step * kStep * width)), top: height / 2 });
    else if (factor !== undefined) zoom(u, chart, factor);
    else return;
    event.preventDefault();
  });
}

function makeLive(figure) {
  const svg = figure.querySelector("svg"), chart = readChart(svg), root = document.createElement("div");
  const tables = [...chart.curves.flatMap((c) => c.runs), ...chart.dots.map((d) => [d.points.map((p) => p[0]), d.points.map((p) => p[1])])];
  if (!tables.length || tables.some((t) => !t[0].length)) return;
  figure.style.height = `${figure.offsetHeight}px`;  // until the chart stands: what is below it must not move away from a click
  readColours(chart, svg);
  const below = (element) => element.getBoundingClientRect().bottom + parseFloat(style(element, "marginBottom")) - figure.getBoundingClientRect().top;
  const end = below(svg), width = () => Math.floor(figure.clientWidth - 24);
  root.className = "chart";
  root.tabIndex = 0;
  root.setAttribute("role", "application");
  root.setAttribute("aria-label", `${svg.getAttribute("aria-label")}. Arrow keys tell values, plus and minus zoom, 0 shows all.`);
  figure.append(root);
  const { paint, tell } = legendOf(chart, figure);
  const u = new uPlot(options(chart, { width: width(), height: kStart_px }), uPlot.join(tables), root);
  u.hooks.setCursor = [tell];
  controls(u, chart, figure, root);
  figure.classList.add("live");
  // As high as its SVG was.
  const ratio = (root.getBoundingClientRect().height - below(figure.querySelector(".keys")) + end) / width();
  const resize = () => u.setSize({ width: width(), height: Math.max(kLeast_px, Math.floor(ratio * width())) });
  resize();
  requestAnimationFrame(() => { figure.style.height = ""; });
  new ResizeObserver(() => { if (figure.clientWidth > 60 && width() !== u.width) resize(); }).observe(figure);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColours(chart, svg); paint(); u.redraw(); });
}

/** Charts are made when they come near the view: a page of fifty opens at once. */
export function enliven() {
  const watch = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries)
      if (isIntersecting) { watch.unobserve(target); makeLive(target); }
  }, { rootMargin: "400px" });
  for (const svg of document.querySelectorAll("figure.plot>svg[data-box]")) watch.observe(svg.parentElement);
}
