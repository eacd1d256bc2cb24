// Times the npm package in Node and the native library with one thread. Prints milliseconds, the best of several runs.
// Usage: web_times.mjs PACKAGE NATIVE_DRAWINGS [SCENE...]
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, native, ...scenes] = process.argv.slice(2);
const { Lines, init } = await import(pathToFileURL(resolve(folder, 'lineatlas.js')));
const runs = 5;
const drawings = mkdtempSync(join(tmpdir(), 'lineatlas-'));
const clock = (action) => {
  const start = performance.now();
  const result = action();
  return [performance.now() - start, result];
};
const least = (a, b) => (a === undefined ? b : a.map((value, i) => Math.min(value, b[i])));

const start = performance.now();
await init();
console.log(`module loaded and compiled in ${(performance.now() - start).toFixed(0)} ms`);
const table = new Map();
for (let run = 0; run < runs; ++run) { // by turns, because the machine's speed varies
  const text = execFileSync('taskset', ['-c', '0', native, drawings, ...scenes], { encoding: 'utf8' });
  for (const row of text.trim().split('\n')) {
    const [name, triangles, ...times] = row.split(/ +/);
    const { positions, indices, materials, segments, ...camera } = JSON.parse(readFileSync(join(drawings, `${name}.json`)));
    const mesh = { positions: Float32Array.from(positions), indices: Uint32Array.from(indices), name: 'model' };
    if (materials.length > 0) mesh.materials = Uint32Array.from(materials);
    const [made, lines] = clock(() => new Lines(mesh));
    const [first, seen] = clock(() => lines.draw(camera));
    const [next, again] = clock(() => lines.draw(camera));
    const [svg, drawn] = clock(() => again.toSVG());
    if (drawn !== readFileSync(join(drawings, `${name}.svg`), 'utf8')) throw new Error(`${name} is not what the library makes of it`);
    for (const one of [seen, again, lines]) one.dispose();
    const known = table.get(name) ?? { triangles };
    table.set(name, { triangles, native: least(known.native, times.map(Number)), web: least(known.web, [made, first, next, svg]) });
  }
}
rmSync(drawings, { recursive: true });
console.log('| model | triangles | lines, native | WebAssembly | first view, native | WebAssembly | next view, native | WebAssembly | SVG |\n|---|---|---|---|---|---|---|---|---|');
for (const [name, { triangles, native: n, web: w }] of table) {
  const f = (value) => (value < 10 ? value.toFixed(1) : value.toFixed(0));
  console.log(`| ${name} | ${triangles} | ${f(n[0])} | ${f(w[0])} | ${f(n[1])} | ${f(w[1])} | ${f(n[2])} | ${f(w[2])} | ${f(w[3])} |`);
}
