// The thread of worker.js. Each message is a call, each answer its result.
import { Lines, init, readMesh } from './lineatlas.js';

let port = null;

const objects = new Map();
let last = 0;

function kept(object) {
  objects.set(++last, object);
  return { handle: last };
}

const buffersOf = (result) => (result === null || typeof result !== 'object' ? []
  : Object.values(result.mesh ?? result).filter(ArrayBuffer.isView).map((list) => list.buffer));

async function run({ method, handle, args = [], stop, wantsProgress }) {
  const progress = (done) => {
    if (wantsProgress) port.postMessage({ done });
    return stop === undefined || Atomics.load(stop, 0) === 0;
  };
  const object = objects.get(handle);
  switch (method) {
    case 'init': return void (await init(args[0]));
    case 'extract': return kept(new Lines(args[0], { ...args[1], progress }));
    case 'readMesh': return readMesh(...args);
    case 'draw': return kept(object.draw(args[0], { ...args[1], progress }));
    case 'dispose':
      objects.delete(handle);
      return object.dispose();
    default: return typeof object[method] === 'function' ? object[method](...args) : object[method];
  }
}

async function answer(request) {
  try {
    const result = await run(request);
    port.postMessage({ result }, buffersOf(result));
  } catch (error) {
    port.postMessage({ error: { message: error.message, isAbort: error.name === 'AbortError' } });
  }
}

async function listen() {
  if (typeof self === 'object' && typeof self.postMessage === 'function') {
    port = self;
    port.onmessage = ({ data }) => answer(data);
  } else {
    port = (await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:worker_threads')).parentPort;
    port.on('message', answer);
  }
}
listen();
