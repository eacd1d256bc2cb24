// Lines in a worker. worker.d.ts describes the classes. Calls go to worker_thread.js, one after the other.
import { kinds, none, supported } from './lineatlas.js';

export { kinds, none, supported };

const aborted = (signal) => signal.reason ?? new DOMException('lineatlas: aborted', 'AbortError');

/// A Web Worker, or a thread of Node with the same interface.
async function makeThread() {
  const url = new URL('./worker_thread.js', import.meta.url);
  if (typeof Worker === 'function') return new Worker(url, { type: 'module' });
  const { Worker: Thread } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:worker_threads');
  const thread = new Thread(url);
  thread.unref();
  thread.on('message', (data) => thread.onmessage({ data }));
  thread.on('error', (error) => thread.onerror({ message: error.message }));
  return thread;
}

class Thread {
  #thread = null;
  #jobs = []; // the first one is running
  #ended = null;

  constructor(source, worker) {
    this.#start(source, worker);
  }

  async #start(source, worker) {
    try {
      this.#thread = worker ?? (await makeThread());
      this.#thread.onmessage = ({ data }) => this.#receive(data);
      this.#thread.onerror = ({ message }) => this.end(new Error(`lineatlas: the worker has failed: ${message}`));
    } catch (error) {
      this.end(error);
      return;
    }
    this.#jobs.unshift({ request: { method: 'init', args: [source] }, resolve() {}, reject: (error) => this.end(error) });
    this.#send();
  }

  /// options: the caller's options that are not sent to the thread.
  call(request, { signal, progress } = {}, transfer = []) {
    return new Promise((resolve, reject) => {
      if (this.#ended !== null) return reject(this.#ended);
      if (signal?.aborted) return reject(aborted(signal));
      const job = { request, resolve, reject, progress, transfer };
      if (signal) this.#abortWith(signal, job);
      this.#jobs.push(job);
      if (this.#thread !== null && this.#jobs.length === 1) this.#send();
    });
  }

  #abortWith(signal, job) {
    // A shared stop flag reaches the running thread. Without shared memory the thread runs to its end.
    if (typeof SharedArrayBuffer === 'function' && (globalThis.crossOriginIsolated ?? true))
      job.request.stop = new Int32Array(new SharedArrayBuffer(4));
    signal.addEventListener('abort', () => {
      job.reject(aborted(signal));
      job.dropped = true;
      if (job.request.stop) Atomics.store(job.request.stop, 0, 1);
      if (this.#jobs[0] !== job) this.#jobs = this.#jobs.filter((other) => other !== job);
    }, { once: true });
  }

  #send() {
    const { request, progress, transfer } = this.#jobs[0];
    this.#thread.postMessage({ ...request, wantsProgress: progress !== undefined }, transfer ?? []);
  }

  #receive({ done, result, error }) {
    const job = this.#jobs[0];
    if (done !== undefined) return job.progress(done);
    if (error !== undefined) job.reject(error.isAbort ? new DOMException(error.message, 'AbortError') : new Error(error.message));
    else if (job.dropped && result?.handle !== undefined) this.call({ method: 'dispose', handle: result.handle });
    else job.resolve(result);
    this.#jobs.shift(); // only now, so that calls made in these handlers wait and are sent once
    if (this.#jobs.length > 0) this.#send();
  }

  end(error) {
    this.#ended ??= error;
    for (const job of this.#jobs.splice(0)) job.reject(error);
    this.#thread?.terminate();
  }
}

const split = ({ signal, progress, ...rest } = {}) => [{ signal, progress }, rest];

// A camera that can be sent to a thread. Objects of three.js cannot.
const sendable = ({ view, projection, ...size }) =>
  ({ view: view.elements ?? view, projection: projection.elements ?? projection, ...size });

class Remote {
  constructor(thread, handle) {
    this._thread = thread;
    this._handle = handle;
  }
  _call(method, args, own) {
    if (this._handle === null) return Promise.reject(new Error(`lineatlas: ${this.constructor.name} was disposed of`));
    return this._thread.call({ method, handle: this._handle, args }, own);
  }
  async dispose() {
    if (this._handle === null) return;
    const gone = this._call('dispose', []);
    this._handle = null;
    await gone;
  }
}

export class Lines extends Remote {
  get segmentCount() { return this._call('segmentCount', []); }
  get bounds() { return this._call('bounds', []); }
  get notes() { return this._call('notes', []); }
  setHidden(parts) { return this._call('setHidden', [parts]); }
  frame(options) { return this._call('frame', [options]); }
  async draw(camera, options) {
    const [own, rest] = split(options);
    const { handle } = await this._call('draw', [sendable(camera), rest], own);
    return new Drawing(this._thread, handle);
  }
  pick(camera, x, y, options) { return this._call('pick', [sendable(camera), x, y, options]); }
}

export class Drawing extends Remote {
  get segmentCount() { return this._call('segmentCount', []); }
  segments() { return this._call('segments', []); }
  toSVG(options) { return this._call('toSVG', [options]); }
  toDXF(options) { return this._call('toDXF', [options]); }
  toJSON(options) { return this._call('toJSON', [options]); }
}

const buffersOf = (meshes) => [...new Set(meshes.flatMap((mesh) => [mesh.positions, mesh.indices, mesh.materials])
  .filter(ArrayBuffer.isView).map((list) => list.buffer))];

export class LinesWorker {
  #thread;
  constructor({ wasm, worker } = {}) {
    this.#thread = new Thread(wasm instanceof URL ? wasm.href : wasm, worker);
  }
  async extract(meshes, options) {
    const [own, { transfer = false, ...rest }] = split(options);
    const list = (Array.isArray(meshes) ? meshes : [meshes])
      .map((mesh) => (mesh.matrix ? { ...mesh, matrix: mesh.matrix.elements ?? mesh.matrix } : mesh));
    const { handle } = await this.#thread.call({ method: 'extract', args: [list, rest] }, own, transfer ? buffersOf(list) : []);
    return new Lines(this.#thread, handle);
  }
  readMesh(file, name) { return this.#thread.call({ method: 'readMesh', args: [file, name] }); }
  dispose() {
    this.#thread.end(new Error('lineatlas: the worker was disposed of'));
  }
}
