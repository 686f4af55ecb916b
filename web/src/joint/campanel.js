// The figures at one place of a cam: chosen by a click on the cam, or by its slider.
import { Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from "three";
import { bodyName } from "../kit/names.js";
import { degrees, element, fold, slider } from "./dom.js";

function nearestRow(cam, point) {
  const far = cam.contact_mm.map(([x, y, z]) => Math.hypot(x - point.x, y - point.y, z - point.z));
  return far.indexOf(Math.min(...far));
}

/** How far a value is inside its limit, in percent of the limit; below 0: it breaks the rule. */
export function margin(rule, row) {
  const part = rule.values[row] / rule.allowed - 1;
  return 100 * (rule.bound === "at most" ? -part : part);
}

const digits = (value, count = 4) => (value === null ? "\u2013" : String(Number(value.toPrecision(count))));

function facts(cam, row) {
  return [
    ["cam angle", `${degrees(cam.angle_rad[row]).toFixed(1)} deg`],
    ["arm", `${digits(cam.arm_mm[row])} mm`],
    ["tension", `${digits(cam.tension_N[row])} N`],
    ["load of the law", `${digits(cam.load_Nm[row])} Nm`],
    ["radius of curvature", `${digits(cam.rho_mm[row])} mm`],
  ];
}

function ruleRow(rule, row) {
  const value = rule.values[row];
  const spare = margin(rule, row);
  const cells = [rule.rule, `${digits(value)} ${rule.unit}`, `${rule.bound} ${digits(rule.allowed)} ${rule.unit}`, `${spare.toFixed(0)} %`];
  return element("tr", { "data-rule": rule.rule, class: spare < 0 ? "broken" : null }, ...cells.map((text) => element("td", {}, text)));
}

function table(cam, row) {
  const head = element("tr", {}, ...["rule", "here", "allowed", "margin"].map((name) => element("th", { scope: "col" }, name)));
  return element("table", {}, element("thead", {}, head), element("tbody", {}, ...cam.rules.map((rule) => ruleRow(rule, row))));
}

function wholePart(cam) {
  const list = cam.rules_of_whole_part;
  return element("details", {}, element("summary", {}, `${list.length} rules have one value for the whole part`), element("p", {}, list.join(", ")));
}

function content(cam, row) {
  const list = element("dl", {});
  for (const [name, value] of facts(cam, row)) list.append(element("dt", {}, name), element("dd", {}, value));
  return [list, table(cam, row), wholePart(cam)];
}

export function makeCamPanel({ scene, stage, model, changed }) {
  const mark = new Mesh(new SphereGeometry(1, 16, 12), new MeshBasicMaterial({ color: 0x00a050, depthTest: false }));
  mark.renderOrder = 3000;
  mark.visible = false;
  stage.scene.add(mark);
  const body = element("div", { class: "joint3d-cam", "aria-live": "polite" });
  const names = scene.cams.map((cam) => element("option", { value: cam.part }, bodyName(cam.part)));
  const choice = element("select", { id: "joint3d-cam-part", onchange: () => state.show(`${choice.value}_agonist`, 0) }, ...names);
  const place = slider("joint3d-cam-row", "place", { min: 0, max: 1, step: 1 }, (row) => state.show(state.body ?? `${choice.value}_agonist`, row));
  const label = element("label", { for: "joint3d-cam-part" }, "cam ");
  const state = { body: null, row: null, panel: fold("At a place of a cam", label, choice, place.row, body) };

  state.show = (name, row) => {
    const { cam } = model.find(name);
    Object.assign(state, { body: name, row });
    state.panel.open = true;
    choice.value = cam.part;
    place.input.max = cam.angle_rad.length - 1;
    place.show(row, `${degrees(cam.angle_rad[row]).toFixed(1)} deg`);
    body.replaceChildren(element("h3", {}, bodyName(name)), ...content(cam, row));
    changed();
    stage.invalidate();
  };
  state.pick = (hit) => {
    const own = hit.point.clone().applyMatrix4(hit.solid.mesh.matrixWorld.clone().invert());
    state.show(hit.solid.name, nearestRow(hit.solid.cam, own));
  };
  stage.before.push(() => {
    mark.visible = state.body !== null && model.find(state.body).mesh.visible;
    if (!mark.visible) return;
    const chosen = model.find(state.body);
    mark.position.copy(new Vector3(...chosen.cam.contact_mm[state.row]).applyMatrix4(chosen.mesh.matrix));
    mark.scale.setScalar(stage.camera.position.distanceTo(stage.controls.target) / 200);
  });
  body.append(element("p", {}, "Click a cam, or move the slider."));
  return state;
}
