// Findings as buttons on the part, linked with their rows in the page both ways.
import { Vector3 } from "three";
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

/** The number in a row becomes a button that shows the place on the part. */
function linkRows(all, select, view) {
  for (const finding of all) {
    const number = document.getElementById(`finding-${finding.number}`);
    if (!number) continue;
    const show = () => {
      select(finding.number);
      view.scrollIntoView({ block: "nearest" });
    };
    const link = button(String(finding.number), { class: "joint3d-link", "aria-label": `Show finding ${finding.number} on the joint in 3D` });
    link.addEventListener("click", show);
    number.replaceChildren(link);
  }
}

export function makeFindings({ scene, stage, section, model, overlay, say, changed }) {
  const state = { selected: null, passes: false };
  state.select = (number) => {
    state.selected = number === state.selected ? null : number;
    markRow(state.selected);
    const finding = scene.findings.find((one) => one.number === state.selected);
    if (finding && finding.severity === "pass") state.passes = true;
    const row = button("Go to its row", { class: "joint3d-go", onclick: () => scrollToRow(number) });
    if (finding) say(`Finding ${finding.number}, ${finding.severity}, ${finding.rule}: ${finding.what}. `, row);
    else say("");
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
  stage.after.push(() => {
    for (const marker of markers) placeMarker(marker, state, stage, section, model);
  });
  return state;
}

const isShown = ({ finding }, state) => finding.severity !== "pass" || state.passes || finding.number === state.selected;

function placeMarker(marker, state, stage, section, model) {
  const { finding, made } = marker;
  const body = model.find(finding.body);
  const shown = isShown(marker, state) && body.mesh.visible;
  made.hidden = !shown;
  if (!shown) return;
  const at = new Vector3(...finding.point_mm).applyMatrix4(body.placement);
  const covered = isCovered(at, stage, section, model);
  const selected = finding.number === state.selected;
  const screen = at.project(stage.camera);
  made.style.left = `${(screen.x * 0.5 + 0.5) * 100}%`;
  made.style.top = `${(0.5 - screen.y * 0.5) * 100}%`;
  made.classList.toggle("covered", covered && !selected);
  made.setAttribute("aria-pressed", String(selected));
}
