// The spring law and the dead-band, with the points of the shown pose.
import { colour, degrees, element, fold } from "./dom.js";
import { lookUp } from "./pose.js";

const HEIGHT = 170, LEAST_WIDTH = 150;

/** Points over a chart: [x, y, colour's name]. */
function dots(points) {
  return (plot) => {
    for (const [x, y, name] of points()) {
      if (y === null) continue;
      plot.ctx.beginPath();
      plot.ctx.arc(plot.valToPos(x, "x", true), plot.valToPos(y, "y", true), 5 * devicePixelRatio, 0, 2 * Math.PI);
      plot.ctx.fillStyle = colour(name);
      plot.ctx.fill();
    }
  };
}

function axis(label, size) {
  return { label, size, stroke: () => colour("--soft"), grid: { stroke: () => colour("--line"), width: 1 }, ticks: { show: false }, labelSize: 16, font: "11px sans-serif", labelFont: "12px sans-serif" };
}

function chart(parent, { x, y, series, data, points }) {
  const lines = series.map(([label, name]) => ({ label, stroke: () => colour(name), width: 2, points: { show: false } }));
  const options = {
    width: Math.max(LEAST_WIDTH, parent.clientWidth), height: HEIGHT, pxAlign: 0, scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(0, low), 1.05 * high] } },
    axes: [axis(x, 26), axis(y, 42)], series: [{ label: x }, ...lines], hooks: { draw: [dots(points)] }, legend: { live: false },
  };
  const plot = new window.fusee.plot(options, data, parent);
  new ResizeObserver(() => plot.setSize({ width: Math.max(LEAST_WIDTH, parent.clientWidth), height: HEIGHT })).observe(parent);
  return plot;
}

function lawPoints(scene, channels) {
  const { theta_rad: theta, f_se_Nm: series, f_pe_Nm: parallel } = scene.law;
  const joint = (channels[8] * scene.joint_radius_mm) / scene.capstan_radius_mm;
  return [[0, 1], [4, -1]].flatMap(([turn, sign]) => {
    const stretched = channels[turn] + sign * joint;
    return [
      [degrees(stretched), lookUp(theta, series, stretched), "--se"],
      [degrees(channels[turn]), lookUp(theta, parallel, channels[turn]), "--pe"],
    ];
  });
}

export const deadBandAt = (scene, tau) => lookUp(scene.dead_band.tau_Nm, scene.dead_band.exact_deg, tau);

export function makeCurves(scene, state) {
  const law = element("figure", { class: "joint3d-chart" }, element("figcaption", {}, "Spring law, both sides"));
  const band = element("figure", { class: "joint3d-chart" }, element("figcaption", {}, "Dead-band at the joint"));
  const curves = { element: fold("Curves with this pose", element("div", { class: "joint3d-charts" }, law, band)), plots: [] };
  const wide = matchMedia("(min-width: 901px)"), unfold = () => (curves.element.open = wide.matches);
  wide.addEventListener("change", unfold);
  unfold();
  curves.start = () => {
    const angles = scene.law.theta_rad.map(degrees);
    curves.plots = [
      chart(law, { x: "deflection [deg]", y: "torque [Nm]", series: [["series spring", "--se"], ["parallel spring", "--pe"]],
        data: [angles, scene.law.f_se_Nm, scene.law.f_pe_Nm], points: () => lawPoints(scene, state.channels) }),
      chart(band, { x: "co-contraction [Nm]", y: "dead-band [deg]", series: [["exact", "--exact"]],
        data: [scene.dead_band.tau_Nm, scene.dead_band.exact_deg], points: () => [[state.tau, deadBandAt(scene, state.tau), "--exact"]] }),
    ];
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", curves.update);
  };
  curves.update = () => curves.plots.forEach((plot) => plot.redraw(false, true));
  return curves;
}
