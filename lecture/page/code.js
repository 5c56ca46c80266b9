// The code of the step as it runs for the pinned pixel, each line with its equations and numbers.

/** What the listing is made of, without its numbers. */
let listing = "";
const NUMBERS = ["value", "chosen", "altered"];

function showCode() {
  if (!$("code").querySelector("details").open) return;
  const parts = asked("code");
  const shape = JSON.stringify([language, parts], (key, value) =>
    (NUMBERS.includes(key) ? undefined : value));
  if (shape !== listing) {
    listing = shape;
    $("listing").replaceChildren(...parts.map(listPart).filter(Boolean));
  }
  $("listing").classList.toggle("whole", state.whole);
  const notes = parts.flatMap(({ lines }) => lines.flatMap((line) => line.notes));
  const places = $("listing").querySelectorAll(".note");
  for (const [place, { value, chosen, altered }] of notes.entries()) {
    const note = places[place];
    note.lastChild.textContent = value;
    note.classList.toggle("altered", altered);
    note.closest(".row").classList.toggle("chosen", chosen);
  }
}

/** A function or a type; the rest of a file is folded, with the number of its new lines. */
function listPart({ path, rest, lines }) {
  const rows = lines.map(listRow);
  const name = element("code", { className: "path", textContent: path });
  if (!rest) return element("div", {}, name, ...rows);
  const count = lines.filter(({ change }) => change === "new").length;
  return element("details", {}, element("summary", {}, name, count ? ` +${count}` : ""), ...rows);
}

function listRow({ number, pieces, notes, change, idle }) {
  const whole = pieces.map(([, part]) => part).join("");
  const parts = pieces.map(([kind, part]) =>
    (kind ? element("span", { className: kind, textContent: part }) : part));
  const code = element(change === "gone" ? "del" : "code", {}, ...parts);
  code.style.setProperty("--indent", whole.search(/\S|$/));
  const row = element("div", { className: "row" }, code, ...notes.map(listNote));
  if (change) row.classList.add(change);
  row.classList.toggle("idle", idle);
  row.dataset.number = number;
  return row;
}

/** An equation with its numbers; a click makes it the picture. */
function listNote({ math, shown, symbol, name }) {
  const equation = element("span", { innerHTML: math });
  const note = element(name ? "button" : "span", { className: "note" }, equation, element("b", {}));
  note.dataset.means = symbol;
  if (!name) return note;
  note.dataset.line = JSON.stringify(name);
  note.setAttribute("aria-label", shown);
  note.onclick = () => act({ show: name });
  return note;
}

/** What is pointed at is marked wherever else it stands: in code, explanation and equation. */
function point({ target }) {
  const at = target.closest("[data-line], [data-symbol], #listing .row, .lines > div");
  const told = at && (at.querySelector("[data-line]") || at);
  const line = told && told.dataset.line;
  const means = told && (told.dataset.symbol || told.dataset.means);
  for (const note of $("panels").querySelectorAll("[data-line]"))
    note.classList.toggle("pointed",
      line ? note.dataset.line === line : Boolean(means) && note.dataset.means === means);
  const marked = $("listing").querySelector(".note.pointed");
  const symbol = means || (marked && marked.dataset.means);
  for (const place of formula().querySelectorAll("[data-symbol]"))
    place.classList.toggle("pointed", Boolean(symbol) && place.dataset.symbol === symbol);
}

function readCode() {
  $("code").querySelector("details").ontoggle = showCode;
  document.addEventListener("pointerover", point);
}
