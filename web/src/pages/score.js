// The page of score.json: a blind benchmark (docs/benchmark.md).
import { change, isKnown, kUnknown, number, percent, span } from "../kit/format.js";
import { html } from "../kit/markup.js";
import { Plot } from "../kit/plot.js";
import { facts, paragraph, section, tag } from "../kit/sections.js";
import { cell, faint, num, strong, table } from "../kit/table.js";
import { causeName, kCauses, plainName } from "./diagnosis/causes.js";
import { chance } from "./diagnosis/words.js";

const kTiles = ["effect_named", "effect_and_side", "none_on_null", "both_of_two", "intervals_hold", "held_out_halved", "unknown_called_unknown", "known_called_unknown"];
const perCent = (share) => percent(share, 1);
const perCents = (range) => (range.every(isKnown) ? `${range.map((share) => (100 * share).toFixed(1)).join(" to ")} %` : kUnknown);
const hitsText = ({ hits, of }) => `${hits} of ${of}`;
const intervalText = ({ of, wilson95 }) => (of === 0 ? "" : perCents(wilson95));

function wantedText([low, high]) {
  const least = low > 0, most = high < 1, whole = (share) => (100 * share).toFixed(0);
  if (!least && !most) return "";
  if (least && most) return `${whole(low)} to ${whole(high)} %`;
  return low === 1 ? "100 %" : least ? `at least ${whole(low)} %` : `at most ${whole(high)} %`;
}

function wantedCell({ wanted, of, value }) {
  const text = wantedText(wanted), met = value >= wanted[0] && value <= wanted[1];
  return text && of ? cell(tag(met ? "pass" : "warning", text), "num") : num(text);
}

function headOf({ figures, cases, fusee, seal }) {
  return { kind: "fusee blind benchmark", title: `${cases} sealed cases`, stamp: `fusee ${fusee}, seal ${seal}`, tiles: kTiles.map((key) => [figures[key].name, perCent(figures[key].value), figures[key].of ? hitsText(figures[key]) : "no such case"]) };
}

function figureSection({ figures, model }) {
  const rows = Object.entries(figures).map(([key, figure]) => [figure.name, num(hitsText(figure)), strong(perCent(figure.value)), num(intervalText(figure)), wantedCell(figure), num(perCent(figure.shuffled)), num(perCents(figure.shuffled95)),
    ...(model ? [num(perCent(model.figures[key].value))] : [])]);
  const control = model ? ` Control: the ${model.cases} cases of the model itself show what the method misses without a model error.` : "";
  return section("Figures", [paragraph(`Intervals are Wilson's. Control: the same answers with shuffled labels score at chance level.${control}`),
    table("Figures of the benchmark", ["", "cases", "share", "95 %", "wanted", "labels shuffled", "95 % of shuffles", ...(model ? ["model = plant"] : [])], rows)]);
}

function confusionSection({ confusion }) {
  const answers = [...new Set(Object.values(confusion).flatMap(Object.keys))].sort();
  const named = (id) => (kCauses[id] ? plainName(id) : id);
  const rows = Object.entries(confusion).map(([truth, said]) => [num(named(truth)), ...answers.map((answer) => {
    const count = String(said[answer] ?? ""), right = answer === truth || (answer === "unknown" && truth.startsWith("outside."));
    return right ? strong(count) : num(count);
  })]);
  return section("Confusion", [paragraph("Cases by the effect built in and the effect answered; correct answers are bold. For two effects it shows only how many were answered: the figures above show which."),
    table("Cases by effect built in and answered", ["built in \\ answered", ...answers.map(named)], rows, "dense")]);
}

const held = (plot) => html`<div class="held">${plot.fromZero().svg()}</div>`;

function calibrationSection({ calibration }) {
  const rows = calibration.map((bin) => [num(bin.stated.join(" to ")), num(hitsText(bin)), num(perCent(bin.mean_stated)), num(perCent(bin.value)), num(intervalText(bin))]);
  const known = calibration.filter((bin) => bin.of > 0), stated = known.map((bin) => bin.mean_stated);
  const plot = new Plot("Stated probability and correct share", "stated", "correct").curve("ideal", [0, 1], [0, 1], "sum", true).points("effects", stated, known.map((bin) => bin.value), "se")
    .band("95 %", stated, known.map((bin) => bin.wilson95[0]), known.map((bin) => bin.wilson95[1]), "se");
  return section("Calibration", [paragraph("How often the effects that answers name, with their side, were built in."), table("Stated probability and correct share", ["stated", "correct", "mean stated", "correct share", "95 %"], rows), known.length ? held(plot) : null]);
}

function coverageSection({ coverage }) {
  const rows = Object.entries(coverage).map(([id, share]) => [num(plainName(id)), num(hitsText(share)), num(perCent(share.value)), num(intervalText(share))]);
  return rows.length ? section("Intervals", [paragraph("95 % intervals of correctly named effects that contain the true size."), table("Intervals that contain the true size, by effect", ["effect", "contained", "share", "95 %"], rows)]) : null;
}

const upperMedian = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function shrinkSection({ shrink }) {
  if (!shrink.length) return null;
  const claimed = shrink.map((row) => row.claimed), measured = shrink.map((row) => row.measured), most = Math.max(1, ...claimed);
  const plot = new Plot("Gap after over gap before", "claimed by the diagnosis", "measured on heldout/").curve("ideal", [0, most], [0, most], "sum", true).points("cases", claimed, measured, "t");
  return section("Claimed and measured reduction of the gap", [facts([["cases with a named effect", shrink.length], ["median claimed", number(upperMedian(claimed), 3)], ["median measured", number(upperMedian(measured), 3)]]), held(plot)]);
}

const truthText = (effects) => effects.map((e) => `${causeName(e)} ${number(e.size, 3)}`).join(", ") || "none";

function answerText({ verdict, effects }) {
  const found = effects.map((e) => `${causeName(e)} ${number(e.value, 3)} (95 %: ${span(e.ci95)})`).join(", ");
  return verdict === "failed" || !found ? verdict : `${verdict}: ${found}`;
}

const alternativesText = (alternatives) => alternatives.map((other) => `${other.effects.map(causeName).join(" + ") || "none"} ${chance(other.probability)}`).join("; ");

function missSection({ misses }) {
  const rows = misses.map(({ case: name, what, truth, answer }) => [num(name), what, truthText(truth), answerText(answer), faint(alternativesText(answer.alternatives)), num(change(answer.held_out_before, answer.held_out_after))]);
  return section("Misses", rows.length ? table("Misses", ["case", "what", "built in", "answer", "alternatives", "held-out gap [sigma]"], rows, "dense") : paragraph("None."));
}

export function scorePage(score) {
  const { median, worst } = score.seconds, time = isKnown(median) ? paragraph(`One case on one thread: median ${number(median, 3)} s, worst ${number(worst, 3)} s.`) : null;
  return { head: headOf(score), sections: [figureSection(score), confusionSection(score), calibrationSection(score), coverageSection(score), shrinkSection(score), section("Time", time), missSection(score)] };
}
