// node small_pages.mjs FOLDER: pages whose results take minutes to make, from the small results of results.mjs: pareto.html, score.html, paper.html.
import { readFileSync, writeFileSync } from "node:fs";
import * as results from "./results.mjs";

const web = (name) => readFileSync(new URL(`../../web/${name}`, import.meta.url), "utf8"), [folder] = process.argv.slice(2);

/** As report::page_file fills the shell (src/report/page/bundle.cpp). */
function pageOf(name, result) {
  const data = `<script type="application/json" id="result">${JSON.stringify(result).replaceAll("<", "\\u003c")}</script>`;
  const texts = { title: name, page: name, style: web("built/page.css"), summary: "a summary", data, script: `<script>${web("built/page.js")}</script>` };
  return web("src/shell.html").replace(/\{(\w+)\}/g, (found, key) => texts[key] ?? found);
}

for (const [name, result] of Object.entries({ pareto: results.front, score: results.score(), paper: results.paper })) writeFileSync(`${folder}/${name}.html`, pageOf(name, result));
