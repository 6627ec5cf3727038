/** ammo.wasm as base64 text, put in by Rollup (tools/rollup-plugins.js) for the single-file bundle. */
declare module 'virtual:ammo-wasm-base64' {
  const base64: string;
  export default base64;
}

/** A style sheet as text (tools/css-text.js). */
declare module '*.css' {
  const text: string;
  export default text;
}
