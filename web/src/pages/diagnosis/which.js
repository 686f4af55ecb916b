// Which effect causes the gap, how far it shrinks, and what else the diagnosis holds.
import { change, counted, isKnown, number, percent, span, withUnit } from "../../kit/format.js";
import { html } from "../../kit/markup.js";
import { Plot } from "../../kit/plot.js";
import { faintParagraph, folded, foldedSection, paragraph, section, subheading } from "../../kit/sections.js";
import { num, shareCell, strong, table } from "../../kit/table.js";
import { causeName, causesName, effectSentence, intervalText, plainName, sizeText, withNames } from "./causes.js";
import { chance, columnName, experimentName, forReading } from "./words.js";

const kMostHypotheses = 30;
const faintLine = (text) => text && html`<br><span class="faint">${text}</span>`;

function effectTable({ effects, meanings }) {
  const rows = effects.map((effect) => {
    const { id, probability, parameter, extra = {} } = effect, { law = "", meaning = "", remedy = "" } = meanings[id] ?? {};
    return [html`<b>${effectSentence(effect, meanings[id])}</b>${faintLine(Object.entries(extra).map(([name, value]) => `${name} = ${number(value, 4)}`).join(", "))}`, strong(sizeText(parameter)), num(intervalText(parameter)), num(chance(probability)),
      html`${withNames(law)}${faintLine(remedy ? meaning : `fusee explain ${id}`)}${faintLine(remedy && `Remedy: ${remedy}`)}`];
  });
  return table("Effects found", ["effect", "size", "95 %", "probability", "law"], rows, "cards");
}

function alternativeTable({ alternatives: all, verdict }) {
  const alternatives = verdict === "unknown" ? all.filter(({ effects }) => effects.length) : all;  // that nothing is wrong is no alternative to an unknown cause
  return alternatives.length ? [subheading("Alternatives"), table("Alternatives", ["effects", "probability"], alternatives.map((a) => [causesName(a.effects), shareCell(a.probability, chance(a.probability))]))] : null;
}

function rankingTable({ verdict, effects, ranking }) {
  if (!ranking.length) return null;
  const setOf = (causes) => causes.map(causeName).sort().join(), decided = ["identified", "none", "partly_explained"].includes(verdict);
  const rows = ranking.slice(0, kMostHypotheses).map((h) => [
    html`${causesName(h.effects, " + ")}${decided && setOf(h.effects) === setOf(effects) && html` <span class="tag pass-tag">found</span>`}`,
    num(h.parameters.map(sizeText).join("; ")), num(h.log_evidence, 3), shareCell(h.probability, chance(h.probability)), num(h.chi2), num(h.left_out, 3)]);
  const rest = ranking.length - kMostHypotheses;
  const unexplained = verdict === "unknown" ? " None of them explains the gap: the probabilities are among these alone." : "";
  return folded("Ranking of all hypotheses", [paragraph(`The log evidence is relative to the best. The left-out gap, in sigma, is that of experiments that the fit did not use.${unexplained}`),
    table("Hypotheses by probability", ["effects", "size", "log evidence [nats]", "probability", "chi\u00b2", "left-out gap"], rows, "dense"), rest > 0 ? faintParagraph(`diagnosis.json holds ${rest} more.`) : null]);
}

export const whichSection = (d) => section("Which effects cause it", [effectTable(d), alternativeTable(d), rankingTable(d)]);

/** What a plain fit of all parameters would have claimed, and what it costs. */
export function absorptionSection({ absorption }) {
  if (!absorption) return null;
  const read = (value, unit) => { const p = forReading({ value, unit }); return withUnit(number(p.value, 3), p.unit); };
  const rows = absorption.parameters.map((p) => [num(p.name), num(read(p.value, p.unit)), num(isKnown(p.tolerances) ? number(p.tolerances, 3) : ""), num(read(p.with_cause, p.unit))]);
  return section("What a plain fit would claim", [paragraph(withNames(absorption.sentence)),
    folded("Parameters of that fit", [paragraph("All build parameters fitted, without an effect and with tolerances 30 times as wide, as tools of system identification do; beside it their values with the cause."),
      table("A fit of all parameters", ["parameter", "fitted", "in tolerances", "with the cause"], rows, "dense")])]);
}

