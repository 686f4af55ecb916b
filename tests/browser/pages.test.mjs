// Every page from a small result: its sections, tables and charts, escaped names, and a dash for what is not known.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { firstAxes, otherRefusals, outcomeSentence } from "../../web/src/pages/study.js";
import { effectSentence, kCauses, withNames } from "../../web/src/pages/diagnosis/causes.js";
import * as results from "./results.mjs";
import { drawn, elements, occurrences } from "./structure.mjs";

const charts = (html) => occurrences(html, '<figure class="plot"');

test("simulation: each section, with and without equilibria", () => {
  const html = drawn("simulation", results.simulation());
  assert.ok(html.includes("a&lt;b") && html.includes("verdict pass-tag") && html.includes("Unknown: a gap"));
  assert.ok(html.includes("\u2713 Co-contraction reduces the stiction at the joint</span>") && html.includes("The linear dead-band falls from 11.5 to 5.73 deg as co-contraction rises from 0.5 to 1 Nm."));
  assert.equal(elements(html, "h2").length, 9, "results, measured, joint, levels, equilibrium, push, subsystems, hysteresis, summary");
  assert.equal(elements(html, "table").length, 3);
  assert.equal(charts(html), 4 + 3 + 4 + 2, "joint, push, subsystems, hysteresis");
  assert.ok(elements(html, "td").includes("\u2013"), "what is not known is a dash");
  const more = drawn("simulation", { ...results.simulation(), equilibria: results.equilibria });
  assert.equal(elements(more, "h2").length, 10);
  for (const text of ["tau_1 = 1 Nm, tau_2 = 0.9 Nm, tau_q = 0 Nm", "theta_1 = 0.5 rad, theta_2 = 0.25 rad, q = 0 rad (0 deg)", "linear 10 deg; exact unknown", "equilibrium.outside"])
    assert.ok(more.includes(text), text);
});

test("simulation: another arrangement shows its summary and levels", () => {
  const other = results.simulation();
  other.survey.arrangement = "series_elastic";
  const html = drawn("simulation", other);
  assert.deepEqual(elements(html, "h2"), ["Results", "Summary of the arrangement", "Levels of co-contraction"]);
});

test("search: found springs, cams that cannot be cut and their rule", () => {
  const html = drawn("search", results.search());
  for (const text of ["arm&lt;1&gt;-design", "verdict warning-tag", "cam.convexity", "no &lt;convex&gt; contour", "law.end_torque_Nm = 1.8", "u &amp; C are", "Cost over u", "Lever arm of the series spool", "<b>Set law.end_torque_Nm = 1.8</b>", "<b>24</b>"])
    assert.ok(html.includes(text), text);
  assert.equal(elements(html, "h2").length, 5, "result, cost, springs, cams, findings");
  const none = drawn("search", results.search(false));
  assert.ok(none.includes("verdict pass-tag") && !none.includes('class="cam'));
  assert.equal(elements(none, "h2").length, 4);
});

test("pareto: the explorer, the levels and what was dropped", () => {
  const html = drawn("pareto", results.front);
  assert.deepEqual(elements(html, "h2"), ["Two figures", "Designs", "Levels of co-contraction", "Dropped designs"]);
  assert.ok(html.includes("stopped early") && html.includes("pareto/00.toml") && html.includes("at_0.5_Nm_deg"));
});

test("identification: figure 8, and many motors by direction only", () => {
  const html = drawn("identification", results.identification(["<b>", "other"]));
  assert.equal(occurrences(html, '<circle class="dot'), 2 * (8 + 4), "two charts: a dot for each repeat, four keys");
  assert.ok(html.includes('class="band') && html.includes("gear_friction = 0.25") && html.includes("The gear loses 25 % of its load to friction (20 to 30 %).") && html.includes("(p = 0.012)") && !html.includes("<b> drive"));
  const many = drawn("identification", results.identification(Array.from({ length: 600 }, (_, i) => `motor ${i}`)));
  assert.ok(many.includes("Of 2400 dots") && !many.includes("<title>motor 1 drive"));
  assert.ok(occurrences(many, '<circle class="dot') < 2500);
});

test("paper: every figure and table", () => {
  const html = drawn("paper", results.paper);
  for (const text of ["arm&lt;1&gt;", "noise &amp; both", "everywhere", "noise.unbounded", "of the synthetic example"]) assert.ok(html.includes(text), text);
  assert.equal(elements(html, "h2").length, 13, "overview, figures 1, 2, 6, 8, 9 with its cost, springs and cams, two tables, relatives, noise");
});

