import type { Value } from '../../fields/types.js';
import type { Coordinate } from '../../shapes/geometry.js';
import { EmitterNode } from './emitter-node.js';

const isNumbers = (value: unknown): boolean =>
  ArrayBuffer.isView(value) || (Array.isArray(value) && typeof value.flat()[0] === 'number');

const isCoordinate = (value: unknown): value is { point?: unknown } =>
  typeof value === 'object' && value !== null && 'type' in value && value.type === 'Coordinate';

/** A Coordinate, or the flat list of its numbers, as it is kept. */
function kept(spelling: string, value: unknown): unknown {
  if (spelling !== 'coord') return value;
  if (isNumbers(value)) return { type: 'Mesh', points: value };
  if (!isCoordinate(value)) return value;
  return { type: 'Mesh', ...(value.point !== undefined && { points: value.point }) };
}

/** An emitter that has points. */
export abstract class CoordEmitterNode extends EmitterNode {
  override set(spelling: string, value: unknown, text: unknown = value): void {
    super.set(spelling, kept(spelling, value), text);
  }

  override event(spelling: string, value: unknown): void {
    super.event(spelling, kept(spelling, value));
  }

  override get(spelling: string): Value {
    const value = super.get(spelling);
    if (spelling !== 'coord' || value === null) return value;
    return { type: 'Coordinate', point: [...this.points] } satisfies Coordinate;
  }

  /** Flat xyz, metres. */
  protected get points(): number[] {
    return this.asked<{ points?: number[] } | null>('coord')?.points ?? [];
  }

  protected get index(): number[] {
    return this.asked('coordIndex');
  }
}
