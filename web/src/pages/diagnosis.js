// The page of diagnosis.json (docs/gap.md), in the order where, which, how far.
import { change, isKnown, number, span } from "../kit/format.js";
import { bulletList, section, verdictTag } from "../kit/sections.js";
import { isolabilitySection } from "./diagnosis/isolability.js";
import { markedJoint, placeSection } from "./diagnosis/place.js";
import { redesignSection } from "./diagnosis/redesign.js";
import { traceSection } from "./diagnosis/traces.js";
import { whereSection } from "./diagnosis/where.js";
import { buildSection, formSection, howFarSection, nextSection, powerSection, transferSection, whichSection } from "./diagnosis/which.js";
import { chance } from "./diagnosis/words.js";
import { tellScene } from "./joint.js";

const verdictOf = ({ verdict, doubts = [] }) => verdictTag(...{
  identified: ["pass", "Cause identified"], none: ["pass", "No gap beyond tolerance and noise"], ambiguous: ["warning", "Cause ambiguous"],
  inconclusive: ["warning", doubts.length ? "No certain answer" : "Too few data for a verdict"], unknown: ["error", "Cause unknown"],
}[verdict]);

/** The verdict, its probability and what speaks against it. */
function sentenceOf({ sentence, probability, doubts = [] }) {
  return [sentence, isKnown(probability) ? ` Probability: ${chance(probability)}.` : "", ...doubts.map((doubt) => ` Doubt: ${doubt}.`)].join("");
}

function headOf(d) {
  const { gap } = d, held = gap.heldout_after_95.every(isKnown) ? `, after: ${span(gap.heldout_after_95)}` : "";
  return { kind: "fusee diagnosis", title: d.case, verdict: verdictOf(d), sentence: sentenceOf(d), stamp: `fusee ${d.fusee}, case ${d.case}, files ${d.case_sha256.slice(0, 12)}`, tiles: [
    ["Gap before \u2192 after", `${change(gap.before, gap.after)} sigma`], ["Noise floor", `${number(gap.noise_floor, 3)} sigma`], ["Gap on held-out rows", `${change(gap.heldout_before, gap.heldout_after)} sigma`, held],
    ["Probability", chance(d.probability), d.effects.length > 1 ? "of the less certain effect" : ""]] };
}

export function diagnosisPage(d, data) {
  const joint = markedJoint(d, data);
  return {
    head: headOf(d),
    sections: [formSection(d), traceSection(d), whereSection(d), placeSection(d), joint.section, whichSection(d), transferSection(d), howFarSection(d), nextSection(d), redesignSection(data("redesign")),
      section("Remarks", bulletList(d.remarks)), powerSection(d), isolabilitySection(d), buildSection(d)],
    start: () => tellScene({ marks: joint.marks }),
  };
}
