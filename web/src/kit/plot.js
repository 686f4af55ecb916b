// Curves and dots over one axis as SVG; the style sheet sets the colours. live.js makes it zoom and tell values; a print shows the SVG.
import { general, isKnown } from "./format.js";
import { html } from "./markup.js";

// Drawing units; the page scales the whole picture.
const kWidth = 520, kHeight = 300, kLeft = 58, kRight = 14, kLegend = 16, kLegendRow = 18, kBare = 12, kBottom = 46, kTick = 5;
const kTicks = 5, kNoteHeight = 14, kLetter = 6.6, kLegendGap = 40, kTickGap = 8, kNameWidth = 22, kDot = 2.6, kCap = 3;

/** Name of the axis of many charts. */
export const kCoContraction = "co-contraction, motor torque at the capstan [Nm]";

/** Three decimals. */
export const at = (value) => String(Number(value.toFixed(3)) || 0);
const keyWidth = (label) => kLegendGap + kLetter * label.length;

/** Range of the known values; [0, 1] without any, widened if all are equal. */
function rangeOf(columns) {
  let low = Infinity, high = -Infinity;
  for (const value of columns.flat()) if (isKnown(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (low > high) return [0, 1];
  return high - low > 1e-9 * Math.max(1, Math.abs(high)) ? [low, high] : [low - 0.5, high + 0.5];
}

function roundStep(width, count) {
  const raw = width / count, power = 10 ** Math.floor(Math.log10(raw));
  return ([1, 2, 5].find((factor) => raw <= factor * power * 1.0001) ?? 10) * power;
}

/** About `count` round values in the range, in steps of 1, 2 or 5 times a power of ten. */
export function roundTicks([low, high], count) {
  const step = roundStep(high - low, count), ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= high / step + 1e-9; ++i) ticks.push(i === 0 ? 0 : i * step);
  return ticks;
}

export class Plot {
  /** Axis names with unit, as "capstan angle [rad]". */
  constructor(title, xName, yName) {
    Object.assign(this, { title, xName, yName, curves: [], dots: [], bands: [], shades: [], marks: [], zero: false });
  }

  /** @param css colour class of the style sheet: se, pe, sum, t, exact, linear. null in y leaves a gap */
  curve(label, x, y, css, dashed = false) {
    this.curves.push({ label, x, y, css, dashed });
    return this;
  }
  /** Dots; with `deviation`, bars from y - deviation to y + deviation, none for null. */
  points(label, x, y, css, deviation = []) {
    const end = (sign) => y.map((value, i) => (isKnown(value) && isKnown(deviation[i]) ? value + sign * deviation[i] : value));
    this.dots.push({ label, x, y, css, low: end(-1), high: end(1) });
    return this;
  }
  /** The area between two curves, behind everything else and not in the legend. */
  band(label, x, low, high, css) {
    this.bands.push({ label, x, low, high, css });
    return this;
  }
  /** A band over a range of x with its name. */
  shade([low, high], label) {
    if (high > low) this.shades.push({ low, high, label });
    return this;
  }
  /** A vertical line with its name. */
  mark(x, label) {
    if (isKnown(x)) this.marks.push({ x, label });
    return this;
  }
  /** Extends the y axis to zero. */
  fromZero() {
    this.zero = true;
    return this;
  }

  #frame() {
    const { curves, dots, bands } = this, all = [...curves, ...dots, ...bands];
    const keys = this.#legendRows().length, top = keys > 0 ? kLegend + kLegendRow * keys : kBare;
    const x = rangeOf(all.map((one) => one.x));
    const [low, high] = rangeOf([...curves.map((one) => one.y), ...[...dots, ...bands].flatMap((one) => [one.low, one.high]), this.zero ? [0] : []]);
    const step = roundStep(high - low, kTicks), y = [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step];
    const letters = Math.max(...roundTicks(y, kTicks).map((tick) => general(tick).length));
    const left = Math.max(kLeft, kNameWidth + kLetter * letters + kTickGap);
    return { x, y, top, left,
      atX: (value) => left + ((value - x[0]) / (x[1] - x[0])) * (kWidth - left - kRight),
      atY: (value) => kHeight - kBottom - ((value - y[0]) / (y[1] - y[0])) * (kHeight - top - kBottom) };
  }

  #axes(f) {
    const bottom = kHeight - kBottom, right = kWidth - kRight;
    return [
      roundTicks(f.y, kTicks).map((tick) => html`<path class="rule" d="M${at(f.left)} ${at(f.atY(tick))}H${right}"/><text class="tick" x="${at(f.left - kTickGap)}" y="${at(f.atY(tick) + 4)}" text-anchor="end">${general(tick)}</text>`),
      roundTicks(f.x, kTicks + 1).map((tick) => html`<path class="axis" d="M${at(f.atX(tick))} ${bottom}v${kTick}"/><text class="tick" x="${at(f.atX(tick))}" y="${bottom + 19}" text-anchor="middle">${general(tick)}</text>`),
      html`<path class="axis" d="M${at(f.left)} ${bottom}H${right}"/>`,
      html`<text class="name" x="${at((f.left + right) / 2)}" y="${kHeight - 8}" text-anchor="middle">${this.xName}</text>`,
      html`<text class="name" transform="translate(15 ${(f.top + bottom) / 2}) rotate(-90)" text-anchor="middle">${this.yName}</text>`,
    ];
  }

  #bands(f) {
    return this.bands.map(({ label, x, low, high, css }) => {
      const rows = x.map((_, i) => i).filter((i) => [x[i], low[i], high[i]].every(isKnown));
      if (!rows.length) return null;
      const place = (i, y) => `${at(f.atX(x[i]))} ${at(f.atY(y[i]))}`;
      return html`<path class="band ${css}" d="M${rows.map((i) => place(i, low)).join("L")}L${rows.reverse().map((i) => place(i, high)).join("L")}Z"><title>${label}</title></path>`;
    });
  }

  #curves(f) {
    return this.curves.map(({ label, x, y, css, dashed }) => {
      let path = "", down = false;
      for (let i = 0; i < x.length; ++i) {
        const shown = isKnown(x[i]) && isKnown(y[i]);
        if (shown) path += `${down ? "L" : "M"}${at(f.atX(x[i]))} ${at(f.atY(y[i]))}`;
        down = shown;
      }
      return html`<path class="curve ${css}${dashed && " dashed"}" d="${path}"><title>${label}</title></path>`;
    });
  }

  #dots(f) {
    return this.dots.map(({ label, x, y, css, low, high }) => {
      const rows = x.map((_, i) => i).filter((i) => isKnown(x[i]) && isKnown(y[i]));
      const circles = rows.map((i) => html`<circle class="dot ${css}" cx="${at(f.atX(x[i]))}" cy="${at(f.atY(y[i]))}" r="${kDot}"/>`);
      const bars = rows.filter((i) => high[i] > low[i]).map((i) => {
        const centre = f.atX(x[i]), left = at(centre - kCap), bottom = at(f.atY(low[i])), top = at(f.atY(high[i]));
        return `M${left} ${bottom}h${2 * kCap}M${left} ${top}h${2 * kCap}M${at(centre)} ${bottom}V${top}`;
      });
      return [bars.length ? html`<path class="curve ${css} bar" d="${bars.join("")}"/>` : null, html`<g><title>${label}</title>${circles}</g>`];
    });
  }

  #notes(f) {
    const note = (x, y, anchor, label) => html`<text class="note" transform="translate(${at(x)} ${at(y)}) rotate(-90)" text-anchor="${anchor}">${label}</text>`;
    const shades = this.shades.map(({ low, high, label }) => {
      const left = f.atX(Math.max(low, f.x[0])), right = f.atX(Math.min(high, f.x[1]));
      // A narrow band's name would cover the curves; its tooltip still shows it.
      return [html`<rect class="shade" x="${at(left)}" y="${f.top}" width="${at(Math.max(0, right - left))}" height="${kHeight - f.top - kBottom}"><title>${label}</title></rect>`,
        right - left < kNoteHeight ? null : note((left + right) / 2 + 4, f.top + 5, "end", label)];
    });
    const marks = this.marks.filter(({ x }) => x >= f.x[0] && x <= f.x[1]).map(({ x, label }) => [
      html`<path class="mark" d="M${at(f.atX(x))} ${f.top}V${kHeight - kBottom}"/>`,
      note(f.atX(x) + (f.atX(x) < kWidth / 2 ? kNoteHeight - 2 : -4), kHeight - kBottom - 6, "start", label)]);
    return [shades, marks];
  }

  /** Keys of the legend in lines that fit the width; none for a single curve. */
  #legendRows() {
    if (this.curves.length + this.dots.length < 2) return [];
    const rows = [];
    let x = kWidth;
    const add = (mark, label) => {
      if (!rows.length || x + keyWidth(label) > kWidth) {
        rows.push([]);
        x = kLeft;
      }
      rows[rows.length - 1].push({ mark, label, x });
      x += keyWidth(label);
    };
    for (const { css, dashed, label } of this.curves) add(html`<path class="curve ${css}${dashed && " dashed"}" d="M0 0h20"/>`, label);
    for (const { css, label } of this.dots) add(html`<circle class="dot ${css}" cx="10" r="${kDot}"/>`, label);
    return rows;
  }

  #legend() {
    return this.#legendRows().map((row, i) => row.map(({ mark, label, x }) => html`<g transform="translate(${at(x)} ${20 + i * kLegendRow})">${mark}<text class="key" x="26" y="4">${label}</text></g>`));
  }

  /** The chart as a figure of the page. data-x and data-y are the ends of the axes, data-box their places: live.js reads the values. */
  svg() {
    const f = this.#frame();
    return html`<figure class="plot"><figcaption>${this.title}</figcaption><svg viewBox="0 0 ${kWidth} ${kHeight}" role="img" aria-label="${this.title}: ${this.yName} over ${this.xName}" data-x="${f.x[0]} ${f.x[1]}" data-y="${f.y[0]} ${f.y[1]}" data-box="${at(f.left)} ${f.top} ${kWidth - kRight} ${kHeight - kBottom}">${this.#axes(f)}${this.#notes(f)}${this.#bands(f)}${this.#curves(f)}${this.#dots(f)}${this.#legend()}</svg></figure>`;
  }
}
