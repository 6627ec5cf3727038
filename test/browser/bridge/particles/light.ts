import { worldOf, type World } from '../../inside.js';
import { drawn, place, until } from '../../scene.js';
import { documentOf, picture } from '../batch/pictures.js';

/** Radians, X3D's default: of the smaller side of the canvas. */
const FIELD_OF_VIEW = Math.PI / 4;

/** What is white is on, what is black is not; no light but what a scene says. */
export const WHITE =
  '<appearance><material diffusecolor="0 0 0" specularcolor="0 0 0" emissivecolor="1 1 1"></material></appearance>';

const STAGE = `<environment gammacorrectiondefault="none"></environment><navigationinfo headlight="false" transitiontype="TELEPORT"></navigationinfo><background skycolor="0 0 0"></background>
  <viewpoint id="view" fieldofview="${FIELD_OF_VIEW}"></viewpoint>`;

/** A scene whose system `s` stands `seconds` after it began, seen from `distance` metres before the origin. */
export async function still(seconds: number, content: string, distance: number) {
  const x3d = place(STAGE + content);
  const s = x3d.querySelector('#s')! as Element & { positions: number[][] };
  await until(() => worldOf(s) !== undefined);
  const world: World = await worldOf(s)!.ready;
  world.paused = true;
  world.reset();
  world.advance(seconds);
  await lookFrom(x3d, 0, distance);
  return { x3d, world, s, places: s.positions };
}

/** Looks at the origin from so many metres, `turn` radians to the right of where z points. */
export async function lookFrom(x3d: Element, turn: number, distance: number): Promise<void> {
  const at = [Math.sin(turn) * distance, 0, Math.cos(turn) * distance];
  const view = x3d.querySelector('#view')!;
  view.setAttribute('orientation', `0 1 0 ${turn}`);
  view.setAttribute('position', at.join(' '));
  await drawn();
}

/** Light in a part of a picture. */
export interface Light {
  /** In whole white pixels. */
  sum: number;
  /** Where it is on the whole, pixels from the middle, to the right and up. */
  middle: [x: number, y: number];
  /** From its first to its last pixel that is lit by half. */
  span: [x: number, y: number];
}

/** What is seen of a scene. */
export class Sight {
  readonly #pixels: Uint8Array;
  readonly width: number;
  readonly height: number;

  constructor(x3d: Element) {
    this.#pixels = picture(x3d);
    const { drawingBufferWidth, drawingBufferHeight } = documentOf(x3d).ctx.ctx3d;
    [this.width, this.height] = [drawingBufferWidth, drawingBufferHeight];
  }

  /** Pixels of a metre at that distance. */
  perMetre(distance: number): number {
    return Math.min(this.width, this.height) / 2 / Math.tan(FIELD_OF_VIEW / 2) / distance;
  }

  /** Of the colour at a point, pixels from the middle: red, green, blue of 1. */
  at([x, y]: readonly [number, number]): number[] {
    const pixel = Math.floor(this.height / 2 + y) * this.width + Math.floor(this.width / 2 + x);
    return [0, 1, 2].map((channel) => this.#pixels[4 * pixel + channel]! / 255);
  }

  /** Within `reach` pixels from a point; without one, everywhere. */
  light(about: readonly [number, number] = [0, 0], reach = Infinity): Light {
    let [sum, byX, byY] = [0, 0, 0];
    const [columns, rows]: number[][] = [[], []];
    for (let row = 0; row < this.height; row++)
      for (let column = 0; column < this.width; column++) {
        const value = this.#pixels[4 * (row * this.width + column)]! / 255;
        const [x, y] = [column + 0.5 - this.width / 2, row + 0.5 - this.height / 2];
        if (Math.abs(x - about[0]) > reach || Math.abs(y - about[1]) > reach) continue;
        sum += value;
        byX += value * x;
        byY += value * y;
        if (value >= 0.5) {
          columns!.push(column);
          rows!.push(row);
        }
      }
    const span = (all: number[]): number => Math.max(...all) - Math.min(...all) + 1;
    return { sum, middle: [byX / sum, byY / sum], span: [span(columns!), span(rows!)] };
  }
}
