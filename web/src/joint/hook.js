// window.fuseeScene: the state of the view, for tests and for scripts.
import { Ray, Vector3 } from "three";
import { degrees } from "./dom.js";
import { pickAlong } from "./pick.js";

/** Share of the view's pixels that are not background. */
function drawnShare(stage) {
  const gl = stage.renderer.getContext();
  stage.draw();
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let drawn = 0;
  for (let i = 3; i < pixels.length; i += 4) drawn += pixels[i] > 0 ? 1 : 0;
  return (4 * drawn) / pixels.length;
}

/** Is every shown body inside the view? */
function fits({ model, stage }) {
  const inside = ({ x, y }) => Math.abs(x) <= 1 && Math.abs(y) <= 1;
  return model.solids().every(({ mesh }) => {
    const { min, max } = mesh.geometry.boundingBox;
    return Array.from({ length: 8 }, (_, i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(mesh.matrixWorld).project(stage.camera)).every(inside);
  });
}

/** Is a body seen: does a ray from the camera to some place of its box meet it first? */
function sees({ model, stage, section }, name) {
  const { mesh } = model.find(name), { min, max } = mesh.geometry.boundingBox, shares = [0.1, 0.3, 0.5, 0.7, 0.9], eye = stage.camera.position;
  const places = shares.flatMap((x) => shares.flatMap((y) => shares.map((z) => new Vector3(x, y, z).multiply(max.clone().sub(min)).add(min).applyMatrix4(mesh.matrixWorld))));
  return places.some((place) => pickAlong(new Ray(eye.clone(), place.sub(eye).normalize()), section, model)?.solid.mesh === mesh);
}

export function makeHook(viewer) {
  const { model, stage, section, measure, findings, cams, act, state } = viewer;
  return {
    ready: true,
    act,
    drawnShare: () => drawnShare(stage),
    fits: () => fits(viewer),
    sees: (name) => sees(viewer, name),
    get state() {
      return {
        tau_Nm: state.tau, share: state.share, torque_Nm: state.torque, joint_deg: degrees(state.channels[8]), channels: [...state.channels],
        angles_deg: Object.fromEntries(model.bodies.map((body) => [body.name, degrees(body.data.gain * body.angle)])),
        matrices: Object.fromEntries(model.bodies.map((body) => [body.name, body.placement.toArray()])),
        marked: model.bodies.filter((body) => body.data.marked).map((body) => body.name), finding: findings.selected, playing: viewer.player.on, explode: model.explode, hidden: [...model.hidden], section: { kind: section.kind, share: section.share },
        measure: { on: measure.on, mm: measure.mm, points: measure.points.map((p) => p.toArray()) }, cam: { body: cams.body, row: cams.row },
      };
    },
  };
}
