// window.fuseeScene: the state of the view, for tests and for scripts.
import { degrees } from "./dom.js";

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

export function makeHook(viewer) {
  const { model, stage, section, measure, findings, cams, act, state } = viewer;
  return {
    ready: true,
    act,
    drawnShare: () => drawnShare(stage),
    get state() {
      return {
        tau_Nm: state.tau, share: state.share, torque_Nm: state.torque, joint_deg: degrees(state.channels[8]), channels: [...state.channels],
        angles_deg: Object.fromEntries(model.bodies.map((body) => [body.name, degrees(body.data.gain * body.angle)])),
        matrices: Object.fromEntries(model.bodies.map((body) => [body.name, body.placement.toArray()])),
        finding: findings.selected, explode: model.explode, hidden: [...model.hidden], section: { kind: section.kind, share: section.share },
        measure: { on: measure.on, mm: measure.mm, points: measure.points.map((p) => p.toArray()) }, cam: { body: cams.body, row: cams.row },
      };
    },
  };
}
