// Clicks and hovering on the view.
import { bodyName } from "../kit/names.js";
import { pickAt } from "./pick.js";

const STILL = 5; // [px] that a click may move

/** @param viewer with stage, section, model, tip @param click (hit) */
export function listenToPointer(viewer, click) {
  const { canvas } = viewer.stage;
  const pick = (event) => pickAt(event, viewer.stage, viewer.section, viewer.model);
  let down = null;
  let due = null;
  canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  canvas.addEventListener("pointerup", (event) => {
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < STILL) click(pick(event));
    down = null;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0 || event.pointerType === "touch") return;
    if (due === null) requestAnimationFrame(() => hover(viewer, due, pick, () => (due = null)));
    due = event;
  });
  canvas.addEventListener("pointerleave", () => (viewer.tip.hidden = true));
}

function hover(viewer, event, pick, done) {
  done();
  const hit = pick(event);
  const box = viewer.stage.canvas.getBoundingClientRect();
  viewer.tip.hidden = hit === null;
  viewer.tip.textContent = hit ? bodyName(hit.solid.name) + (hit.cut ? " (cut)" : "") : "";
  viewer.tip.style.left = `${event.clientX - box.left}px`;
  viewer.tip.style.top = `${event.clientY - box.top}px`;
}
