// The controls beside the view. Every control works with the keyboard, in the order of the page.
import { bodyName, kSidesMeaning } from "../kit/names.js";
import { button, element, fold, slider } from "./dom.js";

const CUTS = [["off", "no section"], ["x", "across x"], ["y", "across y"], ["z", "across the axis"], ["view", "facing the view"]];

const group = (title, ...children) => element("fieldset", {}, element("legend", {}, title), ...children);

function check(id, text, checked, onchange) {
  const input = element("input", { type: "checkbox", id, checked, onchange: () => onchange(input.checked) });
  return element("label", { class: "joint3d-check", for: id }, input, ` ${text}`);
}

function poseGroup(viewer) {
  const { poses, act, model } = viewer;
  const [low, high] = poses.tau;
  viewer.tau = slider("joint3d-tau", "co-contraction", { min: low, max: high, step: (high - low) / 200 }, act.tau);
  viewer.torque = slider("joint3d-torque", "joint torque", { min: -1, max: 1, step: 0.01 }, act.share);
  viewer.words = element("p", { class: "joint3d-pose", "aria-live": "polite" });
  viewer.play = button("\u25b6 Play co-contraction", { class: "joint3d-play", "aria-pressed": "false", onclick: act.play });
  const looks = [[model.bodies.some((body) => body.data.marked) ? "Marked place" : "Cams", act.cams], ["Whole joint", act.home]].map(([text, onclick]) => button(text, { onclick }));
  return group("Pose", element("div", { class: "joint3d-buttons" }, viewer.play, ...looks), viewer.tau.row, viewer.torque.row, viewer.words);
}

function sectionGroup(viewer) {
  const options = CUTS.map(([value, text]) => element("option", { value }, text));
  viewer.cut = element("select", { id: "joint3d-cut", onchange: () => viewer.act.section(viewer.cut.value, 0) }, ...options);
  viewer.depth = slider("joint3d-depth", "depth", { min: -1, max: 1, step: 0.005 }, (share) => viewer.act.section(viewer.section.kind, share));
  return fold("Section", element("label", { for: "joint3d-cut" }, "plane "), viewer.cut, viewer.depth.row);
}

function showGroup(viewer) {
  const { act, model } = viewer;
  viewer.explode = slider("joint3d-explode", "explode", { min: 0, max: 1, step: 0.01 }, act.explode);
  const names = [...model.bodies.map((body) => body.name), "cables"];
  const checks = names.map((name) => check(`joint3d-show-${name}`, bodyName(name), !model.hidden.has(name), (on) => act.show(name, on)));
  const bodies = fold("Bodies", element("p", {}, kSidesMeaning), element("div", { class: "joint3d-bodies" }, ...checks));
  viewer.passes = check("joint3d-passes", "places of passed rules too", false, act.passes);
  viewer.measureButton = button("Measure", { "aria-pressed": "false", class: "joint3d-measure", onclick: act.measure });
  return fold("Explode, measure, hide", viewer.explode.row, viewer.passes, viewer.measureButton, bodies);
}

const KEYS = [
  ["arrows", "turn the view"], ["+ and -", "nearer, farther"], ["c", "cams"], ["h", "whole joint"], ["p", "play, stop"], ["x, y, z, v", "section across x, y, the axis, facing the view"],
  ["s", "no section"], ["[ and ]", "depth of the section"], ["e", "explode"], ["m", "measure"], ["n", "next finding"], ["Esc", "end measuring and selection"],
];

function keysHelp() {
  const list = element("dl", { id: "joint3d-keys" });
  for (const [key, text] of KEYS) list.append(element("dt", {}, key), element("dd", {}, text));
  return fold("Keys while the view has the focus", list);
}

export function makePanel(viewer, ...more) {
  return element("div", { class: "joint3d-panel" }, poseGroup(viewer), ...more.slice(0, 1), sectionGroup(viewer), showGroup(viewer), ...more.slice(1), keysHelp());
}

const STEP = Math.PI / 24;

/** @param turn (azimuth, elevation, factor) */
export function listenToKeys(canvas, viewer, turn) {
  const { act } = viewer;
  const section = (kind) => () => act.section(kind, 0);
  const deeper = (by) => () => act.section(viewer.section.kind, Math.max(-1, Math.min(1, viewer.section.share + by)));
  const actions = {
    ArrowLeft: () => turn(-STEP, 0), ArrowRight: () => turn(STEP, 0), ArrowUp: () => turn(0, STEP), ArrowDown: () => turn(0, -STEP),
    "+": () => turn(0, 0, 0.9), "-": () => turn(0, 0, 1 / 0.9), h: act.home, c: act.cams, p: act.play, e: () => act.explode(viewer.model.explode > 0 ? 0 : 1),
    x: section("x"), y: section("y"), z: section("z"), v: section("view"), s: section("off"), "[": deeper(-0.05), "]": deeper(0.05),
    m: act.measure, n: act.nextFinding, Escape: act.escape,
  };
  canvas.addEventListener("keydown", (event) => {
    const action = event.ctrlKey || event.metaKey || event.altKey ? null : actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
