// Findings as buttons on the part, linked with their rows in the page both ways.
import { Vector3 } from "three";
import { partName } from "../kit/names.js";
import { button } from "./dom.js";
import { isCovered } from "./pick.js";

const rowOf = (number) => document.getElementById(`finding-${number}`)?.closest("tr") ?? null;

function markRow(number) {
  for (const row of document.querySelectorAll("tr.joint3d-row")) row.classList.remove("joint3d-row");
  rowOf(number)?.classList.add("joint3d-row");
}

/** Shows a row, also in a folded block. */
function scrollToRow(number) {
  const row = rowOf(number);
  for (let fold = row?.closest("details"); fold; fold = fold.parentElement?.closest("details")) fold.open = true;
  row?.scrollIntoView({ block: "center" });
}

function makeMarker(finding, select) {
  const made = button(String(finding.number), {
    class: `joint3d-marker ${finding.severity}`,
    "data-finding": finding.number,
    "aria-label": `Finding ${finding.number}, ${finding.severity}: ${finding.rule}`,
    "aria-pressed": "false",
    title: `${finding.number}. ${finding.rule}: ${finding.what}`,
    onclick: () => select(finding.number),
  });
  return { finding, made };
}

/** The number in a row becomes a button that shows the place on the part, and so does the line in the head of the page. */
function linkRows(all, select, view) {
  for (const finding of all) {
    const show = (event) => {
      event.preventDefault();
      select(finding.number, true);
      view.scrollIntoView({ block: "nearest" });
    };
    for (const line of document.querySelectorAll(`a.remedy[data-finding="${finding.number}"]`)) line.addEventListener("click", show);
    const number = document.getElementById(`finding-${finding.number}`);
    if (!number) continue;
    const link = button(String(finding.number), { class: "joint3d-link", "aria-label": `Show finding ${finding.number} on the joint in 3D` });
    link.addEventListener("click", show);
    number.replaceChildren(link);
  }
}

const kNear_mm = 150, kTurns = 8, kElevations = [30, -30, 60, -60, 0];  // of the camera from a place, and the ways to look at it [deg]

/** Where the camera sees a place: from the present direction, or the first one from which nothing covers it. */
function seenFrom(at, stage, section, model) {
  const here = stage.direction(), ways = [here], turn = Math.atan2(here.y, here.x), was = stage.camera.position.clone();
  for (const elevation of kElevations) for (let i = 0; i < kTurns; ++i) {
    const rise = (elevation * Math.PI) / 180, round = turn + (i % 2 ? 1 : -1) * Math.ceil(i / 2) * ((2 * Math.PI) / kTurns);
    ways.push(new Vector3(Math.cos(rise) * Math.cos(round), Math.cos(rise) * Math.sin(round), Math.sin(rise)));
  }
  const free = ways.find((way) => {
    stage.camera.position.copy(at).addScaledVector(way, kNear_mm);
    return !isCovered(at, stage, section, model);
  });
  stage.camera.position.copy(was);
  return at.clone().addScaledVector(free ?? here, kNear_mm);
}

export function makeFindings({ scene, stage, section, model, overlay, say, changed }) {
  const state = { selected: null, passes: false };
  const placeOf = (finding) => new Vector3(...finding.point_mm).applyMatrix4(model.find(finding.body).placement);
  state.select = (number, keep = false) => {
    state.selected = number === state.selected && !keep ? null : number;
    markRow(state.selected);
    const finding = scene.findings.find((one) => one.number === state.selected);
    if (finding && finding.severity === "pass") state.passes = true;
    const row = button("Go to its row", { class: "joint3d-go", onclick: () => scrollToRow(number) });
    if (finding) say(`${finding.number}, ${partName(finding.body)}: ${finding.what}. `, row);
    else say("");
    if (finding) stage.fly(placeOf(finding), seenFrom(placeOf(finding), stage, section, model));
    changed();
    stage.invalidate();
  };
  const markers = scene.findings.map((finding) => makeMarker(finding, state.select));
  state.next = () => {
    const shown = markers.filter((marker) => isShown(marker, state)).map((marker) => marker.finding.number);
    if (shown.length > 0) state.select(shown[(shown.indexOf(state.selected) + 1) % shown.length]);
  };
  overlay.append(...markers.map((marker) => marker.made));
  linkRows(scene.findings, state.select, overlay.parentElement);
  const leaders = document.createElementNS(kSvg, "svg");
  leaders.setAttribute("aria-hidden", "true");
  overlay.prepend(leaders);
  stage.after.push(() => {
    const shown = markers.filter((marker) => placeMarker(marker, state, stage, section, model));
    spread(shown, overlay.clientWidth, overlay.clientHeight);
    for (const { made, at } of shown) Object.assign(made.style, { left: `${at.x}px`, top: `${at.y}px` });
    leaders.innerHTML = shown.map(({ place, at }) => `<path d="M${place.x.toFixed(1)} ${place.y.toFixed(1)}L${at.x.toFixed(1)} ${at.y.toFixed(1)}"/>`).join("");
  });
  return state;
}

const kSvg = "http://www.w3.org/2000/svg", kApart = 28, kEdge = 16, kPasses = 60;  // [px]
const isShown = ({ finding }, state) => finding.severity !== "pass" || state.passes || finding.number === state.selected;

/** Sets `place`, where the finding lies in the view; false if its button is hidden. */
function placeMarker(marker, state, stage, section, model) {
  const { finding, made } = marker, body = model.find(finding.body), at = new Vector3(...finding.point_mm).applyMatrix4(body.placement);
  const covered = isShown(marker, state) && isCovered(at, stage, section, model), selected = finding.number === state.selected, screen = at.project(stage.camera);
  const inside = Math.abs(screen.x) <= 1 && Math.abs(screen.y) <= 1 && screen.z < 1, shown = isShown(marker, state) && body.mesh.visible && inside;
  made.hidden = !shown;
  if (!shown) return false;
  const { clientWidth: width, clientHeight: height } = made.parentElement;
  marker.place = { x: (screen.x * 0.5 + 0.5) * width, y: (0.5 - screen.y * 0.5) * height };
  made.classList.toggle("covered", covered && !selected);
  made.setAttribute("aria-pressed", String(selected));
  return true;
}

/** Moves buttons apart that would hide each other, and into the view. Sets `at`. */
function spread(markers, width, height) {
  for (const marker of markers) marker.at = { ...marker.place };
  for (let pass = 0, moved = true; moved && pass < kPasses; ++pass) {
    moved = false;
    markers.forEach(({ at: a }, i) => markers.slice(i + 1).forEach(({ at: b }, k) => {
      const far = Math.hypot(b.x - a.x, b.y - a.y), lack = kApart - far;
      if (lack <= 0.5) return;
      const angle = far > 0.01 ? Math.atan2(b.y - a.y, b.x - a.x) : 2.4 * (i + k), dx = 0.5 * lack * Math.cos(angle), dy = 0.5 * lack * Math.sin(angle);
      Object.assign(a, { x: a.x - dx, y: a.y - dy });
      Object.assign(b, { x: b.x + dx, y: b.y + dy });
      moved = true;
    }));
    for (const { at } of markers) Object.assign(at, { x: Math.min(width - kEdge, Math.max(kEdge, at.x)), y: Math.min(height - kEdge, Math.max(kEdge, at.y)) });
  }
}
