// Markup in an address: `#markup=…` as it is, `#shared=…` compressed. Nothing of it is sent to a server.

const NOTE = 'The address holds no markup that can be read: it may have been cut short.';

/** For links into the playground, made at once. `base` is where the site lies. */
export const playgroundAddress = (markup: string, base = '/'): string =>
  `${base}playground.html#markup=${toBase64(new TextEncoder().encode(markup))}`;

/** For addresses that people send to each other: shorter. */
export async function sharedHash(markup: string): Promise<string> {
  const text = new Blob([markup]).stream();
  return `#shared=${toBase64(await bytesOf(text.pipeThrough(new CompressionStream('deflate-raw'))))}`;
}

/** The markup that an address has behind its #; undefined where there is none. */
export async function markupIn(hash: string): Promise<string | undefined> {
  const [, kind, value] = /^#(markup|shared)=(.*)$/s.exec(hash) ?? [];
  if (!kind) return undefined;
  try {
    const bytes = fromBase64(value!);
    return textOf(kind === 'shared' ? await decompressed(bytes) : bytes);
  } catch {
    throw new Error(NOTE);
  }
}

/** More than any scene: a few bytes can be made to unfold into gigabytes. */
const LIMIT = 4e6;

async function decompressed(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  return bytesOf(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')));
}

async function bytesOf(stream: ReadableStream<Uint8Array>): Promise<Uint8Array<ArrayBuffer>> {
  const parts: BlobPart[] = [];
  let size = 0;
  const reader = stream.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    size += part.value.length;
    if (size > LIMIT) throw new RangeError('too long');
    parts.push(part.value.slice());
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

const textOf = (bytes: Uint8Array): string =>
  new TextDecoder('utf-8', { fatal: true }).decode(bytes);

/** In the letters that addresses take. */
function toBase64(bytes: Uint8Array): string {
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}
