// The page: a three.js scene. When the camera rests, a worker of lineatlas finds its lines.
import { AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, OrthographicCamera, PerspectiveCamera, Plane, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { supported } from 'lineatlas';
import { RestingLines, cameraOf, lineSegmentsOf, meshesOf } from 'lineatlas/three';
import { LinesWorker } from 'lineatlas/worker';
import workerText from 'inside:worker';
import wasm from 'lineatlas/lineatlas.wasm';
import { models } from './models.mjs';

const $ = (id) => document.getElementById(id);
const view = $('view'), state = $('state');
const dark = matchMedia('(prefers-color-scheme: dark)');
const colorOf = (name) => new Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim());

function say(text, isError = false) {
  state.textContent = text;
  state.classList.toggle('error', isError);
}
const fail = (error) => say(error.message, true);

const renderer = new WebGLRenderer({ antialias: true });
renderer.localClippingEnabled = true;
view.prepend(renderer.domElement);
const scene = new Scene();
scene.add(new AmbientLight());
const perspective = new PerspectiveCamera(40, 1, 0.1, 100), parallel = new OrthographicCamera();
let camera = perspective;
const controls = new OrbitControls(camera, renderer.domElement);
let isStale = true; // true if the canvas must be drawn again
const redraw = () => { isStale = true; };
controls.addEventListener('change', redraw);
const faces = new MeshBasicMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
const rough = new LineBasicMaterial();
const strong = new LineMaterial({ linewidth: 1.75, depthTest: false });
const weak = new LineMaterial({ linewidth: 1, depthTest: false, dashed: false, transparent: true, opacity: 0.45 });

let model = new Group(), shownParts = new Map(), box = new Box3();
let lines = null, drawing = null, exact = new Group(), edges = new Group();
let making = new AbortController();
scene.add(model, edges, exact);

const blob = URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' }));
const worker = supported ? new LinesWorker({ wasm, worker: new Worker(blob) }) : null;

function recolor() {
  scene.background = colorOf('--paper');
  faces.color = colorOf('--paper').lerp(colorOf('--ink'), 0.06);
  rough.color = colorOf('--soft');
  strong.color = colorOf('--ink');
  weak.color = colorOf('--ink');
  redraw();
}

function clear(group) {
  for (const child of group.children) child.geometry.dispose();
  group.clear();
}

/// Shows rough lines while the camera moves: edges, hidden by the depth buffer.
function showRough(on) {
  edges.visible = on;
  exact.visible = !on;
  redraw();
}

function plane() {
  const axis = $('axis').value;
  if (axis === '') return null;
  const normal = new Vector3().setComponent(Number(axis), 1);
  const at = box.min.getComponent(Number(axis)) + ($('cut').value / 100) * (box.max.getComponent(Number(axis)) - box.min.getComponent(Number(axis)));
  return { point: normal.clone().multiplyScalar(at).toArray(), normal: normal.toArray() };
}

async function makeLines() {
  making.abort();
  making = new AbortController();
  const { signal } = making;
  resting.invalidate();
  const old = lines;
  lines = null;
  setSaving(null);
  showRough(true);
  const cut = plane();
  // Only clips faces and rough lines. Exact lines also lie on the plane itself.
  const clipping = cut ? [new Plane(new Vector3(...cut.normal).negate(), new Vector3(...cut.point).dot(new Vector3(...cut.normal)))] : [];
  faces.clippingPlanes = rough.clippingPlanes = clipping;
  try {
    await old?.dispose();
    const { meshes } = meshesOf(model);
    if (meshes.length === 0) return say('All parts are hidden.');
    const start = performance.now();
    const made = await worker.extract(meshes, {
      signal,
      sections: cut ? [cut] : [],
      progress: (done) => { if (!signal.aborted) say(`Finding lines: ${Math.round(100 * done)} %`); },
    });
    if (signal.aborted) return made.dispose();
    lines = made;
    const notes = await lines.notes;
    say(`${(await lines.segmentCount).toLocaleString('en')} pieces of lines in ${Math.round(performance.now() - start)} ms${notes.length ? `; ${notes[0]}` : ''}`);
    resting.invalidate();
  } catch (error) {
    if (error.name !== 'AbortError') fail(error);
  }
}

function setSaving(made) {
  drawing = made;
  $('svg').disabled = $('dxf').disabled = made === null;
}

const size = () => [renderer.domElement.width, renderer.domElement.height];
const resting = new RestingLines({
  camera: () => camera,
  size,
  lines: () => ({
    async draw(seen, options) {
      if (lines === null) throw new DOMException('none yet', 'AbortError');
      const start = performance.now();
      const found = await lines.draw(seen, { ...options, hidden: $('hidden').checked });
      say(`${(await found.segmentCount).toLocaleString('en')} pieces, exact, in ${Math.round(performance.now() - start)} ms`);
      return found;
    },
  }),
  onMove: () => {
    setSaving(null);
    showRough(true);
    say('Roughly, while the camera moves');
  },
  onLines: (segments, seen) => {
    clear(exact);
    exact.add(lineSegmentsOf(segments, { material: strong }));
    if ($('hidden').checked) exact.add(lineSegmentsOf(segments, { hidden: true, material: weak }));
    showRough(false);
    setSaving(seen);
  },
  onError: fail,
});

function listParts() {
  $('parts').replaceChildren(...[...shownParts.keys()].map((object, i) => {
    const label = document.createElement('label'), check = document.createElement('input'), name = document.createElement('span');
    check.type = 'checkbox';
    check.checked = object.visible;
    check.onchange = () => {
      object.visible = check.checked;
      shownParts.get(object).visible = check.checked;
      makeLines();
    };
    name.textContent = object.name || `part ${i + 1}`;
    label.append(check, ' ', name);
    return label;
  }));
}

