// Compares the npm package with plain three.js, for models in files. Plain three.js is EdgesGeometry (30 degrees) tested against a
// depth buffer of 24 bits with glPolygonOffset(1, 1), one sample per pixel. Prints the milliseconds from arrays to paths (the least of
// six runs), the number of paths, and the missed and false lengths by rays (lineatlas check) within half a pixel, in % of the visible
// length. Usage: web_rivals.mjs WEB TOOL MODEL... WEB is the folder with `package` and `node_modules` (with three), TOOL the native tool.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [web, tool, ...models] = process.argv.slice(2);
const load = (path) => import(pathToFileURL(resolve(web, path)));
const { BufferAttribute, BufferGeometry, EdgesGeometry, PerspectiveCamera, Vector3 } = await load('node_modules/three/build/three.module.js');
const { Lines, init, readMesh } = await load('package/lineatlas.js');
const { cameraOf } = await load('package/three.js');
const size = [1024, 768], folder = mkdtempSync(join(tmpdir(), 'lineatlas-'));
await init();

/// The camera of the tool's drawing of the model, and the tool's options for it.
function cameraFor(model) {
  const file = join(folder, 'native.json');
  execFileSync(tool, ['draw', model, '-o', file, '--size', size.join('x')], { stdio: 'ignore' });
  const { description } = JSON.parse(readFileSync(file, 'utf8'));
  const numbers = (option) => description.match(new RegExp(`--${option} ([-+.,e\\d]+)`))[1].split(',').map(Number);
  const eye = new Vector3(...numbers('eye')), target = new Vector3(...numbers('target')), distance = eye.distanceTo(target);
  const camera = new PerspectiveCamera(numbers('fov')[0], size[0] / size[1], distance / 50, distance * 10);
  camera.position.copy(eye);
  camera.up.set(...numbers('up'));
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return { camera, description };
}

/// Positions in the picture: pixels from the upper left corner, and depth from 0 to 1.
function projected(camera, positions) {
  const point = new Vector3(), out = new Float64Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    point.fromArray(positions, i).project(camera);
    out.set([((point.x + 1) / 2) * size[0], ((1 - point.y) / 2) * size[1], (point.z + 1) / 2], i);
  }
  return out;
}

function depthBuffer(points, indices) {
  const [width, height] = size, buffer = new Float64Array(width * height).fill(1), unit = 2 ** -24;
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => points.subarray(3 * indices[t + k], 3 * indices[t + k] + 3));
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0) continue;
    const slopeX = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
    const slopeY = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    const offset = Math.max(Math.abs(slopeX), Math.abs(slopeY)) + unit;
    const [first, last] = [0, 1].map((axis) => [Math.min(a[axis], b[axis], c[axis]), Math.max(a[axis], b[axis], c[axis])]);
    for (let y = Math.max(0, Math.ceil(last[0] - 0.5)); y <= Math.min(height - 1, last[1] - 0.5); ++y)
      for (let x = Math.max(0, Math.ceil(first[0] - 0.5)); x <= Math.min(width - 1, first[1] - 0.5); ++x) {
        const [px, py] = [x + 0.5, y + 0.5];
        const side = (p, q) => ((q[0] - p[0]) * (py - p[1]) - (q[1] - p[1]) * (px - p[0])) / area;
        if (side(a, b) < 0 || side(b, c) < 0 || side(c, a) < 0) continue;
        const depth = Math.round((a[2] + slopeX * (px - a[0]) + slopeY * (py - a[1]) + offset) / unit) * unit;
        if (depth < buffer[y * width + x]) buffer[y * width + x] = depth;
      }
  }
  return buffer;
}

/// The pieces of each segment that lie before the depth of their pixels.
function visiblePieces(ends, buffer) {
  const pieces = [];
  for (let i = 0; i < ends.length; i += 6) {
    const from = ends.subarray(i, i + 3), to = ends.subarray(i + 3, i + 6);
    const steps = Math.max(1, Math.ceil(Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1]))));
    const at = (share) => [0, 1, 2].map((k) => from[k] + share * (to[k] - from[k]));
    let start = null;
    for (let step = 0; step <= steps; ++step) {
      const [x, y, depth] = at(Math.min(step + 0.5, steps) / steps).map((value, k) => (k < 2 ? Math.floor(value) : value));
      const isInside = x >= 0 && y >= 0 && x < size[0] && y < size[1];
      const isSeen = step < steps && isInside && depth <= buffer[y * size[0] + x];
      if (isSeen && start === null) start = step;
      if (isSeen || start === null) continue;
      pieces.push([at(start / steps).slice(0, 2), at(step / steps).slice(0, 2)]);
      start = null;
    }
  }
  return pieces;
}

function byDepthBuffer(mesh, camera) {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  const edges = new EdgesGeometry(geometry, 30).attributes.position.array;
  return visiblePieces(projected(camera, edges), depthBuffer(projected(camera, mesh.positions), mesh.indices));
}

function byPackage(mesh, camera) {
  const lines = new Lines(mesh), drawing = lines.draw(cameraOf(camera, ...size));
  const paths = JSON.parse(drawing.toJSON()).paths.map(({ points }) => points);
  for (const one of [drawing, lines]) one.dispose();
  return paths;
}

function judged(model, description, paths) {
  const file = join(folder, 'drawing.json');
  writeFileSync(file, JSON.stringify({
    format: 'lineatlas-drawing', version: 1, units: 'pixels', size, description, groups: [],
    pens: [{ mark: 'solid', width: 2, color: '#000000', opacity: 1 }],
    paths: paths.map((points) => ({ kind: 'crease', visible: true, closed: false, outline: false, alpha: 1, pen: 0, points })),
  }));
  const text = execFileSync(tool, ['check', file, model], { encoding: 'utf8' });
  return ['missed', 'false'].map((what) => text.match(new RegExp(`${what} within 0.5 px +([\\d.]+) %`))[1]);
}

console.log('| model | triangles | way | ms | paths | missed, % | false, % |\n|---|---|---|---|---|---|---|');
for (const model of models) {
  const { mesh } = readMesh(readFileSync(model), basename(model)), { camera, description } = cameraFor(model);
  const ways = [['`lineatlas`', byPackage], ['`EdgesGeometry`, depth buffer', byDepthBuffer]].map(([way, draw]) => ({ way, draw, least: Infinity }));
  for (let run = 0; run < 6; ++run) // by turns, because the machine's speed varies
    for (const one of ways) {
      const start = performance.now();
      one.paths = one.draw(mesh, camera);
      one.least = Math.min(one.least, performance.now() - start);
    }
  for (const { way, least, paths } of ways)
    console.log(`| ${basename(model)} | ${mesh.indices.length / 3} | ${way} | ${least.toFixed(least < 10 ? 1 : 0)} | ${paths.length} | ${judged(model, description, paths).join(' | ')} |`);
}
rmSync(folder, { recursive: true });
