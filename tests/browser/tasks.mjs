// What a reader comes to a page for. Each check takes the page, its name and expect(holds, what), and waits for states, never for times.
import { settled } from "./checks.mjs";

const laidOut = (page) => settled(page, () => page.evaluate(() => [document.documentElement.scrollHeight, document.querySelector("#joint-3d canvas")?.width]));

const kLeastTarget = 24, kScreen = 900, kMostScreens = 3, kLines_px = { 1400: 40, 420: 84 };  // of a remedy: one line; on a phone its reason stands below it

/** The report: verdict, four figures, remedies in a line each and the scene on the first screen; details folded, so that it has less than three screens. */
export async function checkReport(page, name, expect) {
  if (name !== "report") return;
  const words = await page.evaluate(() => ({ verdict: document.querySelector(".verdict").textContent, tiles: [...document.querySelectorAll(".tile")].map((tile) => [...tile.children].map((e) => e.tagName).join()),
    remedies: [...document.querySelectorAll(".remedy b")].map((e) => e.textContent), open: [...document.querySelectorAll("main>section:not(#joint-3d)")].filter((e) => !e.querySelector(":scope>details:not([open])")).map((e) => e.id) }));
  expect(/^! Can be made once its \d+ warnings are accepted$/.test(words.verdict), `the verdict is "${words.verdict}"`);
  expect(words.tiles.length === 4 && words.tiles.every((tile) => tile === "P,B,SPAN"), `the figures are not four with a name and a line: ${words.tiles.join(" ")}`);
  expect(words.remedies.includes("Turn on supports, 189 mm\u00b2"), `the remedies are ${words.remedies.join("; ")}`);
  expect(words.open.length === 0, `not folded: ${words.open.join(", ")}`);
  for (const width of [1400, 420]) {
    await page.setViewportSize({ width, height: kScreen });
    await laidOut(page);
    const at = await page.evaluate(() => ({ scene: document.querySelector(".joint3d-frame, .joint3d-drawing").getBoundingClientRect().top + scrollY, height: document.documentElement.scrollHeight, lines: [...document.querySelectorAll(".remedy")].map((e) => e.offsetHeight) }));
    expect(at.scene < kScreen, `${width}: the scene begins at ${at.scene} px, below the first screen`);
    expect(at.height < kMostScreens * kScreen, `${width}: the page has ${(at.height / kScreen).toFixed(1)} screens`);
    expect(Math.max(...at.lines) < kLines_px[width], `${width}: a remedy has ${Math.max(...at.lines)} px`);
  }
  await page.setViewportSize({ width: 1400, height: 1200 });
  await laidOut(page);
}

/** The report of one spring: less than three screens before its details. */
export async function checkOneSpring(page, name, expect) {
  if (name !== "one_spring") return;
  for (const width of [1400, 420]) {
    await page.setViewportSize({ width, height: kScreen });
    const height = await settled(page, () => page.evaluate(() => document.documentElement.scrollHeight));
    expect(height < kMostScreens * kScreen, `${width}: the page has ${(height / kScreen).toFixed(2)} screens`);
  }
  await page.setViewportSize({ width: 1400, height: 1200 });
  await laidOut(page);
}

