// Reads the values of a chart from its SVG (plot.js): its paths, and the frame in data-x, data-y and data-box.

const numbers = (text) => text.trim().split(/\s+/).map(Number);
const title = (element) => element.querySelector("title")?.textContent ?? "";

/** Runs of rising or falling x, each sorted by rising x: a loop has two. */
function runs(points) {
  const all = [];
  let run = [], way = 0;
  for (const point of points) {
    const step = run.length ? point[0] - run[run.length - 1][0] : 0;
    if (run.length && step * way < 0) {
      all.push(run);
      run = [run[run.length - 1]];
      way = 0;
    }
    if (step !== 0) way = Math.sign(step);
    if (run.length && step === 0) run.pop();
    run.push(point);
  }
  all.push(run);
  return all.map((r) => (r[0][0] > r[r.length - 1][0] ? r.reverse() : r)).map((r) => [r.map((p) => p[0]), r.map((p) => p[1])]);
}

/** @returns {{x, y, box, toX, toY, curves, dots, drawn}} curves: label, element, runs of values; drawn: shapes that are only drawn */
export function readChart(svg) {
  const x = numbers(svg.dataset.x), y = numbers(svg.dataset.y), box = numbers(svg.dataset.box), [left, top, right, bottom] = box;
  const toX = (px) => x[0] + ((px - left) / (right - left)) * (x[1] - x[0]), toY = (py) => y[0] + ((bottom - py) / (bottom - top)) * (y[1] - y[0]);
  const value = (text) => { const [px, py] = numbers(text); return [toX(px), toY(py)]; };
  const curves = [...svg.querySelectorAll(":scope>path.curve:not(.bar)")].map((element) => ({
    label: title(element), element, dashed: element.classList.contains("dashed"),
    runs: element.getAttribute("d").split("M").filter(Boolean).flatMap((piece) => runs(piece.split("L").map(value))),
  }));
  const dots = [...svg.querySelectorAll(":scope>g:not([transform])")].filter((g) => g.querySelector(".dot")).map((g) => {
    const points = [...g.querySelectorAll(".dot")].map((c) => [toX(+c.getAttribute("cx")), toY(+c.getAttribute("cy"))]);
    return { label: title(g), element: g.querySelector(".dot"), points: points.sort((a, b) => a[0] - b[0]) };
  });
  const drawn = [...svg.querySelectorAll(":scope>rect.shade,:scope>path.mark,:scope>path.band,:scope>path.bar")].map((element) => ({ element, path: shape(element) }));
  const texts = [...svg.querySelectorAll(":scope>text.note")].map((element) => ({ text: element.textContent, at: numbers(element.getAttribute("transform").match(/\(([^)]*)/)[1]) }));
  const names = [...svg.querySelectorAll(":scope>text.name")].map((e) => e.textContent);
  return { x, y, box, curves, dots, drawn, texts, names };
}

function shape(element) {
  if (element.tagName !== "rect") return new Path2D(element.getAttribute("d"));
  const path = new Path2D(), of = (name) => +element.getAttribute(name);
  path.rect(of("x"), of("y"), of("width"), of("height"));
  return path;
}
