// The npm package in Node: what it makes is what the library makes, byte for byte, and what is wrong with arrays and cameras is
// said in one line. WEB_PACKAGE names the package's folder, WEB_DRAWINGS what native_drawings wrote.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { files, models, refusedFiles } from './models.mjs';

const packageOf = (name) => import(pathToFileURL(`${process.env.WEB_PACKAGE}/${name}.js`));
const { Lines, init, kinds, none, readMesh, supported } = await packageOf('lineatlas');
const fileOf = (name) => readFile(`${process.env.WEB_DRAWINGS}/${name}`, 'utf8');

const cube = {
  positions: Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1]),
  indices: Uint32Array.from([0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]),
};
const frame = (lines, options = {}) => lines.frame({ width: 400, height: 300, ...options });

before(async () => {
  assert.ok(supported);
  await init();
});

test('kinds are those of the library', async () => {
  assert.deepEqual(kinds, JSON.parse(await fileOf('kinds.json')));
});

for (const name of models) {
  test(`${name} is what the library makes of it`, async () => {
    const { positions, indices, materials, segments, ...camera } = JSON.parse(await fileOf(`${name}.json`));
    const mesh = { positions: Float32Array.from(positions), indices: Uint32Array.from(indices), name: 'model' };
    if (materials.length > 0) mesh.materials = Uint32Array.from(materials);
    const lines = new Lines(mesh);
    assert.equal(lines.segmentCount, segments);
    const visible = lines.draw(camera), all = lines.draw(camera, { hidden: true });
    assert.equal(visible.toSVG(), await fileOf(`${name}.svg`));
    assert.equal(all.toSVG({ style: { hidden: true } }), await fileOf(`${name}_hidden.svg`));
    assert.equal(visible.toDXF(), await fileOf(`${name}.dxf`));
    assert.equal(visible.toJSON(), await fileOf(`${name}_drawing.json`));
    const pieces = all.segments();
    assert.equal(pieces.visible.reduce((sum, one) => sum + one, 0), visible.segmentCount);
    for (const one of [visible, all, lines]) one.dispose();
  });
}

const bytesOf = (name) => readFile(`${process.env.WEB_DRAWINGS}/${name}`);

for (const name of files) {
  test(`${name} is read as the library reads it`, async () => {
    const { mesh, origin, notes } = readMesh(await bytesOf(name), name);
    assert.deepEqual([origin, notes], [[0, 0, 0], []]);
    const lines = new Lines(mesh), drawing = lines.draw(JSON.parse(await fileOf(`${name}.json`)));
    assert.equal(drawing.toSVG(), await fileOf(`${name}.svg`));
  });
}

for (const name of refusedFiles) {
  test(`${name} is refused as by the library`, async () => {
    const bytes = await bytesOf(name), message = await fileOf(`${name}.error`);
    assert.match(message, /^cannot read ".*": /);
    assert.throws(() => readMesh(bytes, name), { message });
    assert.equal(new Lines(cube).segmentCount, 12); // and the module lives on
  });
}

test('a file has groups, lines and notes', async () => {
  const { mesh } = readMesh(await bytesOf('house.obj'), 'house.obj');
  assert.deepEqual(mesh.groups, [['house', 'wall'], ['house', 'roof'], ['fence', 'wall']].map(([object, material]) => ({ object, material })));
  assert.deepEqual([...new Set(mesh.materials)], [0, 1, 2]);
  assert.deepEqual(mesh.polylines.map((line) => [...line]), [[0, 10, 11]]);
  const far = readMesh(new TextEncoder().encode('v 1e7 0 0\nv 10000001 0 0\nv 1e7 1 0\nf 1 2 3\nf 1 1 2\n'), 'far.OBJ');
  assert.deepEqual(far.origin, [10000001, 0, 0]);
  assert.deepEqual(far.notes, ['1 face with equal corners dropped', 'far from zero for its size, drawn about 10000001,0,0']);
});

