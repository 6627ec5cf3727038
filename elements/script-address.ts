/** A file beside the script; where its address is no base (blob:, data:) the bare name, which nobody finds. */
export function besideScript(file: string, address: string): string {
  try {
    return new URL(file, address).href;
  } catch {
    return file;
  }
}

/** Where the classic script was loaded from; known only while it runs for the first time. */
export function scriptAddress(): string {
  const script = document.currentScript as HTMLScriptElement | SVGScriptElement | null;
  return script && 'src' in script && script.src ? script.src : document.baseURI;
}
