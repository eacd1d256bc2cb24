/** Whether this browser or Node can run the module: WebAssembly with SIMD and exceptions. */
export const supported: boolean;

/**
 * Loads the module, once. All else must wait for it.
 *
 * @param source Where it is: a URL, its bytes or a compiled module. By default `lineatlas.wasm` beside this file.
 * @throws Error where the module cannot be loaded, or is not {@link supported}.
 */
export function init(source?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module): Promise<void>;

/** What a line is. */
export type Kind =
  | 'crease' | 'boundary' | 'material' | 'silhouette' | 'file'
  | 'intersection' | 'section' | 'hatching' | 'ridge' | 'valley'
  | 'tangent' | 'centre' | 'trail';

/** Kinds by their numbers in {@link Segments.kind}. */
export const kinds: readonly Kind[];

/** Stands where there is no part, vertex or triangle: 0xffffffff. */
export const none: number;

/** Numbers in any list; a typed array of the right type is not copied twice. */
export type Numbers = ArrayLike<number>;

/** Sixteen numbers by columns, or what has them as `elements`, as THREE.Matrix4 does. */
export type Matrix = Numbers | { elements: Numbers };

/** Triangles and polylines of one part of a model. Arrays are copied. */
export interface MeshArrays {
  /** x, y, z of each vertex; finite. */
  positions?: Numbers;
  /** Floats from one vertex to the next; 3 by default. */
  stride?: number;
  /** Three vertices for each triangle; without it vertices are corners as they come. An empty list: there is no triangle. */
  indices?: Numbers;
  /** A number for each triangle: where it changes there is a line. */
  materials?: Numbers;
  /** What the numbers of `materials` are, from 0: names that stand in the files that are written. */
  groups?: { object?: string; material?: string }[];
  /** Places the mesh in the world. */
  matrix?: Matrix;
  /** Stands in the files that are written. */
  name?: string;
  /** Lines of your own: x, y, z of their points, or, in a Uint32Array, vertices of the mesh. */
  polylines?: (Numbers | Uint32Array)[];
}

/** Told what share is done, 0 to 1; `false` ends the call with an AbortError. It must not call this package. */
export type Progress = (done: number) => boolean | void;

/** What {@link readMesh} found in a file. */
export interface LoadedMesh {
  /** For `new Lines()`; add a `name` or a `matrix`. OBJ files have groups: their objects and materials. */
  mesh: MeshArrays & { positions: Float32Array; indices: Uint32Array; materials?: Uint32Array; polylines?: (Float32Array | Uint32Array)[] };
  /** Was taken off all positions: zeros, but for models so far from zero that floats could not hold them. */
  origin: number[];
  /** What was repaired or left out, a line each. */
  notes: string[];
}

/**
 * Reads OBJ, PLY, STL or OFF by the readers of the native tool.
 *
 * @param name Of the file: its extension says what type it is, errors name it.
 * @throws Error, one line with the name and the cause: truncated, of another type, a corner that is no vertex of the file.
 */
export function readMesh(file: ArrayBuffer | ArrayBufferView, name: string): LoadedMesh;

export interface LinesOptions {
  /** Others are not looked for; all by default. */
  kinds?: Kind[];
  /** Degrees: every edge bent by more is a crease. By default 30, but for noise of scans and seams of surfaces. */
  creaseAngle?: number;
  /** Where silhouettes of curved surfaces run: as the surface's own, or along edges of triangles. 'auto' by default. */
  silhouettes?: 'auto' | 'smooth' | 'mesh';
  /** Nothing is joined between meshes, so that {@link Lines.setHidden} works. */
  separateParts?: boolean;
  /** Planes that cut the model, at most six; what lies where the normal points to is gone. */
  sections?: { point: Numbers; normal: Numbers }[];
  /** Between lines on the faces of cuts, model units; false: none. By default a fortieth of the model. */
  hatching?: number | false;
  progress?: Progress;
}

