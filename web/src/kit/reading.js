// What a page does with its folded blocks and its table of contents.

/** A link to something folded opens it; a link to a folded section opens that. */
export function followLinks() {
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    const closed = [];
    if (target.firstElementChild?.tagName === "DETAILS") closed.push(target.firstElementChild);
    for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details")) closed.push(fold);
    for (const fold of closed) fold.open = true;
    if (closed.length) target.scrollIntoView();
  };
  addEventListener("hashchange", reveal);
  reveal();
}

/** A print holds all that is folded. */
export function unfoldForPrint() {
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    for (const fold of opened) fold.open = true;
  });
  addEventListener("afterprint", () => {
    for (const fold of opened) fold.open = false;
    opened = [];
  });
}

/** The section in view is marked in the table of contents. */
export function markContents() {
  const links = [...document.querySelectorAll("nav a")], sections = [...document.querySelectorAll("main>section")], seen = new Set();
  if (!links.length) return;
  const watch = new IntersectionObserver((entries) => {
    for (const entry of entries) entry.isIntersecting ? seen.add(entry.target) : seen.delete(entry.target);
    const first = sections.find((section) => seen.has(section));
    for (const link of links) {
      if (first && link.hash === `#${first.id}`) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
  }, { rootMargin: "0px 0px -60% 0px" });
  for (const section of sections) watch.observe(section);
}
