// Measured against predicted: each trace as a chart, the most telling first.
import { counted, isKnown } from "../../kit/format.js";
import { Plot } from "../../kit/plot.js";
import { faintParagraph, folded, grid, section } from "../../kit/sections.js";
import { columnName, experimentName } from "./words.js";

const kSigmasOf95 = 1.959964;     // two-sided 95 % of a normal distribution
const kSamePrediction = 0.1;      // of sigma: of repeats
const kMostTurns = 12;            // more overlapping bands hide the lines
const kScattered = 0.2;           // of the range of x: mean step of unordered rows
const kJump = 0.5, kSteps = 3;    // of the range of x, and of the usual step: where a new line begins
const kMostDots = 120, kMostTelling = 4;

/** "pe agonist" is "parallel spring, agonist"; a column has its unit. */
const traceName = (label) => label.replace(/^[a-z]\w*_\w+(?= |$)/, columnName).replace(/^se /, "series spring, ").replace(/^pe /, "parallel spring, ");

const anyKnown = (values) => values.some(isKnown);
const stepsOf = (x) => x.slice(1).map((value, i) => value - x[i]);
const rangeOf = (x) => x.reduce((high, value) => Math.max(high, value), -Infinity) - x.reduce((low, value) => Math.min(low, value), Infinity);
const picked = (values, rows) => rows.map((i) => values[i] ?? null);

function turns(x) {
  let count = 0, last = 0;
  for (const step of stepsOf(x)) {
    if (step * last < 0) ++count;
    if (step !== 0) last = step;
  }
  return count;
}

/** True if some x repeats and rows of equal x have equal predictions: repeats of a curve, not the two branches of a loop. */
function isRepeats(trace, byX) {
  const x = picked(trace.x, byX), y = picked(anyKnown(trace.after) ? trace.after : trace.before, byX), sigma = picked(trace.sigma, byX), same = [];
  for (let i = 1; i < x.length; ++i) if (x[i] === x[i - 1]) same.push(Math.abs(y[i] - y[i - 1]) <= kSamePrediction * sigma[i]);
  return same.length > 0 && same.every(Boolean);
}

/** True if x alternates in steps too long for a path. */
const isScattered = (x) => turns(x) > kMostTurns && stepsOf(x).reduce((sum, step) => sum + Math.abs(step), 0) > kScattered * rangeOf(x) * x.length;

/** The rows in the order of their path, or by rising x without a path. */
function drawnRows(trace) {
  const rows = trace.x.map((_, i) => i).filter((i) => isKnown(trace.x[i])), byX = [...rows].sort((a, b) => trace.x[a] - trace.x[b]);
  return isRepeats(trace, byX) || isScattered(picked(trace.x, rows)) ? byX : rows;
}

/** True where row i begins a new sweep, so that no line leads to it. */
function sweepStarts(x) {
  if (x.length < 3) return x.map(() => false);
  const steps = stepsOf(x).map(Math.abs), usual = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 2)], range = rangeOf(x);
  return x.map((_, i) => i > 0 && steps[i - 1] > kJump * range && steps[i - 1] > kSteps * usual);
}

/** A column with a gap before each new sweep. */
const withGaps = (values, fresh) => values.flatMap((value, i) => (fresh[i] ? [null, value] : [value]));

/** One band for each direction: a band that folds over itself would cancel itself. */
function addBands(plot, x, after, sigma, fresh) {
  let rows = [], last = 0;
  const end = (sign) => rows.map((i) => (isKnown(after[i]) && isKnown(sigma[i]) ? after[i] + sign * kSigmasOf95 * sigma[i] : null));
  const flush = () => {
    if (rows.length > 1) plot.band("95 % of predicted measurements", picked(x, rows), end(-1), end(1), "se");
    rows = [];
    last = 0;
  };
  x.forEach((value, i) => {
    const step = i ? value - x[i - 1] : 0;
    if (fresh[i]) flush();
    else if (step * last < 0) {
      flush();
      rows.push(i - 1);
    }
    if (step !== 0 && !fresh[i]) last = step;
    rows.push(i);
  });
  flush();
}

export function traceChart(trace) {
  const rows = drawnRows(trace), [x, before, after, measured, sigma] = ["x", "before", "after", "measured", "sigma"].map((key) => picked(trace[key], rows)), fresh = sweepStarts(x);
  const plot = new Plot(`${experimentName(trace.experiment)}: ${traceName(trace.label)}`, columnName(trace.x_name), columnName(trace.y_name));
  if (anyKnown(after) && turns(x) <= kMostTurns) addBands(plot, x, after, sigma, fresh);
  if (anyKnown(before)) plot.curve("before", withGaps(x, fresh), withGaps(before, fresh), "pe", true);
  if (anyKnown(after)) plot.curve("after", withGaps(x, fresh), withGaps(after, fresh), "se");
  const step = Math.ceil(rows.length / kMostDots);  // more dots would cover the lines
  return plot.points("measured", x, measured.map((value, i) => (i % step === 0 ? value : null)), "sum").svg();
}

/** @param traces `explained`: by how much the effects reduce its squared gap; `rows`: of the table, of which the JSON may hold some */
export function traceSection({ traces }) {
  if (!traces.length) return null;
  const first = [...traces].sort((a, b) => b.explained - a.explained).slice(0, kMostTelling), rest = traces.filter((trace) => !first.includes(trace));
  const most = Math.min(kMostDots, Math.max(...traces.map((trace) => trace.x.length))), thinned = traces.some((trace) => trace.rows > most);
  const words = `Dots: measured. Dashed: the nominal model. Solid: the model with the effects found, and the band that should contain 95 % of the measurements; without a band where a path turns often.${thinned ? ` Long tables show evenly chosen rows: at most ${most} dots.` : ""}`;
  const blocks = [...new Set(rest.map((trace) => trace.experiment))].map((experiment) => {
    const own = rest.filter((trace) => trace.experiment === experiment);
    return folded(`${experimentName(experiment)}: ${counted(own.length, "chart")} more`, grid(own.map(traceChart)));
  });
  return section("Measured against predicted", [grid(first.map(traceChart)), faintParagraph(words), blocks]);
}
