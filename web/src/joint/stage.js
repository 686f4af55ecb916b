// Renderer, camera and light. A frame is drawn only when something has changed.
import { AmbientLight, Box3, DirectionalLight, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const UP = new Vector3(0, 0, 1);
const AZIMUTH = (-55 * Math.PI) / 180; // those of assembly_view.svg
const ELEVATION = (32 * Math.PI) / 180;

function makeRenderer(canvas) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
  renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
  renderer.localClippingEnabled = true;
  renderer.setClearAlpha(0);
  return renderer;
}

/** The wheel scrolls the page until the view has the focus; so does one finger that moves up or down, while one that moves sideways turns the joint. */
function makeControls(camera, canvas) {
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.enableZoom = false;
  canvas.style.touchAction = "pan-y";
  canvas.addEventListener("focus", () => (controls.enableZoom = true));
  canvas.addEventListener("blur", () => (controls.enableZoom = false));
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  return controls;
}

function makeLights(scene, camera) {
  const key = new DirectionalLight(0xffffff, 2.2);
  key.position.set(0.4, 0.7, 1);
  camera.add(key, key.target);
  key.target.position.set(0, 0, -1);
  scene.add(camera, new AmbientLight(0xffffff, 1.1));
}

export function sphereOf(object) {
  return new Box3().setFromObject(object).getBoundingSphere(new Sphere());
}

/** The direction from the joint to the viewer. */
const homeDirection = () =>
  new Vector3(Math.cos(ELEVATION) * Math.cos(AZIMUTH), Math.cos(ELEVATION) * Math.sin(AZIMUTH), Math.sin(ELEVATION));

export function makeStage(canvas, group) {
  const renderer = makeRenderer(canvas);
  const scene = new Scene();
  const camera = new PerspectiveCamera(32, 1, 1, 10000);
  camera.up.copy(UP);
  makeLights(scene, camera);
  scene.add(group);
  const controls = makeControls(camera, canvas);
  const stage = { renderer, scene, camera, controls, canvas, before: [], after: [] };
  let due = false;
  stage.draw = () => {
    due = false;
    for (const step of stage.before) step();
    renderer.render(scene, camera);
    for (const step of stage.after) step();
  };
  stage.invalidate = () => {
    if (!due) requestAnimationFrame(stage.draw);
    due = true;
  };
  controls.addEventListener("change", stage.invalidate);
  controls.addEventListener("start", () => (stage.framed = null));
  stage.frame = (meshes, direction = homeDirection()) => {
    stage.framed = () => look(stage, meshes(), direction);  // again at another size of the view
    stage.framed();
  };
  stage.direction = () => camera.position.clone().sub(controls.target).normalize();
  stage.fly = (target, position) => fly(stage, target, position);
  new ResizeObserver(() => resize(stage)).observe(canvas.parentElement);
  resize(stage);
  stage.frame(() => group.children);
  return stage;
}

const FLIGHT_MS = 450;

/** Moves the camera to a place; at once for readers who want no motion. */
function fly(stage, target, position) {
  const { camera, controls } = stage, from = { target: controls.target.clone(), position: camera.position.clone() }, begin = performance.now();
  const ms = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : FLIGHT_MS, flight = (stage.flight = {});
  stage.framed = null;
  const step = (now) => {
    if (stage.flight !== flight) return;
    const t = ms ? Math.min(1, Math.max(0, (now - begin) / ms)) : 1, eased = t * t * (3 - 2 * t);
    controls.target.lerpVectors(from.target, target, eased);
    camera.position.lerpVectors(from.position, position, eased);
    camera.near = camera.position.distanceTo(controls.target) / 50;
    camera.updateProjectionMatrix();
    controls.update();
    stage.invalidate();
    if (t < 1) requestAnimationFrame(step);
  };
  step(begin);
}

/** The corners of the boxes of all shown meshes, from the view's centre along right, up and towards the viewer. */
function cornersSeen(meshes, centre, axes) {
  const corners = [];
  for (const mesh of meshes) {
    mesh.updateMatrixWorld(true);
    if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
    const { min, max } = mesh.geometry.boundingBox;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(mesh.matrixWorld).sub(centre);
      corners.push(axes.map((axis) => corner.dot(axis)));
    }
  }
  return corners;
}

/** Looks along a direction from so far that every shown mesh is seen. */
function look(stage, all, direction) {
  const { camera, controls } = stage, meshes = all.filter((one) => one.visible);
  if (!meshes.length) return;
  stage.flight = null;
  const right = new Vector3().crossVectors(UP, direction).normalize();
  const axes = [right, new Vector3().crossVectors(direction, right), direction];
  const centre = controls.target.clone();
  const corners = cornersSeen(meshes, centre, axes);
  const middle = [0, 1].map((k) => (Math.min(...corners.map((c) => c[k])) + Math.max(...corners.map((c) => c[k]))) / 2);
  const slope = Math.tan(((camera.fov / 2) * Math.PI) / 180);
  const needed = ([x, y, z]) => z + Math.max(Math.abs(x - middle[0]) / (slope * camera.aspect), Math.abs(y - middle[1]) / slope);
  const distance = 1.06 * Math.max(...corners.map(needed));
  controls.target.copy(centre).addScaledVector(axes[0], middle[0]).addScaledVector(axes[1], middle[1]);
  camera.position.copy(controls.target).addScaledVector(direction, distance);
  camera.near = distance / 50;
  camera.far = distance * 20;
  camera.updateProjectionMatrix();
  controls.update();
  stage.invalidate();
}

function resize(stage) {
  const { width, height } = stage.canvas.parentElement.getBoundingClientRect();
  if (width < 1 || height < 1) return;
  stage.renderer.setSize(width, height, false);
  stage.camera.aspect = width / height;
  stage.camera.updateProjectionMatrix();
  stage.framed?.();
  stage.invalidate();
}

/** Turns the camera about the joint [rad], or moves it nearer (factor below 1). */
export function orbit(stage, azimuth, elevation, factor = 1) {
  const { camera, controls } = stage;
  const arm = camera.position.clone().sub(controls.target).applyAxisAngle(UP, azimuth);
  const level = new Vector3().crossVectors(UP, arm).normalize();
  const angle = arm.angleTo(UP) - elevation;
  if (angle > 0.05 && angle < Math.PI - 0.05) arm.applyAxisAngle(level, -elevation);
  camera.position.copy(controls.target).addScaledVector(arm, factor);
  stage.framed = null;
  controls.update();
  stage.invalidate();
}
