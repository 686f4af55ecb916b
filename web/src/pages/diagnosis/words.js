// A diagnosis in words.
import { isKnown, millimetres, number } from "../../kit/format.js";

const kUnits = [["_Nms", "Nms"], ["_Nm", "Nm"], ["_m_s", "m/s"], ["_rad", "rad"], ["_N", "N"], ["_m", "m"], ["_s", "s"], ["_kg", "kg"], ["_A", "A"], ["_V", "V"]];
const kExperiments = { breakaway: "break-away", dead_band: "dead-band", cocontraction: "co-contraction", log: "time log" };
const spaced = (id) => id.replaceAll("_", " ");

/** "dead_band" is "dead-band"; a file keeps its name. */
export const experimentName = (id) => kExperiments[id] ?? (id.includes(".csv") ? id : spaced(id));

/** A sentence of the engine that begins with an experiment's id. */
export const named = (text) => text.replace(/^[a-z_]+(?=: )/, experimentName);

/** A column of a table: "q_high_rad" is "q high [rad]", "v_m_s" is "v [m/s]". */
export function columnName(column) {
  const known = kUnits.find(([ending]) => column.endsWith(ending) && column.length > ending.length);
  return known ? `${experimentName(column.slice(0, -known[0].length))} [${known[1]}]` : spaced(column);
}

/** A probability; "< 0.001" below a thousandth, and nothing is certain: "> 0.999". */
export const chance = (probability) => (isKnown(probability) && probability < 1e-3 ? "< 0.001" : probability >= 0.9995 ? "> 0.999" : number(probability, 3));

/** Lengths in millimetres, pure numbers ("1") without a unit, everything else unchanged. */
export function forReading({ value, ci95 = [null, null], unit }) {
  return unit === "m" ? { value: millimetres(value), ci95: ci95.map(millimetres), unit: "mm" } : { value, ci95, unit: unit === "1" ? "" : unit };
}
