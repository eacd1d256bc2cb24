// Functions for three.js. three.d.ts describes them.
import { Matrix4, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

const webGPU = 2001; // THREE.WebGPUCoordinateSystem

export function cameraOf(camera, width, height) {
  camera.updateWorldMatrix(true, false);
  return {
    view: new Float32Array(camera.matrixWorld.clone().invert().elements),
    projection: new Float32Array(camera.projectionMatrix.elements),
    width,
    height,
    zeroToOne: camera.coordinateSystem === webGPU,
  };
}

/// The current positions of vertices, with morphs and bones applied.
function positionsOf(object) {
  const source = object.geometry.attributes.position;
  const moves = object.isSkinnedMesh || object.morphTargetInfluences?.some((influence) => influence !== 0);
  if (!moves && source.array instanceof Float32Array && source.itemSize === 3 && !source.isInterleavedBufferAttribute)
    return source.array.subarray(0, 3 * source.count);
  const positions = new Float32Array(3 * source.count), point = new Vector3();
  for (let i = 0; i < source.count; ++i) {
    if (moves) object.getVertexPosition(i, point);
    else point.fromBufferAttribute(source, i);
    point.toArray(positions, 3 * i);
  }
  return positions;
}

/// The drawn vertices in their order.
function cornersOf({ index, attributes, drawRange }) {
  const all = index !== null ? index.array : Uint32Array.from({ length: attributes.position.count }, (_, i) => i);
  return Uint32Array.from(all.subarray(drawRange.start, Math.min(all.length, drawRange.start + drawRange.count)));
}

const isShown = (material) => material.visible !== false;

/// The triangles with a visible material, and the material of each.
function trianglesOf(object) {
  const { geometry, material } = object;
  const corners = cornersOf(geometry);
  const whole = corners.length - (corners.length % 3);
  if (!Array.isArray(material)) return isShown(material) ? { indices: corners.subarray(0, whole) } : { indices: new Uint32Array(0) };
  const indices = [], materials = [], first = geometry.drawRange.start;
  for (const { start, count, materialIndex } of geometry.groups) {
    if (!material[materialIndex] || !isShown(material[materialIndex])) continue;
    for (let i = Math.max(start - first, 0); i + 2 < Math.min(whole, start - first + count); i += 3) {
      indices.push(corners[i], corners[i + 1], corners[i + 2]);
      materials.push(materialIndex);
    }
  }
  return { indices: Uint32Array.from(indices), materials: Uint32Array.from(materials) };
}

function polylinesOf(object, positions) {
  const corners = [...cornersOf(object.geometry)];
  if (object.isLineLoop && corners.length > 0) corners.push(corners[0]);
  const at = (i) => positions.subarray(3 * corners[i], 3 * corners[i] + 3);
  if (!object.isLineSegments) return [Float32Array.from(corners.flatMap((_, i) => [...at(i)]))];
  return corners.flatMap((_, i) => (i % 2 === 1 ? [Float32Array.of(...at(i - 1), ...at(i))] : []));
}

function placesOf(object) {
  if (!object.isInstancedMesh) return [object.matrixWorld.clone()];
  return Array.from({ length: object.count }, (_, i) => {
    const place = new Matrix4();
    object.getMatrixAt(i, place);
    return place.premultiply(object.matrixWorld);
  });
}

function meshesOfOne(object) {
  const positions = positionsOf(object);
  const shape = object.isMesh ? { positions, ...trianglesOf(object) } : { polylines: polylinesOf(object, positions) };
  return placesOf(object).map((matrix) => ({ ...shape, matrix: [...matrix.elements], name: object.name, object }));
}

function isDrawn(object) {
  if (object.isBatchedMesh) throw new Error(`lineatlas: "${object.name}" is a BatchedMesh, which is not read; give its parts as meshes`);
  return (object.isMesh || object.isLine) && !object.isLineSegments2 && object.geometry.attributes.position !== undefined;
}

export function meshesOf(root, { filter = () => true } = {}) {
  root.updateWorldMatrix(true, true);
  const objects = [];
  root.traverseVisible((object) => {
    if (isDrawn(object) && filter(object)) objects.push(object);
  });
  const found = objects.flatMap(meshesOfOne);
  return { meshes: found.map(({ object, ...mesh }) => mesh), objects: found.map(({ object }) => object) };
}

function selected({ count, positions, visible }, wanted) {
  const result = [];
  for (let i = 0; i < count; ++i)
    if (visible[i] === wanted) result.push(...positions.subarray(6 * i, 6 * i + 6));
  return result;
}

export function lineSegmentsOf(segments, { hidden = false, material = new LineMaterial({ color: 0x000000, linewidth: 1.5 }) } = {}) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(selected(segments, hidden ? 0 : 1));
  const lines = new LineSegments2(geometry, material);
  lines.name = hidden ? 'hidden lines' : 'visible lines';
  lines.raycast = () => {};
  return lines;
}

export class RestingLines {
  #options;
  #drawn = ''; // the last camera that was drawn or is being drawn
  #seen = ''; // the camera of the last frame
  #since = 0; // the time of its last change
  #abort = null;

  constructor(options) {
    this.#options = { delay: 150, ...options };
  }

  invalidate() {
    this.#drawn = '';
  }

  /// Called in each frame.
  update(now = performance.now()) {
    const { camera, size, delay, onMove } = this.#options;
    const view = cameraOf(camera(), ...size());
    const key = JSON.stringify([...view.view, ...view.projection, view.width, view.height]);
    if (key !== this.#seen) {
      if (this.#seen === this.#drawn && this.#drawn !== '') onMove?.();
      this.#seen = key;
      this.#since = now;
      this.#abort?.abort();
      this.#drawn = '';
    } else if (key !== this.#drawn && now - this.#since >= delay) {
      this.#drawn = key;
      this.#draw(view);
    }
  }

  async #draw(view) {
    const { lines, onLines, onError = (error) => { throw error; }, draw } = this.#options;
    const abort = (this.#abort = new AbortController());
    try {
      const drawing = await lines().draw(view, { ...draw, signal: abort.signal });
      try {
        const segments = await drawing.segments();
        if (!abort.signal.aborted) onLines(segments, view);
      } finally {
        await drawing.dispose();
      }
    } catch (error) {
      if (error.name !== 'AbortError') onError(error);
    }
  }
}
