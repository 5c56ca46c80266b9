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

/** Shows the picture that was made last, with what lies over it now. */
function show(made = stage.made) {
  if (!made || made.left) return;
  const { size, marked } = state;
  // As high as the letters beside the picture, larger where the picture is, and no larger than it
  // can hold.
  const width = Math.max(1, $("picture").clientWidth);
  const letters = Math.max(13, 0.022 * width) * larger * size[0] / width;
  const text = Math.max(8, Math.min(size[1] / 12, letters));
  put($("now"), null, marked ? size : made.size, made, text);
}

/** The letters over the picture are as high as those beside it, however wide it is. */
new ResizeObserver(() => show()).observe($("picture"));

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

async function copy(what) {
  notice(`${text("Copied:")} ${what}`);
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

function save() {
  const href = $("now").toDataURL("image/png");
  element("a", { href, download: `${state.name}.png` }).click();
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
