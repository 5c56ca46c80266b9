// The figures of the handouts, live as soon as they are seen.

class Figure {
  constructor(place) {
    [this.name, this.about] = [place.dataset.figure, place.dataset.about];
    const canvas = element("canvas", {});
    place.append(canvas);
    // What it is about is at hand; its other controls come after its text.
    const [box, others] = [1, 2].map(() => element("div", { className: "controls" }));
    this.more = element("details", { className: "others" }, element("summary", {}), others);
    place.after(box);
    place.parentNode.append(this.more);
    const layers = [{ figure: this.name }];
    this.drawing = new Drawing(() => ({ layers, size: this.state.size }), (made, drawn) => {
      put(canvas, this.name, this.state.size, made);
      place.dataset.drawn = drawn;
    });
    const own = (box) =>
      new Controls(box, `figure${this.drawing.number}-`, (what) => this.moved(what));
    [this.control, this.others] = [box, others].map(own);
    // As the keys do beside the picture.
    place.parentNode.onkeydown = (event) => {
      const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
      if (!steps || event.target.type !== "range") return;
      event.preventDefault();
      this.moved({ nudge: [event.target.name, event.shiftKey ? steps / 10 : steps] });
    };
  }

  moved(what) {
    change({ doOn: [this.name, what] });
    this.refresh(true);
  }

  refresh(moving = false) {
    this.state = asked({ state: { of: this.name, spoken } });
    const { groups } = this.state;
    const isAbout = ({ name }) => name === this.about;
    const settings = groups.flatMap((group) => group.settings.filter(isAbout));
    this.control.show([{ name: "", settings }]);
    const without = (group) =>
      ({ ...group, settings: group.settings.filter((setting) => !isAbout(setting)) });
    const rest = groups.map(without).filter(({ settings }) => settings.length);
    this.others.show(rest);
    this.more.hidden = !rest.length;
    this.more.firstChild.textContent = text("More controls");
    this.drawing.redraw(moving);
  }
}

const figures = new Map();

function enliven() {
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      if (!figures.has(target)) figures.set(target, new Figure(target));
      figures.get(target).refresh();
    }
  });
  for (const place of document.querySelectorAll("[data-figure]")) seen.observe(place);
}