const kSurvival = { agrees: "agrees", differs: "there, with another size", gone: html`<b>not there</b>`, open: "its rows do not tell" };

/** Which causes hold on another case, and how far they close its gap. */
export function againstSection({ against }) {
  if (!against) return null;
  const { gap } = against, rows = against.causes.map((c) => [causeName(c), num(sizeText(c.here)), num(intervalText(c.here)), num(isKnown(c.there.value) ? sizeText(c.there) : ""), num(intervalText(c.there)), kSurvival[c.survival]]);
  return section("Does it hold elsewhere", [
    paragraph(`On ${against.case} the gap is ${number(gap.before, 3)} sigma${rows.length ? `; ${number(gap.carried, 3)} with these causes as they are, ${number(gap.refitted, 3)} with their sizes fitted there` : ""}; ${number(gap.own, 3)} with its own diagnosis, ${against.verdict}: ${causesName(against.effects)}.`),
    table(`Causes of this case on ${against.case}`, ["cause", "size here", "95 %", "size there", "95 %", "there"], rows)]);
}

const kAxes = { capstan_rad: "capstan angle [rad]", joint_rad: "joint angle [rad]", end_share: "deflection over that of the cam's end", time_s: "time [s]", session_s: "time of the session [s]", torque_Nm: "torque [Nm]",
  rad_per_s: "speed [rad/s]", rad: "angle [rad]", s: "delay [s]" };

function termPart(term) {
  const { curve, extra = {}, units = [] } = term, p = forReading(term.parameter), axis = (name) => kAxes[name] ?? "factor or share";
  const rows = [["size", num(p.value, 3), num(span(p.ci95)), p.unit], ...Object.entries(extra).map(([name, value], i) => [name, num(value, 3), "", units[i] ?? ""])];
  return [paragraph(term.sentence), paragraph(`It enters at the ${term.port}, and depends on: ${term.depends_on}. Law: ${term.law} Probability among the forms that were tried: ${chance(term.probability)}.`),
    curve.x.length ? new Plot(plainName(term.id), axis(curve.x_name), axis(curve.y_name)).curve("law as fitted", curve.x, curve.y, "se").svg() : null,
    table(`Values of ${causeName(term)}`, ["value", "as fitted", "95 %", "unit"], rows, "dense")];
}

/** The generic terms that explain the gap of an unknown effect: sentence, law, values, curve. */
export function formSection({ unknown_term: term, term_units: units }) {
  if (!term) return null;
  return section("Form of the unknown effect", [
    paragraph("No hypothesis of the library that was fitted explains the gap. Generic laws were fitted at every place of the joint; what follows explains most of it. It is a form, not a cause: check that place."),
    [term, term.second].filter(Boolean).map((one, i) => termPart({ ...one, units: units[i] }))]);
}

/** What effects fitted on a part of the files do on the held-out file. */
export function transferSection({ transfer }) {
  const rows = transfer.map((t) => [num(causesName(t.effects)), num(t.parameters.map(sizeText).join(", ")), `${t.fitted}: ${change(t.fit_before, t.fit_after)}`, `${t.heldout}: ${change(t.heldout_before, t.heldout_after)}`,
    t.heldout_after < t.heldout_before ? "better" : html`<b>worse</b>`]);
  return rows.length ? foldedSection("Does it transfer", counted(rows.length, "effect"), [
    paragraph(`Each effect fitted on one part of the files and applied to the file that is held out: root mean square error in ${transfer[0].unit}, before \u2192 after. A false cause fits its own file and worsens the other.`),
    table("Error on the files of the fit and on the held-out file", ["effects", "size", "fitted to", "held out", "held out is"], rows)]) : null;
}

