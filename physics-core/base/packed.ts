// Numbers as text, for plain data that may have to go through JSON: base64 of their bytes, which keeps every bit.

/** Characters that one call can take as arguments. */
const PIECE = 0x2000;

type Numbers = Float64Array | Float32Array | Int32Array | Uint8Array;

export function pack(numbers: Numbers): string {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += PIECE)
    text += String.fromCharCode(...bytes.subarray(i, i + PIECE));
  return btoa(text);
}

/** Throws where it is no base64 of whole numbers of `size` bytes. */
function bufferOf(text: string, size: number): ArrayBuffer {
  const all = atob(text);
  if (all.length % size !== 0) throw new RangeError('numbers are cut in half');
  const bytes = new Uint8Array(all.length);
  for (let i = 0; i < all.length; i++) bytes[i] = all.charCodeAt(i);
  return bytes.buffer;
}

export const bytesOf = (text: string): Uint8Array => new Uint8Array(bufferOf(text, 1));
export const floatsOf = (text: string): Float32Array => new Float32Array(bufferOf(text, 4));
export const doublesOf = (text: string): Float64Array => new Float64Array(bufferOf(text, 8));
export const wordsOf = (text: string): Int32Array => new Int32Array(bufferOf(text, 4));
