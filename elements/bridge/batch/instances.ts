import type { X3DColor, X3DVolume } from '../x3dom/renderer.js';
import type { X3DMatrix } from '../x3dom/x3dom.js';

/** Per instance: three rows of its matrix; red, green, blue and the id that it is picked by. */
const FLOATS = 16;
const VECTORS = 4;
const BYTES = 4;
/** Per instance: the least x, y, z that it reaches, and the greatest. */
const BOX = 6;
/** Attributes of the last places, of which WebGL 2 has sixteen: x3dom's own begin at the first. */
export const FIRST_ATTRIBUTE = 12;

/** What tells the bodies of one batch apart, here and in WebGL, and how far each of them reaches. */
export class Instances {
  count = 0;
  #data = new Float32Array(8 * FLOATS);
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
  place(at: number, m: X3DMatrix, inner: X3DMatrix): void {
    this.#row(at, 0, m._00, m._01, m._02, m._03, inner);
    this.#row(at, 1, m._10, m._11, m._12, m._13, inner);
    this.#row(at, 2, m._20, m._21, m._22, m._23, inner);
    this.#note(at);
  }

  #row(at: number, row: number, x: number, y: number, z: number, w: number, m: X3DMatrix): void {
    const data = this.#data;
    const i = at * FLOATS + 4 * row;
    data[i] = x * m._00 + y * m._10 + z * m._20;
    data[i + 1] = x * m._01 + y * m._11 + z * m._21;
    data[i + 2] = x * m._02 + y * m._12 + z * m._22;
    data[i + 3] = x * m._03 + y * m._13 + z * m._23 + w;
  }

  /** `inside`: how far it reaches in the frame of `m`. */
  reach(at: number, m: X3DMatrix, inside: X3DVolume): void {
    this.#along(at, 0, m._00, m._01, m._02, m._03, inside);
    this.#along(at, 1, m._10, m._11, m._12, m._13, inside);
    this.#along(at, 2, m._20, m._21, m._22, m._23, inside);
  }

  /** To the last bit as x3dom adds it up, since shadows hang on that. */
  #along(
    at: number,
    axis: number,
    x: number,
    y: number,
    z: number,
    origin: number,
    { min, max }: X3DVolume,
  ): void {
    const x0 = x * min.x;
    const x1 = x * max.x;
    const y0 = y * min.y;
    const y1 = y * max.y;
    const z0 = z * min.z;
    const z1 = z * max.z;
    const box = at * BOX + axis;
    this.#boxes[box] = origin + Math.min(x0, x1) + Math.min(y0, y1) + Math.min(z0, z1);
    this.#boxes[box + 3] = origin + Math.max(x0, x1) + Math.max(y0, y1) + Math.max(z0, z1);
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
