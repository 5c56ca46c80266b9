// The keys: the steps' program knows what each does; what only a page can do is done here.

/** What only a page can do, as it knows what is where on it; `fine` if Shift is down. */
const HANDS = {
  before: () => select(-1),
  after: () => select(1),
  less: (fine) => nudge(fine ? -0.1 : -1),
  more: (fine) => nudge(fine ? 0.1 : 1),
  reset: () => act({ reset: selected().name || "" }),
  pin() {
    const here = pointed || (document.activeElement === $("picture") ? [0.5, 0.5] : null);
    if (here) pinAt(here);
    else notice(text("point at the picture to pin a pixel"));
  },
  larger: () => enlarge(1.1),
  smaller: () => enlarge(1 / 1.1),
};

/** The control or heading that keys act on, by its id. */
let chosen = "";

const ROWS = "summary, input, select";

/** What can be selected: headings and controls, as far as they are not folded away. */
const rows = () => [...$("answers").querySelectorAll(ROWS), ...$("controls").querySelectorAll(ROWS)]
  .filter((row) => {
    const fold = row.closest("details");
    return row.tagName === "SUMMARY" || !fold || fold.open;
  });

function selected() {
  const all = rows();
  return all.find(({ id }) => id === chosen) || all.find(({ name }) => name) || all[0];
}

/** Selects this row, as it is seen. */
function choose(row) {
  chosen = row.id;
  for (const other of rows()) (other.closest(".control") || other).classList.remove("selected");
  (row.closest(".control") || row).classList.add("selected");
}

/** Pins a pixel: keys then act on the controls of what is seen there. */
function pinAt(place) {
  act({ pin: place });
  const heading = state.pin && $(`group-${state.hit}`);
  if (!heading || heading.parentNode.contains(selected())) return;
  heading.parentNode.open = true;
  choose(heading.parentNode.querySelector("input, select"));
}

function select(by) {
  const all = rows();
  const row = all[(all.indexOf(selected()) + by + all.length) % all.length];
  choose(row);
  row.focus();
}

function nudge(steps) {
  const row = selected();
  choose(row);
  if (row.name) moved({ nudge: [row.name, steps] });
  else if (row.parentNode.open !== steps > 0) row.click();
  row.scrollIntoView({ block: "nearest" });
}

function enlarge(factor) {
  larger = Math.min(4, Math.max(0.5, larger * factor));
  document.documentElement.style.setProperty("--larger", larger);
  showLegend();
  show();
}

/** Whether what had the focus last belongs to the picture; it may be no more. */
let within = false;

/** Whether a key is the browser's, or that of what has the focus. */
function isKept({ key, target, ctrlKey, altKey, metaKey }) {
  if (ctrlKey || altKey || metaKey || key === "Tab") return true;
  // Whoever reads has all keys; here they act on the picture, and on what belongs to it.
  const here = target === document.body ? within : target.closest(".live");
  if (!here && !state.alone && !state.blank) return true;
  if (/^(Enter| )$/.test(key) && target.matches("a, button, summary, select, [type=checkbox]"))
    return true;
  // Who reads with the keyboard turns pages there, and what has its own ways keeps them.
  return Boolean(target.closest("#handouts, #divider, #pixel, #code, #keys"))
    && /^(Arrow|Page|Home|End|Enter| )/.test(key);
}

function keys() {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || isKept(event)) return;
    if (press(event.key, true, event.shiftKey)) event.preventDefault();
  });
  document.addEventListener("keyup", (event) => press(event.key, false));
  // A click leaves the keys with the control that they act on, or gives them to the picture.
  document.addEventListener("mousedown", (event) => {
    within = false;
    const kept = "#view button, #sliders button, :is(#controls, #answers) summary";
    if (!event.target.closest(kept)) return;
    event.preventDefault();
    within = true;
    if (!document.activeElement.closest("#controls, #answers"))
      $("picture").focus({ preventScroll: true });
  });
  document.addEventListener("focusin", ({ target }) => {
    within = Boolean(target.closest(".live"));
  });
  for (const way of ["focusin", "click"])
    document.addEventListener(way, ({ target }) => {
      const row = rows().find((other) => other === target.closest(ROWS));
      if (row) choose(row);
    });
}