test("study: says how many designs it holds", () => {
  const html = drawn("study", results.study);
  assert.ok(html.includes("3 designs. This page shows the first 2 of them") && html.includes('title="mass &lt;both&gt;"'));
  assert.deepEqual(elements(html, "h2"), ["Two figures", "Designs"]);
  assert.ok(html.includes("1 made, 1 refused: no &lt;convex&gt; contour</span>"));
});

test("study: the first axes vary; over a key where designs were refused, which have no figures", () => {
  const of = (rows) => ({ ...results.study, rows: rows.map(([outcome, ...figures], i) => [`${i}`, [outcome, ...figures, outcome === "made" ? null : `r.${outcome}`], null, null]) });
  assert.deepEqual(firstAxes(of([["made", 12, 20, 1], ["made", 13, 25, 2]])), { x: "mass_g", y: "dead_band_at_peak_deg", front: true });
  assert.deepEqual(firstAxes(of([["made", 12, 20, 1], ["made", 12, 25, 2]])), { x: "key", y: "dead_band_at_peak_deg", front: true }, "equal masses are no axis");
  assert.deepEqual(firstAxes(of([["made", 12, 20, 1], ["made", 13, 25, 2], ["a", null, null, 3]])), { x: "key", y: "dead_band_at_peak_deg", front: false });
  assert.deepEqual(firstAxes(of([["made", 12, 20, 1]])).x, "mass_g", "a single design has axes too");
  const heavier = firstAxes({ columns: ["outcome", "key", "mass_g", "k_pe_triangles"].map((name) => ({ name, meaning: "", text: name === "outcome" })), rows: [["a", ["made", 1, 12, 900]], ["b", ["made", 2, 13, 950]], ["c", ["refused", 3, null, null]]] });
  assert.deepEqual(heavier, { x: "key", y: "mass_g", front: false }, "without a dead-band a figure that tells designs apart, no size of a mesh");
  assert.equal(outcomeSentence(of(["made", "made", "a", "b", "b", "c", "d"].map((outcome) => [outcome, null, null, 1]))), "2 made, 5 refused, 2 of them: r.b");
  const faults = { ...results.study, rows: ["b", "b", "a", "c", "d", "e", "f"].map((rule) => ["", ["refused", null, null, 1, `r.${rule}`, `error: r.${rule}: fault ${rule}, 3 mm: measured 1`]]) };
  assert.equal(outcomeSentence(faults), "0 made, 7 refused, 2 of them: fault b");
  assert.equal(otherRefusals(faults), "Refused also by fault a (r.a): 1; fault c (r.c): 1; fault d (r.d): 1; 2 other rules: 2.");
  assert.equal(otherRefusals(results.study), "");
});

test("design: every figure, drawing and finding", () => {
  const html = drawn("design", results.design());
  assert.ok(html.includes("<h1>disc&lt;1&gt;</h1>") && html.includes("verdict warning-tag") && !html.includes("<frays>"));
  assert.equal(elements(html, "h2").length, 8, "two parts, findings, passed, law, dead-band, read-back, files");
  assert.equal(charts(html), 2 + 1 + 4 + 2, "arms, height of the helix, law, joint");
  for (const text of ["cable.bend_ratio", "preload 4.1 rad", "a handbook", ">6.1 mm<", "\u2265 8 mm", "assimp", "0.02 %", "springs.csv", "51.1 kB", "via=cgal", "10.0000 mm", "not proven", "0.1 mm at 9 N"])
    assert.ok(html.includes(text), text);
  const places = ['class="cam k_se"', "<title>1. cable.bend_ratio", 'class="cam k_pe"', "<title>2. cable.bend_ratio"].map((text) => html.indexOf(text));
  assert.deepEqual([...places].sort((a, b) => a - b), places, "the warnings of k_se and k_pe are 1 and 2, each on its own drawing");
});

