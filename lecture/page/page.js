"use strict";

const SIZE = [960, 540];
const LONGEST_ADDRESS = 4000;
/** A picture that takes longer than this is drawn with fewer pixels while something is dragged. */
const DRAGGED_MS = 22;
/** A worker has one more band of rows than it draws, so that it never waits for the page. */
const AHEAD = 2;
/** The largest band of rows, and the smallest: the last ones, so that all workers end together. */
const BAND_PIXELS = [36 * 960, 6 * 960];
/** Without workers: how long the page draws before it looks whether there is something else to do. */
const ALONE_MS = 12;

const $ = (id) => document.getElementById(id);
const STEPS = document.querySelectorAll("#steps a").length;
const PORTUGUESE = JSON.parse($("portuguese").textContent);

/** Of the languages that the page has, the one that the browser likes most. */
function languageOfBrowser() {
  const known = (navigator.languages || []).find((tag) => /^(pt|en)\b/i.test(tag));
  return /^pt/i.test(known) ? "pt-BR" : "en";
}

let language = languageOfBrowser();
/** A text in the language of the page, found by its English. */
const text = (english) => (language === "en" ? english : PORTUGUESE[english] || english);

/**
 * What runs a command in the steps' program; also within a worker, which knows nothing else of here.
 * The answer stays in the program's memory, and is there until the next command.
 */
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
    const answer = new Uint8Array(memory.buffer, page_output(), Math.abs(length));
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
      const rgb = run(`rows ${data.layer} ${data.width} ${data.height} ${data.first} ${data.count}`).slice();
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
      worker.bands = [];
      worker.onmessage = ({ data }) => { worker.bands.shift(); pump(); drawings[data.drawing].finished(data); };
      worker.onerror = (event) => { event.preventDefault(); lost(worker); };
      worker.postMessage({ module });
      workers.push(worker);
    }
  } catch {
    workers = [];
  }
}

/** A worker that cannot work: its bands are drawn by another, or here. */
function lost(worker) {
  workers = workers.filter((other) => other !== worker);
  queue.unshift(...worker.bands);
  pump();
}

// ---- drawing: a picture is a number of bands of one or two layers, handed out as workers get free

let queue = [];
const drawings = [];

/** A picture that is drawn again whenever something changes, with fewer pixels while it goes on changing. */
class Drawing {
  /** Which layers it has and how large it is, is asked for each time; `show` puts it where it is seen. */
  constructor(layers, size, show) {
    Object.assign(this, { layers, size, show });
    this.number = drawings.push(this) - 1;
    this.frame = 0;
    /** The picture in the making, or the one that was made last. */
    this.made = null;
    this.busy = this.wanted = this.moving = false;
    /** Milliseconds for a pixel; how many a picture may have while something is dragged follows. */
    this.cost = 60 / (960 * 540);
  }

  /** Something has changed. */
  redraw() {
    this.wanted = true;
    // One of other layers is not waited for: there may be no step before any more.
    const goesOn = this.busy && this.made.quick && String(this.made.layers) === String(this.layers());
    if (!goesOn) this.draw(this.moving);
  }

  draw(quick) {
    const [layers, size] = [this.layers(), this.size()];
    const whole = this.cost * size[0] * size[1] * layers.length;
    const part = quick ? Math.min(1, Math.max(1 / 6, Math.sqrt(DRAGGED_MS / whole))) : 1;
    const [width, height] = size.map((side) => Math.max(1, Math.round(side * part)));
    this.wanted = false;
    this.busy = true;
    this.started = performance.now();
    this.frame += 1;
    this.made = { quick: part < 1, width, height, left: 0, layers, rgb: {} };
    for (const layer of layers) this.made.rgb[layer] = new Uint8Array(3 * width * height);
    queue = queue.filter((band) => band.drawing !== this.number);
    const [most, least] = BAND_PIXELS.map((pixels) => Math.max(1, Math.round(pixels / width)));
    for (let first = 0, count; first < height; first += count) {
      const share = Math.ceil((height - first) / (3 * Math.max(1, workers.length)));
      count = Math.min(height - first, most, Math.max(least, share));
      for (const layer of layers) {
        queue.push({ drawing: this.number, frame: this.frame, layer, width, height, first, count });
        this.made.left += 1;
      }
    }
    pump();
  }

