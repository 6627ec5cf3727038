/** ammo.wasm packed inside a script, put in by Rollup (tools/build/rollup-plugins.js). */
declare module 'virtual:ammo-wasm' {
  export default function wasm(): Promise<Uint8Array>;
}

/** A style sheet as text (tools/build/css-text.js). */
declare module '*.css' {
  const text: string;
  export default text;
}
