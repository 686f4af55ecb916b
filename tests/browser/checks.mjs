// What a reader does on a page. Each check takes the page, its name, expect(holds, what) and a list of notes.

/** A chart tells values for the arrow keys, zooms for + and shows all again for 0. */
export async function checkCharts(page, name, expect) {
  const count = await page.locator("figure.plot>svg[data-box]").count();
  if (!["study", "assembly"].includes(name)) expect(count > 0, "there is no chart");
  if (count === 0) return;
  const figures = page.locator("figure.plot:has(>svg[data-box])"), figure = name === "search" ? figures.last() : figures.first(), chart = figure.locator(".chart");
  await figure.scrollIntoViewIfNeeded();
  await chart.waitFor({ timeout: 5000 }).catch(() => {});
  if (!(await chart.count())) return expect(false, "no chart is live");
  expect(!(await figure.locator(":scope>svg").isVisible()), "the SVG still stands beside the live chart");
  // Pixels that are drawn, and how many of them differ from the first time.
  const ink = () => figure.locator("canvas").evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height), whole = (canvas.whole ??= data);
    let drawn = 0, other = 0;
    for (let i = 3; i < data.length; i += 4) { drawn += data[i] > 0; other += Math.abs(data[i] - whole[i]) > 64; }
    return { drawn, other };
  });
  await chart.focus();
  await page.keyboard.press("0");
  await page.waitForTimeout(300);  // drawn at its final size
  const whole = await ink();
  expect(whole.drawn > 500, `the chart has ${whole.drawn} drawn pixels`);
  for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
  const values = await figure.locator(".keys b").allTextContents();
  expect(values.some((v) => /\d/.test(v)), "the arrow keys tell no value");
  await page.keyboard.press("+");
  await page.waitForTimeout(60);
  const zoomed = await ink();
  expect(zoomed.other > 0.1 * whole.drawn, `+ does not zoom: ${zoomed.other} of ${whole.drawn} drawn pixels differ`);
  await page.keyboard.press("0");
  await page.waitForTimeout(300);
  const again = await ink();  // dashes begin elsewhere
  expect(again.other < 0.15 * whole.drawn && again.other < 0.5 * zoomed.other, `0 does not show all again: ${again.other} of ${whole.drawn} drawn pixels differ`);
}

/** Every link inside the page leads to something; one to a folded row opens its block. */
export async function checkLinks(page, name, expect) {
  const dead = await page.evaluate(() => [...document.querySelectorAll('a[href^="#"]')].map((a) => a.getAttribute("href").slice(1)).filter((id) => !document.getElementById(id)));
  expect(dead.length === 0, `links to nothing: ${[...new Set(dead)].join(", ")}`);
  if (name !== "report") return;
  const mark = page.locator("a.place").first();
  await mark.focus();
  await page.keyboard.press("Enter");
  const id = (await mark.getAttribute("href")).slice(1);
  expect(await page.locator(`#${id}`).evaluate((e) => e.matches(":target") && e.getBoundingClientRect().top < innerHeight), `the mark on the drawing does not lead to ${id}`);
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
  await page.waitForTimeout(60);
  expect(await details.evaluate((d) => d.open), `a link to ${id} does not open it`);
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
  expect((await page.evaluate(() => window.fuseeScene.drawnShare())) > 0.01, "the scene is blank");
  const before = await state();
  await page.locator('#joint-3d input[type="range"]').first().focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press("ArrowRight");
  const after = await state();
  expect(after.tau_Nm > before.tau_Nm, "the slider does not raise the co-contraction");
  for (const body of ["k_pe_agonist", "k_se_agonist", "k_pe_antagonist"])
    expect(Math.abs(after.angles_deg[body] - before.angles_deg[body]) > 1, `the slider does not turn ${body}`);
  expect(Math.abs(after.angles_deg.k_pe_agonist + after.angles_deg.k_pe_antagonist) < 1e-3, "both sides are not mirror images");
  if (name === "report") await checkMarkers(page, expect, state);
}

/** A finding is linked to its place on the part, in both directions. */
async function checkMarkers(page, expect, state) {
  const marker = page.locator("#joint-3d .joint3d-marker:visible").last(), number = Number(await marker.getAttribute("data-finding"));
  await marker.click();
  expect((await state()).finding === number, `a click on marker ${number} does not select it`);
  expect(await page.evaluate((n) => document.getElementById(`finding-${n}`).closest("tr").classList.contains("joint3d-row"), number), `row ${number} is not highlighted`);
  await marker.click();
  expect((await state()).finding === null, "a second click does not let go");
  await page.locator(`#finding-${number} button`).click();
  expect((await state()).finding === number, `the row's button does not show finding ${number}`);
}
