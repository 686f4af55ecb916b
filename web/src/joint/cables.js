// Lines of the cables in a pose: wound on a cam or from an end, over guides, onto a drum.
import { Vector3 } from "three";

const ARC_POINTS = 32;

const vector = (v) => new Vector3(v[0], v[1], v[2]);

/** The contact at a cam angle, between the rows of its table; in the cam's frame. */
export function contactAt(cam, angle) {
  const angles = cam.angle_rad;
  let i = 0;
  while (i + 2 < angles.length && angle > angles[i + 1]) ++i;
  const t = Math.min(1, Math.max(0, (angle - angles[i]) / (angles[i + 1] - angles[i])));
  return vector(cam.contact_mm[i]).lerp(vector(cam.contact_mm[i + 1]), t);
}

/** From the anchor along the wound rows to the contact; rows that carry no cable stand at the contact. */
function woundLine(cam, angle, matrix) {
  const contact = contactAt(cam, angle);
  const last = cam.wound_end === "last";
  const order = cam.angle_rad.map((_, i) => (last ? cam.angle_rad.length - 1 - i : i));
  const rows = order.map((i) => ((last ? cam.angle_rad[i] > angle : cam.angle_rad[i] < angle) ? vector(cam.contact_mm[i]) : contact.clone()));
  return [...cam.to_anchor_mm.map(vector), ...rows, contact].map((p) => p.applyMatrix4(matrix));
}

function slid(node, channels) {
  const at = vector(node.at_mm);
  return node.slide < 0 ? at : at.addScaledVector(vector(node.direction), channels[node.slide]);
}

function arcLine(arc, channels) {
  const wound = Math.max(0, arc.base_rad + arc.gain * channels[arc.channel]);
  return Array.from({ length: ARC_POINTS }, (_, i) => {
    const angle = arc.start_rad + (arc.direction * wound * (i + 1)) / ARC_POINTS;
    const c = arc.centre_mm;
    return new Vector3(c[0] + arc.radius_mm * Math.cos(angle), c[1] + arc.radius_mm * Math.sin(angle), c[2]);
  });
}

/** @param bodyOf name -> { matrix, angle, cam } of the cam that a cable begins on */
export function cableLine(cable, channels, bodyOf) {
  const from = cable.from ? bodyOf(cable.from) : null;
  const line = from ? woundLine(from.cam, from.angle, from.matrix) : [];
  for (const node of cable.nodes) line.push(slid(node, channels));
  return cable.arc ? [...line, ...arcLine(cable.arc, channels)] : line;
}
