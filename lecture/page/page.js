"use strict";

// The page's own words; what the steps and handouts say comes from them.
const TEXTS = {
  en: {
    title: "Ray tracing in seven steps", steps: "Steps", picture: "Picture", tools: "Tools",
    drag: "The picture. Arrow keys turn the camera, plus and minus zoom, Enter pins the middle, Shift and arrow keys move the pin.",
    keys: "Drag to turn, wheel or pinch to zoom, click a pixel to explain it. Keys: arrows, + and −, Enter, Shift+arrows, B, D, V, H, O, Page Up and Page Down.",
    divider: "Divider: left the step before, right this one", hold: "Hold: step before", divide: "Divider", vectors: "Vectors", handles: "Handles", outside: "From outside", symbols: "Symbols", formula: "Equation",
    unpin: "Unpin", reset: "Reset all", link: "Copy link", command: "Copy command", save: "Save PNG",
    controls: "Controls", pixel: "The pixel", unpinned: "Click a pixel of the picture: here its equations appear with their numbers.",
    diff: "What is new in the code", camera: "camera", resetOne: "Reset", numbersOf: "Numbers of",
    copied: "Copied:", seen: "seen, sRGB 0 to 255", pinnedAt: "The pixel",
    ignored: "Not all of the address can be used:", broken: "The pictures cannot be drawn in this browser (it lacks WebAssembly or something in it); the texts can be read all the same.",
    long: "the address is too long", noStep: "there is no such step", noPixel: "there is no such pixel", noSize: "there is no such size",
    on: "on", off: "off",
  },
  "pt-BR": {
    title: "Ray tracing em sete passos", steps: "Passos", picture: "Imagem", tools: "Ferramentas",
    drag: "A imagem. As setas giram a câmera, mais e menos aproximam, Enter fixa o meio, Shift e setas movem o pixel fixado.",
    keys: "Arraste para girar, roda ou pinça para aproximar, clique num pixel para explicá-lo. Teclas: setas, + e −, Enter, Shift+setas, B, D, V, H, O, Page Up e Page Down.",
    divider: "Divisória: à esquerda o passo anterior, à direita este", hold: "Segure: passo anterior", divide: "Divisória", vectors: "Vetores", handles: "Alças", outside: "De fora", symbols: "Símbolos", formula: "Equação",
    unpin: "Soltar pixel", reset: "Tudo como no início", link: "Copiar link", command: "Copiar comando", save: "Salvar PNG",
    controls: "Controles", pixel: "O pixel", unpinned: "Clique num pixel da imagem: aqui aparecem as suas equações com os números.",
    diff: "O que há de novo no código", camera: "câmera", resetOne: "Como no início:", numbersOf: "Números de",
    copied: "Copiado:", seen: "visto, sRGB de 0 a 255", pinnedAt: "O pixel",
    ignored: "Nem tudo no endereço pode ser usado:", broken: "As imagens não podem ser calculadas neste navegador (falta WebAssembly ou algo nele); os textos podem ser lidos mesmo assim.",
    long: "o endereço é longo demais", noStep: "esse passo não existe", noPixel: "esse pixel não existe", noSize: "esse tamanho não existe",
    on: "ligado", off: "desligado",
  },
};

const STEPS = 7;
const SIZE = [960, 540];
const LONGEST_ADDRESS = 4000;
/** A picture that takes longer than this is drawn with fewer pixels while something is dragged. */
const DRAGGED_MS = 22;
const BAND_PIXELS = 18 * 960;

const $ = (id) => document.getElementById(id);
let language = (navigator.languages || []).some((tag) => /^pt\b/i.test(tag)) &&
  !/^en\b/i.test((navigator.languages || [])[0] || "") ? "pt-BR" : "en";
const text = (key) => TEXTS[language][key];

