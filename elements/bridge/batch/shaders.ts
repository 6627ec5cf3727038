import { x3dom } from '../x3dom/x3dom.js';
import type { X3DProgram } from '../x3dom/renderer.js';
import type { Pass } from './passes.js';
import { FIRST_ATTRIBUTE, VECTORS } from './rows.js';

// x3dom's own shaders, with the matrices, colour and id of each body from its instance in the place of uniforms. They go
// by the names that x3dom has for them, so that what it reckons with them is the same to the last bit.

/** x3dom writes its shaders otherwise than 1.8.3 does. */
export class OtherShader extends Error {}

/** Three columns, beside which the translation stands. */
const AFFINE =
  'mat4(vec4(batch5.xyz, 0.0), vec4(batch6.xyz, 0.0), vec4(batch7.xyz, 0.0), vec4(batch5.w, batch6.w, batch7.w, 1.0))';
const NORMALS =
  'mat4(vec4(batch8.xyz, 0.0), vec4(batch9.xyz, 0.0), vec4(batch10.xyz, 0.0), vec4(0.0, 0.0, 0.0, 1.0))';

/** Uniforms of the vertex shader that are no longer such, in each pass. */
const MATRICES: Record<Pass, Record<string, string>> = {
  picture: { modelViewMatrix: AFFINE, normalMatrix: NORMALS },
  shadow: {},
  pick: { modelMatrix: AFFINE },
};
const PROJECTED = { modelViewProjectionMatrix: 'mat4(batch0, batch1, batch2, batch3)' };

/** What each pass gives from the vertex to the pixel: name, type, value. */
const HANDED: Record<Pass, [string, string, string][]> = {
  picture: [['diffuseColor', 'vec3', 'vec3(batch8.w, batch9.w, batch10.w)']],
  shadow: [],
  pick: [
    ['highBit', 'float', 'floor(batch4.w / 256.0) / 255.0'],
    ['lowBit', 'float', 'mod(batch4.w, 256.0) / 255.0'],
  ],
};

const attributes = (pass: Pass): string[] =>
  Array.from({ length: VECTORS[pass] }, (_, i) => `batch${i}`);

function replaced(source: string, pattern: RegExp | string, by: string): string {
  if (source.search(pattern) < 0)
    throw new OtherShader(`x3dom writes its shaders otherwise than 1.8.3, without ${pattern}`);
  return source.replace(pattern, by);
}

const isES3 = (source: string): boolean => source.startsWith('#version 300 es');

export function vertexShader(source: string, pass: Pass): string {
  const [into, outOf] = isES3(source) ? ['in', 'flat out'] : ['attribute', 'varying'];
  const declared = [
    ...attributes(pass).map((name) => `${into} vec4 ${name};\n`),
    ...HANDED[pass].map(([name, type]) => `${outOf} ${type} ${name};\n`),
  ].join('');
  const given = HANDED[pass].map(([name, , value]) => `${name} = ${value};\n`).join('');
  let text = replaced(source, /void main\(void\) \{\n/, `${declared}void main(void) {\n${given}`);
  for (const [name, value] of Object.entries({ ...PROJECTED, ...MATRICES[pass] }))
    text = withoutUniform(text, name, value);
  // The size of a Box, in x3dom a part of its corners.
  text = replaced(
    text,
    /vec3 (vertPosition|pos) = (position(\.xyz)?);/,
    'vec3 $1 = $2 * batch4.xyz;',
  );
  // Which eye: there is but one, and its attribute counts instances.
  if (pass !== 'shadow')
    text = replaced(text, /(in|attribute) float eyeIdx;/, 'const float eyeIdx = -1.0;');
  return text;
}

/** Not all shaders light what they draw: only those have normals. */
function withoutUniform(source: string, name: string, value: string): string {
  if (name === 'normalMatrix' && !source.includes(name)) return source;
  return replaced(source, `uniform mat4 ${name};`, `#define ${name} ${value}`);
}

export function fragmentShader(source: string, pass: Pass): string {
  const from = isES3(source) ? 'flat in' : 'varying';
  return HANDED[pass].reduce(
    (text, [name, type]) =>
      replaced(text, new RegExp(`uniform ${type}\\s+${name};`), `${from} ${type} ${name};`),
    source,
  );
}

/** The same program for many instances. */
export function instanced(
  gl: WebGL2RenderingContext,
  { program, shaderID }: X3DProgram,
  pass: Pass,
): X3DProgram {
  const own = gl.createProgram();
  for (const shader of gl.getAttachedShaders(program)!) {
    const source = gl.getShaderSource(shader)!;
    const kind = gl.getShaderParameter(shader, gl.SHADER_TYPE) as number;
    const change = kind === gl.VERTEX_SHADER ? vertexShader : fragmentShader;
    const changed = gl.createShader(kind)!;
    gl.shaderSource(changed, change(source, pass));
    gl.compileShader(changed);
    gl.attachShader(own, changed);
  }
  gl.bindAttribLocation(own, 0, 'position');
  attributes(pass).forEach((name, i) => gl.bindAttribLocation(own, FIRST_ATTRIBUTE + i, name));
  gl.linkProgram(own);
  if (!gl.getProgramParameter(own, gl.LINK_STATUS))
    throw new OtherShader(gl.getProgramInfoLog(own) ?? 'it does not link');
  return x3dom()!.Utils.wrapProgram(gl, own, `${shaderID} batched`);
}