test("design: the verdict in a sentence, titled figures, and one line for each remedy", () => {
  const html = drawn("design", results.design()), head = html.slice(0, html.indexOf("</header>"));
  for (const text of ["! Can be made once its 2 warnings are accepted", "<p>Dead-band, 0.4 to 0.8 Nm</p><b>75 to 20 deg</b><span>as built &amp; more</span>", "<p>Left to accept</p><b>2 warnings</b><span>every rule was judged</span>",
    '<i>1, 2</i><b>Preload 4.1 rad</b><span>series spool and parallel cam: the cable bends too sharply &amp; &lt;frays&gt;: 6.1 mm, at least 8</span>'])
    assert.ok(head.includes(text), text);
  assert.equal(occurrences(head, "<li>"), 1, "findings with the same remedy share a line");
  assert.ok(!html.includes("<nav"), "the heads of its folded sections are its contents");
  const broken = results.design({ verdict: "error" });
  broken.parts[0].findings[1] = { ...broken.parts[0].findings[1], severity: "error", changes: [{ "k_se.spring.rate_N_per_m": "2", "k_se.spring.preload_mm": "3" }] };
  const must = drawn("design", broken);
  assert.ok(/<h2>Findings<\/h2><span>1 error(, \d warnings?)?<\/span>/.test(must), "errors and warnings are counted apart");
  for (const text of ["Must be changed: 1 error", "<p>Left to change</p><b>1 error</b>", "<b>Set spring: rate 2 N/m, preload 3 mm</b>"]) assert.ok(must.includes(text), text);
});

test("design: rules that were not judged stand between warnings and passes", () => {
  const design = results.design();
  design.parts[0].findings.push(results.open);
  const html = drawn("design", design), places = ['class="tag warning-tag"', 'class="tag unjudged-tag"', "k_se.spring.wire_mm", 'class="scroll dense"'].map((text) => html.indexOf(text));
  assert.deepEqual([...places].sort((a, b) => a - b), places);
  assert.ok(html.includes("1 rule not judged: spring 1"));
});

test("design: the joint in 3D, its cables, the budget, a measured table and the joint as exported", () => {
  const { assembly, as_exported, table, budget } = results.whole, design = results.design({ assembly, as_exported });
  design.law.table = table;
  design.headline.budget = budget;
  const html = drawn("design", design, { plan: "<svg></svg>" });
  assert.equal(elements(html, "h2").length, 8 + 5, "the joint, building it, the table, the budget, as exported");
  for (const text of ['id="joint-3d"', "drive cable", "law.csv, 2 rows", "0.1 mm", "200 sampled joints", "57.353 deg", "perimeters, a print", "load &lt;falls&gt;"]) assert.ok(html.includes(text), text);
  const refused = drawn("design", results.design({ no_assembly: "k_pe: an assembly with a roller is not modelled." }));
  assert.ok(refused.includes("Not shown. k_pe: an assembly with a roller"));
});

test("design: an empty one is still a page", () => {
  const none = { tau_Nm: [], theta_rad: [], f_se_Nm: [], f_pe_Nm: [], s_Nm_per_rad: [], p_Nm_per_rad: [] };
  const html = drawn("design", results.design({ verdict: "pass", findings: [], parts: [], files: [], dead_band: [], headline: { figures: [], budget: null }, law: { curves: none } }));
  assert.ok(html.includes("verdict pass-tag"));
  assert.deepEqual(elements(html, "section"), []);
});

const pathOf = (html, css) => html.match(new RegExp(`class="${css}" d="([^"]*)"`))?.[1] ?? "";

test("diagnosis: what is wrong, what helps and where it lies, then the proof", () => {
  const html = drawn("diagnosis", results.diagnosis());
  assert.deepEqual(elements(html, "h2"), ["The faulty place", "Measured against predicted", "Next experiment", "Which effects cause it", "How far the gap shrinks", "Where the gap lies", "Remarks", "What these experiments can distinguish", "How this rig was built"]);
  for (const text of ["verdict pass-tag", "<b>9.12 \u2192 1.04 sigma</b>", "<b>9.31 \u2192 1.06 sigma</b>", "95 %: 0.97 to 1.17", "0.0512 Nm", "0.0473 to 0.0551 Nm", "-0.21 mm", "62 %", "agonist, push up", ">found<", "motor torque [Nm]: 0.02, 0.05", "Leaving out the time log", "&lt; 0.001", "1 chart more",
    "<p class=\"lead\">The gear has 0.0512 Nm of constant friction on the agonist&#39;s side (0.0473 to 0.0551 Nm). Every arm of the series spool is 0.21 mm shorter than drawn on both sides (0.16 to 0.26 mm). Probability: 0.934.</p>".replaceAll("&#39;", "'")])
    assert.ok(html.includes(text), text);
  assert.ok(!html.includes("<se.radius>"));
});

