// The pinned pixel in a line, and the picture in a sentence: on a small screen, and for the ear.

/** Of which pixel it was said last what it is. */
let saidOf = "";

function showGist() {
  const { pin, step } = state;
  $("strip").hidden = !pin;
  const math = formula().querySelector(".math");
  const law = [...math.querySelectorAll("[data-symbol]")].map(({ dataset }) => dataset.symbol);
  const [of, numbers] = (pin && asked({ gist: law })) || ["", []];
  const set = numbers.map(([, html, values]) => `${html} ${values.join(" ")}`);
  $("gist").innerHTML = pin ? [`(${pin.join(", ")}) ${of}`.trim(), ...set].join(" · ") : "";
  // It is said when another pixel is pinned, not at each number that changes.
  const what = pin ? [language, step, ...pin].join() : "";
  if (what === saidOf) return;
  saidOf = what;
  const parts = numbers.map(([symbol, , values]) => `${symbol} ${values.join(" ")}`);
  const words = [of, ...parts].filter(Boolean).join(", ");
  $("said").textContent = pin ? `${pin.join(", ")}: ${words}` : "";
}

/** Says what is seen in the picture, to whoever asks a screen reader. */
function describe() {
  const things = asked("seen").map(([thing, percent]) => `${thing} ${percent} %`);
  $("seen").textContent = [titleOf(state.step), things.join(", ")].filter(Boolean).join(": ");
}
