// The kit of which pages are built: figures, markup, tables, charts, the filter and the front.
import assert from "node:assert/strict";
import { test } from "node:test";
import { spreadAngles, camDrawing } from "../../web/src/kit/drawing.js";
import { sortedBy } from "../../web/src/kit/explorer.js";
import { filtered } from "../../web/src/kit/filter.js";
import { findingsSection, markersOf, notJudgedText, numbered, remedyList } from "../../web/src/kit/findings.js";
import { inkOf, kGap, kSimilarity, levelOf } from "../../web/src/kit/heat.js";
import { axisTexts, bytesText, change, deg, general, number, percent, span } from "../../web/src/kit/format.js";
import { guideSections } from "../../web/src/kit/markdown.js";
import { html } from "../../web/src/kit/markup.js";
import { Plot, roundTicks } from "../../web/src/kit/plot.js";
import { paretoFront, scatter } from "../../web/src/kit/scatter.js";
import { idOf, page, section, tag, verdictTag } from "../../web/src/kit/sections.js";
import { compared, num, shareCell, table } from "../../web/src/kit/table.js";
import { elements, firstUnbalanced, occurrences } from "./structure.mjs";

test("the axis of a constant goes from zero to it", () => {
  assert.ok(String(new Plot("t", "x", "y").curve("c", [0, 1], [0.15, 0.15], "pe").fromZero().svg()).includes('data-y="0 0.15'));
});

test("figures have as many digits as C's %g gives them", () => {
  const cases = [[0, "0"], [0.1 + 0.2, "0.3"], [1234.5, "1234.5"], [1e-4, "0.0001"], [1.25e-5, "1.25e-05"], [123456789, "1.23457e+08"], [-0.5, "-0.5"]];
  for (const [value, text] of cases) assert.equal(general(value), text);
  assert.deepEqual(axisTexts([-2e-6, -1.0000000001e-6, -0, 1e-6]), ["-2e-06", "-1e-06", "0", "1e-06"]);
  assert.deepEqual(axisTexts([100000, 100001]), ["100000", "100001"]);
  assert.equal(number(40760), "40760");
  assert.equal(number(0.00012345), "0.0001234");
  assert.equal(number(null), "\u2013");
  assert.equal(deg(Math.PI), "180");
  assert.equal(span([0.12, 0.5]), "0.12 to 0.5");
  assert.equal(span([0.12, null]), "\u2013");
  assert.equal(change(9.1, 1.04), "9.1 \u2192 1.04");
  assert.equal(percent(0.62), "62 %");
  assert.deepEqual([999, 1500, 2.5e6].map(bytesText), ["999 B", "1.5 kB", "2.50 MB"]);
});

test("markup escapes texts and takes markup as it is", () => {
  assert.equal(String(html`<p title="${'a"b'}">${"<script>&"}</p>${null}${false}${[1, html`<br>`]}`), '<p title="a&quot;b">&lt;script&gt;&amp;</p>1<br>');
  assert.equal(String(html`${"a\u0007b"}`), "a\ufffdb");
});

test("a table has a caption, headings and cells; without rows it is nothing", () => {
  assert.equal(table("none", ["a"], []), null);
  const text = String(table("widths", ["", "angle"], [["<a>", num(0.25)], [compared(0.2, 0.1), shareCell(0.5, "50 %")]], "cards"));
  assert.equal(firstUnbalanced(text), "");
  assert.deepEqual(elements(text, "th"), ["angle"]);
  assert.deepEqual(elements(text, "td"), ["", "&lt;a&gt;", "0.25", "11.46 (+5.7)", "50 %"]);
  assert.deepEqual(elements(String(table("t", ["a", "b", "c"], [["1", "", num(null)], ["2", "", ""]])), "th"), ["a"], "a column that tells nothing is left out");
  assert.ok(text.includes('data-label="angle"') && text.includes('<rect width="45"'));
});

test("a page has a table of contents of its sections", () => {
  assert.equal(idOf("As the shop builds it!"), "as-the-shop-builds-it");
  assert.equal(section("Empty", null), null);
  const text = page({ kind: "k", title: "<t>", verdict: verdictTag("not judged", "ok"), stamp: "s", tiles: [["1", "one"]] }, [section("First", "x"), null, section("Second", html`<b>y</b>`, "two")]);
  assert.ok(text.includes('<li><a href="#first">First</a></li><li><a href="#two">Second</a></li>'));
  assert.ok(text.includes('<h1>&lt;t&gt;</h1>') && text.includes('class="verdict unjudged-tag">\u2713 ok'));
  assert.ok(String(tag("error", "e")).includes("error-tag\">\u2715 e"));
});

