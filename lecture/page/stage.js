// The step's picture, and what stands on it and below it.

/** How much larger all letters are than usual. */
let larger = 1;

const stage = new Drawing(() => ({ layers: state.layers, size: sharp() }), (made, drawn) => {
  show(made);
  if (drawn) settle();
  document.body.dataset.drawn = drawn;
});

/** The pictures are others. */
function redraw(moving) {
  document.body.dataset.drawn = "";
  stage.redraw(moving);
}

const width = () => Math.max(1, $("picture").clientWidth);
/** How high letters are on the picture and below it: as beside it, and larger where it is large. */
const letters = () => Math.max(13, 0.022 * width()) * larger;

/** The most pixels of a picture at rest, and how long it may take where the screen has more. */
const MOST_PIXELS = 2560 * 1440;
const REST_MS = 600;

/** The size of the picture at rest: as sharp as the screen, unless somebody asked for a size. */
function sharp() {
  const { size, sized } = state;
  const pixels = size[0] * size[1];
  const most = Math.min(MOST_PIXELS, REST_MS / stage.cost) / pixels;
  const part = Math.min(width() * devicePixelRatio / size[0], Math.sqrt(most));
  return size.map((side) => Math.round(side * (sized ? 1 : Math.max(1, part))));
}

/** Shows the picture that was made last, and what lies over it now. */
function show(made = stage.made) {
  if (!made || made.left) return;
  put($("now"), null, made.size, made);
  const { marked, size } = state;
  $("marks").hidden = !marked;
  if (!marked) return;
  const part = markCost * size[0] * size[1] > MARKS_MS ? 0.5 : 1;
  mark($("marks"), made.dragged ? size.map((side) => Math.round(side * part)) : sharp());
}

/** Where what lies over a picture takes longer than this, a drag has half as many rows of it. */
const MARKS_MS = 8;
/** Milliseconds for a pixel of it. */
let markCost = 0;

/** Puts what lies over the picture on a canvas of this size, in letters that fit it. */
function mark(canvas, size) {
  const start = performance.now();
  const text = Math.max(8, Math.min(size[1] / 12, letters() * size[0] / width()));
  fill(canvas, size, ask({ marks: { size, text } }));
  markCost = (performance.now() - start) / (size[0] * size[1]);
}

/** What the colours of a told line stand for, as wide as the picture. */
function showLegend() {
  const { legend } = state;
  $("legend").hidden = !legend;
  if (!legend) return;
  const [words, high] = legend;
  $("legend").setAttribute("aria-label", words);
  const text = letters() * devicePixelRatio;
  drawLegend($("legend"), [width() * devicePixelRatio, high * text].map(Math.round), text, false);
}

function drawLegend(canvas, size, text, altered) {
  fill(canvas, size, ask({ below: { size, text, altered } }));
}

/** Letters over the picture are as high as those beside it, however wide it is, and it is sharp. */
new ResizeObserver(() => {
  if (!state) return;
  showLegend();
  show();
  if (!stage.busy && String(sharp()) !== String(stage.made.size)) redraw(true);
}).observe($("picture"));
/** What is scrolled to is not below the picture. */
new ResizeObserver(() => {
  document.documentElement.style.setProperty("--view", `${$("view").offsetHeight}px`);
}).observe($("view"));
/** Where there is room beside the text, the tools stand below the picture. */
new ResizeObserver(() => {
  document.documentElement.style.setProperty("--stage", `${$("stage").offsetHeight}px`);
}).observe($("stage"));

function showStage() {
  const { step, size, pin, divider, holding, vectors, handles, outside } = state;
  $("hold").disabled = $("divide").disabled = step === 1;
  const pressed = { vectors, handles, outside, divide: divider !== null };
  for (const [name, on] of Object.entries(pressed))
    $(name).setAttribute("aria-pressed", String(on));
  $("divider").hidden = divider === null;
  $("divider").value = divider;
  $("edge").hidden = divider === null || holding;
  $("edge").style.left = `${100 * divider}%`;
  [$("edge").dataset.before, $("edge").dataset.now] = [two(step - 1), two(step)];
  $("unpin").hidden = !pin;
  $("pin").hidden = !pin || vectors || outside;
  if (pin) {
    $("pin").style.left = `${100 * (pin[0] + 0.5) / size[0]}%`;
    $("pin").style.top = `${100 * (pin[1] + 0.5) / size[1]}%`;
  }
  showLegend();
  const shape = `${size[0]} / ${size[1]}`;
  $("now").style.aspectRatio = shape;
  $("view").style.setProperty("--shape", shape);
  document.body.classList.toggle("alone", state.alone);
}

/** The old way, where the other is forbidden, as it is from a server without a certificate. */
function copyAsOfOld(what) {
  const [field, focus] = [element("textarea", { value: what }), document.activeElement];
  document.body.append(field);
  field.select();
  const copied = document.execCommand("copy");
  field.remove();
  focus.focus({ preventScroll: true });
  return copied;
}

async function copy(what) {
  let copied = true;
  try { await navigator.clipboard.writeText(what); } catch { copied = copyAsOfOld(what); }
  notice(`${copied ? text("Copied:") : text("To copy by hand:")} ${what}`);
}

/** Saves the picture at its own size with all that lies over it, and its legend below. */
function save() {
  const { legend, layers, name, marked, size } = state;
  const [width, height] = size;
  const all = { size, first: 0, count: height };
  const rgb = layers.map((layer) => ask({ rows: { layer, ...all } }).slice());
  const text = Math.max(12, Math.min(width, height) / 36);
  const high = legend ? Math.round(legend[1] * text) : 0;
  const picture = element("canvas", { width, height: height + high });
  const over = element("canvas", {});
  const paper = picture.getContext("2d");
  put(over, null, size, { size, rgb });
  paper.drawImage(over, 0, 0);
  if (marked) {
    mark(over, size);
    paper.drawImage(over, 0, 0);
  }
  if (legend) {
    drawLegend(over, [width, high], text, true);
    paper.drawImage(over, 0, height);
  }
  element("a", { href: picture.toDataURL("image/png"), download: `${name}.png` }).click();
}

/** The buttons: most do what a key does. */
function buttons() {
  for (const button of document.querySelectorAll("[data-key]"))
    button.onclick = () => press(button.dataset.key);
  const hold = $("hold");
  const held = (down) => () => press("a", down);
  hold.addEventListener("pointerdown", (event) => hold.setPointerCapture(event.pointerId));
  hold.addEventListener("pointerdown", held(true));
  for (const end of ["pointerup", "pointercancel", "blur", "keyup"])
    hold.addEventListener(end, held(false));
  hold.addEventListener("keydown", ({ key }) => {
    if (key === " " || key === "Enter") press("a");
  });
  hold.addEventListener("contextmenu", (event) => event.preventDefault());
  $("divider").oninput = () => act({ divideAt: Number($("divider").value) });
  $("all").onclick = () => {
    // The way back leads to where one read.
    write("pushState", state.address);
    $("pixel").scrollIntoView();
    $("pinned").focus({ preventScroll: true });
  };
  $("unpin").onclick = () => {
    // What is hidden cannot keep the focus.
    if (document.activeElement === $("unpin")) $("picture").focus({ preventScroll: true });
    act("unpin");
  };
  $("notice").onclick = () => notice();
  $("link").onclick = () => copy(location.href.split("#")[0] + encoded(state.address));
  document.addEventListener("click", follow);
}
