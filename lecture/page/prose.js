// The settings in the prose: each shows just that in the picture, and takes it back.

const partsOf = (address) => address.split("&");

/** Whether all that a setting says is shown. */
const holds = ({ dataset }) =>
  partsOf(dataset.address).every((part) => partsOf(state.address).includes(part));

/** Of what is only looked at: what was shown before, and what is shown meanwhile. */
let looked = null;
let looking = 0;

/** Shows just this, from where the step starts, and keeps the pin. */
function showOnly(address) {
  const { pin, size } = state;
  open(address);
  if (pin && !state.pin) act({ pin: pin.map((at, axis) => (at + 0.5) / size[axis]) });
}

/** Shows what a setting says as long as a mouse points at it. */
function look({ target, pointerType }) {
  clearTimeout(looking);
  if (looked) {
    const [before, meanwhile] = looked;
    looked = null;
    if (state.address === meanwhile) open(before);
  }
  const place = target.closest("a.try");
  if (!place || pointerType !== "mouse" || holds(place)) return;
  // A pixel tells what one is to guess. And who only passes by does not mean it.
  if (place.dataset.address.includes("&pixel=")) return;
  looking = setTimeout(() => {
    const before = state.address;
    showOnly(place.dataset.address);
    looked = [before, state.address];
    showOffers();
  }, 150);
}

/** Shows what a setting says, or takes it back where it holds. */
function take(place) {
  clearTimeout(looking);
  const before = looked ? looked[0] : state.address;
  const { address } = place.dataset;
  const others = (part, at) => !at || !partsOf(address).includes(part);
  if (looked || !holds(place)) showOnly(address);
  else open(partsOf(before).filter(others).join("&"));
  looked = null;
  showOffers();
  writeAddress(before);
}

/** Shows which settings hold. */
function showOffers() {
  for (const place of document.querySelectorAll("article:not([hidden]) a.try"))
    place.setAttribute("aria-pressed", String(!looked && holds(place)));
}

/** What was unfolded for the paper alone. */
let unfolded = [];

/** Makes the settings buttons, and has paper show what is folded. */
function offer() {
  for (const place of document.querySelectorAll("a.try")) {
    place.href = encoded(place.dataset.address);
    place.setAttribute("role", "button");
    // Not every screen reader reads a formula.
    place.setAttribute("aria-label", place.title.replace(/--(set|what-if|camera|pixel) /g, ""));
    place.setAttribute("aria-pressed", "false");
  }
  $("handouts").addEventListener("pointerover", look);
  $("handouts").addEventListener("keydown", (event) => {
    if (event.key !== " " || !event.target.matches("a.try")) return;
    event.preventDefault();
    take(event.target);
  });
  addEventListener("beforeprint", () => {
    const folded = "article:not([hidden]) :is(.try, .asks) details:not([open])";
    unfolded = [...document.querySelectorAll(folded)];
    for (const fold of unfolded) fold.open = true;
  });
  addEventListener("afterprint", () => {
    for (const fold of unfolded) fold.open = false;
  });
}
