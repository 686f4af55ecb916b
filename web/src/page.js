// The script of every page: it draws the page from the JSON of its result. `fusee.plot` is the class uPlot.
import uPlot from "uplot";
import { enliven } from "./kit/live.js";
import { followLinks, markContents, unfoldForPrint } from "./kit/reading.js";
import { page } from "./kit/sections.js";
import { pages } from "./pages.js";

window.fusee = Object.assign(window.fusee ?? {}, { plot: uPlot });

const draw = pages[document.body.dataset.page];
if (draw) {
  const data = (id) => JSON.parse(document.getElementById(id)?.textContent ?? "null"), { head, sections, start } = draw(data("result"), data);
  document.body.insertAdjacentHTML("afterbegin", page(head, sections));
  start?.();
}

followLinks();
unfoldForPrint();
markContents();
enliven();
