// The scene of the page as typed arrays and three.js geometries.
import { BufferAttribute, BufferGeometry } from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { MeshBVH } from "three-mesh-bvh";

const CREASE = (35 * Math.PI) / 180; // sharper edges stay edges

function bytes(base64) {
  const text = atob(base64);
  const out = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) out[i] = text.charCodeAt(i);
  return out.buffer;
}

/** Coordinates [mm] of a packed mesh: low + count * step. */
export function unpackPoints(packed) {
  const counts = new Uint16Array(bytes(packed.points));
  return Float32Array.from(counts, (count, i) => packed.low_mm[i % 3] + count * packed.step_mm[i % 3]);
}

/** A packed mesh as a geometry with a bounding volume hierarchy. */
export function geometryOf(packed) {
  const indexed = new BufferGeometry();
  const triangles = bytes(packed.triangles);
  indexed.setAttribute("position", new BufferAttribute(unpackPoints(packed), 3));
  indexed.setIndex(new BufferAttribute(packed.wide ? new Uint32Array(triangles) : new Uint16Array(triangles), 1));
  const geometry = toCreasedNormals(indexed, CREASE);
  geometry.boundsTree = new MeshBVH(geometry);
  return geometry;
}

const PALE = "#c9ced6"; // of what is not marked

/** The scene with what the page tells about it: places of findings, and the colours of marked bodies and cables. */
export function readScene() {
  const element = document.getElementById("joint-scene");
  if (!element) return null;
  const scene = JSON.parse(element.textContent), { places = [], marks = null } = window.fusee;
  scene.findings = places;
  if (marks) for (const one of [...scene.bodies, ...scene.cables]) Object.assign(one, { colour: marks[one.name] ?? PALE, marked: one.name in marks });
  return scene;
}