test('a file of lines alone is drawn', () => {
  const { mesh } = readMesh(new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n'), 'lines.obj');
  const lines = new Lines(mesh);
  assert.deepEqual([mesh.indices.length, lines.draw(frame(lines)).segmentCount], [0, 2]);
});

test('a cube from the corner shows nine edges and hides three', () => {
  const lines = new Lines({ ...cube, name: 'cube' });
  assert.equal(lines.segmentCount, 12);
  assert.deepEqual(lines.bounds, { min: [0, 0, 0], max: [1, 1, 1] });
  const pieces = lines.draw(frame(lines, { from: 'isometric', projection: 'orthographic' }), { hidden: true }).segments();
  assert.equal(pieces.count, 12);
  assert.equal(pieces.visible.filter((one) => one === 1).length, 9);
  for (let i = 0; i < 12; ++i) {
    assert.equal(kinds[pieces.kind[i]], 'crease');
    assert.equal(pieces.part[i], 0);
    const corner = (k) => [...cube.positions.subarray(3 * pieces.edge[2 * i + k], 3 * pieces.edge[2 * i + k] + 3)];
    const ends = [[...pieces.positions.subarray(6 * i, 6 * i + 3)], [...pieces.positions.subarray(6 * i + 3, 6 * i + 6)]];
    const off = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));
    assert.ok(ends.every((end) => Math.min(off(end, corner(0)), off(end, corner(1))) < 1e-5));
    for (let k = 0; k < 4; ++k) assert.ok(pieces.screen[4 * i + k] >= 0 && pieces.screen[4 * i + k] <= (k % 2 ? 300 : 400));
  }
});

test('what stands higher in the world stands higher on the screen', () => {
  const lines = new Lines(cube);
  const { count, positions, screen } = lines.draw(frame(lines, { from: 'front', projection: 'orthographic' })).segments();
  for (let i = 0; i < count; ++i)
    if (positions[6 * i + 1] > positions[6 * i + 4] + 0.5) assert.ok(screen[4 * i + 1] < screen[4 * i + 3] - 50);
});

test('parts have numbers and can be hidden', () => {
  const far = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1);
  const lines = new Lines([cube, { ...cube, matrix: far }], { separateParts: true });
  const camera = frame(lines);
  assert.deepEqual([...new Set(lines.draw(camera).segments().part)].sort(), [0, 1]);
  lines.setHidden([0]);
  assert.deepEqual([...new Set(lines.draw(camera).segments().part)], [1]);
  lines.setHidden([]);
  assert.equal(new Set(lines.draw(camera).segments().part).size, 2);
});

