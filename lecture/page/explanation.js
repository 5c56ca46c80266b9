// How the pinned pixel comes by its colour, and the numbers below the equation's symbols.

/** What the explanation is made of, without what else is told of its lines. */
let told = "";
const MARKS = ["chosen", "pictured", "altered"];
const PASSING = ["values", "outcome", ...MARKS];

function explain() {
  const { pin } = state;
  $("unpinned").hidden = Boolean(pin);
  $("lines").hidden = !pin;
  $("pinned").textContent = pin ? `${text("The pixel")} (${pin.join(", ")})` : text("The pixel");
  const { parts, symbols, seen } = asked("explain") || { parts: [], symbols: [] };
  const lines = seen ? [...parts, { line: { math: "seen", values: seen.map(String) } }] : parts;
  const shape = JSON.stringify([language, lines], (key, value) =>
    (PASSING.includes(key) ? undefined : value));
  if (shape !== told) {
    told = shape;
    const focus = document.activeElement.dataset.line;
    $("explanation").replaceChildren(...tellAll(parts, ""));
    if (seen) $("explanation").append(list([tellSeen()]));
    const again = [...$("explanation").querySelectorAll("[data-line]")];
    const other = focus && again.find(({ dataset }) => dataset.line === focus);
    if (other) other.focus({ preventScroll: true });
  }
  markLines(lines.flatMap(linesOf));
  const places = $("explanation").querySelectorAll("[data-value]");
  for (const [place, value] of lines.flatMap(valuesOf).entries())
    places[place].replaceChildren(...value);
  chooseNumbers(symbols);
}

const linesOf = ({ line, scope }) => (scope ? scope.parts.flatMap(linesOf) : [line]);

/** The line that keys act on, as it was seen last. */
let lineOfKeys = "";

/** Marks the lines that are chosen, seen as a picture, or answered otherwise. */
function markLines(lines) {
  let keys = "";
  const rows = $("explanation").querySelectorAll(".lines > div");
  for (const [place, line] of lines.entries()) {
    const row = rows[place];
    for (const mark of MARKS) row.classList.toggle(mark, Boolean(line[mark]));
    const button = row.querySelector("[aria-pressed]");
    if (button) button.setAttribute("aria-pressed", String(line.pictured));
    if (!line.chosen) continue;
    keys = JSON.stringify(line.name);
    if (keys !== lineOfKeys) reveal(row);
  }
  lineOfKeys = keys;
}

/** Brings a line into sight, wherever it is folded away. */
function reveal(row) {
  for (let fold = row.closest("details"); fold; fold = fold.parentNode.closest("details"))
    fold.open = true;
  row.scrollIntoView({ block: "nearest" });
}

/** What stands at each place for a value of a part, in order. */
function valuesOf({ line, scope }) {
  if (scope) return [[scope.outcome], ...scope.parts.flatMap(valuesOf)];
  return [[line.values.map((number) => number.padStart(9)).join(" ").trimStart()]];
}

const list = (lines) => element("dl", { className: "lines" }, ...lines);

function place(name, className) {
  const made = element(name, { className });
  made.dataset.value = "";
  return made;
}

/** Parts of an explanation, lines that follow each other in a list; folds are known by `path`. */
function tellAll(parts, path) {
  const made = [];
  let lines = null;
  for (const { line, scope } of parts) {
    if (line) {
      if (!lines) made.push(lines = list([]));
      lines.append(tellLine(line));
    } else {
      lines = null;
      const key = `${path}/${scope.name}`;
      const told = foldable(key, scope.open, scope.shown, " ", place("span", "outcome"));
      told.append(...tellAll(scope.parts, key));
      made.push(told);
    }
  }
  return made;
}

/** A line that can be a picture is a button, and one that could have another value has one. */
function tellLine({ shown, math, ink, name, open }) {
  const term = element("dt", {});
  if (ink) {
    term.className = "inked";
    term.style.setProperty("--ink", ink);
  }
  const row = element("div", {}, term, place("dd", ""));
  if (!name) {
    term.innerHTML = math;
    return row;
  }
  const show = element("button", { type: "button", innerHTML: math });
  show.setAttribute("aria-label", shown);
  show.setAttribute("aria-pressed", "false");
  show.dataset.line = JSON.stringify(name);
  term.append(show);
  row.onclick = () => {
    // Who selects a number to copy it means that.
    if (getSelection().isCollapsed) act({ show: name });
  };
  if (open) row.append(element("dd", { className: "ask" }, askButton(shown, name)));
  return row;
}

function askButton(shown, name) {
  const ask = element("button", { type: "button", textContent: "?" });
  ask.setAttribute("aria-label", `${text("What if")} ${shown}`);
  ask.onclick = (event) => {
    event.stopPropagation();
    act({ otherwise: name });
  };
  return ask;
}

const tellSeen = () => tellLine({ math: text("seen, sRGB 0 to 255") });

/** The light or object whose numbers stand in the equation, if there are several. */
let numbersOf = "";

function chooseNumbers([once, ...each]) {
  const chosen = each.find(({ of }) => of === numbersOf) || each[0];
  $("numbers").hidden = !chosen;
  const names = each.map(({ of, shown }) => element("option", { value: of, textContent: shown }));
  const choice = $("chosen");
  const all = names.map(({ textContent }) => textContent).join();
  if (choice.dataset.all !== all) {
    choice.dataset.all = all;
    choice.replaceChildren(...names);
  }
  choice.value = chosen ? chosen.of : "";
  choice.onchange = () => {
    numbersOf = choice.value;
    explain();
  };
  const values = new Map([...(once ? once.values : []), ...(chosen ? chosen.values : [])]);
  for (const place of formula().querySelectorAll("[data-symbol]")) {
    place.textContent = (values.get(place.dataset.symbol) || []).join("\n");
  }
}
