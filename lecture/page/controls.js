// The controls of a step or of a figure, as what they are: switches, choices, sliders.

class Controls {
  /** In `box`; ids begin with `prefix`, and what a hand does is handed to `moved`. */
  constructor(box, prefix, moved) {
    Object.assign(this, { box, prefix, moved, shape: "" });
  }

  /** Makes them anew when there are others, else only gives them their values. */
  show(groups) {
    const kinds = ({ name, kind, options }) => [name, kind, options];
    const shape = groups.map(({ name, open, settings }) => [name, open, settings.map(kinds)]);
    const now = JSON.stringify([language, shape]);
    if (now !== this.shape) {
      this.shape = now;
      this.box.replaceChildren(...groups.map((group) => this.group(group)));
    }
    for (const setting of groups.flatMap(({ settings }) => settings)) this.fill(setting);
  }

  fill({ name, kind, text, fraction, changed, options }) {
    const row = $(`${this.prefix}control-${name}`);
    row.classList.toggle("changed", changed);
    row.querySelector("button").style.visibility = changed ? "visible" : "hidden";
    const [input, output] = [row.querySelector("input, select"), row.querySelector("output")];
    output.textContent = kind === "choice" ? "" : text;
    if (kind === "switch") input.checked = fraction === 1;
    else if (kind === "choice")
      input.selectedIndex = Math.round(fraction * (options.length - 1));
    else {
      input.value = fraction;
      input.setAttribute("aria-valuetext", text);
    }
  }

  group({ name, shown, open, settings }) {
    const rows = settings.map((setting) => this.row(setting));
    if (!name) return element("div", {}, ...rows);
    const made = foldable(`${this.prefix}group-${name}`, open, shown);
    made.firstChild.id = `${this.prefix}group-${name}`;
    made.append(...rows);
    return made;
  }

  row({ name, label, kind, takes, options }) {
    const id = `${this.prefix}input-${name}`;
    const input = this.input({ name, kind, takes, options });
    Object.assign(input, { id, name });
    // Not every screen reader reads a label that is a formula.
    input.setAttribute("aria-label", name);
    const reset = element("button", { type: "button", textContent: "↺" });
    reset.setAttribute("aria-label", `${text("Reset")} ${name}`);
    reset.onclick = () => {
      this.moved({ reset: name });
      input.focus();
    };
    const output = element("output", {});
    output.htmlFor = id;
    const row = element("div", { className: "control", id: `${this.prefix}control-${name}` });
    row.append(element("label", { htmlFor: id, innerHTML: label }), input, output, reset);
    return row;
  }

  input({ name, kind, takes, options }) {
    if (kind === "switch") {
      const input = element("input", { type: "checkbox" });
      input.onchange = () => this.moved({ set: [name, options[Number(input.checked)]] });
      return input;
    }
    if (kind === "choice") {
      const listed = options.map((option) => element("option", { textContent: option }));
      const input = element("select", {}, ...listed);
      input.onchange = () => this.moved({ set: [name, input.value] });
      return input;
    }
    const input = element("input", { type: "range", min: 0, max: 1, step: "any", title: takes });
    input.oninput = () => this.moved({ fraction: [name, Number(input.value)] });
    return input;
  }
}

const controls = new Controls($("controls"), "", moved);
/** Those of what is answered otherwise, below the picture so that they are in sight. */
const answers = new Controls($("answers"), "", moved);

/** Shows all controls; whether something more is answered otherwise than before. */
function showControls() {
  const { groups, altered } = state;
  const count = () => $("answers").querySelectorAll("input").length;
  const before = count();
  answers.show(altered ? groups.slice(0, 1) : []);
  controls.show(altered ? groups.slice(1) : groups);
  $("answers").hidden = !altered;
  if (altered) $("answers").querySelector("summary").textContent = altered;
  if (count() <= before) return false;
  // Keys act on it, as the first that can be selected.
  chosen = "";
  return true;
}
