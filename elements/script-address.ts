/** Where the classic script was loaded from; known only while it runs for the first time. */
export function scriptAddress(): string {
  const script = document.currentScript as HTMLScriptElement | SVGScriptElement | null;
  return script && 'src' in script && script.src ? script.src : document.baseURI;
}
