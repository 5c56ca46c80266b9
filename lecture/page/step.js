// The texts of a step: its handout with the equation and the code in it; and the list of keys.

/** The equation in the handout, with a place for the number of each symbol. */
const formula = () => handout(state.step).querySelector(".equation");

/** Whether the cover is shown. */
let covered = false;

/** Shows the step's handout, or the cover, from its top on. */
function showStep() {
  covered = isCovered();
  const essay = handout(state.step);
  const shown = covered ? $(`cover-${language}`) : essay;
  for (const link of $("steps").querySelectorAll("a")) {
    const is = link.hash === (covered ? "" : `#step${two(state.step)}`);
    if (is) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  for (const article of document.querySelectorAll("article"))
    article.hidden = article !== shown;
  formula().querySelector("h3").after($("numbers"));
  essay.querySelector(".exercise").before($("code"));
  if (covered) showPassage();
  const title = titleOf(state.step);
  document.title = covered ? $("name").textContent : `${title} · ${$("name").textContent}`;
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
  if (reading === "code") shown.querySelector("details").open = true;
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
