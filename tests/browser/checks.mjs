// What a reader does on a page. Each check takes the page, its name, expect(holds, what) and a list of notes.

const kPatience_ms = 20000;  // a busy machine draws late: no check depends on how fast

/** Whether what is asked for comes true: holds() is asked again until then. */
async function becomes(page, holds) {
  for (const end = Date.now() + kPatience_ms; Date.now() < end; await page.waitForTimeout(50)) if (await holds()) return true;
  return holds();
}

/** What look() tells, once it tells the same twice with two frames between. */
export async function settled(page, look) {
  let last, now = JSON.stringify(await look());
  await becomes(page, async () => {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    [last, now] = [now, JSON.stringify(await look())];
    return last === now;
  });
  return JSON.parse(now);
}

/** Opens every block that holds an element. */
const unfold = (locator) => locator.evaluate((element) => { for (let fold = element.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true; });

/** A chart tells values for the arrow keys, zooms for + and shows all again for 0. */
export async function checkCharts(page, name, expect) {
  const count = await page.locator("figure.plot>svg[data-box]").count();
  if (!["study", "assembly"].includes(name)) expect(count > 0, "there is no chart");
  if (count === 0) return;
  const figures = page.locator("figure.plot:has(>svg[data-box])"), figure = name === "search" ? figures.last() : figures.first(), chart = figure.locator(".chart");
  await unfold(figure);
  const height = () => page.evaluate(() => document.documentElement.scrollHeight), high = await settled(page, height);
  await figure.scrollIntoViewIfNeeded();
  await chart.waitFor({ timeout: kPatience_ms }).catch(() => {});
  if (!(await chart.count())) return expect(false, "no chart is live");
  expect(!(await figure.locator(":scope>svg").isVisible()), "the SVG still stands beside the live chart");
  // Pixels that are drawn, and how many of them differ from the picture that was kept.
  const ink = (keep = false) => figure.locator("canvas").evaluate((canvas, kept) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    if (kept || canvas.kept?.length !== data.length) canvas.kept = data;
    let drawn = 0, other = 0;
    for (let i = 3; i < data.length; i += 4) { drawn += data[i] > 0; other += Math.abs(data[i] - canvas.kept[i]) > 64; }
    return { drawn, other };
  }, keep);
  await chart.focus();
  await page.keyboard.press("0");
  await settled(page, () => ink());
  const whole = await ink(true);
  expect(Math.abs((await settled(page, height)) - high) <= 2, `the page is ${await height()} px high with its live charts, ${high} before: what is below them moves away from a click`);
  expect(whole.drawn > 500, `the chart has ${whole.drawn} drawn pixels`);
  // Pixels of a curve's colour: axes alone are no chart. One curve may cover another.
  const [drawn, curves] = await figure.evaluate((e) => {
    const canvas = e.querySelector("canvas"), { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const keys = [...e.querySelectorAll(".keys li")].filter((key) => key.querySelector("i:not(.dot)")), drawn = keys.filter((key) => {
      const [r, g, b] = getComputedStyle(key.querySelector("i")).color.match(/\d+/g).map(Number);
      for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 24) return true;
      return false;
    });
    return [drawn.length, keys.length];
  });
  expect(drawn > 0 || curves === 0, `none of ${curves} curves is drawn`);
  for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
  const tells = async () => (await figure.locator(".keys b").allTextContents()).some((v) => /\d/.test(v));
  expect(await becomes(page, tells), "the arrow keys tell no value");
  await page.keyboard.press("+");
  await becomes(page, async () => (await ink()).other > 0.1 * whole.drawn);
  const zoomed = await settled(page, () => ink());
  expect(zoomed.other > 0.1 * whole.drawn, `+ does not zoom: ${zoomed.other} of ${whole.drawn} drawn pixels differ`);
  await page.keyboard.press("0");
  await becomes(page, async () => (await ink()).other < Math.min(0.15 * whole.drawn, 0.5 * zoomed.other));
  const again = await settled(page, () => ink());  // dashes begin elsewhere
  expect(again.other < 0.15 * whole.drawn && again.other < 0.5 * zoomed.other, `0 does not show all again: ${again.other} of ${whole.drawn} drawn pixels differ`);
}

