// The faulty place: a schematic of the joint, and the bodies of the joint in 3D in which the effects lie.
import { html } from "../../kit/markup.js";
import { bulletList, card, grid, paragraph, section } from "../../kit/sections.js";
import { jointSection } from "../joint.js";
import { bodyName, kSidesMeaning } from "../../kit/names.js";
import { causeName, causesName, effectSentence, signless } from "./causes.js";

/** The effects found are certain, but a part of the gap remains. */
export const isPartly = (verdict) => verdict.replaceAll("_", " ") === "partly explained";

/** The causes that a picture of the joint marks; possible: while the verdict names none. Causes outside the joint have no place. */
export function markedCauses({ verdict, effects, alternatives, meanings }) {
  const inJoint = (causes) => causes.filter(({ id }) => meanings[id]?.of_joint);
  if (verdict === "identified" || isPartly(verdict)) return { found: inJoint(effects), possible: [] };
  if (verdict === "none" || verdict === "inconclusive") return { found: [], possible: [] };
  return { found: [], possible: inJoint([...effects, ...alternatives.flatMap((alternative) => alternative.effects)]) };
}

// A body of the schematic: the first word of the effects that lie in it, its name, place in drawing units on the agonist's side. The
// antagonist's is its mirror image; without a side it stands in the middle.
const kWidth = 520, kHeight = 400;
const kBodies = [["sensor", "sensors", 212, 8, 96, 26, false], ["joint", "joint pulley", 190, 56, 140, 40, false], ["se", "K_SE", 60, 150, 110, 36, true], ["gear", "gear and capstan", 40, 218, 150, 36, true],
  ["motor", "motor", 75, 276, 80, 28, true], ["pe", "K_PE", 60, 350, 110, 36, true], ["loop", "controller", 210, 276, 100, 28, false]];
const kCable = "M115 150L205 96M176 254V368H170";  // from K_SE to the joint, and from the capstan to K_PE

const liesIn = ({ id, side: own }, part, side) => id.startsWith(`${part}.`) && (side === "" || [side, "both", "none"].includes(own));
const stateOf = ({ found, possible }, part, side) => (found.some((cause) => liesIn(cause, part, side)) ? "faulty" : possible.some((cause) => liesIn(cause, part, side)) ? "possible" : "sound");

function bodyMarkup([part, name, left, y, width, height], marked, side) {
  const x = side === "antagonist" ? kWidth - left - width : left;
  return html`<g class="${stateOf(marked, part, side)}"><rect class="thing" x="${x}" y="${y}" width="${width}" height="${height}" rx="6"/><text x="${x + width / 2}" y="${y + height / 2 + 4}" text-anchor="middle">${name}</text></g>`;
}

function sideMarkup(marked, side) {
  const mirrored = side === "antagonist";
  return html`<g class="${stateOf(marked, "cable", side)}"${mirrored && html` transform="matrix(-1 0 0 1 520 0)"`}><path class="line" d="${kCable}"/></g><path class="rule" d="${mirrored ? "M405 186V218M405 254V276" : "M115 186V218M115 254V276"}"/><text class="note" x="${mirrored ? kWidth - 10 : 10}" y="140" text-anchor="${mirrored ? "end" : "start"}">${side}</text>${kBodies.filter((body) => body[6]).map((body) => bodyMarkup(body, marked, side))}`;
}

function schematic(marked) {
  const faulty = causesName(marked.found.length ? marked.found : marked.possible, ", ");
  return html`<figure class="plot schema"><figcaption>The joint</figcaption><svg viewBox="0 0 ${kWidth} ${kHeight}" role="img" aria-label="The joint; faulty: ${faulty}">${sideMarkup(marked, "agonist")}${sideMarkup(marked, "antagonist")}${kBodies.filter((body) => !body[6]).map((body) => bodyMarkup(body, marked, ""))}</svg></figure>`;
}

export function placeSection(diagnosis) {
  const marked = markedCauses(diagnosis), { found, possible } = marked, causes = found.length ? found : possible;
  if (!causes.length) return null;
  const lines = [...new Set(causes.map((cause) => (cause.parameter ? `${effectSentence(cause)}.` : `${causeName(cause)}: ${signless(diagnosis.meanings[cause.id].meaning)}`)))];
  return section("The faulty place", grid(schematic(marked), card(paragraph(found.length ? "Marked: where the effects found lie." : "Marked: where the possible effects lie; none is certain."), bulletList(lines))));
}

// Where effects lie in the model of the joint; the first row whose part begins the effect's id counts. note: what the model leaves out.
const kLies = [{ part: "se.radius", bodies: ["k_se"] }, { part: "se.", bodies: ["k_se_spring"] }, { part: "pe.radius", bodies: ["k_pe"] }, { part: "pe.", bodies: ["k_pe_spring"] },
  { part: "gear.", bodies: ["capstan", "motor_shaft"], note: "; the gear itself is not modelled" }, { part: "motor.", bodies: ["motor_shaft"], note: "; the motor itself is not modelled" },
  { part: "joint.stop", bodies: ["joint_stops"] }, { part: "joint.", bodies: ["joint_pulley"] }, { part: "cable.", bodies: [], cable: "series cable" }, { part: "", bodies: [] }];  // sensors and controller have no body

const liesOf = ({ id }) => kLies.find(({ part }) => id.startsWith(part));

/** Names in the scene. A body without a side has its base name. */
function namesOf(scene, cause) {
  const { bodies, cable } = liesOf(cause), known = new Set(scene.bodies.map((body) => body.name));
  return ["agonist", "antagonist", ""].filter((side) => [side, "both", "none"].includes(cause.side)).flatMap((side) => [
    ...(side && cable ? [`${cable}, ${side}`] : []), ...bodies.map((body) => (side ? `${body}_${side}` : body)).filter((name) => known.has(name))]);
}

/** The rig's joint in 3D: its section, and the colours of what is marked. Nothing without effects. */
export function markedJoint(diagnosis, data) {
  const { found, possible } = markedCauses(diagnosis), causes = found.length ? found : possible, scene = data("joint-scene");
  if (!causes.length || !scene) return { section: null, marks: null };
  const places = causes.map((cause) => ({ cause, names: namesOf(scene, cause) }));
  const lines = new Set(places.map(({ cause, names }) => (names.length ? `${causeName(cause)}: ${names.map(bodyName).join("; ")}${liesOf(cause).note ?? ""}` : `${causeName(cause)}: no body of the model is marked`)));
  const words = [paragraph(`${found.length ? "Red: where the effects found lie." : "Orange: where the possible effects lie; none is certain."} ${kSidesMeaning}`), bulletList([...lines].sort())];
  return { section: jointSection(data("plan"), words), marks: Object.fromEntries(places.flatMap(({ names }) => names.map((name) => [name, found.length ? "#d32f2f" : "#ef9b0f"]))) };
}
