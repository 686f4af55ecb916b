// A section at any plane: bodies are clipped, and their cut faces filled by stencil.
import {
  AlwaysStencilFunc, BackSide, DecrementWrapStencilOp, FrontSide, Group, IncrementWrapStencilOp, Mesh, MeshBasicMaterial,
  MeshStandardMaterial, NotEqualStencilFunc, Plane, PlaneGeometry, ReplaceStencilOp, Vector3,
} from "three";
import { sphereOf } from "./stage.js";

const NORMALS = { x: [-1, 0, 0], y: [0, 1, 0], z: [0, 0, -1] }; // the viewer's side is cut away

/** Counts faces behind the plane's cut: back faces up, front faces down. What is not 0 is inside the body. */
function counter(solid, plane, side, op, order) {
  const material = new MeshBasicMaterial({ side, clippingPlanes: [plane], depthWrite: false, depthTest: false, colorWrite: false });
  Object.assign(material, { stencilWrite: true, stencilFunc: AlwaysStencilFunc, stencilFail: op, stencilZFail: op, stencilZPass: op });
  const mesh = new Mesh(solid.mesh.geometry, material);
  mesh.matrixAutoUpdate = false;
  mesh.matrix = solid.mesh.matrix;
  mesh.renderOrder = order;
  mesh.raycast = () => {};
  return mesh;
}

function makeCap(solid, face, order) {
  const material = new MeshStandardMaterial({ color: solid.mesh.material.color.clone().multiplyScalar(0.8), roughness: 0.9 });
  Object.assign(material, { side: 2, stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc });
  Object.assign(material, { stencilFail: ReplaceStencilOp, stencilZFail: ReplaceStencilOp, stencilZPass: ReplaceStencilOp });
  const cap = new Mesh(face, material);
  cap.onAfterRender = (renderer) => renderer.clearStencil();
  cap.renderOrder = order;
  cap.raycast = () => {};
  return cap;
}

/** The three meshes that draw the cut of one solid. */
function cutOf(solid, plane, face, order) {
  const cap = makeCap(solid, face, order + 0.2);
  const parts = [
    counter(solid, plane, BackSide, IncrementWrapStencilOp, order),
    counter(solid, plane, FrontSide, DecrementWrapStencilOp, order + 0.1),
    cap,
  ];
  return { solid, cap, parts };
}

export function makeSection(stage, model) {
  const plane = new Plane(new Vector3(0, 0, -1), 0);
  const caps = new Group();
  const face = new PlaneGeometry(2000, 2000);
  const solids = [...model.bodies, ...model.cables];
  const section = { plane, kind: "off", share: 0, get on() { return section.kind !== "off"; } };
  let cuts = [];
  stage.scene.add(caps);

  section.set = (kind, share) => {
    if (kind === "view" && section.kind !== "view") plane.normal.copy(stage.camera.getWorldDirection(new Vector3()));
    if (NORMALS[kind]) plane.normal.set(...NORMALS[kind]);
    Object.assign(section, { kind, share });
    const sphere = sphereOf(model.group);
    plane.constant = -plane.normal.dot(sphere.center) - share * sphere.radius;
    if (section.on && cuts.length === 0) {
      cuts = solids.map((solid, i) => cutOf(solid, plane, face, 1 + i));
      caps.add(...cuts.flatMap((cut) => cut.parts));
    }
    for (const solid of solids) {
      solid.mesh.material.clippingPlanes = section.on ? [plane] : null;
      solid.mesh.renderOrder = section.on ? 1000 : 0;
    }
    stage.invalidate();
  };
  stage.before.push(() => {
    caps.visible = section.on;
    for (const { solid, cap, parts } of cuts) {
      for (const part of parts) part.visible = solid.mesh.visible;
      plane.coplanarPoint(cap.position);
      cap.lookAt(cap.position.clone().sub(plane.normal));
      for (const part of parts.slice(0, 2)) part.matrixWorldNeedsUpdate = true;
    }
  });
  return section;
}
