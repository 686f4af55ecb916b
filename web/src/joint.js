// The joint in 3D. Needs page.js before it, the scene in #joint-scene, and a section [data-joint3d].
import { makeCamPanel } from "./joint/campanel.js";
import { deadBandAt, makeCurves } from "./joint/curves.js";
import { readScene } from "./joint/data.js";
import { degrees, element } from "./joint/dom.js";
import { makeFindings } from "./joint/findings.js";
import { makeHook } from "./joint/hook.js";
import { makeMeasure } from "./joint/measure.js";
import { makeModel } from "./joint/model.js";
import { listenToKeys, makePanel } from "./joint/panel.js";
import { listenToPointer } from "./joint/pointer.js";
import { makePoses } from "./joint/pose.js";
import { makeSection } from "./joint/section.js";
import { makePlayer } from "./joint/play.js";
import { makeNames } from "./joint/names.js";
import { makeStage, orbit } from "./joint/stage.js";

function hasWebGL() {
  try {
    return document.createElement("canvas").getContext("webgl2") !== null;
  } catch {
    return false;
  }
}

function makeFrame(root) {
  const canvas = element("canvas", {
    tabindex: 0, role: "application", "aria-label": "The joint in 3D. Arrow keys turn it; more keys are listed below.", "aria-describedby": "joint3d-keys",
  });
  const tip = element("div", { class: "joint3d-tip", hidden: true, "aria-hidden": "true" });
  const overlay = element("div", { class: "joint3d-overlay", role: "group", "aria-label": "Findings on the joint" });
  const said = element("p", { class: "joint3d-said", role: "status" });
  const frame = element("div", { class: "joint3d-frame" }, canvas, overlay, tip);
  root.querySelector(".joint3d-view").append(element("div", { class: "joint3d-left" }, frame, said));
  return { canvas, tip, overlay, frame, say: (...what) => said.replaceChildren(...what) };
}

function poseWords(scene, state) {
  const band = deadBandAt(scene, state.tau);
  const held = band === null ? "The law does not give the dead-band at this co-contraction." : `Stiction holds it within ${band.toFixed(1)} deg.`;
  return `The joint rests at ${degrees(state.channels[8]).toFixed(2)} deg without friction. ${held}`;
}

function applyPose(viewer) {
  const { state, poses, scene, root } = viewer;
  state.torque = state.share * poses.most(state.tau);
  state.channels = poses.at(state.tau, state.share);
  viewer.model.pose(state.channels, viewer.model.explode);
  viewer.measure?.clear();
  viewer.tau.show(state.tau, `${state.tau.toFixed(3)} Nm`);
  viewer.torque.show(state.share, `${state.torque.toFixed(3)} Nm`);
  viewer.words.textContent = poseWords(scene, state);
  viewer.curves.update();
  Object.assign(root.dataset, { tau: state.tau, torque: state.torque, joint: degrees(state.channels[8]) });
  viewer.stage.invalidate();
}

/** What the page marks, else cams and spools of both sides; the whole joint where none is shown. */
function camMeshes({ bodies, group }) {
  const marked = bodies.filter((body) => body.data.marked && body.mesh.visible), meshes = (marked.length ? marked : bodies.filter((body) => body.cam && body.mesh.visible)).map((body) => body.mesh);
  return meshes.length ? meshes : group.children;
}

function makeActions(viewer) {
  const { state, model, stage } = viewer;
  const measure = () => {
    viewer.measure.toggle();
    viewer.measureButton.setAttribute("aria-pressed", String(viewer.measure.on));
  };
  return {
    measure,
    tau: (value) => { viewer.player.stop(); viewer.setTau(value); },
    share: (value) => { state.share = value; applyPose(viewer); },
    section: (kind, share) => {
      viewer.section.set(kind, share);
      viewer.cut.value = kind;
      viewer.depth.show(share, kind === "off" ? "" : `${Math.round(100 * share)} %`);
    },
    play: () => viewer.player.toggle(),
    explode: (value) => {
      model.pose(state.channels, value);
      viewer.measure.clear();
      viewer.explode.show(value, `${Math.round(100 * value)} %`);
      stage.frame(() => model.group.children, stage.direction());
    },
    show: (name, on) => { model.hidden[on ? "delete" : "add"](name); model.show(); stage.invalidate(); },
    passes: (on) => { viewer.findings.passes = on; stage.invalidate(); },
    home: () => stage.frame(() => model.group.children),
    cams: () => stage.frame(() => camMeshes(model)),
    finding: (number) => viewer.findings.select(number),
    nextFinding: () => viewer.findings.next(),
    cam: (body, row) => viewer.cams.show(body, row),
    escape: () => {
      if (viewer.measure.on) measure();
      if (viewer.findings.selected !== null) viewer.findings.select(viewer.findings.selected);
    },
  };
}

function clicked(viewer, hit) {
  if (!hit) return;
  if (viewer.measure.on) viewer.measure.add(hit);
  else if (hit.solid.cam && !hit.cut) viewer.cams.pick(hit);
}

function makeViewer(root, scene) {
  const frame = makeFrame(root);
  const poses = makePoses(scene);
  const state = { tau: poses.tau[0], share: 0, torque: 0, channels: poses.at(poses.tau[0], 0) };
  const model = makeModel(scene);
  const stage = makeStage(frame.canvas, model.group);
  const section = makeSection(stage, model);
  const viewer = { root, scene, poses, state, model, stage, section, tip: frame.tip };
  const changed = () => (root.dataset.finding = viewer.findings?.selected ?? "");
  viewer.measure = makeMeasure(stage, frame.say);
  viewer.findings = makeFindings({ scene, stage, section, model, overlay: frame.overlay, say: frame.say, changed });
  makeNames({ stage, model, overlay: frame.overlay });
  viewer.cams = makeCamPanel({ scene, stage, model, changed });
  viewer.curves = makeCurves(scene, state);
  viewer.setTau = (value) => { state.tau = value; applyPose(viewer); };
  viewer.player = makePlayer(viewer);
  viewer.act = makeActions(viewer);
  root.querySelector(".joint3d-view").append(makePanel(viewer, viewer.curves.element, viewer.cams.panel));
  listenToPointer(viewer, (hit) => clicked(viewer, hit));
  listenToKeys(frame.canvas, viewer, (...by) => orbit(stage, ...by));
  return viewer;
}

/** The drawing along the axis is folded on screen and shown on paper. */
function printDrawing(root) {
  const drawing = root.querySelector(".joint3d-drawing");
  let was = false;
  addEventListener("beforeprint", () => { was = drawing.open; drawing.open = true; });
  addEventListener("afterprint", () => (drawing.open = was));
}

/** Without WebGL the drawing stands in for the view. */
function showDrawing(root) {
  root.querySelector(".joint3d-view").hidden = true;
  root.querySelector(".joint3d-status").hidden = false;
  root.querySelector(".joint3d-drawing").open = true;
}

function start() {
  const root = document.querySelector("[data-joint3d]");
  if (!root) return;
  const scene = readScene();
  if (!scene || !hasWebGL()) return showDrawing(root);
  const viewer = makeViewer(root, scene);
  viewer.curves.start();
  applyPose(viewer);
  viewer.act.explode(0);
  viewer.act.section("off", 0);
  viewer.act.cams();
  root.querySelector(".joint3d-status").remove();
  printDrawing(root);
  window.fuseeScene = makeHook(viewer);
  root.dataset.joint3d = "ready";
}

if (document.readyState === "loading") addEventListener("DOMContentLoaded", start);
else start();
