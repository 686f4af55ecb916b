// What a page is built of. Parameters named text, title or note are texts; content is markup.
import { html, isEmpty } from "./markup.js";

/** "Spring law" is "spring-law". */
export const idOf = (title) => title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");

/** A part of the page, in its table of contents; nothing without content. */
export function section(title, content, id = idOf(title)) {
  return isEmpty(content) ? null : html`<section id="${id}"><h2>${title}</h2>${content}</section>`;
}

/** The same, closed until the reader, a link into it or a print opens it. @param note stands beside the title */
export function foldedSection(title, note, content, id = idOf(title)) {
  if (isEmpty(content)) return null;
  return html`<section id="${id}"><details><summary><h2>${title}</h2><span>${note}</span></summary>${content}</details></section>`;
}

/** A closed block inside a section. */
export const folded = (summary, content) => (isEmpty(content) ? null : html`<details class="block"><summary>${summary}</summary>${content}</details>`);
export const paragraph = (text) => html`<p>${text}</p>`;
export const faintParagraph = (text) => html`<p class="faint">${text}</p>`;
export const subheading = (text) => html`<h3 class="held">${text}</h3>`;
export const bulletList = (texts) => (texts.length ? html`<ul>${texts.map((text) => html`<li>${text}</li>`)}</ul>` : null);
/** Charts and cards in two columns. */
export const grid = (...content) => html`<div class="grid">${content}</div>`;
export const card = (...content) => html`<div class="card">${content}</div>`;
export const facts = (pairs) => html`<dl>${pairs.map(([name, value]) => html`<dt>${name}</dt><dd>${value}</dd>`)}</dl>`;
export const linkTo = (id, text) => html`<a href="#${id}">${text}</a>`;

const kSigns = { pass: "\u2713 ", unjudged: "? ", warning: "! ", error: "\u2715 " };
/** The class of a severity of the JSON. */
export const cssOf = (severity) => (severity === "not judged" ? "unjudged" : severity);
/** A pill that begins with the severity's sign. */
export const tag = (severity, text) => html`<span class="tag ${cssOf(severity)}-tag">${kSigns[cssOf(severity)]}${text}</span>`;
/** The verdict of a page. That of a design that was not fully judged has the sign of a pass. */
export function verdictTag(severity, text) {
  const css = cssOf(severity);
  return html`<span class="verdict ${css}-tag">${kSigns[css === "unjudged" ? "pass" : css]}${text}</span>`;
}

/**
 * The head of a page.
 * @param tiles of each figure its name, the figure, and at most a line @param more markup below the tiles
 */
export function pageHead({ kind, title, verdict = null, sentence = "", stamp, tiles = [], more = null }) {
  const boxes = tiles.map(([name, value, line = ""]) => html`<div class="tile"><p>${name}</p><b>${value}</b>${line && html`<span>${line}</span>`}</div>`);
  return html`<header><p class="eyebrow">${kind} \u00b7 ${stamp}</p><div class="title"><h1>${title}</h1>${verdict}</div>${sentence && html`<p class="lead">${sentence}</p>`}${boxes.length ? html`<div class="tiles">${boxes}</div>` : null}${more}</header>`;
}

/** A link to every section, by its id and heading. */
function contents(body) {
  const links = [...String(body).matchAll(/<section id="([^"]*)"[^>]*>(?:<details><summary>)?<h2>(.*?)<\/h2>/g)];
  return links.length ? `<nav aria-label="Contents"><ol>${links.map(([, id, name]) => `<li><a href="#${id}">${name}</a></li>`).join("")}</ol></nav>` : "";
}

/** A whole page, as text for the body of the document. @param head `folds`: its sections are folded, and their heads are its contents @param sections each markup or null */
export function page(head, sections) {
  const body = html`${sections}`;
  return `<a class="skip" href="#main">To the content</a>${pageHead(head)}<div class="columns">${head.folds ? "" : contents(body)}<main id="main" tabindex="-1">${body}</main></div>`;
}
