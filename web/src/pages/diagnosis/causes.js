// Causes as a person names them: of each effect its name, and a sentence of its size. tests/browser compares the list with those of the engine.
import { capitalised, isKnown, number, percent, span, withUnit } from "../../kit/format.js";
import { forReading } from "./words.js";

/**
 * id: [name, sentence]. {size} is the size without its sign, {more|less} chooses by the sign, {side} names the side. Where the sentence has no choice of words,
 * the size keeps its sign.
 */
export const kCauses = {
  "cable.stretch": ["stretch of the series cable", "The series cable stretches{side}: {size} in series with its spring"],
  "cable.tension_friction": ["friction of the cables at the joint", "The cables rub at the joint with {size} of their pull"],
  "figure.joint_inertia": ["stated inertia of the joint", "The joint's inertia is {size} {above|below} what case.toml states"],
  "figure.joint_radius": ["stated radius of the joint", "The joint's radius is {size} {above|below} what case.toml states{side}"],
  "figure.joint_viscous": ["stated drag of the joint", "The joint's viscous drag is {size} {above|below} what case.toml states"],
  "figure.motor_inertia": ["stated inertia of the motor", "The motor's inertia is {size} {above|below} what case.toml states{side}"],
  "figure.motor_viscous": ["stated drag of the motors", "The motors' viscous drag is {size} {above|below} what case.toml states"],
  "gear.asymmetry": ["one-sided gear friction", "Gear friction is {size} {higher|lower} where the motor winds in, and as much {lower|higher} where it pays out{side}"],
  "gear.backlash": ["play of the gear", "The gear has {size} of play{side}"],
  "gear.coulomb": ["constant gear friction", "The gear has {size} of constant friction{side}"],
  "gear.load_friction": ["gear friction", "Gear friction is {size} {above|below} the model{side}"],
  "gear.load_quadratic": ["gear friction that grows faster than its load", "Gear friction grows faster than its load{side}, by {size}"],
  "gear.stribeck": ["friction of the gear at rest", "Gear friction is {size} higher at rest than in motion{side}"],
  "gear.viscous": ["viscous gear friction", "Gear friction grows with speed{side}, by {size}"],
  "joint.coulomb": ["friction of the joint's bearing", "The joint's bearing has {size} of constant friction"],
  "joint.gravity": ["weight of the link", "The link's weight turns the joint, by {size}"],
  "joint.stop": ["a stop of the joint", "The joint meets a stop at {size}"],
  "joint.viscous": ["viscous friction of the joint", "The joint's friction grows with speed, by {size}"],
  "loop.delay": ["delay of the commands", "Commands act {size} late"],
  "motor.saturation": ["limit of the motor's torque", "The motor delivers at most {size}{side}"],
  "pe.bottoming": ["binding of the parallel spring", "The parallel spring binds beyond {size}{side}"],
  "pe.hysteresis": ["hysteresis of the parallel spring", "The parallel spring's torque is {size} higher in loading and as much lower in unloading{side}"],
  "pe.preload": ["preload of the parallel spring", "The parallel spring starts {size} {compressed|slack}{side}"],
  "pe.radius": ["arms of the parallel cam", "Every arm of the parallel cam is {size} {longer|shorter} than drawn{side}"],
  "pe.rate": ["stiffness of the parallel spring", "The parallel spring is {size} {stiffer|softer} than its rate{side}"],
  "se.hysteresis": ["hysteresis of the series spring", "The series spring's torque is {size} higher in loading and as much lower in unloading{side}"],
  "se.preload": ["preload of the series spring", "The series spring starts {size} {wound|slack}{side}"],
  "se.radius": ["arms of the series spool", "Every arm of the series spool is {size} {longer|shorter} than drawn{side}"],
  "se.rate": ["stiffness of the series spring", "The series spring is {size} {stiffer|softer} than its rate{side}"],
  "sensor.joint_offset": ["zero of the joint encoder", "The zero of the joint encoder is off by {size}"],
  "sensor.torque_offset": ["zero of the dynamometer", "The dynamometer shows {size} where there is no torque"],
  "sensor.torque_scale": ["scale of the motor torque", "The motor delivers {size} {more|less} torque than commanded{side}"],
  "element.presliding": ["yielding before sliding", "The contact yields before it slides, by {size}"],
  "element.backlash": ["play of the element", "The element has {size} of play"],
  "element.asymmetry": ["friction that differs by direction", "Friction differs by {size} between the two directions"],
  "element.viscous": ["viscous friction of the element", "Friction grows with speed, by {size}"],
  "element.stribeck": ["friction of the element at rest", "Friction is higher at rest than in motion, by {size}"],
  "element.load": ["friction that follows the load", "Friction follows the load, by {size}"],
  "law.scale": ["scale of the law", "The torque is {size} {above|below} the design at every angle"],
  "law.series": ["yielding between cam and dynamometer", "Something between cam and dynamometer yields, by {size}"],
  "law.preload": ["preload of the cam", "The cam starts {size} {wound|slack} along its law"],
  "law.hysteresis": ["hysteresis of the law", "Unloading gives back less torque than loading takes, by {size}"],
  "law.coulomb": ["constant friction of the joint", "The joint has {size} of constant friction"],
  "law.arm": ["arm of the cam", "The cam's arm differs from the design by up to {size}"],
  "loop.gain": ["gain of the position loop", "The position loop is {size} {stiffer|softer} than its gain"],
};