/** What the scene of a report does: names, play, discs apart, a flight to a finding, an explosion in the frame, one finger that scrolls. */
export async function checkViewer(page, name, expect) {
  if (name !== "report" || !(await page.evaluate(() => "fuseeScene" in window))) return;
  const state = () => page.evaluate(() => window.fuseeScene.state), names = await page.locator(".joint3d-name:visible").allTextContents();
  expect(["series spool, left", "series spool, right", "parallel cam, left", "parallel cam, right"].every((text) => names.includes(text)), `the view names ${names.join("; ")}`);
  const unseen = await page.evaluate(() => ["k_se_agonist", "k_se_antagonist", "k_pe_agonist", "k_pe_antagonist"].filter((body) => !window.fuseeScene.sees(body)));
  expect(unseen.length === 0, `the view opens without ${unseen.join(", ")}`);
  const ids = await page.locator(".joint3d-view").evaluate((view) => view.textContent.match(/\w+_(ant)?agonist/g) ?? []);
  expect(ids.length === 0, `the panel has the ids ${ids.join(", ")}`);

  const play = page.locator(".joint3d-play"), first = (await state()).tau_Nm;
  await play.click();
  await page.waitForFunction((tau) => window.fuseeScene.state.tau_Nm !== tau, first);
  await play.click();
  expect(!(await state()).playing, "a second click does not stop the co-contraction");

  const discs = await page.locator(".joint3d-marker:visible").evaluateAll((all) => all.map((e) => e.getBoundingClientRect()).map(({ x, y, width }) => ({ x, y, width })));
  const apart = Math.min(...discs.flatMap((a, i) => discs.slice(i + 1).map((b) => Math.hypot(a.x - b.x, a.y - b.y))));
  expect(discs.length > 1 && apart >= kLeastTarget, `discs are ${apart} px apart`);

  const line = page.locator(".remedy[data-finding]").nth(1), number = Number(await line.getAttribute("data-finding"));
  await line.click();
  expect((await state()).finding === number, `its line does not show finding ${number}`);
  const offCentre = () => page.locator(`.joint3d-marker[data-finding="${number}"]`).evaluate((disc) => {
    const a = disc.getBoundingClientRect(), b = disc.parentElement.getBoundingClientRect();
    return Math.hypot(a.x + a.width / 2 - b.x - b.width / 2, a.y + a.height / 2 - b.y - b.height / 2);
  });
  const off = await settled(page, offCentre);
  expect(off < 60, `the view does not fly to finding ${number}: it is ${off} px off the middle`);

  await page.evaluate(() => window.fuseeScene.act.explode(1));
  expect(await page.evaluate(() => window.fuseeScene.fits()), "the exploded joint leaves the frame");
  await page.evaluate(() => { window.fuseeScene.act.explode(0); window.fuseeScene.act.escape(); });
  await checkFinger(page, expect);
}

/** On a phone every name that the view shows is read whole. */
export async function checkNames(page, name, expect) {
  if (!["report", "diagnosis_joint"].includes(name) || !(await page.evaluate(() => "fuseeScene" in window))) return;
  await page.setViewportSize({ width: 420, height: kScreen });
  await page.locator("#joint-3d canvas").first().scrollIntoViewIfNeeded();
  await laidOut(page);
  const [names, cut] = await page.locator(".joint3d-name:visible").evaluateAll((all) => [all.length, all.filter((e) => {
    const own = e.getBoundingClientRect(), view = e.parentElement.getBoundingClientRect();
    return own.left < view.left - 1 || own.right > view.right + 1 || own.bottom > view.bottom + 1;
  }).map((e) => e.textContent)]);
  expect(names > 1 && cut.length === 0, `of ${names} names the view cuts ${cut.join(", ")}`);
  await page.setViewportSize({ width: 1400, height: 1200 });
  await laidOut(page);
}

/** One finger that moves up on the view scrolls the page. */
async function checkFinger(page, expect) {
  await page.setViewportSize({ width: 420, height: kScreen });
  const canvas = page.locator("#joint-3d canvas").first();
  await canvas.scrollIntoViewIfNeeded();
  await laidOut(page);
  const box = await canvas.boundingBox(), before = await page.evaluate(() => scrollY), devtools = await page.context().newCDPSession(page);
  const x = box.x + box.width / 2, from = Math.min(kScreen - 40, box.y + box.height - 40);
  const send = (type, y) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
  await devtools.send("Emulation.setTouchEmulationEnabled", { enabled: true });
  await send("touchStart", from);
  for (let i = 1; i <= 10; ++i) await send("touchMove", from - 20 * i);
  await send("touchEnd");
  await devtools.send("Emulation.setTouchEmulationEnabled", { enabled: false });
  const scrolled = await page.waitForFunction((y) => scrollY > y + 100, before, { timeout: 10000 }).catch(() => null);
  expect(scrolled, "one finger that moves up on the view does not scroll the page");
  await page.setViewportSize({ width: 1400, height: 1200 });
  await laidOut(page);
}

