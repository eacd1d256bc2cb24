/** True if this browser or Node can run the module, which needs WebAssembly with SIMD and exceptions. */
export const supported: boolean;

/**
 * Loads the module. Call it once, and wait for it before other calls.
 *
 * @param source The module: its URL, its bytes, or a compiled module. By default `lineatlas.wasm` beside this file.
 * @throws Error if the module cannot be loaded or is not {@link supported}.
 */
export function init(source?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module): Promise<void>;

/** Why an edge is a line. */
export type Kind =
  | 'crease' | 'boundary' | 'material' | 'silhouette' | 'file'
  | 'intersection' | 'section' | 'hatching' | 'ridge' | 'valley'
  | 'tangent' | 'centre' | 'trail';

/** The kinds in the order of their numbers in {@link Segments.kind}. */
export const kinds: readonly Kind[];

/** The value for no part, vertex or triangle: 0xffffffff. */
export const none: number;

/** A list of numbers. A typed array of the right type saves a copy. */
export type Numbers = ArrayLike<number>;

/** Sixteen numbers by columns, or an object with these as `elements`, such as THREE.Matrix4. */
export type Matrix = Numbers | { elements: Numbers };

/** Triangles and polylines of one part of a model. Arrays are copied. */
export interface MeshArrays {
  /** x, y, z of each vertex; finite. */
  positions?: Numbers;
  /** Floats from one vertex to the next; 3 by default. */
  stride?: number;
  /** Three vertices per triangle. Without indices, each three vertices in order are a triangle. An empty list: no triangles. */
  indices?: Numbers;
  /** A number per triangle. Edges between different numbers are lines of kind material. */
  materials?: Numbers;
  /** The names of `materials` 0, 1, ... in written files. */
  groups?: { object?: string; material?: string }[];
  /** The transform from the mesh to the world. */
  matrix?: Matrix;
  /** The name of the part in written files. */
  name?: string;
  /** Extra lines: x, y, z of their points, or, as a Uint32Array, vertices of the mesh. */
  polylines?: (Numbers | Uint32Array)[];
}

/** Gets the share that is done, 0 to 1. Returning `false` ends the call with an AbortError. It must not call this package. */
export type Progress = (done: number) => boolean | void;

/** The result of {@link readMesh}. */
export interface LoadedMesh {
  /** An argument for `new Lines()`; you may add a `name` or a `matrix`. OBJ files have groups for their objects and materials. */
  mesh: MeshArrays & { positions: Float32Array; indices: Uint32Array; materials?: Uint32Array; polylines?: (Float32Array | Uint32Array)[] };
  /** Was subtracted from all positions. It is not zero for models so far from zero that floats would lose digits. */
  origin: number[];
  /** Repairs and omissions, one line each. */
  notes: string[];
}

/**
 * Reads OBJ, PLY, STL or OFF with the readers of the native tool.
 *
 * @param name The file's name. Its extension gives the type; errors contain the name.
 * @throws Error with the name and the cause in one line, such as a truncated file, another type, or a corner that is no vertex.
 */
export function readMesh(file: ArrayBuffer | ArrayBufferView, name: string): LoadedMesh;

export interface LinesOptions {
  /** The kinds of line to find; all by default. */
  kinds?: Kind[];
  /** Edges bent by more than this, in degrees, are creases. By default 28.8, and noise of scans and seams of surfaces are left out. */
  creaseAngle?: number;
  /** Silhouettes of curved surfaces: 'smooth' follows the surface, 'mesh' edges of triangles. 'auto' (the default) chooses. */
  silhouettes?: 'auto' | 'smooth' | 'mesh';
  /** Joins nothing between meshes. {@link Lines.setHidden} needs it. */
  separateParts?: boolean;
  /** At most six planes that cut the model. The side that the normal points to is removed. */
  sections?: { point: Numbers; normal: Numbers }[];
  /** Distance between hatching lines on cut faces, in model units. By default a fortieth of the cut's size; false: none. */
  hatching?: number | false;
  progress?: Progress;
}

