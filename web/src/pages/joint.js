// The section of the joint in 3D. joint.js fills the space that it holds free where the browser has WebGL; else it shows the drawing along the axis.
import { html, raw } from "../kit/markup.js";

/** What joint.js takes from the page: places of findings, and colours of marked bodies and cables by name or null. */
export function tellScene({ places = [], marks = null }) {
  window.fusee.places = places;
  window.fusee.marks = marks;
}

/** @param plan the drawing along the axis, SVG @param words markup below the heading */
export function jointSection(plan, words = null) {
  return html`<section id="joint-3d" class="joint3d" data-joint3d="static"><h2>The joint in 3D</h2>${words}<p class="joint3d-status" role="status" hidden>The joint in 3D needs WebGL, which this browser does not give the page: the drawing shows it along its axis.</p><div class="joint3d-view"></div><details class="joint3d-drawing"><summary>Drawing: along the axis, at the lowest load and at the highest</summary><figure class="plot">${raw(plan)}</figure></details></section>`;
}
