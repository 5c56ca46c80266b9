// Hands on the picture: they turn it, zoom, drag points and pin pixels.

/** The hands, by their pointers. */
const pointers = new Map();
/** How far they have been dragged, in pixels of the screen. */
let dragged = 0;
/** The handle that is held. */
let grabbed = null;
/** Where a pointer was last over the picture, if it is there. */
let pointed = null;

/** Where a pointer is on the picture, as shares of its width and height, from the upper left. */
function share(event) {
  const box = $("picture").getBoundingClientRect();
  return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
}

function grab(event) {
  const reach = (event.pointerType === "mouse" ? 14 : 28) / $("picture").clientWidth;
  return asked({ grab: { at: share(event), reach } });
}

function spread() {
  const [a, b] = [...pointers.values()];
  return Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
}

function down(event) {
  if (event.button) return;
  $("picture").setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  const first = pointers.size === 1;
  dragged = first ? 0 : Infinity;
  grabbed = first ? grab(event) : null;
  $("picture").classList.add("grabbed");
}

function move(event) {
  pointed = share(event);
  const last = pointers.get(event.pointerId);
  if (!last) return;
  const before = pointers.size === 2 && spread();
  pointers.set(event.pointerId, event);
  const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
  dragged += Math.abs(right) + Math.abs(down);
  if (before) moved({ zoom: before / spread() });
  else if (grabbed !== null) moved({ drag: [grabbed, share(event)] });
  else if (pointers.size === 1 && dragged > 4) {
    // Across the picture is half a turn, on any screen.
    const angle = 180 / $("picture").clientWidth;
    moved({ orbit: [-right * angle, down * angle] });
  }
}

function up(event) {
  if (!pointers.delete(event.pointerId) || pointers.size) return;
  $("picture").classList.remove("grabbed");
  if (event.type === "pointerup" && dragged <= 4 && grabbed === null) pinAt(share(event));
}

function turned(event) {
  event.preventDefault();
  moved({ zoom: Math.exp(Math.max(-1, Math.min(1, event.deltaY / 500))) });
}

/** Where the Tab key has led to the picture, arrows turn it, and with Shift they move the pin. */
function typed(event) {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const [right, below] = way[event.key] || [];
  if (right === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  if (event.shiftKey) act({ movePin: [right, below] });
  else moved({ orbit: [5 * right, -5 * below] });
}

function hands() {
  const picture = $("picture");
  picture.addEventListener("pointerdown", down);
  picture.addEventListener("pointermove", move);
  picture.addEventListener("pointerup", up);
  picture.addEventListener("pointercancel", up);
  picture.addEventListener("pointerleave", () => { pointed = null; });
  picture.addEventListener("wheel", turned, { passive: false });
  picture.addEventListener("keydown", typed);
}