/** Every link inside the page leads to something; one to a folded row opens its block. */
export async function checkLinks(page, name, expect) {
  const dead = await page.evaluate(() => [...document.querySelectorAll('a[href^="#"]')].map((a) => a.getAttribute("href").slice(1)).filter((id) => !document.getElementById(id)));
  expect(dead.length === 0, `links to nothing: ${[...new Set(dead)].join(", ")}`);
  if (name !== "report") return;
  const mark = page.locator("a.place").first();
  await unfold(mark);
  await mark.focus();
  await page.keyboard.press("Enter");
  const id = (await mark.getAttribute("href")).slice(1);
  const reached = () => page.locator(`#${id}`).evaluate((e) => e.matches(":target") && e.getBoundingClientRect().top < innerHeight);
  expect(await becomes(page, reached), `the mark on the drawing does not lead to ${id}`);
  const colour = await page.locator(`tr:has(#${id})>td`).first().evaluate((e) => getComputedStyle(e).backgroundColor);
  expect(colour !== "rgba(0, 0, 0, 0)", "the finding of the mark is not highlighted");
}

/** Folded blocks are closed, and a link to one opens it. */
export async function checkFolds(page, name, expect) {
  const folded = page.locator("main>section:has(>details:first-child)").first();
  if (!(await folded.count())) return;
  const id = await folded.getAttribute("id"), details = folded.locator(":scope>details");
  expect(!(await details.evaluate((d) => d.open)), `${id} is open at first`);
  await page.evaluate((to) => { location.hash = to; }, id);
  expect(await becomes(page, () => details.evaluate((d) => d.open)), `a link to ${id} does not open it`);
}

/** A print has the SVG of the charts, all that is folded, and no navigation. */
export async function checkPrint(page, name, expect) {
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const printed = await page.evaluate(() => ({
    navigation: [...document.querySelectorAll("nav,button")].filter((e) => e.offsetParent !== null).length,
    closed: document.querySelectorAll("details:not([open])").length,
    charts: [...document.querySelectorAll("figure.live>svg")].filter((e) => getComputedStyle(e).display === "none").length,
  }));
  expect(printed.navigation === 0, "the print has the navigation or buttons");
  expect(printed.closed === 0, `${printed.closed} folded blocks are not printed`);
  expect(printed.charts === 0, `${printed.charts} charts are not printed`);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.emulateMedia({ media: "screen" });
}

/** The joint in 3D of a report: drawn, moved by its slider, its findings linked with their rows both ways. */
export async function checkScene(page, name, expect, notes) {
  if (!["report", "diagnosis_joint"].includes(name)) return;
  if (!(await page.evaluate(() => "fuseeScene" in window))) return notes.push(`NO 3D on the page ${name}: its scene was not tested`);
  const state = () => page.evaluate(() => window.fuseeScene.state);
  await page.locator("#joint-3d canvas").first().scrollIntoViewIfNeeded();
  expect(await becomes(page, () => page.evaluate(() => window.fuseeScene.drawnShare() > 0.01)), "the scene is blank");
  const before = await state();
  await page.locator('#joint-3d input[type="range"]').first().focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press("ArrowRight");
  await becomes(page, async () => (await state()).tau_Nm > before.tau_Nm);
  const after = await settled(page, state);
  expect(after.tau_Nm > before.tau_Nm, "the slider does not raise the co-contraction");
  for (const body of ["k_pe_agonist", "k_se_agonist", "k_pe_antagonist"])
    expect(Math.abs(after.angles_deg[body] - before.angles_deg[body]) > 1, `the slider does not turn ${body}`);
  expect(Math.abs(after.angles_deg.k_pe_agonist + after.angles_deg.k_pe_antagonist) < 1e-3, "both sides are not mirror images");
  if (name === "report") await checkMarkers(page, expect, state);
}

/** A finding is linked to its place on the part, in both directions. */
async function checkMarkers(page, expect, state) {
  const number = Number(await page.locator("#joint-3d .joint3d-marker:visible").last().getAttribute("data-finding")), marker = page.locator(`#joint-3d .joint3d-marker[data-finding="${number}"]`);
  const shows = (wanted) => becomes(page, async () => (await state()).finding === wanted);
  await marker.click();
  expect(await shows(number), `a click on marker ${number} does not select it`);
  expect(await page.evaluate((n) => document.getElementById(`finding-${n}`).closest("tr").classList.contains("joint3d-row"), number), `row ${number} is not highlighted`);
  await marker.click();
  expect(await shows(null), "a second click does not let go");
  await page.locator(`#finding-${number} button`).click();
  expect(await shows(number), `the row's button does not show finding ${number}`);
}
