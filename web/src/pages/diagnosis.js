// The page of diagnosis.json (docs/gap.md): what is wrong, what helps, where it lies; then the proof.
import { change, deg, isKnown, newtonMetres, number, span } from "../kit/format.js";
import { bulletList, section, verdictTag } from "../kit/sections.js";
import { effectSentence, withNames } from "./diagnosis/causes.js";
import { isolabilitySection } from "./diagnosis/isolability.js";
import { isPartly, markedJoint, placeSection } from "./diagnosis/place.js";
import { redesignSection } from "./diagnosis/redesign.js";
import { traceSection } from "./diagnosis/traces.js";
import { whereSection } from "./diagnosis/where.js";
import { absorptionSection, againstSection, buildSection, formSection, howFarSection, nextSection, powerSection, transferSection, whichSection } from "./diagnosis/which.js";
import { chance, experimentName, named } from "./diagnosis/words.js";
import { tellScene } from "./joint.js";

const isNamed = ({ verdict, effects }) => (verdict === "identified" || isPartly(verdict)) && effects.length > 0;

function verdictOf({ verdict, effects, doubts = [] }) {
  if (isPartly(verdict)) return verdictTag("warning", "Partly explained");
  const known = {
    identified: ["pass", effects.length > 1 ? "Causes identified" : "Cause identified"], none: ["pass", "No gap beyond tolerance and noise"], ambiguous: ["warning", "Cause ambiguous"],
    inconclusive: ["warning", doubts.length ? "No certain answer" : "Too few data for a verdict"], unknown: ["error", "Cause unknown"],
  }[verdict];
  return known ? verdictTag(...known) : verdictTag("warning", verdict);
}

const kCertain = 0.9995;

/** What a user's model says of its effect, if it is one sentence: "A constant friction opposes this joint: ". */
const ownWords = (id, { meaning = "", remedy = "" } = {}) => (remedy && meaning && !id.includes(".") && !meaning.includes(". ") ? `${meaning.replace(/\.$/, "")}: ` : "");

/** What is wrong, with sign, size and interval; else the engine's sentence. Then what speaks against it. */
function sentenceOf(d) {
  const { sentence, probability, doubts = [] } = d, own = d.effects.map((effect) => `${ownWords(effect.id, d.meanings[effect.id])}${effectSentence(effect, d.meanings[effect.id])}.`).join(" ");
  const rest = sentence.match(/That explains a part.*/)?.[0] ?? sentence;  // before it the engine names the causes by their ids
  const said = isNamed(d) ? own + (isPartly(d.verdict) ? ` ${withNames(rest)}` : "") : withNames(sentence), unsure = isKnown(probability) && probability < kCertain ? ` Probability: ${chance(probability)}.` : "";
  return [said, unsure, ...doubts.map((doubt) => ` Doubt: ${withNames(doubt)}.`)].join("");
}

const fileName = (path) => path.split("/").pop();

/** What to do, and the dead-band afterwards. */
function remedyTiles(d, redesign) {
  if (!isNamed(d)) return d.next.length ? [["Next experiment", experimentName(d.next[0].experiment), `${number(d.next[0].cost_min, 2)} min, ${number(d.next[0].information_bit, 2)} bit of information expected`]] : [];
  const known = d.effects.map(({ id }) => d.meanings[id] ?? {}), own = known.map((meaning) => meaning.remedy).find(Boolean);
  if (own) return [["Remedy", "Mend it", own]];
  if (!known.some((meaning) => meaning.of_joint)) return [["Remedy", "Mend it", "or keep it in the model"]];
  if (!redesign) return [["Remedy", "Mend it, or make new cams", "diagnose --write-profile makes their profile"]];
  const { profiles, at_peak: peak, not_mended: rest } = redesign, made = profiles.filter((profile) => profile.can_be_cut);
  const remedy = made.length ? ["Remedy", "New cams", `fusee make ${made.map(({ file }) => fileName(file)).join(" ")}`] : profiles.length ? ["Remedy", "No cams can be made", "the rules that refuse them are below"] : ["Remedy", "Mend it", rest.map((n) => n.instead)[0] ?? ""];
  if (!peak || !made.length) return [remedy];
  const widths = (which) => `${deg(peak[which].measured_rad, 3)} deg`;
  return [remedy, ["Dead-band afterwards", widths("new_cams"), `at ${newtonMetres(peak.tau_Nm)}; now ${widths("old_cams")}, by the profile ${widths("promised")}`]];
}

function headOf(d, redesign) {
  const { gap } = d, held = gap.heldout_after_95.every(isKnown) ? `95 %: ${span(gap.heldout_after_95)}` : "";
  const held_out = isKnown(gap.heldout_before) ? [["Gap on held-out rows", `${change(gap.heldout_before, gap.heldout_after)} sigma`, held]] : [];
  return { kind: "fusee diagnosis", title: d.case, verdict: verdictOf(d), sentence: sentenceOf(d), stamp: `fusee ${d.fusee}, case ${d.case}, files ${d.case_sha256.slice(0, 12)}`,
    tiles: [...remedyTiles(d, redesign), ["Gap before \u2192 after", `${change(gap.before, gap.after)} sigma`, `noise floor ${number(gap.noise_floor, 3)}`], ...held_out] };
}

export function diagnosisPage(d, data) {
  const joint = markedJoint(d, data), redesign = data("redesign");
  return {
    head: headOf(d, redesign),
    sections: [joint.section ?? placeSection(d), formSection(d), traceSection(d), nextSection(d), whichSection(d), howFarSection(d), absorptionSection(d), againstSection(d), redesignSection(redesign), whereSection(d), transferSection(d),
      section("Remarks", bulletList(d.remarks.map((remark) => named(withNames(remark))))), powerSection(d), isolabilitySection(d), buildSection(d)],
    start: () => tellScene({ marks: joint.marks }),
  };
}
