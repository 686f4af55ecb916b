// Figures as texts. A figure that is not known is null in the JSON of a result, and an en dash here.

export const kUnknown = "\u2013";
export const isKnown = (value) => typeof value === "number" && Number.isFinite(value);
export const degrees = (rad) => (isKnown(rad) ? (rad * 180) / Math.PI : null);
export const millimetres = (m) => (isKnown(m) ? 1e3 * m : null);

const trimmed = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);

/** %g of C: `digits` significant digits without trailing zeros, "1e-05" for the very small and the very large. */
export function general(value, digits = 6) {
  if (value === 0) return "0";
  const [mantissa, power] = value.toExponential(digits - 1).split("e"), exponent = Number(power);
  if (exponent >= -4 && exponent < digits) return trimmed(value.toFixed(digits - 1 - exponent));
  return `${trimmed(mantissa)}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
}

/** `digits` significant digits, whole numbers in full. */
export function number(value, digits = 4) {
  if (!isKnown(value)) return kUnknown;
  const size = Math.abs(value);
  return size >= 10 ** digits && size < 1e9 ? value.toFixed(0) : general(value, digits);
}

/** The values at the marks of an axis: as many digits as tell them apart, no "-0". */
export function axisTexts(values) {
  for (let digits = 4; digits < 12; ++digits) {
    const texts = values.map((value) => general(value, digits));
    if (new Set(texts).size === new Set(values).size) return texts;
  }
  return values.map((value) => general(value, 12));
}

/** With `digits` decimals. */
export const fixed = (value, digits) => (isKnown(value) ? value.toFixed(digits) : kUnknown);
/** An angle in degrees, without the unit. */
export const deg = (rad, digits = 4) => number(degrees(rad), digits);
export const newtonMetres = (torque, digits = 3) => `${number(torque, digits)} Nm`;
/** "0.12 to 0.5" of [low, high]; an en dash if an end is not known. */
export const span = (range, digits = 3) => (range && range.every(isKnown) ? range.map((value) => number(value, digits)).join(" to ") : kUnknown);
/** "9.1 -> 1.04" with an arrow. */
export const change = (before, after) => `${number(before, 3)} \u2192 ${number(after, 3)}`;
/** 0.62 is "62 %". */
export const percent = (share, decimals = 0) => (isKnown(share) ? `${(100 * share).toFixed(decimals)} %` : kUnknown);
export const counted = (count, what, many = `${what}s`) => `${count} ${count === 1 ? what : many}`;
export const capitalised = (text) => text.charAt(0).toUpperCase() + text.slice(1);
export const withUnit = (value, unit) => (unit ? `${value} ${unit}` : value);

export function bytesText(bytes) {
  const [size, unit, decimals] = bytes < 1e3 ? [1, "B", 0] : bytes < 1e6 ? [1e3, "kB", 1] : bytes < 1e9 ? [1e6, "MB", 2] : [1e9, "GB", 2];
  return `${(bytes / size).toFixed(decimals)} ${unit}`;
}