function gapRow(name, rows, gap, forecast) {
  const remaining = isKnown(gap.heldout_after) && isKnown(gap.heldout_before) ? gap.heldout_after / gap.heldout_before : null;
  return [name, num(rows), ...[gap.before, gap.after, gap.noise_floor, gap.heldout_before, forecast, gap.heldout_after].map((value) => num(value, 3)), num(span(gap.heldout_after_95)), num(percent(remaining))];
}

/** "8 torques", in the unit of the measured values: before, as the fit claims, and as measured on what it had not seen. */
function heldOutRow({ experiment, rows, held_out, in_unit }) {
  const gaps = in_unit ? [in_unit.before, in_unit.after, in_unit.heldout_after].map((value) => num(withUnit(number(value, 3), in_unit.unit))) : ["", "", ""];
  return [num(experimentName(experiment)), num(String(rows)), held_out, ...gaps];
}

function heldOutTable(experiments) {
  const rows = experiments.filter((own) => own.held_out || own.in_unit).map(heldOutRow);
  return rows.length ? [paragraph("Whole runs, levels or stretches were kept aside in turn, and each was predicted by a fit that had not seen it. If the answer is true, the gap measured there is about as small as the fit of all rows claims."),
    table("Gap in the unit of the measured values, claimed and measured", ["experiment", "rows", "kept aside in turn", "before", "after, claimed", "after, measured"], rows, "cards")] : null;
}

export function howFarSection({ experiments, gap }) {
  if (!experiments.length) return null;
  const rows = [...experiments.map((e) => gapRow(num(experimentName(e.experiment)), String(e.rows), e.gap, e.forecast)), gapRow(strong("all"), "", gap, null)];
  return section("How far the gap shrinks", [heldOutTable(experiments), folded("The same in sigma, with the forecast", [paragraph("All in sigma. No fit uses the held-out rows; the forecast is their gap as the fit predicts it."),
    table("Gap of each experiment before and after", ["experiment", "rows", "before", "after", "floor", "held out, before", "forecast", "measured", "95 %", "remaining"], rows)])]);
}

export function nextSection({ next, next_experiment: text, verdict }) {
  const setPoints = ({ variable, set_points: points }) => (points.length && variable ? `${columnName(variable)}: ` : "") + points.map((value) => number(value, 3)).join(", ");
  const rows = next.map((n) => [withNames(n.text), num(experimentName(n.experiment)), setPoints(n), num(n.information_bit, 2), num(n.cost_min, 2)]);
  const caption = verdict === "inconclusive" ? "Measurements that show what these rows do not" : "Measurements that distinguish the causes";
  return section("Next experiment", [text && !next.some((n) => n.text === text) ? paragraph(withNames(text)) : null, table(caption, ["measurement", "experiment", "set points", "bits expected", "minutes"], rows, "cards")]);
}

export function buildSection({ build }) {
  const rows = Object.entries(build).map(([name, raw]) => { const p = forReading(raw); return [num(name), num(p.value, 3), num(span(p.ci95)), p.unit]; });
  return rows.length ? foldedSection("How this rig was built", counted(rows.length, "figure"), [paragraph("Deviations from nominal within the build tolerances, fitted together with the effects."),
    table("Build figures as fitted", ["figure", "value", "95 %", "unit"], rows, "dense")]) : null;
}

/** The least size of each effect that a verdict without effects excludes. */
export function powerSection({ power }) {
  if (!power.length) return null;
  const unseen = power.filter((own) => !own.shown), sized = (value, unit) => forReading({ value, unit });
  const rows = [...unseen, ...power.filter((own) => own.shown)].map((own) => [causeName(own), num(sized(own.least, own.unit).value, 2), num(sized(own.usual, own.unit).value, 2), sized(own.usual, own.unit).unit, own.shown ? "yes" : html`<b>no</b>`]);
  return foldedSection("What these rows would have shown", `${power.length - unseen.length} of ${power.length} causes at their usual size`, [
    paragraph("The size of each cause that would have been named in 95 of 100 cases: the least one; of a limit, as a stop, the greatest. A cause of a smaller size may be there."),
    table("Size of each cause that would have been named", ["cause", "size", "usual", "unit", "shown"], rows, "dense")]);
}
