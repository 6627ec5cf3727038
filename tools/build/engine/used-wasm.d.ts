/** ammo.wasm without what the core can't reach; `sources` call it by name, the core's if not said. */
export function usedWasm(sources?: readonly string[]): Uint8Array<ArrayBuffer>;
