/** The wasm heap has no room for what was to be made, or may not grow as far. */
export class HeapExhausted extends Error {}
