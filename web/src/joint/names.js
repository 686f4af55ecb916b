// The names of what the page marks, else of the cams, beside them in the view.
import { Vector3 } from "three";
import { bodyName } from "../kit/names.js";
import { element } from "./dom.js";

const kBelow_px = 14, kHigh_px = 24, kWide_px = 90;

/** The lowest corner of a body's box as drawn. */
function belowOf({ mesh }, stage, width, height) {
  const { min, max } = mesh.geometry.boundingBox, corners = Array.from({ length: 8 }, (_, i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(mesh.matrixWorld).project(stage.camera));
  const x = corners.reduce((sum, corner) => sum + corner.x, 0) / 8, low = Math.min(...corners.map((corner) => corner.y));
  return { x: (0.5 * x + 0.5) * width, y: (0.5 - 0.5 * low) * height + kBelow_px, seen: corners.every((corner) => corner.z < 1) };
}

export function makeNames({ stage, model, overlay }) {
  const marked = model.bodies.filter((body) => body.data.marked), names = (marked.length ? marked : model.bodies.filter((body) => body.cam)).map((body) => ({ body, made: element("span", { class: "joint3d-name", "aria-hidden": "true" }, bodyName(body.name)) }));
  overlay.prepend(...names.map((name) => name.made));
  stage.after.push(() => {
    const { clientWidth: width, clientHeight: height } = overlay;
    const taken = [];  // a name that would cover another one is left out; one at the edge is read whole
    for (const name of names) name.half = name.made.offsetWidth / 2 || name.half || 0;
    for (const name of names) {
      const { body, made } = name;
      if (!body.mesh.geometry.boundingBox) body.mesh.geometry.computeBoundingBox();
      const at = belowOf(body, stage, width, height), { seen } = at, inside = at.x > 0 && at.x < width && at.y > 0 && at.y < height;
      const x = Math.max(name.half, Math.min(at.x, width - name.half)), y = Math.min(at.y, height - kHigh_px / 2);
      const free = taken.every((other) => Math.abs(other.x - x) > kWide_px || Math.abs(other.y - y) > kHigh_px);
      made.hidden = !(body.mesh.visible && seen && free && inside);
      if (!made.hidden) taken.push({ x, y });
      Object.assign(made.style, { left: `${x}px`, top: `${y}px` });
    }
  });
}
