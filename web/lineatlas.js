// Visible lines of 3D models. lineatlas.d.ts describes the functions.

// The smallest module with SIMD and with exceptions of the older kind, which most browsers know.
const probe = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 16, 1, 14, 0, 6, 123, 65, 0, 253, 15, 25, 65, 1, 253, 15, 11, 11]);

export const supported = typeof WebAssembly === 'object' && WebAssembly.validate(probe);

export const kinds = Object.freeze([
  'crease', 'boundary', 'material', 'silhouette', 'file', 'intersection', 'section', 'hatching', 'ridge', 'valley',
  'tangent', 'centre', 'trail',
]);
export const none = 0xffffffff;

const encoder = new TextEncoder(), decoder = new TextDecoder();

let wasm = null; // the exports of the module
let told = null; // the progress function of the current call
let running = false; // true while that function runs
let thrown = null; // the error that it threw

// Addresses in the upper half of memory arrive as negative numbers.
const at = (Type, address, count) => new Type(wasm.memory.buffer, address >>> 0, count);
const bytesAt = (address, size) => at(Uint8Array, address, size);
const floatsAt = (address, count) => at(Float32Array, address, count);
const messageOf = () => decoder.decode(bytesAt(wasm.la_message(), wasm.la_message_size()));

// System calls of C++: the time, and output of fatal errors.
const system = {
  clock_time_get(id, precision, to) {
    const now = BigInt(Math.round(performance.now() * 1e6));
    new DataView(wasm.memory.buffer).setBigUint64(to, now, true);
    return 0;
  },
  fd_write(file, pieces, count, to) {
    const memory = new DataView(wasm.memory.buffer);
    let size = 0, text = '';
    for (let i = 0; i < count; ++i) {
      const length = memory.getUint32(pieces + 8 * i + 4, true);
      text += decoder.decode(bytesAt(memory.getUint32(pieces + 8 * i, true), length));
      size += length;
    }
    console.error(text);
    memory.setUint32(to, size, true);
    return 0;
  },
  environ_sizes_get(count, size) {
    const memory = new DataView(wasm.memory.buffer);
    memory.setUint32(count, 0, true);
    memory.setUint32(size, 0, true);
    return 0;
  },
  environ_get: () => 0,
  proc_exit(code) { throw new Error(`lineatlas: the module ended itself with ${code}`); },
};
const unknown = () => 52; // ENOSYS

function tell(done) {
  running = true;
  try {
    return told === null || told(done) !== false ? 1 : 0;
  } catch (error) {
    thrown = { error };
    return 0;
  } finally {
    running = false;
  }
}

function importsOf(module) {
  const imports = { lineatlas: { progress: tell } };
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    if (from !== 'lineatlas') (imports[from] ??= {})[name] = system[name] ?? unknown;
  return imports;
}

