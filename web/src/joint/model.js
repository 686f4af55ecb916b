// The joint as three.js objects, and its pose.
import { Color, DoubleSide, Group, Matrix4, Mesh, MeshStandardMaterial, Vector3 } from "three";
import { acceleratedRaycast } from "three-mesh-bvh";
import { cableLine } from "./cables.js";
import { geometryOf } from "./data.js";
import { coilLine, coilPoints, setTube, tubeGeometry } from "./tube.js";

const CABLE_COLOUR = "#b03030";
const CABLES = "cables";

const mirrorOf = (axis) => new Matrix4().makeScale(axis === "x" ? -1 : 1, axis === "y" ? -1 : 1, 1);

function material(colour) {
  return new MeshStandardMaterial({ color: new Color(colour), roughness: 0.55, metalness: 0.1, side: DoubleSide });
}

function makeMesh(data, geometries) {
  const coil = data.coil;
  const geometry = coil ? tubeGeometry(coilPoints(coil)) : geometries[data.mesh];
  const mesh = new Mesh(geometry, material(data.colour));
  mesh.matrixAutoUpdate = false;
  mesh.name = data.name;
  if (!coil) mesh.raycast = acceleratedRaycast;
  return mesh;
}

function makeBody(data, scene, geometries) {
  return {
    name: data.name,
    data,
    mesh: makeMesh(data, geometries),
    cam: scene.cams.find((cam) => cam.part === data.mesh) ?? null,
    rest: new Matrix4().fromArray(data.rest),
    // Coils are made for their side: their frame stands in for the mirror image.
    shape: data.coil ? new Matrix4().fromArray(data.coil.frame) : mirrorOf(data.mirror),
    placement: new Matrix4(), // from the body's own frame, without the mirror image
    angle: 0,
  };
}

/** From the body's own frame to the assembly: rest, turned about its own z, slid. */
export function placeBody(body, channels, explode) {
  const { data } = body;
  body.angle = data.turn >= 0 ? channels[data.turn] : 0;
  const shift = new Vector3(...data.apart_mm).multiplyScalar(explode);
  if (data.slide >= 0) shift.addScaledVector(new Vector3(...data.direction), channels[data.slide]);
  body.placement.makeTranslation(shift).multiply(body.rest).multiply(new Matrix4().makeRotationZ(data.gain * body.angle));
  body.mesh.matrix.multiplyMatrices(body.placement, body.shape);
  body.mesh.matrixWorldNeedsUpdate = true;
}

function makeCables(scene, bodyOf, channels) {
  const radius = scene.cable_mm / 2;
  return scene.cables.map((data) => {
    const mesh = new Mesh(tubeGeometry(cableLine(data, channels, bodyOf).length), material(data.colour ?? CABLE_COLOUR));
    mesh.name = data.name;
    return { name: data.name, data, mesh, pose: (at) => setTube(mesh.geometry, cableLine(data, at, bodyOf), radius) };
  });
}

export function makeModel(scene) {
  const geometries = {};
  for (const [name, packed] of Object.entries(scene.meshes)) geometries[name] = geometryOf(packed);
  const group = new Group();
  const bodies = scene.bodies.map((data) => makeBody(data, scene, geometries));
  const find = (name) => bodies.find((body) => body.name === name);
  const bodyOf = (name) => ({ matrix: find(name).mesh.matrix, angle: find(name).angle, cam: find(name).cam });
  const hidden = new Set(["frame_plate", "frame_rear"]); // which would hide the joint from above, and the spools from the motors
  const model = { group, bodies, cables: [], hidden, find, channels: [], explode: 0 };

  model.pose = (channels, explode) => {
    Object.assign(model, { channels, explode });
    for (const body of bodies) {
      if (body.data.coil) setTube(body.mesh.geometry, coilLine(body.data.coil, channels), body.data.coil.wire_mm / 2);
      placeBody(body, channels, explode);
    }
    for (const cable of model.cables) if (explode === 0) cable.pose(channels);
    model.show();
  };
  model.show = () => {
    for (const body of bodies) body.mesh.visible = !hidden.has(body.name);
    for (const cable of model.cables) cable.mesh.visible = explode0(model) && !hidden.has(CABLES);
  };
  model.solids = () => [...bodies, ...model.cables].filter((solid) => solid.mesh.visible);

  const zero = new Array(9).fill(0);
  model.pose(zero, 0);
  model.cables = makeCables(scene, bodyOf, zero);
  group.add(...bodies.map((body) => body.mesh), ...model.cables.map((cable) => cable.mesh));
  return model;
}

const explode0 = (model) => model.explode === 0; // cables have no place between bodies that are moved apart
