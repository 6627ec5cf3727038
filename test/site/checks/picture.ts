// Pictures of a page as numbers. A browser can read PNG: another tab of it does.
import type { BrowserContext } from 'playwright';

export interface Picture {
  width: number;
  height: number;
  /** Red, green, blue and opacity of each pixel, row by row from the top. */
  data: Buffer;
}

/** Runs in the page that decodes. */
async function decode(png: string): Promise<{ width: number; height: number; data: string }> {
  const image = await createImageBitmap(await (await fetch(png)).blob());
  const { width, height } = image;
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const reader = new FileReader();
  reader.readAsDataURL(new Blob([data]));
  await new Promise((done) => (reader.onload = done));
  return { width, height, data: String(reader.result).split(',')[1]! };
}

export async function decoder(context: BrowserContext): Promise<(png: Buffer) => Promise<Picture>> {
  const tab = await context.newPage();
  return async (png) => {
    const read = await tab.evaluate(decode, `data:image/png;base64,${png.toString('base64')}`);
    return { ...read, data: Buffer.from(read.data, 'base64') };
  };
}

export const colorAt = ({ data, width }: Picture, x: number, y: number): number[] => {
  const at = 4 * (Math.round(y) * width + Math.round(x));
  return [...data.subarray(at, at + 3)];
};

/** Between two colours: 0 to 441. */
export const distance = (a: number[], b: number[]): number =>
  Math.hypot(...a.map((value, i) => value - b[i]!));

/** Share of the pixels that are further than `far` from those of another picture as large. */
export function shareApart({ data, width, height }: Picture, other: Picture, far: number): number {
  let apart = 0;
  for (let i = 0; i < data.length; i += 4) {
    const way = [0, 1, 2].map((k) => data[i + k]! - other.data[i + k]!);
    if (Math.hypot(...way) > far) apart++;
  }
  return apart / (width * height);
}

/** Share of the pixels none of whose channels exceeds `limit`. */
export function shareBelow({ data, width, height }: Picture, limit: number): number {
  let dark = 0;
  for (let i = 0; i < data.length; i += 4)
    if (data[i]! <= limit && data[i + 1]! <= limit && data[i + 2]! <= limit) dark++;
  return dark / (width * height);
}

/** Share of the pixels whose channels are further than `far` from each other. */
export function shareColored({ data, width, height }: Picture, far: number): number {
  let colored = 0;
  for (let i = 0; i < data.length; i += 4) {
    const color = [...data.subarray(i, i + 3)];
    if (Math.max(...color) - Math.min(...color) > far) colored++;
  }
  return colored / (width * height);
}