test("diagnosis: what was kept aside, and the gap there in its unit beside the claimed one", () => {
  const html = drawn("diagnosis", results.diagnosis()), text = html.replace(/<[^>]*>/g, " ").replace(/ +/g, " ");
  assert.ok(text.includes("break-away 24 8 &lt;torques&gt; 0.124 Nm 0.0121 Nm 0.0148 Nm"));
  assert.ok(!/<details[^>]*>(?:(?!<\/details>)[^])*kept aside in turn/.test(html), "it is open");
  const { experiments } = results.diagnosis(), bare = drawn("diagnosis", results.diagnosis({ experiments: experiments.map(({ held_out, in_unit, ...own }) => own) }));
  assert.ok(bare.includes("How far the gap shrinks") && !bare.includes("kept aside"), "a result of an older version");
});

test("diagnosis: the gap map folds long strips, by rising range", () => {
  const html = drawn("diagnosis", results.diagnosis());
  assert.ok(html.indexOf(">27<") < html.indexOf(">2.4<"));
  assert.equal(occurrences(html, ">0.3</text>"), 2, "an edge that two cells share is shown once in each map");
  for (const [fill, count] of [["#8c2d04", 2], ["#fec44f", 2], ["#fff7bc", 2]]) assert.equal(occurrences(html, `fill="${fill}"`), count, `${fill}: one cell, one key of the legend`);
  const map = Array.from({ length: 30 }, (_, i) => ({ experiment: "log", region: { variable: "t_s", from: i, to: i + 1 }, before: 1, after: 1 }));
  assert.equal(occurrences(drawn("diagnosis", results.diagnosis({ map })), ">time log</text>"), 2 * 4);
  const apart = [[0.1, 0.1], [0.5, 0.8]].map(([from, to]) => ({ experiment: "dead_band", region: { variable: "cocontraction_Nm", from, to }, before: 1, after: 1 }));
  assert.equal(occurrences(drawn("diagnosis", results.diagnosis({ map: apart })), ">0.5\u20130.8</text>"), 2);
});

test("diagnosis: an ambiguous verdict marks the possible causes, in 3D too", () => {
  const scene = { bodies: [{ name: "capstan_agonist" }, { name: "motor_shaft_agonist" }, { name: "k_se_agonist" }, { name: "k_se_antagonist" }] };
  const ambiguous = drawn("diagnosis", results.diagnosis({ verdict: "ambiguous" }), { "joint-scene": scene, plan: "<svg></svg>" });
  assert.ok(ambiguous.includes("none is certain") && !ambiguous.includes("The faulty place") && drawn("diagnosis", results.diagnosis({ verdict: "ambiguous" })).includes("friction of the gear at rest on the agonist's side: What &lt;gear.stribeck&gt; does."));
  assert.ok(ambiguous.includes("Orange: where") && ambiguous.includes("constant gear friction on the agonist's side: capstan, right; motor shaft, right; the gear itself is not modelled"));
  const none = drawn("diagnosis", results.diagnosis({ verdict: "none" }), { "joint-scene": scene, plan: "" });
  assert.ok(!none.includes("The faulty place") && !none.includes("joint-3d"));
});

test("diagnosis: classes of causes are outlined, many causes stay bounded", () => {
  const html = drawn("diagnosis", results.diagnosis());
  assert.equal(occurrences(html, 'stroke-width="2"'), 1, "a pair");
  assert.ok(html.includes("<li>constant gear friction on the agonist's side, arms of the series spool on both sides</li>") && html.includes(">98</text>"));
  const many = Array.from({ length: 200 }, () => ({ id: "gear.coulomb", side: "agonist" }));
  const bounded = drawn("diagnosis", results.diagnosis({ isolability: { causes: many, signature_similarity: many.map(() => many.map(() => 0.5)), detectable: [], units: [], classes: [] } }));
  assert.ok(bounded.includes("72 of 200") && bounded.length < 900000);
});

test("diagnosis: a trace of a spring has its name", () => {
  const html = drawn("diagnosis", results.diagnosis({ traces: [results.traceOf([0, 1], [1, 2], { experiment: "spring_pull", label: "pe agonist" }), results.traceOf([0, 1], [1, 2], { label: "q_rad" })] }));
  for (const title of ["spring pull: parallel spring, agonist", "time log: q [rad]"]) assert.ok(html.includes(`<figcaption>${title}</figcaption>`), title);
});

