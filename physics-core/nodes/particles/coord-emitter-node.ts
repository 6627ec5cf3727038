import type { Coordinate } from '../../shapes/geometry.js';
import { EmitterNode } from './emitter-node.js';

const isNumbers = (value: unknown): boolean =>
  ArrayBuffer.isView(value) || (Array.isArray(value) && typeof value.flat()[0] === 'number');

/** As for a geometry, the flat list of its numbers may stand for a Coordinate. */
const coordinateOf = (spelling: string, value: unknown): unknown =>
  spelling === 'coord' && isNumbers(value) ? { type: 'Coordinate', point: value } : value;

/** An emitter that has points. */
export abstract class CoordEmitterNode extends EmitterNode {
  override set(spelling: string, value: unknown, text: unknown = value): void {
    super.set(spelling, coordinateOf(spelling, value), text);
  }

  override event(spelling: string, value: unknown): void {
    super.event(spelling, coordinateOf(spelling, value));
  }

  /** Flat xyz, metres. */
  protected get points(): number[] {
    return this.asked<Coordinate | null>('coord')?.point ?? [];
  }

  protected get index(): number[] {
    return this.asked('coordIndex');
  }
}
