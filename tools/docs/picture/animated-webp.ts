// Still WebP pictures, one after the other, as one that moves: https://developers.google.com/speed/webp/docs/riff_container

const uint = (value: number, bytes: number): Buffer => {
  const buffer = Buffer.alloc(bytes);
  buffer.writeUIntLE(value, 0, bytes);
  return buffer;
};

/** Chunks have even lengths. */
const chunk = (name: string, content: Buffer): Buffer =>
  Buffer.concat([
    Buffer.from(name, 'latin1'),
    uint(content.length, 4),
    content,
    Buffer.alloc(content.length % 2),
  ]);

/** The chunks of a still picture that hold its pixels. */
function pixelsOf(still: Buffer): Buffer {
  const kept: Buffer[] = [];
  for (let at = 12; at < still.length;) {
    const length = still.readUInt32LE(at + 4);
    const end = at + 8 + length + (length % 2);
    if (/^(ALPH|VP8[ L])$/.test(still.toString('latin1', at, at + 4)))
      kept.push(still.subarray(at, end));
    at = end;
  }
  return Buffer.concat(kept);
}

const ANIMATED = 0x02;
/** A frame takes the place of the one before, and is not mixed with it. */
const REPLACES = 0x02;

/** Runs for ever; each frame stands so many milliseconds. */
export function animatedWebp(stills: Buffer[], width: number, height: number, ms: number): Buffer {
  const size = Buffer.concat([uint(width - 1, 3), uint(height - 1, 3)]);
  const frames = stills.map((still) => {
    const head = Buffer.concat([uint(0, 6), size, uint(ms, 3), uint(REPLACES, 1)]);
    return chunk('ANMF', Buffer.concat([head, pixelsOf(still)]));
  });
  const content = Buffer.concat([
    Buffer.from('WEBP', 'latin1'),
    chunk('VP8X', Buffer.concat([uint(ANIMATED, 4), size])),
    chunk('ANIM', uint(0, 6)),
    ...frames,
  ]);
  return chunk('RIFF', content);
}
