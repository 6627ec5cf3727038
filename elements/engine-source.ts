/** Where the engine's wasm comes from: each entry file says so before the first physics element appears. */
export interface EngineOptions {
  wasmUrl?: string;
  wasmBinary?: Uint8Array;
  /** Where measurements of accuracy find their worker. */
  workerUrl?: string;
}

let source: () => EngineOptions | Promise<EngineOptions> = () => ({});

export function setEngineSource(options: typeof source): void {
  source = options;
}

export const engineSource = async (): Promise<EngineOptions> => source();
