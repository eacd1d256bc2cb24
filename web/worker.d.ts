import type { Camera, DrawOptions, FrameOptions, Kind, LinesOptions, LoadedMesh, MeshArrays, Numbers, Pick, Segments, WriteOptions }
  from './lineatlas.js';

export { kinds, none, supported } from './lineatlas.js';

export interface Abortable {
  /**
   * Ends the call: its promise is rejected with the signal's reason at once. A call that has not begun never begins. One
   * that has is stopped on pages that are cross-origin isolated; on others it works on, and what it finds is dropped.
   */
  signal?: AbortSignal;
}

/** A worker that holds models. Calls are done one after the other. */
export class LinesWorker {
  /**
   * @param options.wasm Where the module is; see `init()` of `lineatlas`.
   * @param options.worker One that runs `worker_thread.js` of this package, where bundlers do not find it by themselves.
   */
  constructor(options?: { wasm?: string | URL | ArrayBuffer | WebAssembly.Module; worker?: Worker });
  /** As `new Lines()`. Arrays are copied; with `transfer` they move, and are empty afterwards. */
  extract(meshes: MeshArrays | MeshArrays[], options?: LinesOptions & Abortable & { transfer?: boolean }): Promise<Lines>;
  /** As `readMesh()` of `lineatlas`. */
  readMesh(file: ArrayBuffer | ArrayBufferView, name: string): Promise<LoadedMesh>;
  /** Ends the worker and all that it holds. */
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
  /** Its arrays are moved, not copied. */
  segments(): Promise<Segments>;
  toSVG(options?: WriteOptions): Promise<string>;
  toDXF(options?: WriteOptions): Promise<string>;
  toJSON(options?: WriteOptions): Promise<string>;
  dispose(): Promise<void>;
}