/** What runs a command in the steps' program; also within a worker, which knows nothing else of here. */
function runner(instance) {
  const { memory, page_input, page_run, page_output } = instance.exports;
  return (command, rgb) => {
    const bytes = new TextEncoder().encode(rgb ? `${command}\n` : command);
    const whole = bytes.length + (rgb ? rgb.length : 0);
    // The memory may grow: its buffer is asked for afterwards.
    const input = page_input(whole);
    const place = new Uint8Array(memory.buffer, input, whole);
    place.set(bytes);
    if (rgb) place.set(rgb, bytes.length);
    const length = page_run();
    const answer = new Uint8Array(memory.buffer, page_output(), Math.abs(length)).slice();
    if (length < 0) throw new Error(new TextDecoder().decode(answer));
    return answer;
  };
}

function work(runner) {
  let run;
  onmessage = ({ data }) => {
    if (data.module) run = runner(new WebAssembly.Instance(data.module));
    else if (data.change) try { run(data.change); } catch { /* The page has said so. */ }
    else {
      const rgb = run(`rows ${data.layer} ${data.width} ${data.height} ${data.first} ${data.count}`);
      postMessage({ ...data, rgb }, [rgb.buffer]);
    }
  };
}

// ---- the steps' program, and the workers that have one each

let run = null;
let workers = [];

/** A command that changes what is shown: here, and in each worker. */
function change(command) {
  run(command);
  for (const worker of workers) worker.postMessage({ change: command });
}

const lines = (command) =>
  new TextDecoder().decode(run(command)).split("\n").slice(0, -1).map((line) => line.split("\t"));

async function start() {
  const packed = Uint8Array.from(atob($("wasm").textContent), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
  run = runner(await WebAssembly.instantiate(module));
  const source = new Blob([`(${work})(${runner})`], { type: "text/javascript" });
  const count = Math.min(navigator.hardwareConcurrency || 1, 8);
  try {
    const address = URL.createObjectURL(source);
    for (let place = 0; place < count; place++) {
      const worker = new Worker(address);
      worker.onmessage = ({ data }) => { worker.band = null; finished(data); hand(worker); };
      worker.onerror = (event) => { event.preventDefault(); lost(worker); };
      worker.postMessage({ module });
      workers.push(worker);
    }
  } catch {
    workers = [];
  }
}

/** A worker that cannot work: its band is drawn by another, or here. */
function lost(worker) {
  workers = workers.filter((other) => other !== worker);
  if (worker.band) bands.unshift(worker.band);
  pump();
}

// ---- drawing: a frame is a number of bands of one or two layers, handed out as workers get free

let size = SIZE;
let frame = 0;
let bands = [];
let frames = {};
let wanted = false;
let moving = false;
let drawing = false;
let started = 0;
/** Milliseconds for a picture of one pixel; what a dragged one may have of them follows. */
let cost = 60 / (960 * 540);
let settle = 0;

const layers = () => (showsBefore() ? ["now", "before"] : ["now"]);

/** Something has changed: draw it, at first with fewer pixels if it goes on changing. */
function redraw() {
  wanted = true;
  document.body.dataset.drawn = "";
  if (!drawing) draw(moving);
  else if (!frames.quick) draw(moving);
  explain();
}

function draw(quick) {
  if (!run) return;
  const shown = layers();
  const whole = cost * size[0] * size[1] * shown.length;
  const part = quick ? Math.min(1, Math.max(1 / 6, Math.sqrt(DRAGGED_MS / whole))) : 1;
  const [width, height] = size.map((side) => Math.max(1, Math.round(side * part)));
  wanted = false;
  drawing = true;
  started = performance.now();
  frame += 1;
  frames = { quick: part < 1, width, height, left: 0, layers: shown, rgb: {} };
  bands = [];
  const count = Math.max(1, Math.round(BAND_PIXELS / width));
  for (let first = 0; first < height; first += count)
    for (const layer of shown)
      bands.push({ frame, layer, width, height, first, count: Math.min(count, height - first) });
  for (const layer of shown) frames.rgb[layer] = new Uint8Array(3 * width * height);
  frames.left = bands.length;
  pump();
}

function hand(worker) {
  worker.band = bands.shift() || null;
  if (worker.band) worker.postMessage(worker.band);
}

function pump() {
  for (const worker of workers) if (!worker.band) hand(worker);
  if (!workers.length && bands.length) alone();
}

const { port1, port2 } = new MessageChannel();
port1.onmessage = () => {
  const band = bands.shift();
  if (!band) return;
  const { layer, width, height, first, count } = band;
  finished({ ...band, rgb: run(`rows ${layer} ${width} ${height} ${first} ${count}`) });
  if (bands.length) alone();
};
/** Without workers: a band here, then whatever else the page has to do, then the next. */
function alone() { port2.postMessage(0); }

function finished({ frame: number, layer, width, first, rgb }) {
  if (number !== frame) return;
  frames.rgb[layer].set(rgb, 3 * width * first);
  frames.left -= 1;
  if (frames.left) return;
  drawing = false;
  const { width: cols, height: rows, quick } = frames;
  const spent = performance.now() - started;
  cost = 0.5 * cost + 0.5 * spent / (cols * rows * frames.layers.length);
  show();
  if (wanted) draw(moving);
  else if (quick) { clearTimeout(settle); settle = setTimeout(() => { moving = false; draw(false); }, 80); }
  document.body.dataset.drawn = quick || wanted ? "" : `${frame} ${Math.round(spent)}`;
}

/** Puts the frame on the canvas, with what is drawn over it. */
function show() {
  const { width, height } = frames;
  const drawn = (pin && vectors) || handles || outside;
  const [cols, rows] = drawn ? size : [width, height];
  // As high as the letters beside the picture, and no larger than the picture can hold.
  const scale = size[0] / Math.max(1, $("picture").clientWidth);
  const letters = Math.max(8, Math.min(size[1] / 12, 15 * scale));
  const marks = `${letters} ${pin ? pin.join(",") : "-"} ${Number(vectors)} ${Number(handles)}`;
  for (const layer of frames.layers) {
    const canvas = $(layer);
    const rgba = run(`show ${layer} ${cols} ${rows} ${width} ${height} ${drawn ? marks : "8 - 0 0"}`, frames.rgb[layer]);
    if (canvas.width !== cols || canvas.height !== rows) [canvas.width, canvas.height] = [cols, rows];
    canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(rgba.buffer), cols, rows), 0, 0);
  }
}