test("diagnosis: repeats are one curve, a loop keeps its branches, a new sweep is a new line", () => {
  const page = (trace) => drawn("diagnosis", results.diagnosis({ traces: [trace] }));
  const loop = page(results.loopTrace("there and back"));
  assert.equal(occurrences(loop, 'class="band se"'), 3, "up, down over zero, up to zero");
  assert.equal(pathOf(loop, "curve se").split("M").length - 1, 1);
  assert.equal(pathOf(loop, "curve se").split("L").length - 1, 80);
  const repeats = page(results.traceOf([1, 2, 3, 1, 2, 3], [5, 6, 7, 5, 6, 7]));
  assert.equal(occurrences(repeats, 'class="band se"'), 1);
  const ten = Array.from({ length: 10 }, (_, i) => i), sweeps = page(results.traceOf([...ten, ...ten], [...ten, ...ten.map((i) => i + 5)]));
  assert.equal(pathOf(sweeps, "curve se").split("M").length - 1, 2);
  assert.equal(pathOf(sweeps, "curve pe dashed"), "", "no prediction before, no line");
  const cycles = page(results.traceOf(Array.from({ length: 400 }, (_, i) => Math.sin(0.2 * i)), Array.from({ length: 400 }, (_, i) => Math.cos(0.2 * i))));
  assert.equal(occurrences(cycles, 'class="band se"'), 0, "25 turns");
  const mixed = [0, 5, 1, 6, 2, 7, 3, 8, 4, 9, 0.5, 5.5, 1.5, 6.5, 2.5, 7.5, 3.5, 8.5, 4.5, 9.5], heights = [...pathOf(page(results.traceOf(mixed, mixed)), "curve se").matchAll(/ ([\d.]+)/g)].map(([, y]) => Number(y));
  assert.deepEqual([...heights].sort((a, b) => b - a), heights, "scatter is sorted");
});

test("diagnosis: the band is 95 per cent wide", () => {
  const html = drawn("diagnosis", results.diagnosis({ traces: [results.traceOf([0, 1], [0, 0], { sigma: [1, 1] })] }));
  // The axis goes from -2 to 2 over 220 units: 300 less 46 for the axis and 34 for the legend.
  const heights = [...pathOf(html, "band se").matchAll(/ ([\d.]+)/g)].map(([, y]) => Number(y));
  assert.ok(Math.abs((Math.max(...heights) - Math.min(...heights)) / 2 - (1.959964 * 220) / 4) < 2e-3);
});

test("diagnosis: the form of an unknown effect, a transfer, the power, new cams", () => {
  const transfer = [{ effects: [{ id: "law.series", side: "none" }], fitted: "a.csv", heldout: "b.csv", fit_before: 10.4, fit_after: 3, heldout_before: 6.9, heldout_after: 7.9, parameters: [{ value: 9e-4, unit: "rad/Nm" }], unit: "Nm" }];
  const power = [{ id: "gear.coulomb", side: "agonist", least: null, usual: 0.02, unit: "Nm", shown: false }, { id: "se.radius", side: "both", least: 1e-4, usual: 2e-4, unit: "m", shown: true }];
  const html = drawn("diagnosis", results.diagnosis({ ...results.unknown, transfer, power, doubts: ["a doubt"] }), { redesign: results.redesign });
  for (const text of ["Cause unknown", "Doubt: a doubt.", "The motor ripples 12 times a turn.", "enters at the motor", "the probabilities are among these alone", "capstan angle [rad]", "per_rad", "1/rad", "other of the term", "b.csv: 6.9 \u2192 7.9", "<b>worse</b>", "1 of 2 causes", "<b>no</b>",
    "11 %", "less than 0.001 %", "18 % with the old cams, 2.5 % with new cams", "1 Nm: exact dead-band", "arm &lt;new&gt;.toml", "gear friction &lt;b&gt;", "fusee make will refuse these cams.", "cam.arm", "cams &lt; are new", "The profile covers all."])
    assert.ok(html.includes(text), text);
});

