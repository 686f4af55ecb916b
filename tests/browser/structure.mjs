// The structure of a page that the modules of web/src draw from a JSON, so that tests do not depend on its prose.
import assert from "node:assert/strict";
import { page } from "../../web/src/kit/sections.js";
import { pages } from "../../web/src/pages.js";

const kVoid = ["meta", "br", "input"];

/** The first tag that does not close the innermost open one; "" if all are balanced. */
export function firstUnbalanced(html) {
  const open = [];
  for (const [, tag] of html.matchAll(/<(\/?[a-zA-Z][^>]*)>/g)) {
    const name = tag.match(/^\/?[\w-]+/)[0];
    if (tag.endsWith("/") || kVoid.includes(name)) continue;
    if (!name.startsWith("/")) open.push(name);
    else if (`/${open.pop()}` !== name) return tag;
  }
  return open.pop() ?? "";
}

/** The texts of every element of a name. */
export const elements = (html, name) => [...html.matchAll(new RegExp(`<${name}[\\s>][^]*?</${name}>`, "g"))].map(([found]) => found.replace(/<[^>]*>/g, ""));
export const occurrences = (html, text) => html.split(text).length - 1;

/** A page as text: well-formed, loads nothing, and has no figure that JavaScript could not write. */
export function drawn(name, result, data = {}) {
  const { head, sections } = pages[name](result, (id) => data[id]), html = page(head, sections);
  assert.equal(firstUnbalanced(html), "", name);
  for (const wrong of ["undefined", "NaN", ">null", "null ", "[object", "Infinity", "http://", "https://", "<script", "<link", "<img", "src=", "url("])
    assert.ok(!html.includes(wrong), `${name}: "${wrong}" at ...${html.slice(Math.max(0, html.indexOf(wrong) - 120), html.indexOf(wrong) + 60)}`);
  const links = [...html.matchAll(/href="#([^"]*)"/g)].map(([, id]) => id).filter((id) => !html.includes(`id="${id}"`));
  assert.deepEqual(links, [], `${name}: links to nothing`);
  return html;
}