/** A change by hand, of which more may follow at once. */
function moved(command) {
  try { change(command); } catch (error) { return notice(error.message); }
  moving = true;
  refresh();
}

// ---- what the address says, and what it is made to say

let state = null;
let pin = null;
let divided = false;
let held = false;
let vectors = true;
let handles = false;
let outside = false;

const showsBefore = () => (divided || held) && state && state.step > 1;

function notice(message) {
  $("notice").textContent = message || "";
  $("notice").hidden = !message;
}

/** Two whole numbers, or none. */
const pair = (value, letter) => {
  const found = /^(\d{1,6})[,x](\d{1,6})$/.exec(value);
  return found && value.includes(letter) ? [Number(found[1]), Number(found[2])] : null;
};

const decoded = (part) => { try { return decodeURIComponent(part); } catch { return part; } };

/** Shows what `address` says, and says what of it cannot be shown. */
function open(address) {
  const wrong = [];
  if (address.length > LONGEST_ADDRESS) { wrong.push(text("long")); address = ""; }
  const [name, ...settings] = address.replace(/^#/, "").split("&").filter((part) => part).map(decoded);
  const found = /^step0?(\d+)(_\w+)?$/.exec(name || "step01");
  let step = found ? Number(found[1]) : 0;
  if (step < 1 || step > STEPS) { wrong.push(`${(name || "").slice(0, 40)}: ${text("noStep")}`); step = 1; }
  change(`open ${step}`);
  pin = null;
  size = SIZE;
  divided = handles = outside = false;
  vectors = true;
  let place = null;
  for (const setting of settings) {
    const [key, value = ""] = setting.split(/=(.*)/s);
    if (key === "pixel") place = value;
    else if (key === "size") {
      const wish = pair(value, "x");
      if (wish && wish[0] > 0 && wish[1] > 0 && wish[0] * wish[1] <= 4e6) size = wish;
      else wrong.push(`size: ${text("noSize")}`);
    } else if (key === "divide") {
      const at = Number(value);
      divided = value !== "" && at >= 0 && at <= 1 && step > 1;
      if (divided) $("divider").value = at;
    } else if (key === "vectors") vectors = value !== "off";
    else if (key === "handles") handles = value === "on";
    else if (key === "outside") change(`outside ${value === "on" ? "on" : "off"}`);
    else {
      try { change(`set ${key.replace(/\s/g, "_")} ${value.replace(/\s/g, "_")}`); } catch (error) { wrong.push(error.message.slice(0, 200)); }
    }
  }
  if (place !== null) {
    const wish = pair(place, ",");
    if (wish && wish[0] < size[0] && wish[1] < size[1]) pin = wish;
    else wrong.push(`pixel: ${text("noPixel")}`);
  }
  notice(wrong.length ? `${text("ignored")}\n${wrong.slice(0, 5).join("\n")}` : "");
  moving = false;
  refresh();
}

/** The address of what is shown. */
function address() {
  const parts = [`step${two(state.step)}`, ...state.changes];
  if (size !== SIZE) parts.push(`size=${size.join("x")}`);
  if (pin) parts.push(`pixel=${pin.join(",")}`);
  if (!vectors) parts.push("vectors=off");
  if (handles) parts.push("handles=on");
  if (divided) parts.push(`divide=${$("divider").value}`);
  return "#" + parts.map((part) => encodeURIComponent(part).replace(/%(3D|2C)/g, decodeURIComponent)).join("&");
}

let written = null;
let writing = 0;
/** Browsers allow only so many changes of the address a second. */
function writeAddress() {
  clearTimeout(writing);
  writing = setTimeout(() => {
    written = address();
    try { history.replaceState(null, "", written); } catch { /* A frame without an address of its own. */ }
  }, 200);
}

function read() {
  const read = { step: 1, name: "", command: "", changes: [], settings: [] };
  for (const [kind, ...rest] of lines("state")) {
    if (kind === "step") [read.step, read.name] = [Number(rest[0]), rest[1]];
    else if (kind === "command") read.command = rest[0];
    else if (kind === "change") read.changes.push(rest[0]);
    else {
      const [name, group, value, fraction, takes, options, changed] = rest;
      read.settings.push({
        name, group, value, fraction: Number(fraction), takes,
        options: options ? options.split("|") : [], changed: changed === "1",
      });
    }
  }
  return read;
}

/** Reads what the steps' program holds now, and shows it. */
function refresh() {
  const before = state && state.step;
  state = read();
  outside = state.changes.includes("outside=on");
  if (state.step !== before) showStep();
  showControls();
  showStage();
  redraw();
  writeAddress();
}

const two = (step) => String(step).padStart(2, "0");
const handout = (step) => $(`handout${two(step)}-${language}`);

/** The equation of each handout, which stands below the picture. */
const formulas = new Map();

function showStep() {
  const shown = handout(state.step);
  for (const link of $("steps").querySelectorAll("a")) {
    if (link.hash === `#step${two(state.step)}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  for (const article of document.querySelectorAll("article")) article.hidden = article !== shown;
  const heading = shown.querySelector("h2").textContent;
  if (!formulas.has(shown)) formulas.set(shown, shown.querySelector(".equation"));
  $("formula").replaceChildren(formulas.get(shown));
  $("formula").lang = language;
  document.title = `${heading} · ${text("title")}`;
  $("now").setAttribute("aria-label", heading);
}

function showStage() {
  const both = showsBefore();
  $("hold").disabled = $("divide").disabled = state.step === 1;
  $("divide").setAttribute("aria-pressed", String(divided));
  for (const [name, on] of Object.entries({ vectors, handles, outside })) $(name).setAttribute("aria-pressed", String(on));
  $("divider").hidden = !divided || state.step === 1;
  $("before").hidden = !both;
  const share = held ? 1 : Number($("divider").value);
  $("before").style.clipPath = `inset(0 ${100 * (1 - share)}% 0 0)`;
  $("unpin").hidden = !pin;
  $("pin").hidden = !pin || vectors || outside;
  if (pin) {
    $("pin").style.left = `${100 * (pin[0] + 0.5) / size[0]}%`;
    $("pin").style.top = `${100 * (pin[1] + 0.5) / size[1]}%`;
  }
  for (const canvas of [$("now"), $("before")]) canvas.style.aspectRatio = `${size[0]} / ${size[1]}`;
}

// ---- controls

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

let shape = null;

/** The controls: made anew when there are others, else only given their values. */
function showControls() {
  const now = JSON.stringify([language, state.step, state.settings.map(({ name, group, options }) => [name, group, options])]);
  if (now !== shape) { shape = now; makeControls(); }
  for (const setting of state.settings) {
    const row = $(`control-${setting.name}`);
    row.classList.toggle("changed", setting.changed);
    const [input, output, reset] = [row.querySelector("input, select"), row.querySelector("output"), row.querySelector("button")];
    reset.style.visibility = setting.changed ? "visible" : "hidden";
    output.textContent = input.tagName === "SELECT" ? "" : setting.value;
    if (input.type === "range") {
      input.value = setting.fraction;
      input.setAttribute("aria-valuetext", setting.value);
    } else if (input.type === "checkbox") input.checked = setting.fraction === 1;
    else input.selectedIndex = Math.round(setting.fraction * (setting.options.length - 1));
  }
}

function makeControls() {
  const groups = new Map();
  for (const setting of state.settings) {
    if (!groups.has(setting.group)) groups.set(setting.group, []);
    groups.get(setting.group).push(setting);
  }
  const names = [...groups.keys()].filter((name) => name !== "camera");
  const own = names[names.length - 1];
  const order = [own, ...names.filter((name) => name !== own), "camera"].filter((name) => groups.has(name));
  $("controls").replaceChildren(...order.map((name) => {
    const rows = groups.get(name).map(makeControl);
    if (name === own) return element("div", {}, ...rows);
    return element("details", {}, element("summary", { textContent: name === "camera" ? text("camera") : name }), ...rows);
  }));
}

function makeControl({ name, options, takes }) {
  const id = `input-${name}`;
  const label = element("label", { htmlFor: id }, ...symbol(name));
  let input;
  const isSwitch = options.length === 2 && options.includes("on") && options.includes("off");
  if (isSwitch) {
    input = element("input", { type: "checkbox", id });
    input.onchange = () => moved(`set ${name} ${input.checked ? "on" : "off"}`);
  } else if (options.length) {
    input = element("select", { id }, ...options.map((option) => element("option", { textContent: option })));
    input.onchange = () => moved(`fraction ${name} ${input.selectedIndex / Math.max(1, options.length - 1)}`);
  } else {
    input = element("input", { type: "range", id, min: 0, max: 1, step: "any", title: takes });
    input.oninput = () => moved(`fraction ${name} ${input.value}`);
    // As the keys do in the window.
    input.onkeydown = (event) => {
      const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
      if (!steps) return;
      event.preventDefault();
      moved(`nudge ${name} ${event.shiftKey ? steps / 10 : steps}`);
    };
  }
  const reset = element("button", { type: "button", textContent: "↺", onclick: () => moved(`reset ${name}`) });
  reset.setAttribute("aria-label", `${text("resetOne")} ${name}`);
  const output = element("output", {});
  output.htmlFor = id;
  return element("div", { className: "control", id: `control-${name}` }, label, input, output, reset);
}

/** `k_d` with its index below. */
function symbol(name) {
  const found = /^(\w)_(\w+)$/.exec(name);
  return found ? [found[1], element("sub", { textContent: found[2] })] : [name];
}

// ---- the pinned pixel

let told = null;
const folds = new Map();

function explain() {
  $("unpinned").hidden = Boolean(pin);
  $("pinned").textContent = pin ? `${text("pinnedAt")} (${pin.join(", ")})` : text("pixel");
  if (!pin) { told = null; $("explanation").replaceChildren(); fillEquation([]); return; }
  const parts = lines(`explain ${size.join(" ")} ${pin.join(",")}`);
  const now = JSON.stringify(parts.map(([kind, name, more]) => [kind, name, kind === "group" ? more : ""]));
  if (now !== told) { told = now; makeExplanation(parts); }
  const places = $("explanation").querySelectorAll("[data-value]");
  let place = 0;
  for (const [kind, ...rest] of parts) {
    if (kind === "section" || (kind === "group" && !rest[0])) continue;
    const shown = kind === "line" ? rest.slice(3) : kind === "seen" ? rest : rest.slice(2);
    places[place++].textContent = kind === "group" ? shown[0] : shown.map((number) => number.padEnd(9)).join(" ").trimEnd();
  }
  fillEquation(parts);
}

/** The light or object whose numbers stand in the equation, if there are several. */
let numbersOf = "";

/** Puts the pixel's numbers under the symbols of the step's equation. */
function fillEquation(parts) {
  const places = [...$("formula").querySelectorAll("[data-symbol]")];
  const symbols = new Set(places.flatMap((place) => place.dataset.symbol.split("|")));
  // Of each symbol what is told last counts, but of several lights or objects the chosen one.
  const told = new Map();
  const groups = new Map();
  let group = "", section = 0;
  for (const [kind, ...rest] of parts) {
    if (kind === "section") { section += 1; group = ""; }
    else if (kind === "group") group = rest[1] === "1" ? rest[0] : null;
    if (kind !== "line" || group === null) continue;
    const [equation, names, , ...numbers] = rest;
    const parts = names.replace(/^\(|\)$/g, "").split(", ");
    const each = parts.length === numbers.length && parts.length > 1 && !parts.some((part) => part.includes(" "));
    (each ? parts : [names, equation.split(" = ").pop()]).forEach((name, place) => {
      if (!symbols.has(name)) return;
      const value = each ? [numbers[place]] : numbers;
      if (group && group !== "sum" && section > 2) {
        if (!groups.has(group)) groups.set(group, new Map());
        groups.get(group).set(name, value);
      } else told.set(name, value);
    });
  }
  const names = [...groups.keys()];
  if (!names.includes(numbersOf)) numbersOf = names[0] || "";
  for (const [name, value] of groups.get(numbersOf) || []) told.set(name, value);
  for (const place of places) {
    const value = place.dataset.symbol.split("|").map((name) => told.get(name)).find((value) => value);
    place.textContent = value ? value.map((number) => Number(number) || Number(number) === 0 ? String(Number(Number(number).toPrecision(4))).replace("-", "−") : number).join("\n") : "";
  }
  $("numbers").hidden = names.length < 2;
  const choice = $("numbers").querySelector("select");
  if (JSON.stringify(names) !== choice.dataset.names) {
    choice.dataset.names = JSON.stringify(names);
    choice.replaceChildren(...names.map((name) => element("option", { textContent: name })));
  }
  choice.value = numbersOf;
}

function makeExplanation(parts) {
  const top = [];
  let section, group, list, path;
  const fold = (key, name, open, outcome) => {
    const made = element("details", { open: folds.has(key) ? folds.get(key) : open });
    const summary = element("summary", {}, name, " ");
    if (outcome) summary.append(outcome);
    // What is opened by hand stays open.
    summary.addEventListener("click", () => folds.set(key, !made.open));
    made.append(summary);
    return made;
  };
  const value = (name, className) => {
    const made = element(name, { className });
    made.dataset.value = "";
    return made;
  };
  for (const [kind, name, more, ink] of parts) {
    if (kind === "section") {
      path = name;
      top.push(section = group = fold(name, name, true));
      list = null;
    } else if (kind === "group") {
      list = null;
      if (!name) { group = section; continue; }
      section.append(group = fold(`${path}/${name}`, name, more === "1", value("span", "outcome")));
    } else {
      if (kind === "seen") { list = null; group = section = element("div", {}); top.push(group); }
      if (!list) group.append(list = element("dl", { className: "lines" }));
      const symbol = element("dt", {}, kind === "seen" ? text("seen") : name);
      if (kind === "line" && ink) {
        symbol.className = "inked";
        symbol.style.setProperty("--ink", ink);
      }
      list.append(element("div", {}, symbol, value("dd")));
    }
  }
  $("explanation").replaceChildren(...top);
}

// ---- hands on the picture

const pointers = new Map();
let dragged = 0;
/** The handle that is held. */
let grabbed = "";

/** Where a pointer is on the picture, as shares of its width and height, from the upper left. */
function share(event) {
  const box = $("picture").getBoundingClientRect();
  return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
}

function grab(event) {
  if (!handles) return "";
  const [x, y] = share(event);
  const reach = (event.pointerType === "mouse" ? 14 : 28) * size[0] / $("picture").clientWidth;
  return new TextDecoder().decode(run(`grab ${size.join(" ")} ${x * size[0]} ${y * size[1]} ${reach}`));
}

const place = (event) => share(event).map((at, axis) => Math.min(size[axis] - 1, Math.max(0, Math.floor(at * size[axis]))));

const spread = () => {
  const [a, b] = [...pointers.values()];
  return Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
};

function turn(right, up) { moved(`orbit ${right} ${up}`); }

function hands() {
  const picture = $("picture");
  picture.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    picture.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
    if (pointers.size === 1) { dragged = 0; grabbed = grab(event); }
    else { dragged = Infinity; grabbed = ""; }
    picture.classList.add("grabbed");
  });
  picture.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 && spread();
    pointers.set(event.pointerId, event);
    const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
    dragged += Math.abs(right) + Math.abs(down);
    if (before) moved(`zoom ${before / spread()}`);
    else if (grabbed) {
      const [x, y] = share(event);
      moved(`drag ${size.join(" ")} ${grabbed} ${x} ${1 - y}`);
    } else if (pointers.size === 1 && dragged > 4) {
      // Across the picture is half a turn, on any screen.
      const angle = 180 / picture.clientWidth;
      turn(-right * angle, down * angle);
    }
  });
  const up = (event) => {
    if (!pointers.delete(event.pointerId) || pointers.size) return;
    picture.classList.remove("grabbed");
    if (event.type === "pointerup" && dragged <= 4 && !grabbed && !outside) { pin = place(event); refresh(); }
  };
  picture.addEventListener("pointerup", up);
  picture.addEventListener("pointercancel", up);
  picture.addEventListener("wheel", (event) => {
    event.preventDefault();
    moved(`zoom ${Math.exp(Math.max(-1, Math.min(1, event.deltaY / 500)))}`);
  }, { passive: false });
  picture.addEventListener("keydown", (event) => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (way && event.shiftKey) {
      pin = pin || size.map((side) => Math.floor(side / 2));
      pin = pin.map((at, axis) => Math.min(size[axis] - 1, Math.max(0, at + way[axis])));
      refresh();
    } else if (way) turn(5 * way[0], -5 * way[1]);
    else if (event.key === "+" || event.key === "=") moved("zoom 0.9");
    else if (event.key === "-") moved("zoom 1.1111111");
    else if (event.key === "Enter") { pin = size.map((side) => Math.floor(side / 2)); refresh(); }
    else return;
    event.preventDefault();
  });
}

/** The letters over the picture are as high as those beside it, however wide it is. */
new ResizeObserver(() => { if (run && !drawing && frames.rgb) show(); }).observe($("picture"));

function hold(down) {
  if (held === down || (down && state.step === 1)) return;
  held = down;
  showStage();
  if (down) redraw();
}

function go(step) {
  if (step < 1 || step > STEPS) return;
  change(`step ${step}`);
  moving = false;
  notice("");
  refresh();
}

/** What writes what is shown into a file. */
function command() {
  let command = state.command;
  if (size !== SIZE) command += ` --size ${size.join("x")}`;
  if (outside) command += " --outside" + state.changes.filter((change) => change.startsWith("outside.")).map((change) => ` --set ${change}`).join("");
  if (pin) command += ` --pixel ${pin.join(",")}`;
  if (outside || pin) command += ` -o ${state.name}.png`;
  return command.replace(/ --$/, "");
}

async function copy(what) {
  notice(`${text("copied")} ${what}`);
  try { await navigator.clipboard.writeText(what); } catch { /* It is shown, and can be copied by hand. */ }
}

function buttons() {
  const button = $("hold");
  button.addEventListener("pointerdown", (event) => { button.setPointerCapture(event.pointerId); hold(true); });
  for (const end of ["pointerup", "pointercancel", "blur"]) button.addEventListener(end, () => hold(false));
  button.addEventListener("keydown", (event) => { if (event.key === " " || event.key === "Enter") { event.preventDefault(); hold(true); } });
  button.addEventListener("keyup", () => hold(false));
  button.addEventListener("contextmenu", (event) => event.preventDefault());
  $("divide").onclick = () => { divided = !divided && state.step > 1; refresh(); };
  $("vectors").onclick = () => { vectors = !vectors; refresh(); };
  $("handles").onclick = () => { handles = !handles; refresh(); };
  $("outside").onclick = () => { change(`outside ${outside ? "off" : "on"}`); refresh(); };
  $("numbers").querySelector("select").onchange = (event) => { numbersOf = event.target.value; explain(); };
  $("divider").oninput = () => { showStage(); writeAddress(); };
  $("unpin").onclick = () => { pin = null; refresh(); };
  $("reset").onclick = () => moved("reset");
  $("link").onclick = () => copy(location.href.split("#")[0] + address());
  $("command").onclick = () => copy(command());
  $("save").onclick = () => {
    const link = element("a", { href: $("now").toDataURL("image/png"), download: `${state.name}.png` });
    link.click();
  };
  $("language").onclick = () => { language = language === "en" ? "pt-BR" : "en"; translate(); };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !run || /^(INPUT|SELECT)$/.test(event.target.tagName)) return;
    if (event.key === "PageDown") go(state.step + 1);
    else if (event.key === "PageUp") go(state.step - 1);
    else if (/^[1-7]$/.test(event.key)) go(Number(event.key));
    else if (event.key === "b") hold(true);
    else if (event.key === "d") $("divide").click();
    else if (event.key === "v") $("vectors").click();
    else if (event.key === "h") $("handles").click();
    else if (event.key === "o") $("outside").click();
    else if (event.key === "Escape" && pin) $("unpin").click();
    else return;
    event.preventDefault();
  });
  document.addEventListener("keyup", (event) => { if (event.key === "b") hold(false); });
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[href^='#step']");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    // A link to a step takes all along; one with settings shows just these, and keeps the pin.
    if (!link.hash.includes("&")) return go(Number(link.hash.slice(5)));
    const kept = pin;
    open(link.hash);
    pin = kept;
    refresh();
  });
  addEventListener("hashchange", () => { if (location.hash !== written) open(location.hash); });
}

function translate() {
  document.documentElement.lang = language;
  for (const place of document.querySelectorAll("[data-text]")) place.textContent = text(place.dataset.text);
  for (const place of document.querySelectorAll("[data-name]")) place.setAttribute("aria-label", text(place.dataset.name));
  for (const place of document.querySelectorAll("[data-step]"))
    place.textContent = handout(place.dataset.step).querySelector("h2").textContent.split(" · ")[1];
  const other = language === "en" ? "pt-BR" : "en";
  $("language").textContent = { en: "English", "pt-BR": "Português" }[other];
  $("language").lang = other;
  if (state) { told = null; showStep(); showControls(); explain(); }
}

translate();
start().then(() => {
  hands();
  buttons();
  open(location.hash);
}).catch((error) => {
  console.warn(error);
  notice(text("broken"));
  document.documentElement.classList.add("broken");
});
