import type { Camera as ThreeCamera, Object3D } from 'three';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import type { Camera, DrawOptions, MeshArrays, Segments } from './lineatlas.js';
import type { Lines } from './worker.js';

/** A three.js camera as a camera of lineatlas, for a picture of this size in pixels. */
export function cameraOf(camera: ThreeCamera, width: number, height: number): Camera;

/**
 * The visible meshes and lines of an object and its descendants in their current state: with transforms, groups of materials,
 * instances, morphs and bones. `objects[i]` is the object of mesh i, so it is the object of {@link Segments.part} i.
 *
 * @throws Error for a BatchedMesh.
 */
export function meshesOf(root: Object3D, options?: { filter?: (object: Object3D) => boolean }):
  { meshes: MeshArrays[]; objects: Object3D[] };

/** The visible or the hidden segments as an object for a scene. Raycasting ignores the object. */
export function lineSegmentsOf(segments: Segments, options?: { hidden?: boolean; material?: LineMaterial }): LineSegments2;

export interface RestingLinesOptions {
  /** Returns the lines to draw. They belong to a worker, so the page is not blocked. */
  lines: () => Lines;
  /** Returns the current camera. */
  camera: () => ThreeCamera;
  /** Returns the width and height of the canvas in pixels. */
  size: () => [number, number];
  /** Milliseconds that the camera must rest; 150 by default. */
  delay?: number;
  draw?: DrawOptions;
  /** Gets the lines for the resting camera. */
  onLines: (segments: Segments, camera: Camera) => void;
  /** Called when the camera moves, so that shown lines are out of date. */
  onMove?: () => void;
  onError?: (error: Error) => void;
}

/** Draws lines again whenever the camera has come to rest. */
export class RestingLines {
  constructor(options: RestingLinesOptions);
  /** Call this in every frame. */
  update(now?: number): void;
  /** Draws again although the camera has not moved, because lines or options have changed. */
  invalidate(): void;
}
