import type { Camera as ThreeCamera, Object3D } from 'three';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import type { Camera, DrawOptions, MeshArrays, Segments } from './lineatlas.js';
import type { Lines } from './worker.js';

/** A three.js camera for a picture of so many pixels. */
export function cameraOf(camera: ThreeCamera, width: number, height: number): Camera;

/**
 * The visible meshes and lines of an object and all below it, as they are now: placed, with groups of materials, instances,
 * morphs and bones. `objects` has for each mesh the object that it is of, so that {@link Segments.part} leads back to it.
 *
 * @throws Error for a BatchedMesh.
 */
export function meshesOf(root: Object3D, options?: { filter?: (object: Object3D) => boolean }):
  { meshes: MeshArrays[]; objects: Object3D[] };

/** Segments as an object for a scene: the visible ones, or the hidden ones. Nothing hits it by raycasting. */
export function lineSegmentsOf(segments: Segments, options?: { hidden?: boolean; material?: LineMaterial }): LineSegments2;

export interface RestingLinesOptions {
  /** Those to draw, when they are drawn: of a worker, so that the page goes on. */
  lines: () => Lines;
  /** The one that draws now. */
  camera: () => ThreeCamera;
  /** Of the canvas, in pixels: width and height. */
  size: () => [number, number];
  /** Milliseconds that the camera must rest; 150 by default. */
  delay?: number;
  draw?: DrawOptions;
  /** Lines for the camera as it rests. */
  onLines: (segments: Segments, camera: Camera) => void;
  /** The lines that were shown are those of another camera now. */
  onMove?: () => void;
  onError?: (error: Error) => void;
}

/** Keeps lines up to date: drawn when the camera has come to rest. */
export class RestingLines {
  constructor(options: RestingLinesOptions);
  /** To be called with every frame. */
  update(now?: number): void;
  /** Draws again though the camera has not moved: other lines, other options. */
  invalidate(): void;
}
