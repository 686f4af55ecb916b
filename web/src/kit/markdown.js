// The Markdown of fusee's guides: headings, paragraphs, lists, tables, pictures, bold type and links; nothing else.
import { html, raw } from "./markup.js";
import { section } from "./sections.js";
import { cell, table } from "./table.js";

/** Bold type and links; only files beside the page are linked. */
function inline(text) {
  return text.split(/(`[^`]+`|\*\*.+?\*\*|\[[^\]]+\]\([\w.-]+\))/).map((piece) => {
    if (piece.startsWith("`")) return html`<code>${piece.slice(1, -1)}</code>`;
    if (piece.startsWith("**")) return html`<b>${piece.slice(2, -2)}</b>`;
    const link = piece.match(/^\[([^\]]+)\]\(([\w.-]+)\)$/);
    return link ? html`<a href="${link[2]}">${link[1]}</a>` : piece;
  });
}

const cellsOf = (row) => row.replace(/^\||\|$/g, "").split("|").map((text) => text.trim());
const markOf = (line) => line.match(/^(\d+\. |- )/)?.[0] ?? "";

/** Lines in blocks: { kind, lines }, where a list item or a paragraph goes on until an empty line or the next block. */
function blocksOf(markdown) {
  const blocks = [];
  let open = false;
  for (const line of markdown.split("\n")) {
    const kind = line.startsWith("|") ? "table" : line.startsWith("![") ? "picture" : /^##? /.test(line) ? "heading" : markOf(line) ? "item" : "text";
    const last = blocks[blocks.length - 1], goesOn = open && last && (kind === "table" ? last.kind === "table" : kind === "text" && last.kind !== "table");
    if (line && goesOn) last.lines.push(line);
    else if (line) blocks.push({ kind, lines: [line] });
    open = line !== "" && kind !== "heading" && kind !== "picture";
  }
  return blocks;
}

function tableOf(lines, caption) {
  const [head, , ...rows] = lines.map(cellsOf);
  return table(caption, head, rows.map((row) => row.map((text) => cell(inline(text), /^[\d.-]+$/.test(text) ? "num" : ""))));
}

/** Items of one list are joined. @param pictures SVGs by the name of their file without ending */
function markupOf(blocks, caption, pictures) {
  const out = [];
  let items = [];
  const close = () => {
    if (items.length) out.push(items[0].numbered ? html`<ol>${items.map(({ text }) => html`<li>${text}</li>`)}</ol>` : html`<ul>${items.map(({ text }) => html`<li>${text}</li>`)}</ul>`);
    items = [];
  };
  for (const { kind, lines } of blocks) {
    const text = lines.map((line) => line.trim()).join(" ");
    if (kind === "item") { items.push({ numbered: /^\d/.test(text), text: inline(text.slice(markOf(text).length)) }); continue; }
    close();
    if (kind === "table") out.push(tableOf(lines, caption));
    else if (kind === "picture") out.push(html`<figure class="card guide">${raw(pictures[text.match(/\(([\w-]+)\./)[1]])}</figure>`);
    else out.push(html`<p>${inline(text)}</p>`);
  }
  close();
  return out;
}

/** The title of a guide and its sections, the text before the first heading under `first`. */
export function guideSections(markdown, first, pictures) {
  const parts = [{ title: first, blocks: [] }];
  let title = "";
  for (const block of blocksOf(markdown)) {
    const heading = block.kind === "heading" && block.lines[0];
    if (heading && heading.startsWith("# ")) title = heading.slice(2);
    else if (heading) parts.push({ title: heading.slice(3), blocks: [] });
    else parts[parts.length - 1].blocks.push(block);
  }
  return { title, sections: parts.map((part) => section(part.title, markupOf(part.blocks, part.title, pictures))) };
}