  finished({ frame, layer, width, first, rgb }) {
    if (frame !== this.frame) return;
    const { made } = this;
    made.rgb[layer].set(rgb, 3 * width * first);
    made.left -= 1;
    if (made.left) return;
    this.busy = false;
    const spent = performance.now() - this.started;
    this.cost = 0.5 * this.cost + 0.5 * spent / (made.width * made.height * made.layers.length);
    clearTimeout(this.settle);
    if (this.wanted) this.draw(this.moving);
    else if (made.quick) this.settle = setTimeout(() => { this.moving = false; this.draw(false); }, 80);
    this.show(made, this.busy || made.quick ? "" : `${frame} ${spent.toFixed(1)}`);
  }
}

function pump() {
  for (let ahead = 0; ahead < AHEAD; ahead++)
    for (const worker of workers)
      if (worker.bands.length === ahead && queue.length) {
        worker.bands.push(queue[0]);
        worker.postMessage(queue.shift());
      }
  if (!workers.length && queue.length) alone();
}

const { port1, port2 } = new MessageChannel();
port1.onmessage = () => {
  const end = performance.now() + ALONE_MS;
  while (queue.length && performance.now() < end) {
    const band = queue.shift();
    const { drawing, layer, width, height, first, count } = band;
    const rgb = run(`rows ${layer} ${width} ${height} ${first} ${count}`);
    drawings[drawing].finished({ ...band, rgb });
  }
  if (queue.length) alone();
};
/** Without workers: some bands here, then whatever else the page has to do, then the next. */
function alone() { port2.postMessage(0); }

/** Puts a picture on a canvas of this size, with what is drawn over it. */
function put(canvas, layer, [cols, rows], { width, height, rgb }, marks) {
  const rgba = run(`show ${layer} ${cols} ${rows} ${width} ${height} ${marks}`, rgb[layer]);
  if (canvas.width !== cols || canvas.height !== rows) [canvas.width, canvas.height] = [cols, rows];
  const pixels = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
  canvas.getContext("2d").putImageData(new ImageData(pixels, cols, rows), 0, 0);
}

// ---- the step's picture

let size = SIZE;

const stage = new Drawing(() => (showsBefore() ? ["now", "before"] : ["now"]), () => size, (made, drawn) => {
  show(made);
  document.body.dataset.drawn = drawn;
});

/** Something has changed: draw it, and explain the pinned pixel. */
function redraw() {
  document.body.dataset.drawn = "";
  stage.redraw();
  explain();
}

function show(made) {
  const drawn = (pin && vectors) || handles || outside;
  // As high as the letters beside the picture, larger where the picture is, and no larger than it can hold.
  const width = Math.max(1, $("picture").clientWidth);
  const letters = Math.max(8, Math.min(size[1] / 12, Math.max(13, 0.022 * width) * size[0] / width));
  const marks = `${letters} ${pin ? pin.join(",") : "-"} ${Number(vectors)} ${Number(handles)}`;
  for (const layer of made.layers)
    put($(layer), layer, drawn ? size : [made.width, made.height], made, drawn ? marks : "8 - 0 0");
}

/** A change by hand, of which more may follow at once. */
function moved(command) {
  const wrong = attempt(command);
  notice(() => wrong);
  if (wrong) return;
  stage.moving = true;
  refresh();
}

