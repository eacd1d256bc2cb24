// lineatlas/three in Node: what of a scene becomes meshes and lines. Skipped where three.js is not beside the package
// (npm install --prefix build/web three). WEB_PACKAGE names the package's folder.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { before, test } from 'node:test';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.env.WEB_PACKAGE);
const three = resolve(folder, '../node_modules/three/build/three.module.js');
const skip = existsSync(three) ? false : 'there is no three.js; npm install --prefix build/web three';
const load = (path) => import(pathToFileURL(path));
let T, Lines, init, kinds, cameraOf, lineSegmentsOf, meshesOf, RestingLines;

before(async () => {
  if (skip) return;
  T = await load(three);
  ({ Lines, init, kinds } = await load(`${folder}/lineatlas.js`));
  ({ RestingLines, cameraOf, lineSegmentsOf, meshesOf } = await load(`${folder}/three.js`));
  await init();
});

function cameraAt(x, y, z) {
  const camera = new T.PerspectiveCamera(40, 4 / 3, 0.1, 100);
  camera.position.set(x, y, z);
  camera.lookAt(0, 0, 0);
  return camera;
}
const segmentsOf = (root, camera, options) => new Lines(meshesOf(root).meshes).draw(cameraOf(camera, 640, 480), options).segments();

test('a camera of three.js puts points where three.js does', { skip }, () => {
  for (const camera of [cameraAt(3, 2, 5), Object.assign(new T.OrthographicCamera(-2, 2, 1.5, -1.5, 0.1, 50), {})]) {
    if (camera.isOrthographicCamera) camera.position.set(1, 1, 9), camera.lookAt(0, 0, 0);
    const { count, positions, screen } = segmentsOf(new T.Mesh(new T.BoxGeometry()), camera);
    assert.ok(count > 3);
    for (let i = 0; i < count; ++i) {
      for (const end of [0, 1]) {
        const seen = new T.Vector3(...positions.subarray(6 * i + 3 * end, 6 * i + 3 * end + 3)).project(camera);
        assert.ok(Math.abs((seen.x + 1) * 320 - screen[4 * i + 2 * end]) < 0.02);
        assert.ok(Math.abs((1 - seen.y) * 240 - screen[4 * i + 2 * end + 1]) < 0.02);
      }
    }
  }
});

test('parents place, hidden objects are left out, numbers lead back to objects', { skip }, () => {
  const root = new T.Group(), box = new T.Mesh(new T.BoxGeometry()), ball = new T.Mesh(new T.SphereGeometry()), gone = new T.Mesh(new T.BoxGeometry());
  box.position.x = 3;
  root.position.y = 5;
  gone.visible = false;
  root.add(box, ball, gone);
  const { meshes, objects } = meshesOf(root);
  assert.deepEqual(objects, [box, ball]);
  assert.deepEqual(new Lines(meshes[0]).bounds, { min: [2.5, 4.5, -0.5], max: [3.5, 5.5, 0.5] });
});

test('instances, groups of materials, skins and morphs are as they are drawn', { skip }, () => {
  const instances = new T.InstancedMesh(new T.BoxGeometry(), new T.MeshBasicMaterial(), 3);
  for (let i = 0; i < 3; ++i) instances.setMatrixAt(i, new T.Matrix4().makeTranslation(4 * i, 0, 0));
  assert.deepEqual(new Lines(meshesOf(instances).meshes).bounds.max, [8.5, 0.5, 0.5]);

  const sides = new T.Mesh(new T.BoxGeometry(), Array.from({ length: 6 }, (_, i) => new T.MeshBasicMaterial({ visible: i !== 0 })));
  const [side] = meshesOf(sides).meshes;
  assert.equal(side.indices.length, 30);
  assert.deepEqual([...new Set(side.materials)], [1, 2, 3, 4, 5]);

  const geometry = new T.BoxGeometry();
  geometry.morphAttributes.position = [new T.Float32BufferAttribute(geometry.attributes.position.array.map((v) => 3 * v), 3)];
  const morphed = new T.Mesh(geometry);
  morphed.updateMorphTargets();
  morphed.morphTargetInfluences[0] = 1;
  assert.equal(new Lines(meshesOf(morphed).meshes).bounds.max[0], 1.5);

  const arm = new T.BoxGeometry(), count = arm.attributes.position.count;
  arm.setAttribute('skinIndex', new T.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
  arm.setAttribute('skinWeight', new T.Float32BufferAttribute(Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)), 4));
  const skinned = new T.SkinnedMesh(arm, new T.MeshBasicMaterial()), bone = new T.Bone();
  skinned.add(bone);
  skinned.bind(new T.Skeleton([bone]));
  bone.position.x = 7;
  assert.equal(new Lines(meshesOf(skinned).meshes).bounds.max[0], 7.5);
});

test('lines of three.js are lines', { skip }, () => {
  const points = new T.BufferGeometry().setFromPoints([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map((p) => new T.Vector3(...p)));
  const counts = [T.Line, T.LineLoop, T.LineSegments].map((Kind) => segmentsOf(new Kind(points), cameraAt(0.5, 0.5, 6)));
  assert.deepEqual(counts.map(({ count }) => count), [3, 4, 2]);
  assert.equal(kinds[counts[0].kind[0]], 'file');
});

test('segments come back as objects', { skip }, () => {
  const pieces = segmentsOf(new T.Mesh(new T.BoxGeometry()), cameraAt(3, 2, 5), { hidden: true });
  const visible = lineSegmentsOf(pieces), hidden = lineSegmentsOf(pieces, { hidden: true });
  assert.equal(visible.geometry.instanceCount, 9);
  assert.equal(hidden.geometry.instanceCount, 3);
  assert.deepEqual(meshesOf(new T.Group().add(visible)).meshes, []);
});

test('lines are drawn once when the camera rests', { skip }, async () => {
  let camera = cameraAt(3, 2, 5);
  const lines = new Lines(meshesOf(new T.Mesh(new T.BoxGeometry())).meshes);
  let shown = 0, moved = 0;
  const resting = new RestingLines({
    camera: () => camera,
    size: () => [640, 480],
    delay: 100,
    lines: () => ({ draw: async (view, { signal, ...options }) => lines.draw(view, options) }),
    onLines: ({ count }) => { assert.equal(count, 9); ++shown; },
    onMove: () => ++moved,
  });
  const at = async (time) => {
    resting.update(time);
    await new Promise(setImmediate);
    return [shown, moved];
  };
  assert.deepEqual(await at(0), [0, 0]);
  assert.deepEqual(await at(50), [0, 0]);
  assert.deepEqual(await at(120), [1, 0]);
  assert.deepEqual(await at(500), [1, 0]);
  camera.position.x += 0.1;
  assert.deepEqual(await at(510), [1, 1]);
  camera.position.x += 0.1;
  assert.deepEqual(await at(520), [1, 1]);
  assert.deepEqual(await at(600), [1, 1]);
  assert.deepEqual(await at(640), [2, 1]);
  camera = cameraAt(-3, 2, 5); // another one
  assert.deepEqual(await at(650), [2, 2]);
  assert.deepEqual(await at(760), [3, 2]);
});