/** A camera: matrices as in three.js, and the size of the picture in pixels. */
export interface Camera {
  /** World to eye: `camera.matrixWorldInverse`. */
  view: Matrix;
  /** Eye to clip space: `camera.projectionMatrix`, perspective or parallel. */
  projection: Matrix;
  width: number;
  height: number;
  /** True if the depth of clip space goes from 0 to 1, as in WebGPU. */
  zeroToOne?: boolean;
}

export interface FrameOptions {
  width: number;
  height: number;
  /** 'front', 'back', 'left', 'right', 'top', 'bottom', 'isometric', 'dimetric', or degrees 'AZIMUTH,ELEVATION'. */
  from?: string;
  /** The model's up axis, a unit axis; y by default. */
  up?: [number, number, number];
  projection?: 'perspective' | 'orthographic';
  /** Vertical field of view in degrees; 40 by default. */
  fov?: number;
}

export interface DrawOptions {
  /** The kinds of line to draw; all kinds of the lines by default. */
  kinds?: Kind[];
  /** Also finds hidden pieces. */
  hidden?: boolean;
  /** Also finds outlines, which styles with rules for outlines need. */
  outlines?: boolean;
  progress?: Progress;
}

/** Visible and hidden pieces of lines, each straight, in the order of their paths. */
export interface Segments {
  count: number;
  /** Six numbers per piece: start and end in the world. */
  positions: Float32Array;
  /** Four numbers per piece: start and end in pixels from the upper left corner. */
  screen: Float32Array;
  /** Index into {@link kinds}. */
  kind: Uint8Array;
  /** 1: visible; 0: hidden. */
  visible: Uint8Array;
  /** Two numbers per piece: the vertices of its edge in the mesh, or {@link none}. */
  edge: Uint32Array;
  /** The index of the mesh, or {@link none}. */
  part: Uint32Array;
}

export interface WriteOptions {
  /** Settings of a style by key (docs/styles.md): `{ width: 2, color: '#204060', hidden: true }`. */
  style?: Record<string, string | number | boolean>;
  /** The title of an SVG file. */
  title?: string;
  /** The size of the paper in millimetres. The picture is scaled to fit. */
  page?: { width: number; height: number };
  /** Empty millimetres around the picture on a page. */
  margin?: number;
  /** Writes the source of each path to SVG and JSON; true by default. */
  tags?: boolean;
}

/** The result of {@link Lines.pick}. */
export interface Pick {
  /** The kind of the line; null: the result is a face. */
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
 * The lines of a model. Calls throw an Error with one line about the cause: an index without a vertex, a position that is not
 * finite, a camera whose matrix has no inverse, too little memory. The module stays usable after an error.
 */
export class Lines {
  constructor(meshes: MeshArrays | MeshArrays[], options?: LinesOptions);
  /** Number of segments, visible or not. */
  readonly segmentCount: number;
  readonly bounds: { min: number[]; max: number[] };
  /** Cuts that did not close, one line each. */
  readonly notes: string[];
  /** Hides these parts and shows all others. Needs `separateParts`. */
  setHidden(parts: Numbers): void;
  /** A camera that shows the whole model. */
  frame(options: FrameOptions): Camera & { view: Float32Array; projection: Float32Array };
  /** Finds the lines that a camera sees. */
  draw(camera: Camera, options?: DrawOptions): Drawing;
  /** The visible line within `radius` pixels (8 by default) of a point, else the face there. x and y: pixels from the upper left. */
  pick(camera: Camera, x: number, y: number, options?: { radius?: number; kinds?: Kind[] }): Pick | null;
  /** Frees the memory. The garbage collector frees forgotten lines, but at no certain time. */
  dispose(): void;
}

/** The lines that a camera sees. The {@link Lines} must live as long. */
export class Drawing {
  private constructor();
  readonly segmentCount: number;
  /** The pieces as a copy. */
  segments(): Segments;
  /** SVG 1.1, with paths joined and simplified. */
  toSVG(options?: WriteOptions): string;
  /** DXF of AutoCAD 2004, in millimetres. */
  toDXF(options?: WriteOptions): string;
  /** JSON as in docs/vector.md. */
  toJSON(options?: WriteOptions): string;
  /** Frees its memory. */
  dispose(): void;
}