/** Why a command cannot be done; "" if it is. */
function attempt(command) {
  try { change(command); return ""; } catch (error) { return error.message; }
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

/** What is said now, in whatever language the page is then. */
let said = () => "";
function notice(message = () => "") {
  said = message;
  $("notice").textContent = said();
  $("notice").hidden = !said();
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
  if (address.length > LONGEST_ADDRESS) { wrong.push(() => text("the address is too long")); address = ""; }
  const [name, ...settings] = address.replace(/^#/, "").split("&").filter((part) => part).map(decoded);
  const found = /^step0?(\d+)(_\w+)?$/.exec(name || "step01");
  let step = found ? Number(found[1]) : 0;
  if (step < 1 || step > STEPS) { wrong.push(() => `${(name || "").slice(0, 40)}: ${text("there is no such step")}`); step = 1; }
  change(`open ${step}`);
  pin = null;
  size = SIZE;
  divided = handles = outside = false;
  vectors = true;
  let place = null;
  for (const setting of settings) {
    const [key, value = ""] = setting.split(/=(.*)/s);
    if (key === "pixel") place = value;
    else if (key === "language") speak(/^pt/.test(value) ? "pt-BR" : "en");
    else if (key === "size") {
      const wish = pair(value, "x");
      if (wish && wish[0] > 0 && wish[1] > 0 && wish[0] * wish[1] <= 4e6) size = wish;
      else wrong.push(() => `size: ${text("there is no such size")}`);
    } else if (key === "divide") {
      const at = Number(value);
      divided = value !== "" && at >= 0 && at <= 1 && step > 1;
      if (divided) $("divider").value = at;
    } else if (key === "vectors") vectors = value !== "off";
    else if (key === "handles") handles = value === "on";
    else if (key === "outside") change(`outside ${value === "on" ? "on" : "off"}`);
    else {
      const command = `set ${key.replace(/\s/g, "_")} ${value.replace(/\s/g, "_")}`;
      // What cannot be done now can neither be done when the language changes.
      if (attempt(command)) wrong.push(() => attempt(command).slice(0, 200));
    }
  }
  if (place !== null) {
    const wish = pair(place, ",");
    if (wish && wish[0] < size[0] && wish[1] < size[1]) pin = wish;
    else wrong.push(() => `pixel: ${text("there is no such pixel")}`);
  }
  const several = () => [text("Not all of the address can be used:"), ...wrong.slice(0, 5).map((say) => say())];
  notice(wrong.length ? () => several().join("\n") : undefined);
  stage.moving = false;
  refresh();
}

/** The address of what is shown. */
function address() {
  const parts = [`step${two(state.step)}`, ...state.changes];
  if (size !== SIZE) parts.push(`size=${size.join("x")}`);
  if (pin) parts.push(`pixel=${pin.join(",")}`);
  if (!vectors) parts.push("vectors=off");
  if (handles) parts.push("handles=on");
  if (language !== languageOfBrowser()) parts.push(`language=${language.slice(0, 2)}`);
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

/** What is shown now can be come back to. */
function leave() {
  written = address();
  try {
    history.replaceState(null, "", written);
    history.pushState(null, "", written);
  } catch { /* As above. */ }
}

/** What a step or a figure holds now. */
function read(command) {
  const read = { step: 1, name: "", command: "", size: SIZE, changes: [], settings: [] };
  for (const [kind, ...rest] of lines(command)) {
    if (kind === "step") [read.step, read.name] = [Number(rest[0]), rest[1]];
    else if (kind === "command") read.command = rest[0];
    else if (kind === "size") read.size = rest.map(Number);
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
  state = read("state");
  outside = state.changes.includes("outside=on");
  if (state.step !== before) showStep();
  controls.show(state.settings);
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
  for (const article of document.querySelectorAll("article"))
    article.hidden = article !== shown && article.id !== `diff${two(state.step)}`;
  const heading = shown.querySelector("h2").textContent;
  if (!formulas.has(shown)) formulas.set(shown, shown.querySelector(".equation"));
  $("formula").replaceChildren(formulas.get(shown));
  $("formula").lang = language;
  document.title = `${heading} · ${text("Ray tracing, step by step")}`;
  $("title").textContent = heading;
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
  $("edge").hidden = !both || held;
  $("edge").style.left = `${100 * share}%`;
  [$("edge").dataset.before, $("edge").dataset.now] = [two(state.step - 1), two(state.step)];
  $("unpin").hidden = !pin;
  $("pin").hidden = !pin || vectors || outside;
  if (pin) {
    $("pin").style.left = `${100 * (pin[0] + 0.5) / size[0]}%`;
    $("pin").style.top = `${100 * (pin[1] + 0.5) / size[1]}%`;
  }
  for (const canvas of [$("now"), $("before")]) canvas.style.aspectRatio = `${size[0]} / ${size[1]}`;
  $("view").style.setProperty("--shape", `${size[0]} / ${size[1]}`);
}

// ---- controls

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** The sliders and choices of a step or a figure. */
class Controls {
  /** In `box`; ids begin with `prefix`, and what a hand does is a command for `moved`. */
  constructor(box, prefix, moved) {
    Object.assign(this, { box, prefix, moved, shape: "" });
  }

  /** Makes them anew when there are others, else only gives them their values. */
  show(settings) {
    const shape = JSON.stringify([language, settings.map(({ name, group, options }) => [name, group, options])]);
    if (shape !== this.shape) { this.shape = shape; this.make(settings); }
    for (const setting of settings) {
      const row = $(`${this.prefix}control-${setting.name}`);
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

  /** The step's own first, then folded the ones of the steps before, and last the camera's. */
  make(settings) {
    const groups = new Map();
    for (const setting of settings) {
      if (!groups.has(setting.group)) groups.set(setting.group, []);
      groups.get(setting.group).push(this.row(setting));
    }
    const names = [...groups.keys()];
    const camera = names.pop(), own = names.pop();
    this.box.replaceChildren(...[own, ...names, camera].filter((name) => groups.has(name)).map((name) => {
      if (name === own || !name) return element("div", {}, ...groups.get(name));
      return element("details", {}, element("summary", { textContent: name }), ...groups.get(name));
    }));
  }

  row({ name, options, takes }) {
    const id = `${this.prefix}input-${name}`;
    const label = element("label", { htmlFor: id }, ...symbol(name));
    let input;
    const isSwitch = options.length === 2 && options.includes("on") && options.includes("off");
    if (isSwitch) {
      input = element("input", { type: "checkbox", id });
      input.onchange = () => this.moved(`set ${name} ${input.checked ? "on" : "off"}`);
    } else if (options.length) {
      input = element("select", { id }, ...options.map((option) => element("option", { textContent: option })));
      input.onchange = () => this.moved(`fraction ${name} ${input.selectedIndex / Math.max(1, options.length - 1)}`);
    } else {
      input = element("input", { type: "range", id, min: 0, max: 1, step: "any", title: takes });
      input.oninput = () => this.moved(`fraction ${name} ${input.value}`);
      // As the keys do in the window.
      input.onkeydown = (event) => {
        const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
        if (!steps) return;
        event.preventDefault();
        this.moved(`nudge ${name} ${event.shiftKey ? steps / 10 : steps}`);
      };
    }
    const reset = element("button", { type: "button", textContent: "↺", onclick: () => { this.moved(`reset ${name}`); input.focus(); } });
    reset.setAttribute("aria-label", `${text("Reset")} ${name}`);
    const output = element("output", {});
    output.htmlFor = id;
    return element("div", { className: "control", id: `${this.prefix}control-${name}` }, label, input, output, reset);
  }
}

const controls = new Controls($("controls"), "", moved);

/** `n·l k_d` with its indices below. */
const symbol = (name) =>
  name.split(/(?<=(?<![\p{L}_])\p{L})_(\p{L}+)/u).map((part, at) => (at % 2 ? element("sub", { textContent: part }) : part));

// ---- the figures of the handouts, live as soon as they are seen

class Figure {
  constructor(place) {
    this.name = place.dataset.figure;
    this.canvas = element("canvas", {});
    place.append(this.canvas);
    const box = element("div", { className: "controls" });
    place.after(box);
    this.drawing = new Drawing(() => [this.name], () => this.state.size, (made, drawn) => {
      put(this.canvas, this.name, this.state.size, made, "8 - 0 0");
      place.dataset.drawn = drawn;
    });
    const moved = (command) => {
      if (attempt(`figure ${this.name} ${command}`)) return;
      this.drawing.moving = true;
      this.refresh();
    };
    this.controls = new Controls(box, `figure${this.drawing.number}-`, moved);
    change(`figure ${this.name} reset`);
  }

  refresh() {
    this.state = read(`figure ${this.name} state`);
    this.controls.show(this.state.settings);
    this.drawing.redraw();
  }
}

const figures = new Map();

function enliven() {
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      if (!figures.has(target)) figures.set(target, new Figure(target));
      figures.get(target).refresh();
    }
  });
  for (const place of document.querySelectorAll("[data-figure]")) seen.observe(place);
}

// ---- the pinned pixel

let told = null;
const folds = new Map();

function explain() {
  $("unpinned").hidden = Boolean(pin);
  $("pinned").textContent = pin ? `${text("The pixel")} (${pin.join(", ")})` : text("The pixel");
  if (!pin) { told = null; $("explanation").replaceChildren(); fillEquation([]); return; }
  const parts = lines(`explain ${size.join(" ")} ${pin.join(",")}`);
  const now = JSON.stringify(parts.map(([kind, key, shown, more]) => [kind, key, kind === "group" ? more : "", shown]));
  if (now !== told) { told = now; makeExplanation(parts); }
  const places = $("explanation").querySelectorAll("[data-value]");
  let place = 0;
  for (const [kind, ...rest] of parts) {
    if (kind === "section" || (kind === "group" && !rest[0])) continue;
    const shown = kind === "line" ? rest.slice(4) : kind === "seen" ? rest : rest.slice(3);
    places[place++].replaceChildren(...kind === "group" ? symbol(shown[0]) : [shown.map((number) => number.padStart(9)).join(" ").trimStart()]);
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
  const titles = [];
  let group = "", title = "", section = 0;
  for (const [kind, ...rest] of parts) {
    if (kind === "section") { section += 1; group = ""; }
    else if (kind === "group") [group, title] = [rest[2] === "1" ? rest[0] : null, rest[1]];
    if (kind !== "line" || group === null) continue;
    const [, , name, , ...numbers] = rest;
    if (!symbols.has(name)) continue;
    if (group && group !== "sum" && section > 2) {
      if (!groups.has(group)) { groups.set(group, new Map()); titles.push(title); }
      groups.get(group).set(name, numbers);
    } else told.set(name, numbers);
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
  if (JSON.stringify(titles) !== choice.dataset.titles) {
    choice.dataset.titles = JSON.stringify(titles);
    choice.replaceChildren(...names.map((value, at) => element("option", { value, textContent: titles[at] })));
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
  for (const [kind, key, name, more, ink] of parts) {
    if (kind === "section") {
      path = key;
      top.push(section = group = fold(key, name, true));
      list = null;
    } else if (kind === "group") {
      list = null;
      if (!key) { group = section; continue; }
      section.append(group = fold(`${path}/${key}`, name, more === "1", value("span", "outcome")));
    } else {
      if (kind === "seen") { list = null; group = section = element("div", {}); top.push(group); }
      if (!list) group.append(list = element("dl", { className: "lines" }));
      const term = element("dt", {}, ...(kind === "seen" ? [text("seen, sRGB 0 to 255")] : symbol(name)));
      if (kind === "line" && ink) {
        term.className = "inked";
        term.style.setProperty("--ink", ink);
      }
      list.append(element("div", {}, term, value("dd")));
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
new ResizeObserver(() => { if (stage.made && !stage.busy) show(stage.made); }).observe($("picture"));

function hold(down) {
  if (held === down || (down && state.step === 1)) return;
  held = down;
  showStage();
  if (down) redraw();
}

function go(step) {
  if (step < 1 || step > STEPS || step === state.step) return;
  leave();
  change(`step ${step}`);
  stage.moving = false;
  notice();
  refresh();
}

/** The picture as it is seen: with its two halves while it is divided. */
function seen() {
  const [now, before] = [$("now"), $("before")];
  if (!showsBefore()) return now;
  const both = element("canvas", { width: now.width, height: now.height });
  const [pen, left] = [both.getContext("2d"), Math.round(now.width * $("divider").value)];
  pen.drawImage(now, 0, 0);
  pen.drawImage(before, 0, 0, left, now.height, 0, 0, left, now.height);
  return both;
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
  notice(() => `${text("Copied:")} ${what}`);
  try { await navigator.clipboard.writeText(what); } catch {
    // Where that is forbidden, as it is from a server without a certificate, the old way may do.
    const [field, focus] = [element("textarea", { value: what }), document.activeElement];
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
    focus.focus({ preventScroll: true });
  }
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
  $("unpin").onclick = () => {
    // What is hidden cannot keep the focus.
    if (document.activeElement === $("unpin")) $("picture").focus({ preventScroll: true });
    pin = null;
    refresh();
  };
  $("notice").onclick = () => notice();
  $("reset").onclick = () => moved("reset");
  $("link").onclick = () => copy(location.href.split("#")[0] + address());
  $("command").onclick = () => copy(command());
  $("save").onclick = () => {
    const link = element("a", { href: seen().toDataURL("image/png"), download: `${state.name}.png` });
    link.click();
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !run || event.target.tagName === "SELECT") return;
    if (event.target.tagName === "INPUT" && event.key !== "Escape") return;
    // Who reads with the keyboard turns the page there, not the step.
    if (event.key.startsWith("Page") && event.target.closest("#panels")) return;
    if (event.key === "PageDown") go(state.step + 1);
    else if (event.key === "PageUp") go(state.step - 1);
    else if (/^[1-9]$/.test(event.key)) go(Number(event.key));
    else if (event.key === "b") hold(true);
    else if (event.key === "d") $("divide").click();
    else if (event.key === "v") $("vectors").click();
    else if (event.key === "h") $("handles").click();
    else if (event.key === "o") $("outside").click();
    else if (event.key === "Escape" && said()) notice();
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
    leave();
    open(link.hash);
    pin = kept;
    refresh();
  });
  addEventListener("hashchange", () => { if (location.hash !== written) open(location.hash); });
}

/** Of each line of a difference, how far it is indented. */
function indent() {
  for (const lines of document.querySelectorAll(".diff")) {
    for (const part of lines.childNodes)
      if (part.nodeType === 3) part.replaceWith(...part.data.split(/(?<=\n)/).map((line) => element("span", { textContent: line })));
    for (const line of lines.children) line.style.setProperty("--indent", line.textContent.search(/[^-+ ]|$/));
  }
}

function speak(chosen) {
  language = chosen;
  translate();
}

/** Says everything in the language of the page. */
function translate() {
  if (run) run(`language ${language}`);
  document.documentElement.lang = language;
  for (const place of document.querySelectorAll("[data-text]")) place.textContent = text(place.dataset.text);
  for (const place of document.querySelectorAll("[data-name]")) place.setAttribute("aria-label", text(place.dataset.name));
  for (const place of document.querySelectorAll("[data-step]"))
    place.textContent = handout(place.dataset.step).querySelector("h2").textContent.split(" · ")[1];
  const other = language === "en" ? "pt-BR" : "en";
  $("language").textContent = { en: "English", "pt-BR": "Português" }[other];
  $("language").lang = other;
  notice(said);
  told = null;
  if (state) showStep();
  else for (const article of document.querySelectorAll("article[lang]")) article.hidden = article.lang !== language;
}

translate();
$("language").onclick = () => { speak(language === "en" ? "pt-BR" : "en"); if (state) refresh(); };
start().then(() => {
  run(`language ${language}`);
  document.documentElement.classList.add("runs");
  indent();
  hands();
  buttons();
  open(location.hash);
  enliven();
}).catch((error) => {
  console.warn(error);
  notice(() => text("The pictures cannot be drawn in this browser (it lacks WebAssembly or something in it); the texts can be read all the same."));
  document.documentElement.classList.add("broken");
});
