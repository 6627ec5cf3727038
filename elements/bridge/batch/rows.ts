import type { Pass, Passes } from './passes.js';
import {
  AFFINE,
  multiplyInto,
  putAffine,
  putNormals,
  putProjected,
  read,
  unread,
  type Rows,
} from './products.js';

/** Of each instance: half of a Box's size, the id that it is picked by, and its colour. */
export const LOOK = 7;

/** What there is of each instance, whatever it is drawn for. */
export interface Placed {
  count: number;
  /** Where each stands in the world. */
  models: Rows;
  looks: Float32Array;
}

/**
 * Vectors of four per instance. All: four columns of its matrix to the picture; size and id. Then in the picture: three
 * columns to the eye and three for normals, beside these the colour. To be picked: three columns to the world.
 */
export const VECTORS: Record<Pass, number> = { shadow: 5, pick: 8, picture: 11 };
const BYTES = 4;
/** WebGL 2 has sixteen attributes: x3dom's own, four at the most, begin at the first. */
export const FIRST_ATTRIBUTE = 16 - VECTORS.picture;

// Scratch: nothing is allocated while bodies move.
const seen: Rows = new Float64Array(AFFINE);

/**
 * What WebGL has of the instances for one pass: what x3dom would hand over with each of them as uniforms. That is worked
 * out where an instance moved, and for all of them where the eye did.
 */
export class InstanceRows {
  readonly #pass: Pass;
  readonly #floats: number;
  #data = new Float32Array(0);
  readonly #view = unread();
  readonly #scene = unread();
  #buffer: WebGLBuffer | null = null;
  /** Bytes that WebGL has room for. */
  #room = 0;
  /** What WebGL does not have as it is now. */
  #from = 0;
  #to = Infinity;

  constructor(pass: Pass) {
    this.#pass = pass;
    this.#floats = 4 * VECTORS[pass];
  }

  note(at: number): void {
    if (at < this.#from) this.#from = at;
    if (at >= this.#to) this.#to = at + 1;
  }

  #noteAll(): void {
    this.#from = 0;
    this.#to = Infinity;
  }

  /** The next draw call takes them. */
  bind(gl: WebGL2RenderingContext, eye: Passes, placed: Placed): void {
    this.#buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    this.#look(eye);
    this.#makeRoom(placed);
    const end = Math.min(this.#to, placed.count);
    for (let at = this.#from; at < end; at++) this.#work(at, placed);
    this.#upload(gl, end);
    for (let i = 0; i < VECTORS[this.#pass]; i++) {
      const at = FIRST_ATTRIBUTE + i;
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 4, gl.FLOAT, false, this.#floats * BYTES, 4 * i * BYTES);
      gl.vertexAttribDivisor(at, 1);
    }
  }

  unbind(gl: WebGL2RenderingContext): void {
    for (let i = 0; i < VECTORS[this.#pass]; i++) {
      gl.disableVertexAttribArray(FIRST_ATTRIBUTE + i);
      gl.vertexAttribDivisor(FIRST_ATTRIBUTE + i, 0);
    }
  }

  #look({ view, scene }: Passes): void {
    if (read(scene!, this.#scene)) this.#noteAll();
    if (this.#pass === 'picture' && read(view!, this.#view)) this.#noteAll();
  }

  #makeRoom({ models }: Placed): void {
    const floats = (models.length / AFFINE) * this.#floats;
    if (this.#data.length === floats) return;
    this.#data = new Float32Array(floats);
    this.#noteAll();
  }

  #work(at: number, { models, looks }: Placed): void {
    const data = this.#data;
    const to = at * this.#floats,
      model = at * AFFINE,
      look = at * LOOK;
    putProjected(this.#scene, models, model, data, to);
    for (let i = 0; i < 4; i++) data[to + 16 + i] = looks[look + i]!;
    if (this.#pass === 'pick') putAffine(models, model, data, to + 20);
    if (this.#pass !== 'picture') return;
    multiplyInto(this.#view, models, model, seen);
    putAffine(seen, 0, data, to + 20);
    putNormals(seen, this.#view[15]!, data, to + 32);
    for (let i = 0; i < 3; i++) data[to + 35 + 4 * i] = looks[look + 4 + i]!;
  }

  #upload(gl: WebGL2RenderingContext, end: number): void {
    const data = this.#data;
    const first = this.#from * this.#floats;
    if (this.#room !== data.byteLength) {
      this.#room = data.byteLength;
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    } else if (this.#from < end)
      gl.bufferSubData(gl.ARRAY_BUFFER, first * BYTES, data, first, end * this.#floats - first);
    this.#from = Infinity;
    this.#to = 0;
  }

  free(gl: WebGL2RenderingContext): void {
    gl.deleteBuffer(this.#buffer);
    this.#buffer = null;
    this.#room = 0;
  }
}
