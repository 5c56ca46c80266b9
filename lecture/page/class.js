// The class: its stops, from slide to slide.

/** What is read of each stop, in each language. */
let tours = null;

/** How long the pictures are on their way from one stop to the next. */
const GLIDE_MS = 250;

/** Has the pictures glide to the stop; at once where that takes long or less motion is wanted. */
function glide() {
  const [width, height] = state.size;
  const slow = stage.cost * width * height > GLIDE_MS
    || matchMedia("(prefers-reduced-motion: reduce)").matches;
  const start = performance.now();
  const on = () => {
    const part = slow ? 1 : (performance.now() - start) / GLIDE_MS;
    const { redraw: another } = change({ do: { glide: part } });
    if (another) redraw(part < 1);
    if (part < 1) requestAnimationFrame(on);
  };
  on();
}

/** Shows where the class is, what is said there, and the list of all stops if it is read. */
function showClass() {
  const { stop, listed, blank } = state;
  $("blank").hidden = !blank;
  $("class").hidden = !stop;
  document.body.classList.toggle("class", Boolean(stop));
  if (stop) {
    $("way").value = stop.number / stop.count;
    $("slide").textContent = `${stop.slide} · ${stop.number}/${stop.count}`;
    $("subtitle").innerHTML = stop.subtitle;
    $("mark").textContent = stop.changed ? text("changed here · Home: back to the stop")
      : stop.asks ? text("R: a question") : "";
    $("asked").innerHTML = stop.question;
    $("told").innerHTML = stop.text;
  }
  $("stops").hidden = !listed;
  if (!listed) return;
  const [all, picked] = listed;
  const items = all.map((title, place) => {
    const button = element("button", { textContent: title, onclick: () => act({ listed: place }) });
    if (place === picked) button.setAttribute("aria-current", "true");
    return element("li", {}, button);
  });
  $("stops").querySelector("ol").replaceChildren(...items);
  items[picked].scrollIntoView({ block: "nearest" });
}
