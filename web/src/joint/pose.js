// Poses between those of the grid: bilinear over co-contraction and share of the greatest joint torque.

/** The cell of a rising list that holds a value, and the place in it, 0 to 1. */
function cell(list, value) {
  let i = 0;
  while (i + 2 < list.length && value > list[i + 1]) ++i;
  const t = (value - list[i]) / (list[i + 1] - list[i]);
  return [i, Math.min(1, Math.max(0, t))];
}

const mix = (a, b, t) => a + (b - a) * t;

/** Linear between the rows of a table with rising x, continued at its ends. */
function between(xs, ys, x) {
  let i = 0;
  while (i + 2 < xs.length && x > xs[i + 1]) ++i;
  return ys[i] + ((ys[i + 1] - ys[i]) * (x - xs[i])) / (xs[i + 1] - xs[i]);
}

/** The nine channels of a pose: turn, spool, carriage, drawn of the agonist, of the antagonist, joint angle. */
export function channelsOf(scene, [turn, payout, turn2, payout2]) {
  const { k_se: series, k_pe: parallel } = scene.travel;
  const side = (angle, length) => [
    angle, between(series.length_mm, series.angle_rad, length), scene.capstan_radius_mm * angle, between(parallel.angle_rad, parallel.length_mm, angle),
  ];
  return [...side(turn, payout), ...side(turn2, payout2), (payout - scene.capstan_radius_mm * turn) / scene.joint_radius_mm];
}

/** Without a grid the joint stays at rest: every channel is 0. */
export function makePoses(scene) {
  const { grid } = scene;
  if (!grid) return { tau: [0, 0], most: () => 0, at: () => new Array(9).fill(0) };
  const last = grid.tau_Nm.length - 1;
  return {
    tau: [grid.tau_Nm[0], grid.tau_Nm[last]],
    most(tau) {
      const [i, t] = cell(grid.tau_Nm, tau);
      return mix(grid.most_Nm[i], grid.most_Nm[i + 1], t);
    },
    at(tau, share) {
      const [i, t] = cell(grid.tau_Nm, tau);
      const [j, s] = cell(grid.share, share);
      const level = (row) => row[j].map((value, k) => mix(value, row[j + 1][k], s));
      const above = level(grid.rows[i + 1]);
      return channelsOf(scene, level(grid.rows[i]).map((value, k) => mix(value, above[k], t)));
    },
  };
}

/** y at x of a table with rising x, linear; null outside it or beside a gap. */
export function lookUp(xs, ys, x) {
  if (x < xs[0] || x > xs[xs.length - 1]) return null;
  const [i, t] = cell(xs, x);
  return ys[i] === null || ys[i + 1] === null ? null : mix(ys[i], ys[i + 1], t);
}
