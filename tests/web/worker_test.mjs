// lineatlas/worker in a thread of Node. WEB_PACKAGE names the package's folder.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const { LinesWorker } = await import(pathToFileURL(`${process.env.WEB_PACKAGE}/worker.js`));
const triangle = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], name: 'triangle' };

test('lines are found, drawn and written', async () => {
  const worker = new LinesWorker();
  const lines = await worker.extract(triangle);
  assert.equal(await lines.segmentCount, 3);
  const drawing = await lines.draw(await lines.frame({ width: 40, height: 30 }));
  assert.match(await drawing.toSVG(), /<path/);
  worker.dispose();
});

test('a file is read, and refused', async () => {
  const worker = new LinesWorker(), bytes = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const { mesh } = await worker.readMesh(bytes, 'a.obj');
  assert.deepEqual([...mesh.indices], [0, 1, 2]);
  assert.equal(await (await worker.extract(mesh)).segmentCount, 3);
  await assert.rejects(worker.readMesh(bytes, 'a.stl'), /^Error: cannot read "a.stl": /);
  worker.dispose();
});

test('what was aborted and found all the same is dropped once', async () => {
  const sent = [], thread = { postMessage: ({ method, handle }) => sent.push([method, handle]), terminate() {} };
  const answer = (result) => thread.onmessage({ data: { result } });
  const worker = new LinesWorker({ worker: thread });
  answer();
  const stop = new AbortController(), gone = worker.extract(triangle, { signal: stop.signal });
  stop.abort();
  await assert.rejects(gone, { name: 'AbortError' });
  answer({ handle: 7 });
  assert.deepEqual(sent.slice(1), [['extract', undefined], ['dispose', 7]]);
  answer();
});
