// The address of what is shown.

const decoded = (address) =>
  address.split("&").map((part) => {
    try { return decodeURIComponent(part); } catch { return part; }
  }).join("&");

const encoded = (address) =>
  "#" + address.slice(1).split("&")
    .map((part) => encodeURIComponent(part).replace(/%(3D|2C)/g, decodeURIComponent)).join("&");

/** Shows what an address says; one that says nothing is the cover's. */
function open(address) {
  document.body.classList.toggle("covered", !address);
  passing = !address;
  // Its picture is the last step's.
  act({ open: decoded(address || $("steps").querySelector("li:last-child a").hash) });
  if (!address) pass();
  // Who leads the class has the keys at once.
  if (state.stop) $("picture").focus({ preventScroll: true });
}

let written = "";
let writing = 0;

/** Puts what is shown into the address, in place of the last one or as the next. */
function write(way, address) {
  clearTimeout(writing);
  written = encoded(address);
  try { history[way](null, "", written); } catch { /* A frame without an address of its own. */ }
}

/** Writes the address; what was shown `before`, if that is said, can be come back to. */
function writeAddress(before) {
  clearTimeout(writing);
  if (isCovered()) return;
  if (before) {
    write("replaceState", before);
    write("pushState", state.address);
    return;
  }
  // Browsers allow only so many changes of the address a second.
  writing = setTimeout(() => write("replaceState", state.address), 200);
}

/** A link to a step takes all along, but not where one reads on; one with settings is a button. */
function follow(event) {
  const link = event.target.closest("a[href^='#step']");
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
  event.preventDefault();
  if (link.matches(".try")) take(link);
  else if (isCovered() || link.closest(".next")) {
    open(link.hash);
    write("pushState", state.address);
  } else act({ step: Number(link.hash.slice(5)) });
}

addEventListener("hashchange", () => {
  if (!state || location.hash === written) return;
  written = location.hash;
  open(location.hash);
});
