// The class: its stops, from slide to slide.

/** Tells the program and its workers of the stops. */
function readTours() {
  change({ tours: JSON.parse($("tours").textContent) });
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
    $("subtitle").textContent = stop.subtitle;
    $("mark").textContent = stop.changed ? text("changed here · Home: back to the stop")
      : stop.asks ? text("R: a question") : "";
    $("asked").textContent = stop.question;
    $("told").textContent = stop.text;
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
