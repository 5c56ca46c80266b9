// Hands on the picture and on sliders: they turn, zoom, drag points, pin pixels, and scroll past.

/** The hands, by their pointers. */
const pointers = new Map();
/** Where the first went down, and what it means by now: to turn, or something else; or null. */
let [began, turns] = [null, null];
/** The handle that is held. */
let grabbed = null;
/** Where a pointer was last over the picture, if it is there. */
let pointed = null;
/** Whether the picture has the focus by a click: then the wheel is its, too. */
let entered = false;

/** Where a pointer is on the picture, as shares of its width and height, from the upper left. */
function share(event) {
  const box = $("picture").getBoundingClientRect();
  return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
}

function grab(event) {
  const reach = (event.pointerType === "mouse" ? 14 : 28) / $("picture").clientWidth;
  return asked({ grab: { at: share(event), reach } });
}

/**
 * Whether a pointer that went from one place to another means to go sideways; null as long as it
 * may have gone nowhere. A finger that goes up or down means the page, which the browser scrolls.
 */
function sideways(from, to) {
  const [right, down] = [to.clientX - from.clientX, to.clientY - from.clientY].map(Math.abs);
  const mouse = to.pointerType === "mouse";
  return Math.max(right, down) < (mouse ? 4 : 8) ? null : mouse || right >= down;
}

function spread() {
  const [a, b] = [...pointers.values()];
  return Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
}

function down(event) {
  if (event.button) return;
  $("picture").setPointerCapture(event.pointerId);
  $("picture").focus({ preventScroll: true });
  entered = true;
  pointers.set(event.pointerId, event);
  const first = pointers.size === 1;
  began = event;
  turns = first ? null : false;
  grabbed = first ? grab(event) : null;
  $("picture").classList.add("grabbed");
}

function move(event) {
  pointed = share(event);
  const last = pointers.get(event.pointerId);
  if (!last) return;
  const before = pointers.size === 2 && spread();
  pointers.set(event.pointerId, event);
  if (before) moved({ zoom: before / spread() });
  else if (grabbed !== null) moved({ drag: [grabbed, share(event)] });
  else if (turns ??= sideways(began, event)) {
    // Across the picture is half a turn, on any screen.
    const angle = 180 / $("picture").clientWidth;
    const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
    moved({ orbit: [-right * angle, down * angle] });
  }
}

function up(event) {
  if (!pointers.delete(event.pointerId) || pointers.size) return;
  $("picture").classList.remove("grabbed");
  if (event.type === "pointerup" && turns === null && grabbed === null) pinAt(share(event));
}

/** What is held ends where nobody can know whether it still is. */
function letGo() {
  if (state.holding) press("a", false);
  pointers.clear();
  $("picture").classList.remove("grabbed");
}

/** A finger scrolls, unless it holds something or is one of several. */
function touched(event) {
  if (grabbed !== null || event.touches.length > 1) event.preventDefault();
}

/** The wheel scrolls, unless it is meant for the picture. */
function turned(event) {
  if (!event.ctrlKey && !entered) return;
  event.preventDefault();
  moved({ zoom: Math.exp(Math.max(-1, Math.min(1, event.deltaY / 500))) });
}

/** Where the Tab key has led to the picture, arrows turn it, and with Shift they move the pin. */
function typed(event) {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const [right, below] = way[event.key] || [];
  if (right === undefined || state.listed || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  if (event.shiftKey) act({ movePin: [right, below] });
  else moved({ orbit: [5 * right, -5 * below] });
}

/** A finger on a slider: where it went down, and what the slider was; null once it slides. */
let touching = null;

function slide() {
  const { target } = touching;
  touching = null;
  target.dispatchEvent(new Event("input"));
}

/** A finger that goes up or down past a slider leaves it; a tap or a swipe sideways moves it. */
function sliders() {
  const on = (name, done) => document.addEventListener(name, done, true);
  on("pointerdown", (event) => {
    const { target, pointerType, clientX, clientY } = event;
    const meant = pointerType === "mouse" || target.type !== "range";
    touching = meant ? null : { target, value: target.value, clientX, clientY };
  });
  on("input", (event) => {
    if (touching && event.target === touching.target) event.stopPropagation();
  });
  on("pointermove", (event) => {
    if (touching && sideways(touching, event)) slide();
  });
  for (const end of ["pointerup", "pointercancel"])
    on(end, (event) => {
      if (!touching) return;
      if (end === "pointerup" && sideways(touching, event) === null) return slide();
      touching.target.value = touching.value;
      touching = null;
    });
}

function hands() {
  const picture = $("picture");
  picture.addEventListener("pointerdown", down);
  picture.addEventListener("pointermove", move);
  picture.addEventListener("pointerup", up);
  picture.addEventListener("pointercancel", up);
  picture.addEventListener("pointerleave", () => { pointed = null; });
  picture.addEventListener("touchstart", touched, { passive: false });
  picture.addEventListener("wheel", turned, { passive: false });
  picture.addEventListener("keydown", typed);
  picture.addEventListener("blur", () => { entered = false; });
  addEventListener("blur", letGo);
  document.addEventListener("visibilitychange", letGo);
  sliders();
}