/** A camera: matrices as three.js has them, for a picture of so many pixels. */
export interface Camera {
  /** World to eye: `camera.matrixWorldInverse`. */
  view: Matrix;
  /** Eye to clip space: `camera.projectionMatrix`, perspective or parallel. */
  projection: Matrix;
  width: number;
  height: number;
  /** Depth of clip space goes from 0 to 1, as WebGPU has it. */
  zeroToOne?: boolean;
}

export interface FrameOptions {
  width: number;
  height: number;
  /** 'front', 'back', 'left', 'right', 'top', 'bottom', 'isometric', 'dimetric', or degrees 'AZIMUTH,ELEVATION'. */
  from?: string;
  /** The model's, a unit axis; y by default. */
  up?: [number, number, number];
  projection?: 'perspective' | 'orthographic';
  /** Vertical field of view in degrees; 40 by default. */
  fov?: number;
}

export interface DrawOptions {
  /** Others are left out; all that the lines have by default. */
  kinds?: Kind[];
  /** Hidden pieces too. */
  hidden?: boolean;
  /** What has the background on one side is told, for styles with rules for outlines. */
  outlines?: boolean;
  progress?: Progress;
}

/** What is seen, or hidden, of lines: straight pieces, in the order of their paths. */
export interface Segments {
  count: number;
  /** Six each: start and end in the world. */
  positions: Float32Array;
  /** Four each: start and end in pixels from the upper left corner. */
  screen: Float32Array;
  /** Index into {@link kinds}. */
  kind: Uint8Array;
  /** 1: visible; 0: hidden. */
  visible: Uint8Array;
  /** Two each: vertices of the mesh whose edge the piece is a part of, or {@link none}. */
  edge: Uint32Array;
  /** Number of the mesh, or {@link none}. */
  part: Uint32Array;
}

export interface WriteOptions {
  /** Settings of a style by their keys (docs/styles.md): `{ width: 2, color: '#204060', hidden: true }`. */
  style?: Record<string, string | number | boolean>;
  /** Of an SVG. */
  title?: string;
  /** Millimetres of paper that the picture is scaled to fit on. */
  page?: { width: number; height: number };
  /** Millimetres around the picture on a page. */
  margin?: number;
  /** SVG and JSON tell where each path comes from; true by default. */
  tags?: boolean;
}

/** What was found by {@link Lines.pick}. */
export interface Pick {
  /** Of a line; null: a face. */
  kind: Kind | null;
  part: number;
  edge: [number, number];
  triangle: number;
  /** Pixels from the upper left corner. */
  x: number;
  y: number;
  distance: number;
  world: number[];
}

/**
 * The lines of a model. Calls throw an Error with one line that says what is wrong: an index that no vertex has, a position
 * that is not finite, a camera whose matrix has no inverse, memory that does not suffice. The module lives on then.
 */
export class Lines {
  constructor(meshes: MeshArrays | MeshArrays[], options?: LinesOptions);
  /** Pieces of lines before any is hidden. */
  readonly segmentCount: number;
  readonly bounds: { min: number[]; max: number[] };
  /** Where cuts did not close, a line each. */
  readonly notes: string[];
  /** Shows all parts but these; needs `separateParts`. */
  setHidden(parts: Numbers): void;
  /** A camera that shows all. */
  frame(options: FrameOptions): Camera & { view: Float32Array; projection: Float32Array };
  /** Finds what a camera sees. */
  draw(camera: Camera, options?: DrawOptions): Drawing;
  /** What is seen at a point, in pixels from the upper left corner: a line no farther than `radius` (8), else a face. */
  pick(camera: Camera, x: number, y: number, options?: { radius?: number; kinds?: Kind[] }): Pick | null;
  /** Frees its memory. Lines that are forgotten are freed some day. */
  dispose(): void;
}

/** What a camera sees of {@link Lines}, which must live as long. */
export class Drawing {
  private constructor();
  readonly segmentCount: number;
  /** A copy. */
  segments(): Segments;
  /** SVG 1.1, with paths joined and simplified. */
  toSVG(options?: WriteOptions): string;
  /** DXF of AutoCAD 2004, in millimetres. */
  toDXF(options?: WriteOptions): string;
  /** docs/vector.md */
  toJSON(options?: WriteOptions): string;
  /** Frees its memory. */
  dispose(): void;
}