const kPlaces = { se: "the series spring", pe: "the parallel spring", k_se: "the series spring", k_pe: "the parallel spring", joint_encoder: "the joint encoder", capstan_encoder: "the capstan's encoder" };
const kSides = { both: " on both sides", agonist: " on the agonist's side", antagonist: " on the antagonist's side" };
const spaced = (text) => text.replaceAll("_", " ");

/** "term.motor.ripple" is "ripple of the motor", "port.angle_rad.delay" is "delay of column angle_rad"; an effect of a user's model keeps its own name. */
const unlisted = (id) => {
  const [what, place] = id.split(".").reverse();
  if (!place) return id;
  return `${spaced(what)} of ${id.startsWith("port.") ? `column ${place}` : kPlaces[place] ?? `the ${spaced(place)}`}`;
};

/** Without a side. */
export const plainName = (id) => kCauses[id]?.[0] ?? unlisted(id);
/** "gear friction on both sides" */
export const causeName = ({ id, side }) => plainName(id) + (kSides[side] ?? "");
export const causesName = (causes, between = " and ") => causes.map(causeName).join(between) || "no effect";

/** A text of the engine in which effects stand by their ids: "gear.coulomb (both)". */
export function withNames(text) {
  return text.replace(/\b((?:term\.)?[a-z_]+\.[a-z_]+)(?: \((both|agonist|antagonist|none)\))?/g, (found, id, side) => (kCauses[id] || id.startsWith("term.") ? causeName({ id, side }) : found));
}

/** What an effect is, without the signs of its size: "stiffer or softer". */
export const signless = (meaning) => meaning.replaceAll(" (+)", "").replaceAll(" (-)", "");

const isShare = ({ unit }) => unit === "1" || unit === "";

/** "30 %", "0.12 Nm"; a share of 1 in per cent. */
export function sizeText(parameter) {
  return isShare(parameter) ? percentText(parameter.value) : withUnit(number(forReading(parameter).value, 3), forReading(parameter).unit);
}
const percentText = (share) => (isKnown(share) ? `${number(100 * share, 2)} %` : percent(share));

/** "26 to 34 %", "0.11 to 0.13 Nm"; "" where the fit gives none. */
export function intervalText(parameter) {
  const { ci95, unit } = forReading(parameter);
  if (!ci95.every(isKnown)) return "";
  return isShare(parameter) ? `${ci95.map((end) => number(100 * end, 2)).join(" to ")} %` : withUnit(span(ci95), unit);
}

/** The same effect with its size and its interval above 0. */
function turned({ value, ci95 = [null, null], unit }) {
  return value < 0 ? { value: -value, ci95: [ci95[1], ci95[0]].map((end) => (isKnown(end) ? -end : end)), unit } : { value, ci95, unit };
}

/** An effect of a column in the words of its model: "Column angle_rad is later by a constant time: {size}". */
function portForm(id, { meaning = "" } = {}, value) {
  const signed = meaning.replace(/\.$/, "").replace(/(\w+) \(\+\) or (\w+) \(-\)/, (_, more, less) => (value < 0 ? less : more));
  return `${signed.replace(/this column/i, (found) => `${found.startsWith("T") ? "C" : "c"}olumn ${id.split(".")[1]}`)}: {size}`;
}

/** "Gear friction is 30 % above the model on both sides (26 to 34 %)" @param known what the model says of it, if it is a user's */
export function effectSentence({ id, side, parameter }, known) {
  const form = kCauses[id]?.[1] ?? (id.startsWith("port.") && known?.meaning ? portForm(id, known, parameter.value) : id.includes(".") ? `${capitalised(plainName(id))}{side}: {size}` : `${id} is {size} {above|below} the model{side}`), chosen = /\{[a-z]+\|[a-z]+\}/.test(form), shown = chosen ? turned(parameter) : parameter;
  const interval = intervalText(shown), text = form.replaceAll(/\{([a-z]+)\|([a-z]+)\}/g, (_, more, less) => (parameter.value < 0 ? less : more)).replace("{size}", sizeText(shown)).replace("{side}", kSides[side] ?? "");
  return text + (interval && ` (${interval})`);
}
