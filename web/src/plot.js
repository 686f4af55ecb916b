// The script of every page. `fusee.plot` is the class uPlot.
import uPlot from "uplot";
import { enliven } from "./charts.js";
import { followLinks, markContents, unfoldForPrint } from "./page.js";

window.fusee = Object.assign(window.fusee ?? {}, { plot: uPlot });

followLinks();
unfoldForPrint();
markContents();
enliven();
