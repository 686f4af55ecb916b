// node pages.mjs PICTURES NAME=FILE...: checks each page and leaves pictures of it in the folder PICTURES.
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";
import { checkCharts, checkFolds, checkLinks, checkPrint, checkScene, settled } from "./checks.mjs";
import { checkDiagnosis, checkNames, checkOneSpring, checkReport, checkSimulation, checkStudy, checkViewer } from "./tasks.mjs";

const [output, ...pages] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const kFont = '*{font-family:"DejaVu Sans",sans-serif!important;transition:none!important;scroll-behavior:auto!important}';
// Each scheme and each width once, and all four of the large pages in the long form. These three have small results.
const kSmall = process.env.FUSEE_LONG_TESTS ? ["pareto", "score", "paper"] : pages.map((entry) => entry.split("=")[0]);
const kMostShift = 0.05;                     // half of what is called good (web.dev/cls)
const failures = [], notes = [];
let checks = 0;

/** A fact about a page; false is a failure. */
function expect(where, holds, what) {
  ++checks;
  if (!holds) failures.push(`${where}: ${what}`);
}

async function opened(context, file, where) {
  const page = await context.newPage(), url = `file://${file}`;
  page.on("console", (message) => { if (message.type() === "error") failures.push(`${where}: console: ${message.text()}`); });
  page.on("pageerror", (error) => failures.push(`${where}: script: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && request.url().split("#")[0] !== url) failures.push(`${where}: request of ${request.url()}`);
  });
  await page.addInitScript(() => {
    window.shifted = 0;
    new PerformanceObserver((list) => { for (const entry of list.getEntries()) window.shifted += entry.hadRecentInput ? 0 : entry.value; }).observe({ type: "layout-shift", buffered: true });
  });
  await page.goto(url);
  const shifted = await settled(page, () => page.evaluate(() => window.shifted));
  expect(where, shifted < kMostShift, `what the reader sees moves by itself as the page opens: layout shift ${shifted.toFixed(3)}`);
  await page.addStyleTag({ content: kFont });
  return page;
}

async function checkAxe(page, where) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run({ resultTypes: ["violations"], rules: { "target-size": { enabled: true } } }));  // at least 24 px
  expect(where, violations.length === 0, `axe: ${violations.map((v) => `${v.id} (${v.help}) at ${v.nodes.slice(0, 3).map((n) => n.target).join(", ")}`).join("; ")}`);
}

/** A page that is open, as it looks in light or dark at a width. */
async function checkLook(page, name, colorScheme, width) {
  const where = `${name} ${colorScheme} ${width}`;
  await page.setViewportSize({ width, height: 1200 });
  await page.emulateMedia({ colorScheme });
  const wide = await settled(page, () => page.evaluate(() => document.documentElement.scrollWidth));  // charts take the new width
  expect(where, wide <= width, `the page is ${wide} px wide and scrolls sideways`);
  if (width < 1000) {
    const setOpen = (open) => page.evaluate((wanted) => {
      const changed = [...document.querySelectorAll(wanted ? "details:not([open])" : "details[data-opened]")];
      for (const block of changed) block.open = wanted, block.toggleAttribute("data-opened", wanted);
    }, open);
    await setOpen(true);
    const unfolded = await settled(page, () => page.evaluate(() => document.documentElement.scrollWidth));
    expect(where, unfolded <= width, `unfolded, the page is ${unfolded} px wide and scrolls sideways`);
    await setOpen(false);
  }
  if ((colorScheme === "light") === (width > 1000)) await checkAxe(page, where);  // each scheme and each width once
  await page.screenshot({ path: `${output}/${name}_${colorScheme}_${width}.png` });
}

/** Without scripts a page shows its summary. */
async function checkWithoutScripts(browser, name, file) {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(`file://${file}`);
  expect(name, (await page.locator("noscript pre, main section").count()) > 0, "without scripts there is no summary");
  await context.close();
}

async function checkPage(browser, name, file) {
  const context = await browser.newContext({ viewport: { width: 1400, height: 1200 }, deviceScaleFactor: 0.5, reducedMotion: "reduce" });
  const page = await opened(context, file, name);
  const looks = kSmall.includes(name) ? [["light", 1400], ["dark", 420]] : ["light", "dark"].flatMap((scheme) => [[scheme, 1400], [scheme, 420]]);
  for (const [scheme, width] of looks) await checkLook(page, name, scheme, width);
  await page.setViewportSize({ width: 1400, height: 1200 });
  await page.emulateMedia({ colorScheme: "light" });
  for (const check of [checkReport, checkOneSpring, checkDiagnosis, checkNames, checkStudy, checkSimulation, checkFolds, checkCharts, checkLinks, checkViewer, checkScene, checkPrint]) await check(page, name, (holds, what) => expect(name, holds, what), notes);
  await context.close();
  await checkWithoutScripts(browser, name, file);
}

mkdirSync(output, { recursive: true });
const flags = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-sync"];
if (process.getuid() === 0) flags.push("--no-sandbox");
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
const begin = Date.now();
for (const entry of pages) {
  const [name, file] = entry.split("=");
  await checkPage(browser, name, file);
}
await browser.close();
for (const note of notes) console.log(`NOTE: ${note}`);
for (const failure of failures) console.log(`FAIL: ${failure}`);
console.log(`${pages.length} pages, ${checks} checks, ${failures.length} failures, ${((Date.now() - begin) / 1000).toFixed(1)} s`);
process.exit(failures.length || checks === 0 ? 1 : 0);