/** The diagnosis: what is wrong with sign, size and interval, the remedy beside it, the place red in the joint; no bare id, no sign of a scale, no column without content. */
export async function checkDiagnosis(page, name, expect) {
  if (!name.startsWith("diagnosis")) return;
  const seen = await page.evaluate(() => {
    const main = [...document.querySelectorAll("header, main")].map((e) => e.textContent).join(" ").replace(/fusee explain \S+/g, "");
    const empty = [...document.querySelectorAll("main .scroll table")].filter((table) => [...table.tHead.rows[0].cells].some((_, i) => i > 0 && [...table.tBodies[0].rows].every((row) => /^\u2013?$/.test(row.cells[i].textContent.trim()))));
    return { lead: document.querySelector(".lead").textContent, tiles: [...document.querySelectorAll(".tile p")].map((e) => e.textContent), ids: main.match(/\b(?:term|gear|se|pe|joint|sensor|cable|loop|motor)\.[a-z_]+\b/g) ?? [], signs: /\([+-]\)/.test(main),
      certain: main.includes("Probability: 1."), empty: empty.map((table) => table.caption.textContent) };
  });
  expect(seen.ids.length === 0, `bare ids: ${[...new Set(seen.ids)].join(", ")}`);
  expect(!seen.signs && !seen.certain, "there is a (+) or a probability of 1");
  expect(seen.empty.length === 0, `columns without content: ${seen.empty.join(", ")}`);
  if (name !== "diagnosis_joint") return;
  const says = [/Gear friction is \d+ % above the model on [^(]*\(\d+ to \d+ %\)\./, /The parallel spring is \d+ % stiffer than its rate on [^(]*\(\d+ to \d+ %\)\./].every((sentence) => sentence.test(seen.lead));
  expect(says, `the headline is "${seen.lead}"`);
  expect(seen.tiles[0] === "Remedy", `the figures are ${seen.tiles.join(", ")}`);
  if (!(await page.evaluate(() => "fuseeScene" in window))) return;
  const names = await page.locator(".joint3d-name:visible").allTextContents(), red = await page.evaluate(() => window.fuseeScene.state.marked);
  expect(names.includes("capstan, left") && names.includes("parallel spring, right"), `the view names ${names.join("; ")}`);
  expect(["capstan_agonist", "capstan_antagonist", "k_pe_spring_agonist", "k_pe_spring_antagonist"].every((body) => red.includes(body)), `red: ${red.join(", ")}`);
}

/** A study: what was made and what refused it, axes that vary, refused designs as crosses, a card with outlines, a filter that never empties the page. */
export async function checkStudy(page, name, expect) {
  if (name === "pareto") return expect((await page.locator("#plot circle.front").count()) > 0 && (await page.locator("#bx").inputValue()) === "greatest", "the front is not that of the greatest travel");
  if (name !== "study") return;
  const verdict = await page.locator(".verdict").textContent();
  expect(/^! 2 made, 1 refused: (?!.*[a-z]\.[a-z])\w.+$/.test(verdict), `the verdict is "${verdict}"`);
  const points = await page.locator("#plot circle").evaluateAll((all) => all.map((e) => [e.getAttribute("cx"), e.getAttribute("cy")]));
  expect(points.length === 2 && points[0][0] !== points[1][0] && points[0][1] !== points[1][1], `the first axes do not vary: ${points.join("; ")}`);
  expect((await page.locator("#plot .refused").count()) === 1, "the refused design is no cross");
  await page.locator("#plot circle").first().hover();
  await page.locator("#card svg path").first().waitFor();
  expect((await page.locator("#card svg path").count()) === 2, "the card does not show both outlines");
  await page.locator("#plot .refused rect").hover();
  await page.locator("#card .refusal").waitFor();
  await page.locator("#filter").fill("mass_g < 0");
  expect((await page.locator("#message").textContent()) === "No design fulfils this: all 3 are shown.", "a filter that keeps nothing says nothing");
  expect((await page.locator("#plot circle").count()) === 2 && (await page.locator(".study tbody tr").count()) === 3, "a filter empties the page");
  await page.locator("#filter").fill("");
}

/** A simulation: what co-contraction does, in words. */
export async function checkSimulation(page, name, expect) {
  if (name !== "simulation") return;
  const [verdict, lead] = await Promise.all([".verdict", ".lead"].map((part) => page.locator(part).textContent()));
  expect(/^! Co-contraction leaves the stiction at the joint as it is$/.test(verdict), `the verdict is "${verdict}"`);
  expect(/^The dead-band falls from [\d.]+ to [\d.]+ deg as co-contraction rises from [\d.]+ to [\d.]+ Nm\.$/.test(lead), `the headline is "${lead}"`);
}