test("ticks are round, and a chart draws each curve, gap, dot, band and mark", () => {
  assert.deepEqual(roundTicks([0, 1], 5), [0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
  const chart = new Plot("T", "x [m]", "y [N]").curve("a<b", [0, 1, 2, 3], [0, 1, null, 2], "se").points("dots", [1, 2], [0.5, null], "pe", [0.1, 0.1])
    .band("band", [0, 3], [0, 1], [1, 2], "se").shade([0, 1], "lead-in").mark(2, "here").fromZero();
  const svg = String(chart.svg());
  assert.equal(firstUnbalanced(svg), "");
  assert.equal(svg.match(/class="curve se" d="([^"]*)"><title>/)[1].split("M").length - 1, 2, "a gap begins a new line");
  assert.equal(occurrences(svg, '<circle class="dot pe"'), 1 + 1, "a dot and its key");
  assert.ok(svg.includes("a&lt;b") && svg.includes('class="band se"') && svg.includes('class="shade"') && svg.includes(">here</text>") && svg.includes("curve pe bar"));
  assert.ok(svg.includes('data-x="0 3"') && svg.includes('data-y="0 2"'));
});

test("a chart without values has an axis from 0 to 1, and equal values have room", () => {
  assert.ok(String(new Plot("T", "x", "y").curve("c", [], [], "se").svg()).includes('data-x="0 1"'));
  assert.ok(String(new Plot("T", "x", "y").curve("c", [5, 5], [2, 2], "se").svg()).includes('data-x="4.5 5.5"'));
});

const kRows = [{ name: "left", values: [1, "made"] }, { name: "right", values: [2, "refused"] }, { name: "none", values: [null, "made"] }];
const columnOf = (name) => ({ name: (row) => row.name, mass_g: (row) => row.values[0], outcome: (row) => row.values[1] })[name];
const kept = (filter) => filtered(kRows, filter, columnOf, (row) => [row.name, row.values[1]]).map((row) => row.name);

test("a filter is a word or a condition, and runs no text as code", () => {
  assert.deepEqual(kept(""), ["left", "right", "none"]);
  assert.deepEqual(kept("REFUSED"), ["right"]);
  assert.deepEqual(kept('mass_g < 2 || outcome == "refused"'), ["left", "right"]);
  assert.deepEqual(kept('(mass_g >= 1 && mass_g <= 1.5e0) || name == "none"'), ["left", "none"]);
  assert.deepEqual(kept("mass_g != 1"), ["right"], "an unknown value fulfils no comparison");
  assert.throws(() => kept("alert == 1"), (problem) => problem === "there is no column alert");
  assert.throws(() => kept("mass_g <"), (problem) => problem === "the condition ends too early");
  assert.throws(() => kept("(mass_g < 2"), (problem) => problem === "a bracket is not closed");
  assert.throws(() => kept("mass_g < 2 mass_g"), (problem) => problem === "not understood: mass_g");
});

test("a column sorts both ways, unknown values last", () => {
  assert.deepEqual(sortedBy(kRows, 0, false).map((row) => row.name), ["left", "right", "none"]);
  assert.deepEqual(sortedBy(kRows, 0, true).map((row) => row.name), ["right", "left", "none"]);
});

test("a front holds what no other point beats", () => {
  const points = [{ x: 1, y: 3 }, { x: 2, y: 2 }, { x: 2.5, y: 2.5 }, { x: 3, y: 1 }], front = (better) => points.filter((p) => paretoFront(points, better).has(p)).map((p) => p.x);
  assert.deepEqual(front({ x: "least", y: "least" }), [1, 2, 3]);
  assert.deepEqual(front({ x: "greatest", y: "least" }), [3]);
  const svg = String(scatter([{ ...points[0], name: "<a>", row: 0, href: "a/report.html" }, { x: null, y: 1, name: "b", row: 1, href: null }, { x: 2, y: null, name: "c", row: 2, href: null, refused: true }, { x: null, y: null, name: "d", row: 3, href: null, refused: true }], { x: "x", y: "y" }, new Set()));
  assert.equal(firstUnbalanced(svg), "");
  assert.ok(svg.includes("&lt;a&gt;") && svg.includes('href="a/report.html"'));
  assert.equal(occurrences(svg, "<circle"), 1);
  assert.equal(occurrences(svg, 'class="refused'), 1, "a refused design with one figure is a cross on the edge");
  assert.ok(String(scatter([{ x: null, y: 1, name: "b", row: 1, href: null }], { x: "x", y: "y" }, new Set())).includes("No design has both figures"));
});

const finding = (severity, rule, more = {}) => ({ severity, rule, what: "w", measured: 2, bound: "at most", allowed: 1, unit: "mm^2", where: "", suggestion: "", source: "", ...more });

test("findings are numbered by severity and lead to their places", () => {
  const place = { angle_rad: 0, point_mm: [3, 4, 0] };
  const all = numbered([["law", [finding("pass", "a.b"), finding("not judged", "spring.stress", { suggestion: "k.wire_mm" })]], ["k_se", [finding("error", "cam.rho", { place, what: "a<b" })]]]);
  assert.deepEqual(all.map((f) => [f.number, f.rule]), [[1, "cam.rho"], [2, "spring.stress"], [3, "a.b"]]);
  assert.equal(notJudgedText(all), "1 rule not judged: spring 1");
  const text = String(findingsSection(all));
  assert.equal(firstUnbalanced(text), "");
  assert.ok(text.includes('id="finding-1"') && text.includes('href="#place-1"') && text.includes("\u2264 1 mm\u00b2") && text.includes("k.wire_mm") && text.includes("a&lt;b"));
  assert.deepEqual(markersOf(all, "k_se").map(({ number: index, x, y }) => [index, x, y]), [[1, 3, 4]]);
});

test("a remedy has a figure beside it, unless it is a count that the words have", () => {
  const line = (more) => String(remedyList(numbered([["k_se", [finding("warning", "a.b", { suggestion: "mill it", ...more })]]])));
  assert.ok(line({ what: "the wall, at 3 deg", measured: 0.5, bound: "at least", allowed: 1, unit: "mm" }).includes("the wall: 0.5 mm, at least 1</span>"));
  assert.ok(line({ what: "6 milling rules fail; no mill", measured: 6, bound: "at most", allowed: 0, unit: "rules" }).includes("6 milling rules fail; no mill</span>"));
});

const kDisc = Array.from({ length: 65 }, (_, i) => `${10 * Math.cos((i * Math.PI) / 32)},${10 * Math.sin((i * Math.PI) / 32)}`).join(" ");
const kDrawing = { part: "k_se", closed: true, body: [kDisc], boss: [], floor: kDisc, pitch: kDisc, working: "8,6 6,8", around: "",
  ends: [{ load_Nm: 0.5, contact_mm: [8, 6], direction: [-0.6, 0.8] }, { load_Nm: 1, contact_mm: [6, 8], direction: [-0.8, 0.6] }] };

test("a drawing is to scale, with y up, a scale bar and numbered places", () => {
  const svg = String(camDrawing(kDrawing, [{ number: 7, severity: "error", x: 3, y: 4, title: "a<b" }, { number: 8, severity: "pass", x: 1, y: 1, title: "p" }]));
  assert.equal(firstUnbalanced(svg), "");
  const [, width, left, , box] = svg.match(/width="([\d.]+)mm".*?viewBox="(-?[\d.]+) (-?[\d.]+) ([\d.]+) /);
  assert.equal(width, box, "a unit is a millimetre");
  assert.ok(Math.abs(Number(left) + 13.6) < 0.01);
  assert.ok(svg.includes('class="working" d="M8 -6L6 -8"') && svg.includes(">0.5 Nm</text>"));
  assert.equal(svg.match(/class="scale"><path d="M\S+ \S+v\S+?h([\d.]+)v/)[1], svg.match(/>([\d.]+) mm<\/text>/)[1]);
  assert.ok(svg.includes('aria-label="a&lt;b"') && svg.includes('d="M3 -4L') && svg.includes(">7</text>") && svg.includes('id="place-8"'));
});

test("marks are moved apart and keep their order", () => {
  const moved = spreadAngles([0.1, 0, 0.1, 3, -3.1], 0.3), sorted = [...moved].sort((a, b) => a - b);
  for (let i = 1; i < sorted.length; ++i) assert.ok(sorted[i] - sorted[i - 1] >= 0.3 - 1e-6);
  assert.ok(sorted[0] + 2 * Math.PI - sorted[4] >= 0.3 - 1e-6);
  assert.ok(moved[1] < moved[0]);
});

test("a guide has its headings as sections, with lists, tables, links and pictures", () => {
  const guide = "# Assembly of <x>\nFrame: z is up,\nthe rest follows.\n\n![Seen](plan.svg)\n\n## Order\n1. Set the **rods**\n  into place.\n2. See [bom.csv](bom.csv).\n\n## Cables\n| cable | length |\n|---|---|\n| series | 12.5 |\n";
  const { title, sections } = guideSections(guide, "The joint", { plan: "<svg></svg>" }), text = sections.join("");
  assert.equal(title, "Assembly of <x>");
  assert.equal(firstUnbalanced(text), "");
  assert.deepEqual(elements(text, "h2"), ["The joint", "Order", "Cables"]);
  assert.ok(text.includes("<p>Frame: z is up, the rest follows.</p>") && text.includes("<svg></svg>"));
  assert.deepEqual(elements(text, "li"), ["Set the rods into place.", "See bom.csv."]);
  assert.deepEqual(elements(text, "td"), ["series", "12.5"]);
  assert.ok(text.includes('<a href="bom.csv">bom.csv</a>'));
});

/** Relative luminance of "#rrggbb" (WCAG 2.1). */
function luminance(colour) {
  const [r, g, b] = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

test("colour scales get darker with every level, and figures can be read on each", () => {
  assert.deepEqual([0, 0.999, 1, 2.5, 19.9, 20, 1e300].map((gap) => levelOf(kGap, gap)), [0, 0, 1, 3, 6, 7, 7]);
  for (const { fills } of [kGap, kSimilarity])
    fills.forEach((fill, i) => {
      if (i > 0) assert.ok(luminance(fill) < 0.95 * luminance(fills[i - 1]));
      const [dark, light] = [luminance(fill), luminance(inkOf(i))].sort((a, b) => a - b);
      assert.ok((light + 0.05) / (dark + 0.05) >= 4.5, "WCAG 2.1, level AA");
    });
});
