/** ammo.wasm packed inside a script, put in by Rollup (tools/rollup-plugins.js). */
declare module 'virtual:ammo-wasm' {
  export default function wasm(): Promise<Uint8Array>;
}

/** A style sheet as text (tools/css-text.js). */
declare module '*.css' {
  const text: string;
  export default text;
}
