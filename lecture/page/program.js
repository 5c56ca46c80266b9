// The steps' program: it is asked in JSON, and answers in JSON or with the bytes of a picture.

/**
 * What asks an instance of it; also within a worker, which knows nothing else of here. The bytes of
 * pictures go with a question. The answer stays in the program's memory, until the next question.
 */
function asker(instance) {
  const { memory, page_input, page_run, page_output } = instance.exports;
  return (question, ...pictures) => {
    const parts = [new TextEncoder().encode(`${JSON.stringify(question)}\n`), ...pictures];
    // The memory may grow: its buffer is asked for afterwards.
    let place = page_input(parts.reduce((sum, part) => sum + part.length, 0));
    for (const part of parts) {
      new Uint8Array(memory.buffer, place, part.length).set(part);
      place += part.length;
    }
    const length = page_run();
    const answer = new Uint8Array(memory.buffer, page_output(), Math.abs(length));
    if (length < 0) throw new Error(new TextDecoder().decode(answer));
    return answer;
  };
}

let ask = null;
const asked = (question) => JSON.parse(new TextDecoder().decode(ask(question)));

/** Does something here and in each worker; what came of it. */
function change(question) {
  const done = asked(question);
  for (const worker of workers) worker.postMessage({ change: question });
  return done;
}

/** The bytes of a text of which each letter has seven bits. */
function bytesOf(text) {
  const bytes = new Uint8Array(text.length * 7 / 8);
  let [held, bits, place] = [0, 0, 0];
  for (let at = 0; at < text.length; at++) {
    held = held << 7 | text.charCodeAt(at) & 127;
    bits += 7;
    if (bits >= 8) bytes[place++] = held >> (bits -= 8);
  }
  return bytes;
}

/** What the page has packed under this name. */
const unpacked = (id) => new Response(
  new Blob([bytesOf($(id).textContent)]).stream().pipeThrough(new DecompressionStream("gzip")));

async function start() {
  const module = await WebAssembly.compile(await unpacked("wasm").arrayBuffer());
  ask = asker(await WebAssembly.instantiate(module));
  hire(module);
  tours = await unpacked("packed-tours").json();
  $("licences").textContent = await unpacked("packed-licences").text();
}
