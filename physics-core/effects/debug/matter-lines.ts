import type { Vec3 } from '../../fields/types.js';
import { COLOR } from './colors.js';
import type { LineBuffer } from './line-buffer.js';

/** A rope, a cloth or a soft body. */
export interface Matter {
  /** Where its points are, metres, flat. */
  readonly places: Float64Array;
  /** Three points each; a rope has none. */
  readonly triangles?: Int32Array;
  readonly asleep: boolean;
  readonly source: { readonly settings: { readonly enabled: boolean } };
}

/** By its triangles, which are another list where it has torn. */
const known = new WeakMap<Int32Array, Int32Array>();

/** The links of a rope, or the edges of a surface: each once. */
export function drawMatter(lines: LineBuffer, matter: Matter): void {
  const { places, triangles, asleep, source } = matter;
  const color = !source.settings.enabled ? COLOR.out : asleep ? COLOR.sleeping : COLOR.awake;
  const at = (i: number): Vec3 => [places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!];
  if (!triangles) {
    for (let i = 1; i < places.length / 3; i++) lines.line(at(i - 1), at(i), color);
    return;
  }
  const edges = known.get(triangles) ?? edgesOf(triangles);
  known.set(triangles, edges);
  for (let n = 0; n < edges.length; n += 2) lines.line(at(edges[n]!), at(edges[n + 1]!), color);
}

function edgesOf(triangles: Int32Array): Int32Array {
  const points = triangles.reduce((most, i) => Math.max(most, i), 0) + 1;
  const found = new Set<number>();
  for (let n = 0; n < triangles.length; n++) {
    const a = triangles[n]!;
    const b = triangles[n % 3 === 2 ? n - 2 : n + 1]!;
    found.add(Math.min(a, b) * points + Math.max(a, b));
  }
  return Int32Array.from([...found].flatMap((key) => [Math.floor(key / points), key % points]));
}
