import type { X3DNode } from '../../../../elements/bridge/x3dom/x3dom.js';
import { nextFrame, show, until } from '../../scene.js';

/** What tests ask of x3dom's renderer. */
interface Renderer {
  ctx3d: WebGL2RenderingContext;
  numDrawCalls: number;
  renderScene(area: unknown): void;
}

interface Shown {
  ctx: Renderer;
  needRender: boolean;
  _viewarea: unknown;
  _scene: { _lastMin: unknown; _lastMax: unknown; _childNodes: X3DNode[] };
  _nodeBag: { trans: unknown[] };
}

export const documentOf = (x3d: Element): Shown =>
  (x3d as unknown as { runtime: { canvas: { doc: Shown } } }).runtime.canvas.doc;

/** The scene as it stands, drawn at once: four bytes per pixel. */
export function picture(x3d: Element): Uint8Array {
  const { ctx, _viewarea } = documentOf(x3d);
  ctx.renderScene(_viewarea);
  const gl = ctx.ctx3d;
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** How many calls of WebGL draw the scene. */
export function draws(x3d: Element): number {
  picture(x3d);
  return documentOf(x3d).ctx.numDrawCalls;
}

export const errorOf = (x3d: Element): number => documentOf(x3d).ctx.ctx3d.getError();

/** How many pixels differ, and the one that does so most by how many of 255. */
export function difference(a: Uint8Array, b: Uint8Array): { any: number; most: number } {
  let [any, most] = [0, 0];
  for (let i = 0; i < a.length; i += 4) {
    const by = Math.max(...[0, 1, 2].map((c) => Math.abs(a[i + c]! - b[i + c]!)));
    if (by > 0) any++;
    most = Math.max(most, by);
  }
  return { any, most };
}

/** Pixels that are not of the same colour as the first. */
export const covered = (pixels: Uint8Array): number =>
  pixels.filter((value, i) => i % 4 === 0 && value !== pixels[0]).length;

/** Those whose Shapes look alike, in rows; nothing moves them. `content`: of the Shape. */
export function bodies(count: number, content: (i: number) => string, transform = ''): string {
  return Array.from({ length: count }, (_, i) => {
    const place = [
      ((i % 6) - 2.5) * 1.8,
      ((Math.floor(i / 6) % 4) - 1.5) * 1.8,
      -Math.floor(i / 24) * 1.8,
    ];
    return `<transform id="t${i}" ${transform} translation="${place.join(' ')}" rotation="1 ${i % 3} ${i % 5} ${i * 0.37}">
      <shape id="s${i}">${content(i)}</shape><x3d-rigid-body id="b${i}"></x3d-rigid-body></transform>`;
  }).join('');
}

/** The same, each in groups of its own: round its Transform and in it. */
export const wrapped = (all: string): string =>
  all
    .replaceAll(
      /<transform id="t(\d+)"/g,
      (text, i: string) =>
        `<group id="g${i}"><transform id="o${i}" translation="0.2 0 0" rotation="0 0 1 0.3" scale="1 0.8 1.1"><transform id="p${i}" rotation="1 0 0 0.2">${text}`,
    )
    .replaceAll(
      /<shape id="s(\d+)"/g,
      (text, i: string) =>
        `<group id="h${i}"><transform id="i${i}" translation="0 0.3 0" rotation="1 0 0 0.4">${text}`,
    )
    .replaceAll('</shape>', '</shape></transform></group>')
    .replaceAll(
      '</x3d-rigid-body></transform>',
      '</x3d-rigid-body></transform></transform></transform></group>',
    );

/** Each in a colour of its own. */
export const colored = (i: number, more = ''): string =>
  `<appearance><material diffusecolor="${(i % 7) / 7} ${(i % 5) / 5} ${(i % 3) / 3}" ${more}></material></appearance>`;

const COLLECTION =
  '<x3d-rigid-body-collection id="c" default enabled="false"></x3d-rigid-body-collection>';

/** Shows a scene whose bodies stand still, and waits until it takes no more than so many draws. */
export async function showBatched(content: string, atMost = 2) {
  const { x3d, world } = await show(
    `<viewpoint position="0 0 12"></viewpoint>${COLLECTION}${content}`,
    '#c',
  );
  await until(() => draws(x3d) <= atMost && draws(x3d) > 0);
  return { x3d, world, collection: x3d.querySelector('#c')! };
}

/** Has all bodies drawn one by one, or as they are without that. */
export async function drawPlainly(collection: Element, plainly: boolean): Promise<void> {
  if (plainly) collection.setAttribute('batch', 'false');
  else collection.removeAttribute('batch');
  await nextFrame();
  await nextFrame();
}
