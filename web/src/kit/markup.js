// Markup from values: a text is escaped, markup is taken as it is.

class Markup {
  constructor(text) { this.text = text; }
  toString() { return this.text; }
}

const kSigns = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
/** Control characters of a file's texts are shown as a sign. */
export const escape = (text) => String(text).replace(/[\u0000-\u0008\u000b-\u001f\u007f]/g, "\ufffd").replace(/[&<>"]/g, (sign) => kSigns[sign]);

export const raw = (text) => new Markup(text);

function inserted(value) {
  if (value === null || value === undefined || value === false) return "";
  if (Array.isArray(value)) return value.map(inserted).join("");
  return value instanceof Markup ? value.text : escape(value);
}

/** html`<p>${text}</p>`: texts are escaped; lists are joined; null, undefined and false are nothing. */
export const html = (strings, ...values) => raw(String.raw({ raw: strings }, ...values.map(inserted)));

/** True for null, "" and markup without content. */
export const isEmpty = (markup) => inserted(markup) === "";