function frame() {
  const center = box.getCenter(new Vector3()), radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-6);
  const { width, height } = view.getBoundingClientRect(), aspect = width / Math.max(height, 1);
  const away = (1.05 * radius) / Math.sin((20 * Math.PI) / 180) / Math.min(1, aspect);
  for (const one of [perspective, parallel]) {
    one.position.copy(center).addScaledVector(new Vector3(0.5, 0.45, 1).normalize(), away);
    one.near = away / 100;
    one.far = away * 10;
  }
  parallel.userData.height = (2 * radius * 1.1) / Math.min(1, aspect);
  parallel.zoom = 1;
  controls.target.copy(center);
  resize();
}

function resize() {
  const { width, height } = view.getBoundingClientRect();
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(width, height);
  perspective.aspect = width / Math.max(height, 1);
  const half = (parallel.userData.height ?? 1) / 2;
  Object.assign(parallel, { top: half, bottom: -half, right: half * perspective.aspect, left: -half * perspective.aspect });
  perspective.updateProjectionMatrix();
  parallel.updateProjectionMatrix();
  controls.update();
  redraw();
}

function setModel(object) {
  clear(edges);
  scene.remove(model);
  model = object;
  model.updateWorldMatrix(true, true);
  shownParts = new Map();
  model.traverse((child) => {
    if (!child.isMesh) return;
    child.material = faces;
    const lined = new LineSegments(new EdgesGeometry(child.geometry, 30), rough);
    lined.applyMatrix4(child.matrixWorld);
    edges.add(lined);
    shownParts.set(child, lined);
  });
  scene.add(model);
  box = new Box3().setFromObject(model);
  listParts();
  frame();
  makeLines();
}

/// A file that the package has read, as three.js objects: a mesh per object, and lines.
function objectOf({ mesh }) {
  const root = new Group(), positions = new BufferAttribute(mesh.positions, 3), cornersOf = new Map();
  mesh.indices.forEach((corner, i) => {
    const name = mesh.groups?.[mesh.materials[(i / 3) | 0]].object ?? '';
    if (!cornersOf.has(name)) cornersOf.set(name, []);
    cornersOf.get(name).push(corner);
  });
  for (const [name, corners] of cornersOf) {
    const part = new Mesh(new BufferGeometry().setAttribute('position', positions).setIndex(corners), faces);
    part.name = name;
    root.add(part);
  }
  for (const line of mesh.polylines ?? []) {
    const points = line instanceof Uint32Array ? [...line].flatMap((i) => [...mesh.positions.subarray(3 * i, 3 * i + 3)]) : line;
    root.add(new Line(new BufferGeometry().setAttribute('position', new BufferAttribute(Float32Array.from(points), 3)), rough));
  }
  return root;
}

async function open(file) {
  try {
    say(`Reading ${file.name}`);
    const type = file.name.split('.').pop().toLowerCase();
    const own = async () => objectOf(await worker.readMesh(await file.arrayBuffer(), file.name));
    const readers = {
      obj: own, ply: own, stl: own, off: own,
      glb: async () => (await new GLTFLoader().parseAsync(await file.arrayBuffer(), '')).scene,
      gltf: async () => (await new GLTFLoader().parseAsync(await file.text(), '')).scene,
    };
    if (!readers[type]) throw new Error(`${file.name} is none of ${Object.keys(readers).join(', ')}`);
    setModel(await readers[type]());
    $('model').value = '';
  } catch (error) {
    fail(error);
  }
}

async function save(type) {
  try {
    const found = await lines.draw(drawing, { hidden: $('hidden').checked });
    const options = { style: { hidden: $('hidden').checked, width: 2 * devicePixelRatio } };
    const text = await (type === 'svg' ? found.toSVG(options) : found.toDXF(options));
    await found.dispose();
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type: type === 'svg' ? 'image/svg+xml' : 'application/dxf' }));
    link.download = `drawing.${type}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    say(`drawing.${type} is saved: ${(text.length / 1000).toFixed(0)} kB`);
  } catch (error) {
    fail(error);
  }
}

$('model').append(...['', ...Object.keys(models)].map((name) => new Option(name || 'your file', name)));
$('model').onchange = () => { if ($('model').value) setModel(models[$('model').value]()); };
$('open').onclick = () => $('file').click();
$('file').onchange = () => { if ($('file').files[0]) open($('file').files[0]); };
$('hidden').onchange = () => resting.invalidate();
$('faces').onchange = () => {
  faces.colorWrite = $('faces').checked;
  redraw();
};
$('parallel').onchange = () => {
  const { position } = camera;
  camera = $('parallel').checked ? parallel : perspective;
  camera.position.copy(position);
  controls.object = camera;
  resize();
};
$('axis').onchange = () => { $('cut').disabled = $('axis').value === ''; makeLines(); };
$('cut').onchange = makeLines;
$('svg').onclick = () => save('svg');
$('dxf').onclick = () => save('dxf');
addEventListener('dragover', (event) => { event.preventDefault(); document.body.classList.add('dropping'); });
addEventListener('dragleave', () => document.body.classList.remove('dropping'));
addEventListener('drop', (event) => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  if (event.dataTransfer.files[0]) open(event.dataTransfer.files[0]);
});
new ResizeObserver(resize).observe(view);
dark.addEventListener('change', recolor);

recolor();
if (!supported) {
  say('This browser has no SIMD or no exceptions in WebAssembly: please update it.', true);
} else {
  $('model').value = 'bracket';
  setModel(models.bracket());
  renderer.setAnimationLoop(() => {
    controls.update();
    resting.update();
    if (!isStale) return;
    isStale = false;
    renderer.render(scene, camera);
  });
}
