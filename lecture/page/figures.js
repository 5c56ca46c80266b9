// The figures of the handouts, live as soon as they are seen.

class Figure {
  constructor(place) {
    this.name = place.dataset.figure;
    const canvas = element("canvas", {});
    place.append(canvas);
    const box = element("div", { className: "controls" });
    place.after(box);
    const layers = [{ figure: this.name }];
    this.drawing = new Drawing(() => ({ layers, size: this.state.size }), (made, drawn) => {
      put(canvas, this.name, this.state.size, made);
      place.dataset.drawn = drawn;
    });
    this.controls = new Controls(box, `figure${this.drawing.number}-`, (what) => this.moved(what));
    // As the keys do beside the picture.
    box.onkeydown = (event) => {
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
    this.controls.show(this.state.groups);
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
