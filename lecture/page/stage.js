// The step's picture, and what stands on it and below it.

/** How much larger all letters are than usual. */
let larger = 1;

const stage = new Drawing(() => state, (made, drawn) => {
  show(made);
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

/** Shows the picture that was made last, with what lies over it and below it now. */
function show(made = stage.made) {
  if (!made || made.left) return;
  showLegend();
  const { size, marked } = state;
  // No larger than the picture can hold.
  const text = Math.max(8, Math.min(size[1] / 12, letters() * size[0] / width()));
  put($("now"), null, marked ? size : made.size, made, text);
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

/** The letters over the picture are as high as those beside it, however wide it is. */
new ResizeObserver(() => show()).observe($("picture"));
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

/** Saves the picture; that of a told line with its legend below it. */
function save() {
  const { legend, name } = state;
  let picture = $("now");
  if (legend) {
    const { width, height } = picture;
    const text = Math.max(12, Math.min(width, height) / 36);
    const [below, high] = [element("canvas", {}), Math.round(legend[1] * text)];
    drawLegend(below, [width, high], text, true);
    picture = element("canvas", { width, height: height + high });
    const paper = picture.getContext("2d");
    paper.drawImage($("now"), 0, 0);
    paper.drawImage(below, 0, height);
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
  $("unpin").onclick = () => {
    // What is hidden cannot keep the focus.
    if (document.activeElement === $("unpin")) $("picture").focus({ preventScroll: true });
    act("unpin");
  };
  $("notice").onclick = () => notice();
  $("link").onclick = () => copy(location.href.split("#")[0] + encoded(state.address));
  document.addEventListener("click", follow);
}
