// Elements of the page, in short.

/** @param attributes "on" functions become listeners; null and false are left out */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === false) continue;
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

export const button = (text, attributes) => element("button", { type: "button", ...attributes }, text);

/** A closed block of controls with its title. */
export const fold = (title, ...children) => element("details", { class: "joint3d-fold" }, element("summary", {}, title), element("div", {}, ...children));

/** A slider with its name and its value in words. */
export function slider(id, name, attributes, oninput) {
  const value = element("output", { for: id });
  const input = element("input", { type: "range", id, ...attributes, oninput: () => oninput(Number(input.value)) });
  const row = element("div", { class: "joint3d-slider" }, element("label", { for: id }, name), input, value);
  const show = (number, words) => {
    input.value = number;
    value.textContent = words;
    input.setAttribute("aria-valuetext", words);
  };
  return { row, input, show };
}

/** A colour of the page's style. */
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const degrees = (angle) => (angle * 180) / Math.PI;