test("diagnosis: any number of effects, partly explained; certainty is not told", () => {
  const { effects } = results.diagnosis(), rate = { id: "pe.rate", side: "none", probability: 1, parameter: { value: 0.124, ci95: [0.11, 0.138], unit: "1" } };
  const html = drawn("diagnosis", results.diagnosis({ verdict: "partly_explained", probability: 1, effects: [...effects, rate], sentence: "The rig has 3 effects: se.radius (both). That explains a part of the gap: 3 of 9 sigma remain, most in: pe.rate (both) & more." }));
  for (const text of ["! Partly explained", "The parallel spring is 12 % stiffer than its rate (11 to 14 %).", "(11 to 14 %). That explains a part of the gap: 3 of 9 sigma remain, most in: stiffness of the parallel spring on both sides &amp; more.", "&gt; 0.999", 'class="faulty"']) assert.ok(html.includes(text), text);
  assert.ok(!html.includes("Probability:"));
  assert.equal(elements(html, "b").filter((text) => /stiffer|friction|arm/.test(text)).length, 3, "a row for each effect");
  assert.ok(drawn("diagnosis", results.diagnosis({ verdict: "of tomorrow" })).includes("! of tomorrow"));
});

test("diagnosis: the remedy and the dead-band afterwards stand beside the cause", () => {
  const made = { ...results.redesign, profiles: [{ ...results.redesign.profiles[0], can_be_cut: true }] }, html = drawn("diagnosis", results.diagnosis(), { redesign: made });
  for (const text of ["<p>Remedy</p><b>New cams</b><span>fusee make arm &lt;new&gt;.toml</span>", "<p>Dead-band afterwards</p><b>17.8 deg</b><span>at 1 Nm; now 18.9 deg, by the profile 17.2 deg</span>"]) assert.ok(html.includes(text), text);
  assert.ok(drawn("diagnosis", results.diagnosis(), { redesign: results.redesign }).includes("<b>No cams can be made</b>"));
  assert.ok(drawn("diagnosis", results.diagnosis({ verdict: "ambiguous" })).includes("<p>Next experiment</p><b>break-away</b><span>12 min, 1.7 bit of information expected</span>"));
});

test("diagnosis: the remedy of a user's effect, what a plain fit would claim, and another case", () => {
  const size = (value) => ({ value, ci95: [value - 0.01, value + 0.01], unit: "Nm" }), own = { id: "drag", side: "none" };
  const html = drawn("diagnosis", results.diagnosis({ effects: [{ ...own, probability: 1, parameter: size(0.1) }], meanings: { drag: { meaning: "It <drags>.", law: "frees drag_Nm", remedy: "Oil & wipe it.", of_joint: false } },
    absorption: { parameters: [{ name: "length_m", value: 0.002, tolerances: 12, with_cause: 0, unit: "m" }, { name: "zero_Nm", value: 1, tolerances: null, with_cause: 2, unit: "Nm" }], after: 1, heldout_after: 3, unit: "sigma", sentence: "A fit of all <parameters>." },
    against: { case: "tues<day>", case_sha256: "0", causes: [{ ...own, here: size(0.1), there: size(0.2), survival: "differs" }, { ...own, here: size(0.1), there: { value: null, ci95: [null, null], unit: "Nm" }, survival: "open" }],
      gap: { before: 9, carried: 2, refitted: 1.5, own: 1.25, unit: "sigma" }, verdict: "identified", effects: [own] } }));
  for (const text of ["<p>Remedy</p><b>Mend it</b><span>Oil &amp; wipe it.</span>", "Remedy: Oil &amp; wipe it.", "It &lt;drags&gt;.", "A fit of all &lt;parameters&gt;.", "2 mm", "Does it hold elsewhere", "On tues&lt;day&gt; the gap is 9 sigma; 2 with these causes as they are, 1.5 with their sizes fitted there; 1.25 with its own diagnosis, identified: drag.",
    "there, with another size", "its rows do not tell", '<p class="lead">It &lt;drags&gt;: drag is 0.1 Nm above the model (0.09 to 0.11 Nm).']) assert.ok(html.includes(text), text);
  assert.ok(!html.includes("fusee explain drag"), "explain does not know it");
  const late = { id: "port.x_m.scale", side: "none", parameter: { value: -0.02, ci95: [-0.03, -0.01], unit: "1" } };
  assert.equal(effectSentence(late, { meaning: "Everything in this column is greater (+) or smaller (-) by one factor." }), "Everything in column x_m is smaller by one factor: -2 % (-3 to -1 %)");
  const bare = drawn("diagnosis", results.diagnosis({ meanings: { "gear.coulomb": { of_joint: false }, "se.radius": { of_joint: false } } }));
  assert.ok(bare.includes("<b>Mend it</b><span>or keep it in the model</span>") && !bare.includes("What a plain fit would claim") && !bare.includes("Does it hold elsewhere"));
});

