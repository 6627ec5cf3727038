export function usedWasm(): Uint8Array;
