// Pictures in the making: each is a number of bands of one or two layers.

/**
 * A picture that takes longer than this is drawn with fewer pixels while something is dragged, and
 * so is one that has more pixels than this, as they have to be handed on.
 */
const DRAGGED_MS = 22;
const DRAGGED_PIXELS = 960 * 540;
/** The largest band of rows, and the smallest: the last ones, so that all workers end together. */
const BAND_PIXELS = [36 * 960, 6 * 960];

const drawings = [];

/** A picture that is drawn again whenever something changes; while it goes on, coarsely. */
class Drawing {
  /** `wanted` says its layers and its size, `show` puts it where it is seen. */
  constructor(wanted, show) {
    Object.assign(this, { wanted, show });
    this.number = drawings.push(this) - 1;
    this.frame = 0;
    /** The picture in the making, or the one that was made last. */
    this.made = null;
    this.busy = this.stale = this.moving = false;
    /** Milliseconds for a pixel; how many a picture may have while something is dragged follows. */
    this.cost = 60 / (960 * 540);
  }

  /** Something has changed, and may go on changing: then it is `moving`. */
  redraw(moving) {
    this.moving = moving;
    this.stale = true;
    // Whoever drags sees each picture that was begun: where changes come faster than
    // pictures, there would else be none. One of other layers is not waited for: the step before may be gone.
    const same = () => JSON.stringify(this.made.layers) === JSON.stringify(this.wanted().layers);
    if (!(this.busy && this.made.dragged && same())) this.draw(moving);
  }

  draw(dragged) {
    const { layers, size } = this.wanted();
    const pixels = size[0] * size[1];
    const room = Math.min(DRAGGED_PIXELS, DRAGGED_MS / (this.cost * layers.length));
    const part = dragged ? Math.min(1, Math.max(1 / 6, Math.sqrt(room / pixels))) : 1;
    const [width, height] = size.map((side) => Math.max(1, Math.round(side * part)));
    this.stale = false;
    this.busy = true;
    this.started = performance.now();
    this.frame += 1;
    const rgb = layers.map(() => new Uint8Array(3 * width * height));
    this.made = { dragged, quick: part < 1, size: [width, height], left: 0, layers, rgb };
    queue = queue.filter((band) => band.drawing !== this.number);
    const [most, least] = BAND_PIXELS.map((pixels) => Math.max(1, Math.round(pixels / width)));
    for (let first = 0, count; first < height; first += count) {
      const share = Math.ceil((height - first) / (3 * Math.max(1, workers.length)));
      count = Math.min(height - first, most, Math.max(least, share));
      for (const [place, layer] of layers.entries()) {
        const rows = { layer, size: this.made.size, first, count };
        queue.push({ drawing: this.number, frame: this.frame, place, rows });
        this.made.left += 1;
      }
    }
    pump();
  }

  finished({ frame, place, rows, rgb }) {
    if (frame !== this.frame) return;
    const { made } = this;
    made.rgb[place].set(rgb, 3 * made.size[0] * rows.first);
    made.left -= 1;
    if (made.left) return;
    this.busy = false;
    const spent = performance.now() - this.started;
    const pixels = made.size[0] * made.size[1] * made.layers.length;
    this.cost = 0.5 * this.cost + 0.5 * spent / pixels;
    clearTimeout(this.settle);
    if (this.stale) this.draw(this.moving);
    else if (made.quick) this.settle = setTimeout(() => this.draw(false), 80);
    this.show(made, this.busy || made.quick ? "" : `${frame} ${spent.toFixed(1)}`);
  }
}

/** Puts a picture on a canvas of this size. */
function put(canvas, of, size, made) {
  fill(canvas, size, ask({ show: { of, size, drawn: made.size } }, ...made.rgb));
}

/** Puts pixels of four bytes on a canvas of this size. */
function fill(canvas, [width, height], rgba) {
  if (canvas.width !== width || canvas.height !== height)
    [canvas.width, canvas.height] = [width, height];
  const pixels = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
  canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);
}
