// How the pinned pixel comes by its colour, and the numbers below the equation's symbols.

/** What the explanation is made of, without its numbers. */
let told = "";

function explain() {
  const { pin } = state;
  $("unpinned").hidden = Boolean(pin);
  $("pinned").textContent = pin ? `${text("The pixel")} (${pin.join(", ")})` : text("The pixel");
  const { parts, symbols, seen } = asked("explain") || { parts: [], symbols: [] };
  const lines = seen ? [...parts, { line: { math: "seen", values: seen.map(String) } }] : parts;
  const shape = JSON.stringify([language, lines], (key, value) =>
    (key === "values" || key === "outcome" ? undefined : value));
  if (shape !== told) {
    told = shape;
    $("explanation").replaceChildren(...tellAll(parts, ""));
    if (seen) $("explanation").append(list([tellSeen()]));
  }
  const places = $("explanation").querySelectorAll("[data-value]");
  for (const [place, value] of lines.flatMap(valuesOf).entries())
    places[place].replaceChildren(...value);
  chooseNumbers(symbols);
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

function tellLine({ math, ink }) {
  const term = element("dt", { innerHTML: math });
  if (ink) {
    term.className = "inked";
    term.style.setProperty("--ink", ink);
  }
  return element("div", {}, term, place("dd", ""));
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
  for (const place of $("formula").querySelectorAll("[data-symbol]")) {
    place.textContent = (values.get(place.dataset.symbol) || []).join("\n");
  }
}
