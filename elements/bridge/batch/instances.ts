import type { Affine } from '../geometry/matrix.js';
import type { X3DColor, X3DVolume } from '../x3dom/renderer.js';
import { BOX, reachInto } from './reach.js';

/** Per instance: three rows of its matrix; red, green, blue and the id that it is picked by. */
const FLOATS = 16;
const VECTORS = 4;
const BYTES = 4;
/** Attributes of the last places, of which WebGL 2 has sixteen: x3dom's own begin at the first. */
export const FIRST_ATTRIBUTE = 12;

/** What tells the bodies of one batch apart, here and in WebGL, and how far each of them reaches. */
export class Instances {
  count = 0;
  #data = new Float32Array(8 * FLOATS);
  /** How far each of them reaches. */
  #boxes = new Float64Array(8 * BOX);
  #buffer: WebGLBuffer | null = null;
  /** Bytes that WebGL has room for. */
  #room = 0;
  /** What WebGL does not have yet. */
  #from = Infinity;
  #to = 0;

  /** The place of one more. */
  add(): number {
    const at = this.count++;
    if (this.count * FLOATS > this.#data.length) {
      const [data, boxes] = [this.#data, this.#boxes];
      this.#data = new Float32Array(2 * data.length);
      this.#boxes = new Float64Array(2 * boxes.length);
      this.#data.set(data);
      this.#boxes.set(boxes);
    }
    return at;
  }

  /** The last one comes to this place. */
  remove(at: number): void {
    const last = --this.count;
    this.#data.copyWithin(at * FLOATS, last * FLOATS, (last + 1) * FLOATS);
    this.#boxes.copyWithin(at * BOX, last * BOX, (last + 1) * BOX);
    this.#note(at);
  }

  #note(at: number): void {
    if (at < this.#from) this.#from = at;
    if (at >= this.#to) this.#to = at + 1;
  }

  // ---- one instance -----------------------------------------------------------------------------------------------

  /** `inner`: from the frame of what is drawn to that of `m`. */
  place(at: number, m: Affine, inner: Affine): void {
    const data = this.#data;
    for (let row = 0; row < 12; row += 4) {
      const [i, x, y, z] = [at * FLOATS + row, m[row], m[row + 1], m[row + 2]];
      data[i] = x * inner[0] + y * inner[4] + z * inner[8];
      data[i + 1] = x * inner[1] + y * inner[5] + z * inner[9];
      data[i + 2] = x * inner[2] + y * inner[6] + z * inner[10];
      data[i + 3] = x * inner[3] + y * inner[7] + z * inner[11] + m[row + 3];
    }
    this.#note(at);
  }

  /** `box`: how far it reaches in the frame of `m`. */
  reach(at: number, m: Affine, box: number[]): void {
    reachInto(m, box, this.#boxes, at * BOX);
  }

  /** Of no size, it covers no pixel, and reaches nowhere. */
  hide(at: number): void {
    this.#data.fill(0, at * FLOATS, at * FLOATS + 12);
    this.#boxes.fill(NaN, at * BOX, (at + 1) * BOX);
    this.#note(at);
  }

  look(at: number, { r, g, b }: X3DColor, id: number): void {
    const i = at * FLOATS + 12;
    this.#data[i] = r;
    this.#data[i + 1] = g;
    this.#data[i + 2] = b;
    this.#data[i + 3] = id;
    this.#note(at);
  }

  // ---- all --------------------------------------------------------------------------------------------------------

  /** How far they reach together. */
  bounds({ min, max }: X3DVolume): void {
    const boxes = this.#boxes;
    min.x = min.y = min.z = Infinity;
    max.x = max.y = max.z = -Infinity;
    for (let i = 0; i < this.count * BOX; i += BOX) {
      if (boxes[i] < min.x) min.x = boxes[i];
      if (boxes[i + 1] < min.y) min.y = boxes[i + 1];
      if (boxes[i + 2] < min.z) min.z = boxes[i + 2];
      if (boxes[i + 3] > max.x) max.x = boxes[i + 3];
      if (boxes[i + 4] > max.y) max.y = boxes[i + 4];
      if (boxes[i + 5] > max.z) max.z = boxes[i + 5];
    }
  }

  /** The next draw call takes them. */
  bind(gl: WebGL2RenderingContext): void {
    this.#buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    this.#upload(gl);
    for (let i = 0; i < VECTORS; i++) {
      const at = FIRST_ATTRIBUTE + i;
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 4, gl.FLOAT, false, FLOATS * BYTES, 4 * i * BYTES);
      gl.vertexAttribDivisor(at, 1);
    }
  }

  unbind(gl: WebGL2RenderingContext): void {
    for (let i = 0; i < VECTORS; i++) {
      gl.disableVertexAttribArray(FIRST_ATTRIBUTE + i);
      gl.vertexAttribDivisor(FIRST_ATTRIBUTE + i, 0);
    }
  }

  #upload(gl: WebGL2RenderingContext): void {
    const data = this.#data;
    const [first, end] = [this.#from * FLOATS, Math.min(this.#to, this.count) * FLOATS];
    if (this.#room < data.byteLength) {
      this.#room = data.byteLength;
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    } else if (first < end)
      gl.bufferSubData(gl.ARRAY_BUFFER, first * BYTES, data, first, end - first);
    this.#from = Infinity;
    this.#to = 0;
  }

  free(gl: WebGL2RenderingContext): void {
    gl.deleteBuffer(this.#buffer);
    this.#buffer = null;
    this.#room = 0;
  }
}
