// The workers: each has the steps' program and draws bands of rows. Without them the page does.

/** A worker has one more band of rows than it draws, so that it never waits for the page. */
const AHEAD = 2;
/** Without workers: how long the page draws before it looks whether there is more to do. */
const ALONE_MS = 12;

let workers = [];
/** Bands that nobody draws yet. */
let queue = [];

function work(asker) {
  let ask;
  onmessage = ({ data }) => {
    if (data.module) ask = asker(new WebAssembly.Instance(data.module));
    else if (data.change) try { ask(data.change); } catch { /* The page has said so. */ }
    else {
      const rgb = ask({ rows: data.rows }).slice();
      postMessage({ ...data, rgb }, [rgb.buffer]);
    }
  };
}

function hire(module) {
  const source = new Blob([`(${work})(${asker})`], { type: "text/javascript" });
  const count = Math.min(navigator.hardwareConcurrency || 1, 8);
  try {
    const address = URL.createObjectURL(source);
    for (let place = 0; place < count; place++) {
      const worker = new Worker(address);
      worker.bands = [];
      worker.onmessage = ({ data }) => {
        worker.bands.shift();
        pump();
        drawings[data.drawing].finished(data);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        lost(worker);
      };
      worker.postMessage({ module });
      workers.push(worker);
    }
  } catch {
    workers = [];
  }
}

/** A worker that cannot work: its bands are drawn by another, or here. */
function lost(worker) {
  workers = workers.filter((other) => other !== worker);
  queue.unshift(...worker.bands);
  pump();
}

/** Hands bands out to whoever has too few. */
function pump() {
  for (let ahead = 0; ahead < AHEAD; ahead++)
    for (const worker of workers)
      if (worker.bands.length === ahead && queue.length) {
        worker.bands.push(queue[0]);
        worker.postMessage(queue.shift());
      }
  if (!workers.length && queue.length) alone();
}

const { port1, port2 } = new MessageChannel();
port1.onmessage = () => {
  const end = performance.now() + ALONE_MS;
  while (queue.length && performance.now() < end) {
    const band = queue.shift();
    drawings[band.drawing].finished({ ...band, rgb: ask({ rows: band.rows }) });
  }
  if (queue.length) alone();
};

/** Without workers: some bands here, then whatever else the page has to do, then the next. */
function alone() {
  port2.postMessage(0);
}
