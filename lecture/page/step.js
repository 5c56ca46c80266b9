// The texts of a step: its handout, its equation below the picture; and the list of keys.

/** The equation of each handout, which stands below the picture. */
const formulas = new Map();

function showStep() {
  const shown = handout(state.step);
  for (const link of $("steps").querySelectorAll("a")) {
    if (link.hash === `#step${two(state.step)}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  for (const article of document.querySelectorAll("article"))
    article.hidden = article !== shown;
  if (!formulas.has(shown)) formulas.set(shown, shown.querySelector(".equation"));
  $("formula").replaceChildren(formulas.get(shown));
  $("formula").lang = language;
  const title = titleOf(state.step);
  document.title = `${title} · ${text("Ray tracing, step by step")}`;
  $("title").textContent = title;
}

/** Shows what is read; where another text was read `before`, begins at its top. */
function read(before) {
  const { reading, step } = state;
  $("keys").hidden = reading !== "keys";
  const list = reading !== "keys" ? [] : asked("keys").flatMap(([keys, effect]) =>
    [element("dt", { textContent: keys }), element("dd", { textContent: effect })]);
  $("keys").querySelector("dl").replaceChildren(...list);
  const was = before ? before.reading : "pixel";
  if (was === reading && (reading === "pixel" || before.step === step)) return;
  const shown = {
    pixel: $("panels"),
    keys: $("keys"),
    stops: $("stops"),
    code: $("code"),
    idea: handout(step),
  }[reading];
  const folded = shown.querySelector("details");
  if (reading === "code" || reading === "idea") folded.open = true;
  shown.scrollIntoView();
}

/** Of each line of a difference, how far it is indented. */
function indent() {
  for (const lines of document.querySelectorAll(".diff")) {
    for (const part of lines.childNodes) {
      if (part.nodeType !== 3) continue;
      const pieces = part.data.split(/(?<=\n)/);
      part.replaceWith(...pieces.map((line) => element("span", { textContent: line })));
    }
    for (const line of lines.children)
      line.style.setProperty("--indent", line.textContent.search(/[^-+ ]|$/));
  }
}