test("diagnosis: every effect of the engine has a name and a sentence; no meaning shows a sign", () => {
  const source = ["../../src/effects/library.cpp", "../../src/report/diagnosis/words.cpp"].map((file) => readFileSync(new URL(file, import.meta.url), "utf8")).join("");
  const ids = [...source.matchAll(/\.id = "([a-z_]+\.[a-z_]+)"|(?:Words\{|radius\(|inertia\(|drag\()"([a-z_]+\.[a-z_]+)"/g)].map(([, id, other]) => id ?? other);
  assert.ok(ids.length >= 44, `${ids.length} effects`);
  assert.deepEqual(ids.filter((id) => !kCauses[id]), []);
  for (const id of Object.keys(kCauses)) for (const value of [0.3, -0.3]) {
    const text = effectSentence({ id, side: "both", parameter: { value, ci95: [value - 0.1, value + 0.1], unit: "1" } });
    assert.ok(!/[{}|]|\(\+\)|\(-\)/.test(text) && text.includes("30 %") && text.endsWith(" %)"), text);
  }
  assert.equal(effectSentence({ id: "gear.load_friction", side: "both", parameter: { value: 0.299, ci95: [0.262, 0.336], unit: "1" } }), "Gear friction is 30 % above the model on both sides (26 to 34 %)");
  assert.equal(effectSentence({ id: "gear.load_friction", side: "agonist", parameter: { value: -0.2, ci95: [-0.25, -0.15], unit: "1" } }), "Gear friction is 20 % below the model on the agonist's side (15 to 25 %)");
  assert.equal(withNames("See gear.coulomb (both), term.motor.ripple (agonist) or case.toml."), "See constant gear friction on both sides, ripple of the motor on the agonist's side or case.toml.");
});

test("diagnosis: an empty one has a head and nothing else", () => {
  const none = { before: null, after: null, noise_floor: null, heldout_before: null, heldout_after: null, heldout_after_95: [null, null] };
  const html = drawn("diagnosis", results.diagnosis({ verdict: "none", probability: null, effects: [], alternatives: [], where: [], gap: none, next_experiment: "", next: [], build: {}, experiments: [], map: [], ranking: [], traces: [], remarks: [],
    isolability: { causes: [], signature_similarity: [], detectable: [], units: [], classes: [] } }));
  assert.ok(html.includes("verdict pass-tag") && html.includes("<b>\u2013 \u2192 \u2013 sigma</b>"));
  assert.deepEqual([elements(html, "section"), elements(html, "table")], [[], []]);
});

test("score: figures with their targets, and every miss", () => {
  const html = drawn("score", results.score());
  for (const text of ["3 sealed cases", "sha256:0123abcd", "1 of 2", "0.95 to 0.99", "10.0 to 90.0 %", "at least 95 %", "90 to 99 %", "at most 5 %", "100 %", "constant gear friction on the agonist's side 0.05", "&lt;wrongly&gt; on both sides 1 (95 %: 0.5 to 1.5)", "constant gear friction on the agonist's side + arms of the series spool on both sides 0.3; none 0.1", "failed"])
    assert.ok(html.includes(text), text);
  assert.deepEqual(elements(html, "h2"), ["Figures", "Confusion", "Calibration", "Intervals", "Claimed and measured reduction of the gap", "Time", "Misses"]);
  assert.equal(elements(drawn("score", results.score(results.score())), "th").length, elements(html, "th").length + 1, "a column for the model's own cases");
});

test("assembly: the guide with its pictures", () => {
  const joint = { provenance: { fusee: "0.1", name: "arm<1>" }, capstan_radius_mm: 10, joint_radius_mm: 20, cable_diameter_mm: 0.8, bodies: [1, 2] };
  const html = drawn("assembly", joint, { guide: "# Assembly of arm<1>\nWords.\n\n![View](assembly_plan.svg)\n\n## Order\n1. First\n", pictures: { assembly_plan: "<svg></svg>" } });
  assert.ok(html.includes("Assembly of arm&lt;1&gt;") && html.includes("<svg></svg>") && html.includes("print this page"));
});
