import type { Camera, DrawOptions, FrameOptions, Kind, LinesOptions, LoadedMesh, MeshArrays, Numbers, Pick, Segments, WriteOptions }
  from './lineatlas.js';

export { kinds, none, supported } from './lineatlas.js';

export interface Abortable {
  /**
   * Ends the call. Its promise is rejected at once with the signal's reason. A call that waits never begins. A running call
   * stops in Node and on pages that are cross-origin isolated. On other pages it runs to its end, and its result is dropped.
   */
  signal?: AbortSignal;
}

/** A worker that holds models. It does calls one after the other. */
export class LinesWorker {
  /**
   * @param options.wasm The module; see `init()` of `lineatlas`.
   * @param options.worker A worker that runs `worker_thread.js` of this package. Needed if the bundler does not find that file.
   */
  constructor(options?: { wasm?: string | URL | ArrayBuffer | WebAssembly.Module; worker?: Worker });
  /** As `new Lines()`. Arrays are copied. With `transfer` they are moved, so yours are empty afterwards. */
  extract(meshes: MeshArrays | MeshArrays[], options?: LinesOptions & Abortable & { transfer?: boolean }): Promise<Lines>;
  /** As `readMesh()` of `lineatlas`. */
  readMesh(file: ArrayBuffer | ArrayBufferView, name: string): Promise<LoadedMesh>;
  /** Ends the worker and frees its models. */
  dispose(): void;
}

/** As `Lines` of `lineatlas`, with promises. */
export class Lines {
  private constructor();
  readonly segmentCount: Promise<number>;
  readonly bounds: Promise<{ min: number[]; max: number[] }>;
  readonly notes: Promise<string[]>;
  setHidden(parts: Numbers): Promise<void>;
  frame(options: FrameOptions): Promise<Camera>;
  draw(camera: Camera, options?: DrawOptions & Abortable): Promise<Drawing>;
  pick(camera: Camera, x: number, y: number, options?: { radius?: number; kinds?: Kind[] }): Promise<Pick | null>;
  dispose(): Promise<void>;
}

/** As `Drawing` of `lineatlas`, with promises. */
export class Drawing {
  private constructor();
  readonly segmentCount: Promise<number>;
  /** As `Drawing.segments()`, but the arrays are moved, not copied. */
  segments(): Promise<Segments>;
  toSVG(options?: WriteOptions): Promise<string>;
  toDXF(options?: WriteOptions): Promise<string>;
  toJSON(options?: WriteOptions): Promise<string>;
  dispose(): Promise<void>;
}
