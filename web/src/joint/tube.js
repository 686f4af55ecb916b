// Tubes along lines: cables, and coils of springs. The topology stays, so that a new pose only moves vertices.
import { BufferAttribute, BufferGeometry, Vector3 } from "three";

function tubeIndex(points, sides) {
  const index = [];
  for (let i = 0; i + 1 < points; ++i)
    for (let k = 0; k < sides; ++k) {
      const a = i * sides + k;
      const b = i * sides + ((k + 1) % sides);
      index.push(a, b, b + sides, a, b + sides, a + sides);
    }
  const end = (points - 1) * sides;
  for (let k = 1; k + 1 < sides; ++k) index.push(0, k + 1, k, end, end + k, end + k + 1);
  return index;
}

export function tubeGeometry(points, sides = 8) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * points * sides), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(3 * points * sides), 3));
  geometry.setIndex(tubeIndex(points, sides));
  geometry.userData = { points, sides };
  return geometry;
}

const along = new Vector3();
const across = new Vector3();
const up = new Vector3();
const offset = new Vector3();

/** Puts the rings of a tube on a line of as many points; points that coincide keep the direction of those before. */
export function setTube(geometry, line, radius) {
  const { points, sides } = geometry.userData;
  const position = geometry.attributes.position;
  const normal = geometry.attributes.normal;
  across.set(0, 0, 0);
  for (let i = 0; i < points; ++i) {
    offset.subVectors(line[Math.min(i + 1, points - 1)], line[Math.max(i - 1, 0)]);
    if (offset.lengthSq() > 1e-12) along.copy(offset).normalize();
    across.addScaledVector(along, -across.dot(along));
    if (across.lengthSq() < 1e-6) across.set(Math.abs(along.z) < 0.9 ? 0 : 1, 0, Math.abs(along.z) < 0.9 ? 1 : 0).addScaledVector(along, -along.z);
    across.normalize();
    up.crossVectors(along, across);
    for (let k = 0; k < sides; ++k) {
      const angle = (2 * Math.PI * k) / sides;
      offset.copy(across).multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
      normal.setXYZ(i * sides + k, offset.x, offset.y, offset.z);
      position.setXYZ(i * sides + k, line[i].x + radius * offset.x, line[i].y + radius * offset.y, line[i].z + radius * offset.z);
    }
  }
  position.needsUpdate = normal.needsUpdate = true;
  geometry.computeBoundingSphere();
  geometry.computeBoundingBox();
}

export const coilPoints = (coil) => Math.ceil(coil.turns * 30) + 1;

/** The line of a spring: a torsion spring has more and narrower turns as it is wound, a compression spring less length. */
export function coilLine(coil, channels) {
  const count = coilPoints(coil);
  const wound = coil.winds_with >= 0 ? channels[coil.winds_with] : 0;
  const turns = coil.turns + wound / (2 * Math.PI);
  const radius = (coil.radius_mm * coil.turns) / turns;
  const length = coil.length_mm - (coil.shortens_with >= 0 ? channels[coil.shortens_with] : 0);
  const hand = coil.left ? -1 : 1;
  return Array.from({ length: count }, (_, i) => {
    const share = i / (count - 1);
    const angle = hand * (2 * Math.PI * turns * share - wound); // the far end, at the carriage, stays
    return new Vector3(radius * Math.cos(angle), radius * Math.sin(angle), 0.5 * coil.wire_mm + share * (length - coil.wire_mm));
  });
}