async function compile(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  const url = new URL(source, import.meta.url);
  if (url.protocol === 'file:' && typeof process === 'object') {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`lineatlas: cannot load ${url.href}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

let ready = null;

async function start(source) {
  if (!supported) throw new Error('lineatlas: this browser has no SIMD or no exceptions in WebAssembly; update it');
  const module = await compile(source ?? new URL('./lineatlas.wasm', import.meta.url));
  wasm = (await WebAssembly.instantiate(module, importsOf(module))).exports;
  wasm._initialize();
  broken = null;
}

export function init(source) {
  ready ??= start(source).catch((error) => {
    ready = null;
    throw error;
  });
  return ready;
}

let broken = null; // why the module can no longer be used

/// Calls the module. After an unexpected failure of C++ the module is broken.
function call(name, ...args) {
  if (wasm === null) throw new Error('lineatlas: call init() and wait for it first');
  if (broken !== null) throw broken;
  if (running) throw new Error('lineatlas: nothing can be called within progress');
  try {
    return wasm[name](...args);
  } catch (error) {
    broken = new Error(`lineatlas: the module has failed (${error.message}); call init() and make all lines again`);
    ready = null;
    throw broken;
  }
}

function failure() {
  if (thrown !== null) {
    const { error } = thrown;
    thrown = null;
    return error;
  }
  return wasm.la_cancelled() ? new DOMException(messageOf(), 'AbortError') : new Error(messageOf());
}
function check(well) {
  if (!well) throw failure();
}

/// Makes a long call with progress. Meanwhile the page must not call the module.
function callWithProgress(progress, name, ...args) {
  if (progress !== undefined && typeof progress !== 'function') throw new Error('lineatlas: progress must be a function');
  told = progress ?? null;
  thrown = null;
  try {
    return call(name, ...args);
  } finally {
    told = null;
  }
}

/// Calls `action` with functions that put arguments into the module's memory. Frees that memory afterwards.
function withMemory(action) {
  const taken = [];
  const put = (data) => {
    const address = call('la_allocate', data.byteLength);
    if (address === 0) throw new Error('lineatlas: out of memory; 4 GiB is all that WebAssembly has');
    taken.push(address);
    bytesAt(address, data.byteLength).set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    return address;
  };
  const putText = (text) => {
    const bytes = encoder.encode(text);
    return [put(bytes), bytes.length];
  };
  try {
    return action({ put, putText });
  } finally {
    if (broken === null) for (const address of taken) wasm.la_free(address);
  }
}

function numbersOf(value, Type, what) {
  if (value instanceof Type) return value;
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    if (Type === Uint32Array && Array.prototype.some.call(value, (v) => !(Number.isInteger(v) && v >= 0 && v < none)))
      throw new Error(`lineatlas: ${what} must be whole numbers from 0`);
    return Type.from(value);
  }
  throw new Error(`lineatlas: ${what} must be a ${Type.name} or another list of numbers`);
}

/// A matrix of sixteen numbers by columns, from an array or from an object with `elements`.
function matrixOf(value, what) {
  const numbers = numbersOf(value?.elements ?? value, Float32Array, what);
  if (numbers.length !== 16) throw new Error(`lineatlas: ${what} must have 16 numbers, not ${numbers.length}`);
  return numbers;
}

function maskOf(names, what) {
  if (names === undefined) return (1 << kinds.length) - 1;
  let mask = 0;
  for (const name of names) {
    const kind = kinds.indexOf(name);
    if (kind < 0) throw new Error(`lineatlas: ${what}: there is no kind "${name}"; there is ${kinds.join(', ')}`);
    mask |= 1 << kind;
  }
  return mask;
}

function choiceOf(name, names, what) {
  const index = names.indexOf(name ?? names[0]);
  if (index < 0) throw new Error(`lineatlas: ${what} must be one of ${names.join(', ')}, not "${name}"`);
  return index;
}

/// A list of exactly `count` numbers.
function listOf(value, count, what) {
  const numbers = numbersOf(value, Float64Array, what);
  if (numbers.length !== count) throw new Error(`lineatlas: ${what} must have ${count} numbers, not ${numbers.length}`);
  return numbers;
}

function refuseUnknown(options, known, what) {
  if (options === null || typeof options !== 'object') throw new Error(`lineatlas: ${what} must be an object with ${known.join(', ')}`);
  for (const key of Object.keys(options))
    if (!known.includes(key)) throw new Error(`lineatlas: ${what} has no "${key}"; it has ${known.join(', ')}`);
}

const meshKeys = ['positions', 'stride', 'indices', 'materials', 'groups', 'matrix', 'name', 'polylines'];

const groupsText = (groups, what) => groups.map((group) => {
  refuseUnknown(group, ['object', 'material'], `${what}: a group`);
  return `${group.object ?? ''}\0${group.material ?? ''}\0`;
}).join('');

function addMesh(model, mesh, number) {
  const name = mesh?.name ?? '', what = name === '' ? `mesh ${number}` : `mesh "${name}"`;
  refuseUnknown(mesh, meshKeys, what);
  const { stride = 3 } = mesh;
  if (!(Number.isInteger(stride) && stride >= 3)) throw new Error(`lineatlas: ${what}: stride must be a whole number of floats from 3`);
  withMemory(({ put, putText }) => {
    const list = (value, Type, key) => {
      if (value === undefined || value === null) return [0, 0];
      const numbers = numbersOf(value, Type, `${what}: ${key}`);
      return [put(numbers), numbers.length];
    };
    const positions = mesh.indices?.length === 0 ? undefined : mesh.positions; // without triangles, positions must not become corners
    const matrix = mesh.matrix ? put(matrixOf(mesh.matrix, `${what}: matrix`)) : 0;
    const well = call('la_add_mesh', model, ...putText(name), ...list(positions, Float32Array, 'positions'), stride,
      ...list(mesh.indices, Uint32Array, 'indices'), ...list(mesh.materials, Uint32Array, 'materials'),
      ...putText(groupsText(mesh.groups ?? [], what)), matrix);
    if (!well) throw new Error(messageOf().replace(/^mesh:/, `${what}:`));
    for (const line of mesh.polylines ?? []) {
      if (line instanceof Uint32Array) {
        if (!call('la_join_vertices', model, put(line), line.length)) throw new Error(messageOf().replace(/^mesh:/, `${what}:`));
        continue;
      }
      const points = numbersOf(line, Float32Array, `${what}: polylines`);
      if (points.length % 3 !== 0) throw new Error(`lineatlas: ${what}: a polyline has three numbers for each point`);
      check(call('la_add_polyline', model, put(points), points.length / 3, matrix));
    }
  });
}

// The types of a loaded file's lists, in the order of la_loaded().
const loadedLists = [Float32Array, Uint32Array, Uint32Array, Uint8Array, Uint8Array, Uint32Array, Uint32Array, Float64Array];

function takeLoaded() {
  const [positions, indices, materials, groups, notes, vertices, ends, origin] = loadedLists
    .map((Type, list) => at(Type, wasm.la_loaded(list), wasm.la_loaded_size(list)).slice());
  const names = decoder.decode(groups).split('\0').slice(0, -1);
  const mesh = { positions, indices };
  if (names.length > 0) {
    mesh.materials = materials;
    mesh.groups = names.flatMap((object, i) => (i % 2 === 0 ? [{ object, material: names[i + 1] }] : []));
  }
  if (ends.length > 0) {
    const pointsOf = (line) => Float32Array.from({ length: 3 * line.length }, (_, k) => positions[3 * line[(k / 3) | 0] + (k % 3)]);
    const lines = [...ends].map((end, i) => vertices.slice(ends[i - 1] ?? 0, end));
    mesh.polylines = indices.length > 0 ? lines : lines.map(pointsOf); // meshes without triangles have no vertices
  }
  return { mesh, origin: [...origin], notes: decoder.decode(notes).split('\n').slice(0, -1) };
}

export function readMesh(file, name) {
  const bytes = file instanceof ArrayBuffer ? new Uint8Array(file) : file;
  if (!ArrayBuffer.isView(bytes)) throw new Error('lineatlas: readMesh: the file must be an ArrayBuffer or a typed array');
  if (typeof name !== 'string') throw new Error('lineatlas: readMesh: the name of the file must be given, with its extension');
  return withMemory(({ put, putText }) => {
    try {
      check(call('la_load', put(bytes), bytes.byteLength, ...putText(name)));
      return takeLoaded();
    } finally {
      if (broken === null) wasm.la_drop_loaded();
    }
  });
}

const linesKeys = ['kinds', 'creaseAngle', 'silhouettes', 'separateParts', 'sections', 'hatching', 'progress'];

function makeModel(meshes, options) {
  refuseUnknown(options, linesKeys, 'Lines');
  const model = call('la_make_model');
  if (model === 0) throw failure();
  try {
    meshes.forEach((mesh, number) => addMesh(model, mesh, number));
    for (const { point, normal } of options.sections ?? []) {
      const numbers = Float64Array.of(...listOf(point, 3, 'sections: point'), ...listOf(normal, 3, 'sections: normal'));
      withMemory(({ put }) => check(call('la_add_section', model, put(numbers))));
    }
    if (options.creaseAngle !== undefined && !(options.creaseAngle >= 0 && options.creaseAngle <= 180))
      throw new Error(`lineatlas: creaseAngle must be from 0 to 180 degrees, not ${options.creaseAngle}`);
    const crease = options.creaseAngle === undefined ? NaN : (options.creaseAngle * Math.PI) / 180;
    const hatching = options.hatching === undefined ? 0 : options.hatching === false ? -1 : options.hatching;
    check(callWithProgress(options.progress, 'la_extract', model, maskOf(options.kinds, 'kinds'), crease,
      choiceOf(options.silhouettes, ['auto', 'smooth', 'mesh'], 'silhouettes'), options.separateParts === true ? 1 : 0, hatching));
    return model;
  } catch (error) {
    if (broken === null) wasm.la_free_model(model);
    throw error;
  }
}

// Frees objects that pages forget to dispose of.
const forgotten = new FinalizationRegistry(({ module, free, address }) => {
  if (module === wasm && broken === null) module[free](address);
});

/// An object in the module that must be freed once.
class Owned {
  #address;
  #free;
  #module = wasm;
  constructor(address, free) {
    this.#address = address;
    this.#free = free;
    forgotten.register(this, { module: wasm, free, address }, this);
  }
  get _address() {
    if (this.#address === 0) throw new Error(`lineatlas: ${this.constructor.name} was disposed of`);
    if (this.#module !== wasm) throw new Error('lineatlas: made before init() was called again');
    return this.#address;
  }
  dispose() {
    if (this.#address !== 0 && this.#module === wasm && broken === null) call(this.#free, this.#address);
    this.#address = 0;
    forgotten.unregister(this);
  }
}

const viewKeys = ['view', 'projection', 'width', 'height', 'zeroToOne'];

/// Puts the camera's matrices into the module's memory. Returns the arguments of calls for a camera.
function putCamera(put, camera) {
  refuseUnknown(camera, viewKeys, 'camera');
  const matrices = new Float32Array(32);
  matrices.set(matrixOf(camera.view, 'camera: view'));
  matrices.set(matrixOf(camera.projection, 'camera: projection'), 16);
  for (const side of ['width', 'height'])
    if (!Number.isInteger(camera[side])) throw new Error(`lineatlas: camera: ${side} must be a whole number of pixels`);
  return [put(matrices), camera.width, camera.height, camera.zeroToOne ? 1 : 0];
}

const frameKeys = ['width', 'height', 'from', 'up', 'projection', 'fov'];
const drawKeys = ['kinds', 'hidden', 'outlines', 'progress'];

export class Lines extends Owned {
  #separate;
  constructor(meshes, options = {}) {
    super(makeModel(Array.isArray(meshes) ? meshes : [meshes], options), 'la_free_model');
    this.#separate = options.separateParts === true;
  }

  get segmentCount() { return call('la_segment_count', this._address); }

  get bounds() {
    const numbers = floatsAt(call('la_bounds', this._address), 6);
    return { min: [...numbers.subarray(0, 3)], max: [...numbers.subarray(3)] };
  }

  get notes() {
    check(call('la_notes', this._address));
    return takeText().split('\n').slice(0, -1);
  }

  setHidden(parts) {
    if (!this.#separate) throw new Error('lineatlas: setHidden() needs lines that were made with separateParts: true');
    withMemory(({ put }) => {
      const numbers = numbersOf(parts, Uint32Array, 'setHidden: parts');
      check(call('la_hide', this._address, put(numbers), numbers.length));
    });
  }

  frame(options) {
    refuseUnknown(options, frameKeys, 'frame');
    const { width, height, from = '', up = [0, 1, 0], projection, fov = 40 } = options;
    return withMemory(({ put, putText }) => {
      const to = put(new Float32Array(32));
      check(call('la_frame', this._address, to, width, height, ...putText(from), ...listOf(up, 3, 'up'), (fov * Math.PI) / 180,
        choiceOf(projection, ['perspective', 'orthographic'], 'projection')));
      const numbers = floatsAt(to, 32);
      return { view: numbers.slice(0, 16), projection: numbers.slice(16), width, height };
    });
  }

  draw(camera, options = {}) {
    refuseUnknown(options, drawKeys, 'draw');
    return withMemory(({ put }) => {
      const seen = callWithProgress(options.progress, 'la_find', this._address, ...putCamera(put, camera),
        maskOf(options.kinds, 'kinds'), options.hidden ? 1 : 0, options.outlines ? 1 : 0);
      if (seen === 0) throw failure();
      return new Drawing(this, seen);
    });
  }

  pick(camera, x, y, { radius = 8, kinds: wanted } = {}) {
    return withMemory(({ put }) => {
      const found = call('la_pick', this._address, ...putCamera(put, camera), x, y, radius, maskOf(wanted, 'kinds'));
      if (found === 0) {
        if (wasm.la_message_size() > 0) throw failure();
        return null;
      }
      const [kind, part, start, end, triangle] = at(Uint32Array, found, 5);
      const [px, py, distance, ...world] = floatsAt(found + 20, 6);
      return { kind: kind === none ? null : kinds[kind], part, edge: [start, end], triangle, x: px, y: py, distance, world };
    });
  }
}

function takeText() {
  const text = decoder.decode(bytesAt(wasm.la_text(), wasm.la_text_size()));
  wasm.la_drop_text();
  return text;
}

const writeKeys = ['style', 'title', 'page', 'margin', 'tags'];

export class Drawing extends Owned {
  #lines; // kept, because it must outlive this
  constructor(lines, address) {
    super(address, 'la_free_seen');
    this.#lines = lines;
  }

  get segmentCount() { return call('la_seen_count', this._address); }

  segments() {
    const count = this.segmentCount;
    try {
      check(call('la_segments', this.#lines._address, this._address));
      const copy = (name, Type, each) => at(Type, wasm[`la_segments_${name}`](), each * count).slice();
      return {
        count,
        positions: copy('positions', Float32Array, 6),
        screen: copy('screen', Float32Array, 4),
        kind: copy('kinds', Uint8Array, 1),
        visible: copy('visible', Uint8Array, 1),
        edge: copy('edges', Uint32Array, 2),
        part: copy('parts', Uint32Array, 1),
      };
    } finally {
      if (broken === null) wasm.la_drop_segments();
    }
  }

  #write(format, options) {
    refuseUnknown(options, writeKeys, 'options');
    const { style = {}, title = 'Line drawing', page, margin = 0, tags = true } = options;
    if (page !== undefined && !(page.width > 0 && page.height > 0)) throw new Error('lineatlas: page must have a width and a height above 0');
    const settings = Object.entries(style).map(([key, value]) => `${key}=${value}`);
    return withMemory(({ putText }) => {
      check(call('la_write', this.#lines._address, this._address, format, ...putText(settings.join('\n')), ...putText(title),
        page?.width ?? 0, page?.height ?? 0, margin, tags ? 1 : 0));
      return takeText();
    });
  }

  toSVG(options = {}) { return this.#write(0, options); }
  toDXF(options = {}) { return this.#write(1, options); }
  toJSON(options = {}) { return this.#write(2, options); }
}