test('a matrix that mirrors leaves the outside outside', () => {
  const mirror = Float32Array.of(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const count = (mesh) => {
    const lines = new Lines(mesh);
    return lines.draw(frame(lines, { from: 'front', projection: 'orthographic' })).segmentCount;
  };
  assert.equal(count({ ...cube, matrix: mirror }), count(cube));
});

test('polylines are lines', () => {
  const lines = new Lines({ polylines: [[0, 0, 0, 1, 0, 0, 1, 1, 0]] });
  const pieces = lines.draw(frame(lines)).segments();
  assert.equal(pieces.count, 2);
  assert.equal(kinds[pieces.kind[0]], 'file');
  assert.equal(pieces.part[0], 0);
});

test('a cut has an outline and hatching', () => {
  const lines = new Lines(cube, { sections: [{ point: [0, 0, 0.5], normal: [0, 0, 1] }] });
  const pieces = lines.draw(frame(lines)).segments();
  const found = new Set([...pieces.kind].map((kind) => kinds[kind]));
  assert.ok(found.has('section') && found.has('hatching'));
  assert.deepEqual(lines.notes, []);
});

test('an edge and a face can be picked', () => {
  const lines = new Lines(cube);
  const camera = frame(lines, { from: 'front', projection: 'orthographic' });
  const face = lines.pick(camera, 200, 150);
  assert.equal(face.kind, null);
  assert.equal(face.part, 0);
  assert.ok(Math.abs(face.world[2] - 1) < 1e-5);
  const { screen } = lines.draw(camera).segments();
  const edge = lines.pick(camera, (screen[0] + screen[2]) / 2, (screen[1] + screen[3]) / 2 + 2);
  assert.equal(edge.kind, 'crease');
  assert.equal(lines.pick(camera, 1, 1), null);
});

const refusals = [
  ['an index that no vertex has', () => new Lines({ ...cube, indices: [0, 1, 8], name: 'box' }), /^mesh "box": triangle 0 has the index 8/],
  ['an index below 0', () => new Lines({ ...cube, indices: [0, 1, -1] }), /mesh 0: indices must be whole numbers/],
  ['NaN', () => new Lines({ ...cube, positions: [NaN, ...cube.positions.subarray(1)] }), /finite/],
  ['two corners', () => new Lines({ ...cube, indices: [0, 1] }), /three corners/],
  ['no such option', () => new Lines(cube, { crease: 3 }), /Lines has no "crease"; it has kinds, creaseAngle/],
  ['no such kind', () => new Lines(cube, { kinds: ['edge'] }), /there is no kind "edge"/],
  ['a matrix of 9', () => new Lines({ ...cube, matrix: new Float32Array(9) }), /matrix must have 16 numbers, not 9/],
  ['no width', () => new Lines(cube).draw({ view: new Float32Array(16), projection: new Float32Array(16), height: 3 }), /width must be a whole/],
  ['a group that is none', () => new Lines({ ...cube, materials: Array(12).fill(1), groups: [{ object: 'a' }] }), /mesh 0: there is no group 1 among 1/],
  ['a line of no vertex', () => new Lines({ ...cube, polylines: [Uint32Array.of(0, 8)] }), /mesh 0: a polyline has the vertex 8, but there are 8/],
  ['groups without numbers', () => new Lines({ ...cube, groups: [{ object: 'a' }] }), /there are 12 triangles and 0 materials/],
  ['a file without a name', () => readMesh(new Uint8Array(3)), /the name of the file must be given/],
  ['a file that is no bytes', () => readMesh('v 0 0 0', 'a.obj'), /must be an ArrayBuffer/],
  ['a type that is not read', () => readMesh(new Uint8Array(3), 'a.xyz'), /^cannot read "a.xyz": unknown mesh type ".xyz"; known are .obj, .ply, .stl and .off$/],
  ['no camera', () => new Lines(cube).draw(), /camera must be an object with view, projection/],
  ['no mesh', () => new Lines(), /mesh 0 must be an object with positions/],
  ['half a vertex', () => new Lines({ ...cube, stride: 2.5 }), /stride must be a whole number/],
  ['an angle of a circle', () => new Lines(cube, { creaseAngle: 360 }), /creaseAngle must be from 0 to 180 degrees, not 360/],
  ['a plane without a normal', () => new Lines(cube, { sections: [{ point: [0, 0, 0], normal: [1] }] }), /normal must have 3 numbers, not 1/],
  ['a page without height', () => { const l = new Lines(cube); l.draw(frame(l)).toSVG({ page: { width: 9 } }); }, /page must have/],
  ['to hide what is joined', () => new Lines([cube, cube]).setHidden([0]), /needs lines that were made with separateParts/],
  ['a camera of zeros', () => new Lines(cube).draw({ view: new Float32Array(16), projection: new Float32Array(16), width: 3, height: 3 }), /camera: the view matrix is singular/],
  ['no such setting', () => { const l = new Lines(cube); l.draw(frame(l)).toSVG({ style: { widht: 3 } }); }, /did you mean "width"/],
  ['a cut that misses', () => new Lines(cube, { sections: [{ point: [0, 0, 9], normal: [0, 0, 1] }] }), /misses/],
];
for (const [name, action, message] of refusals) {
  test(`refuses ${name}`, () => {
    assert.throws(action, (error) => {
      assert.ok(error instanceof Error);
      assert.match(error.message, message);
      assert.ok(!error.message.includes('\n'));
      return true;
    });
    assert.equal(new Lines(cube).segmentCount, 12); // and lives on
  });
}

test('what is disposed of cannot be used', () => {
  const lines = new Lines(cube), camera = frame(lines), drawing = lines.draw(camera);
  lines.dispose();
  lines.dispose();
  assert.throws(() => lines.draw(camera), /Lines was disposed of/);
  assert.throws(() => drawing.toSVG(), /Lines was disposed of/);
});

test('progress ends at 1, and may stop', () => {
  const shares = [];
  const lines = new Lines(cube, { progress: (done) => void shares.push(done) });
  assert.equal(shares.at(-1), 1);
  assert.throws(() => lines.draw(frame(lines), { progress: () => false }), { name: 'AbortError' });
  assert.throws(() => lines.draw(frame(lines), { progress: () => { throw new Error('mine'); } }), /^Error: mine$/);
  assert.throws(() => lines.draw(frame(lines), { progress: () => void lines.bounds }), /within progress/);
  assert.equal(lines.draw(frame(lines)).segmentCount, 9);
});

/// The module with no more memory than so many pages of 64 KiB, so that it ends soon.
function withLeastMemory(bytes, pages) {
  const number = (at) => {
    let value = 0, shift = 0;
    for (; bytes[at] & 0x80; ++at, shift += 7) value |= (bytes[at] & 0x7f) << shift;
    return [value | (bytes[at] << shift), at + 1];
  };
  const written = (value) => (value < 0x80 ? [value] : [(value & 0x7f) | 0x80, ...written(value >> 7)]);
  for (let at = 8; at < bytes.length;) {
    const [size, body] = number(at + 1);
    if (bytes[at] === 5) { // memories: one, whose limits are that there are none, and how large it is at first
      assert.deepEqual([bytes[body], bytes[body + 1]], [1, 0]);
      const limits = [1, 1, ...written(number(body + 2)[0]), ...written(pages)];
      return Buffer.concat([bytes.subarray(0, at), Buffer.from([5, ...written(limits.length), ...limits]), bytes.subarray(body + size)]);
    }
    at = body + size;
  }
  throw new Error('there is no memory');
}

test('memory that ends is an error, and the module lives on', async () => {
  const small = await import(`${pathToFileURL(`${process.env.WEB_PACKAGE}/lineatlas.js`)}?small`);
  await small.init(withLeastMemory(await readFile(`${process.env.WEB_PACKAGE}/lineatlas.wasm`), 1024));
  const corner = [0, 0, 0, 0.5, 0, 0, 0, 0.5, 0]; // of triangles side by side
  const place = (i) => [(i / 9) % 1000 | 0, (i / 9000) | 0, 0][i % 3];
  const field = (count) => ({ positions: Float32Array.from({ length: 9 * count }, (_, i) => corner[i % 9] + place(i)) });
  const lines = new small.Lines(cube);
  for (const count of [200_000, 500_000, 1_000_000, 2_000_000]) assert.throws(() => new small.Lines(field(count)), /out of memory/);
  assert.equal(lines.draw(frame(lines)).segmentCount, 9);
  assert.equal(new small.Lines(cube).segmentCount, 12);
});

test('a worker does the same, with promises', async () => {
  const { LinesWorker } = await packageOf('worker');
  const worker = new LinesWorker();
  try {
    const shares = [];
    const lines = await worker.extract({ ...cube, name: 'cube' }, { progress: (done) => shares.push(done) });
    assert.equal(shares.at(-1), 1);
    assert.equal(await lines.segmentCount, 12);
    const camera = await lines.frame({ width: 400, height: 300 });
    const drawing = await lines.draw(camera);
    const here = new Lines({ ...cube, name: 'cube' });
    assert.equal(await drawing.toSVG(), here.draw(camera).toSVG());
    assert.equal((await drawing.segments()).count, 9);
    await assert.rejects(worker.extract({ ...cube, indices: [0, 1, 8] }), /index 8/);
    await drawing.dispose();
    await assert.rejects(drawing.segments(), /disposed of/);
  } finally {
    worker.dispose();
  }
});

test('a worker stops what is aborted, running or not begun', async () => {
  const { LinesWorker } = await packageOf('worker');
  const worker = new LinesWorker();
  try {
    const { positions, indices } = JSON.parse(await fileOf('house.json'));
    const running = new AbortController(), waiting = new AbortController();
    const first = worker.extract({ positions, indices }, { signal: running.signal, progress: () => running.abort() });
    const second = worker.extract(cube, { signal: waiting.signal });
    const third = worker.extract(cube);
    waiting.abort();
    await assert.rejects(second, { name: 'AbortError' });
    await assert.rejects(first, { name: 'AbortError' });
    assert.equal(await (await third).segmentCount, 12);
    await assert.rejects(worker.extract(cube, { signal: AbortSignal.abort() }), { name: 'AbortError' });
  } finally {
    worker.dispose();
  }
});
