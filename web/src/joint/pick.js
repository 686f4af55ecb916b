// What a ray from the camera meets first: a surface, or the face of the section.
import { DoubleSide, Ray, Raycaster, Vector2, Vector3 } from "three";

const raycaster = new Raycaster();
const local = new Ray();

/** Is a point inside a body? A ray from there leaves a closed surface an odd number of times. */
function isInside(body, point) {
  const tree = body.mesh.geometry.boundsTree;
  if (!tree) return false;
  local.origin.copy(point).applyMatrix4(body.mesh.matrixWorld.clone().invert());
  local.direction.set(0.3713, 0.5571, 0.7428); // no axis, so that no edge of a box is met
  return tree.raycast(local, DoubleSide).length % 2 === 1;
}

function onCut(ray, section, model, nearest) {
  if (!section.on || section.plane.distanceToPoint(ray.origin) >= 0) return null;
  const point = ray.intersectPlane(section.plane, new Vector3());
  if (!point || point.distanceTo(ray.origin) >= nearest) return null;
  const solid = model.solids().find((one) => one.data.mesh && isInside(one, point));
  return solid ? { solid, point, cut: true } : null;
}

/** @returns { solid, point, cut } in the assembly's frame, or null */
export function pickAlong(ray, section, model) {
  raycaster.ray.copy(ray);
  raycaster.near = 0;
  raycaster.far = Infinity;
  const solids = model.solids();
  const hits = raycaster.intersectObjects(solids.map((solid) => solid.mesh), false);
  const kept = hits.find((hit) => !section.on || section.plane.distanceToPoint(hit.point) >= 0);
  const surface = kept ? { solid: solids.find((solid) => solid.mesh === kept.object), point: kept.point.clone(), cut: false } : null;
  return onCut(ray, section, model, kept ? kept.distance : Infinity) ?? surface;
}

/** @param event of a pointer on the canvas */
export function pickAt(event, stage, section, model) {
  const box = stage.canvas.getBoundingClientRect();
  const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  raycaster.setFromCamera(at, stage.camera);
  return pickAlong(raycaster.ray.clone(), section, model);
}

/** Does anything stand between the camera and a point? @param slack [mm] for points just below a surface */
export function isCovered(point, stage, section, model, slack = 2) {
  const origin = stage.camera.position;
  const hit = pickAlong(new Ray(origin.clone(), point.clone().sub(origin).normalize()), section, model);
  return hit !== null && hit.point.distanceTo(origin) < point.distanceTo(origin) - slack;
}
