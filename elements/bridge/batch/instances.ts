import type { X3DMatrix } from '../x3dom/x3dom.js';
import type { X3DColor } from '../x3dom/renderer.js';

/** Per instance: three rows of its matrix; red, green, blue and the id that it is picked by. */
const FLOATS = 16;
const VECTORS = 4;
const BYTES = 4;
/** Attributes of the last places, of which WebGL 2 has sixteen: x3dom's own begin at the first. */
export const FIRST_ATTRIBUTE = 12;

/** What tells the bodies of one batch apart, here and in WebGL. */
export class Instances {
  count = 0;
  #data = new Float32Array(8 * FLOATS);
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
      const larger = new Float32Array(2 * this.#data.length);
      larger.set(this.#data);
      this.#data = larger;
    }
    return at;
  }

  /** The last one comes to this place. */
  remove(at: number): void {
    const last = --this.count;
    if (at === last) return;
    this.#data.copyWithin(at * FLOATS, last * FLOATS, (last + 1) * FLOATS);
    this.#note(at);
  }

  #note(at: number): void {
    if (at < this.#from) this.#from = at;
    if (at >= this.#to) this.#to = at + 1;
  }

  place(at: number, m: X3DMatrix): void {
    const data = this.#data;
    let i = at * FLOATS;
    data[i++] = m._00;
    data[i++] = m._01;
    data[i++] = m._02;
    data[i++] = m._03;
    data[i++] = m._10;
    data[i++] = m._11;
    data[i++] = m._12;
    data[i++] = m._13;
    data[i++] = m._20;
    data[i++] = m._21;
    data[i++] = m._22;
    data[i] = m._23;
    this.#note(at);
  }

  /** Of no size, it covers no pixel. */
  hide(at: number): void {
    this.#data.fill(0, at * FLOATS, at * FLOATS + 12);
    this.#note(at);
  }

  name(at: number, id: number): void {
    this.#data[at * FLOATS + 15] = id;
    this.#note(at);
  }

  /** Asked of all in every frame: only another colour is noted. */
  paint(at: number, { r, g, b }: X3DColor): void {
    const data = this.#data;
    const i = at * FLOATS + 12;
    if (data[i] === Math.fround(r) && data[i + 1] === Math.fround(g) && data[i + 2] === Math.fround(b))
      return;
    data[i] = r;
    data[i + 1] = g;
    data[i + 2] = b;
    this.#note(at);
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
    if (this.#room < data.byteLength) {
      this.#room = data.byteLength;
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    } else if (this.#from < this.#to) {
      const [first, end] = [this.#from * FLOATS, Math.min(this.#to, this.count) * FLOATS];
      if (first < end) gl.bufferSubData(gl.ARRAY_BUFFER, first * BYTES, data, first, end - first);
    }
    this.#from = Infinity;
    this.#to = 0;
  }

  free(gl: WebGL2RenderingContext): void {
    gl.deleteBuffer(this.#buffer);
    this.#buffer = null;
    this.#room = 0;
  }
}
