import { x3dom } from '../x3dom/x3dom.js';
import type { X3DProgram } from '../x3dom/renderer.js';
import { FIRST_ATTRIBUTE } from './instances.js';

// x3dom's own shaders, with the place, colour and id of each body from its instance in the place of uniforms.

/** x3dom writes its shaders otherwise than 1.8.3 does. */
export class OtherShader extends Error {}

export type Pass = 'picture' | 'shadow' | 'pick';

const INSTANCE = ['batchX', 'batchY', 'batchZ', 'batchLook'] as const;

/** The inverse of the transpose, times a normal: for any scale. */
const PLACING = `
vec3 batchPoint(vec3 point) {
  vec4 p = vec4(point, 1.0);
  return vec3(dot(batchX, p), dot(batchY, p), dot(batchZ, p));
}
vec3 batchNormal(vec3 n) {
  vec3 x = cross(batchY.xyz, batchZ.xyz);
  vec3 y = cross(batchZ.xyz, batchX.xyz);
  vec3 z = cross(batchX.xyz, batchY.xyz);
  float size = dot(batchX.xyz, x);
  return vec3(dot(x, n), dot(y, n), dot(z, n)) / (size == 0.0 ? 1.0 : size);
}
`;

/** What each pass gives from the vertex to the pixel: name, type, value. */
const HANDED: Record<Pass, [string, string, string][]> = {
  picture: [['diffuseColor', 'vec3', 'batchLook.rgb']],
  shadow: [],
  pick: [
    ['highBit', 'float', 'floor(batchLook.a / 256.0) / 255.0'],
    ['lowBit', 'float', 'mod(batchLook.a, 256.0) / 255.0'],
  ],
};

function replaced(source: string, pattern: RegExp | string, by: string): string {
  if (source.search(pattern) < 0)
    throw new OtherShader(`x3dom writes its shaders otherwise than 1.8.3, without ${pattern}`);
  return source.replace(pattern, by);
}

const isES3 = (source: string): boolean => source.startsWith('#version 300 es');

export function vertexShader(source: string, pass: Pass): string {
  const [into, outOf] = isES3(source) ? ['in', 'flat out'] : ['attribute', 'varying'];
  const declared = [
    ...INSTANCE.map((name) => `${into} vec4 ${name};\n`),
    ...HANDED[pass].map(([name, type]) => `${outOf} ${type} ${name};\n`),
  ].join('');
  const given = HANDED[pass].map(([name, , value]) => `${name} = ${value};\n`).join('');
  let text = replaced(
    source,
    /void main\(void\) \{\n/,
    `${declared}${PLACING}void main(void) {\n${given}`,
  );
  text = replaced(
    text,
    /vec3 (vertPosition|pos) = (position(\.xyz)?);/,
    'vec3 $1 = batchPoint($2);',
  );
  if (/(in|attribute) vec3 normal;/.test(text))
    text = replaced(text, 'vec3 vertNormal = normal;', 'vec3 vertNormal = batchNormal(normal);');
  // Which eye: there is but one, and its attribute counts instances.
  if (pass !== 'shadow')
    text = replaced(text, /(in|attribute) float eyeIdx;/, 'const float eyeIdx = -1.0;');
  return text;
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
  INSTANCE.forEach((name, i) => gl.bindAttribLocation(own, FIRST_ATTRIBUTE + i, name));
  gl.linkProgram(own);
  if (!gl.getProgramParameter(own, gl.LINK_STATUS))
    throw new OtherShader(gl.getProgramInfoLog(own) ?? 'it does not link');
  return x3dom()!.Utils.wrapProgram(gl, own, `${shaderID} batched`);
}
