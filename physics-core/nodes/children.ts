import type { Value } from '../fields/types.js';
import { isGeometry, type Geometry } from '../shapes/geometry.js';
import { soundGeometry } from '../shapes/sound.js';
import { cut, show } from '../base/show.js';
import { PhysicsNode } from './node.js';
import type { Field } from './table.js';

/** A plain-data value with a `type`, from which a node is made. */
export interface NodeData {
  type: string;
  [field: string]: unknown;
}

/** Nodes made from plain data given to the fields of a node; they live and die with it. */
export class Children {
  readonly #parent: PhysicsNode;
  readonly #byField = new Map<string, PhysicsNode[]>();

  constructor(parent: PhysicsNode) {
    this.#parent = parent;
  }

  /**
   * Plain data in a node field becomes nodes of our own, in the place of those it had; geometry stays data. What the field
   * does not take is reported and left out.
   */
  adopt(name: string, { nodes: types }: Field, value: Value): Value {
    if (!types || value === '*') return value;
    const items = [value].flat();
    const before = this.#byField.get(name) ?? [];
    for (const child of before) if (!items.includes(child)) child.remove();
    const made = before.filter((child) => items.includes(child));
    const taken: unknown[] = [];
    for (const item of items) {
      const node = this.#take(name, types, item);
      if (node !== undefined) taken.push(node);
      if (node instanceof PhysicsNode && node !== item) made.push(node);
    }
    this.#byField.set(name, made);
    return Array.isArray(value) ? taken : (taken[0] ?? null);
  }

  #take(name: string, types: readonly string[], item: unknown): unknown {
    if (item === null) return undefined;
    if (item instanceof PhysicsNode) {
      if (types.includes(item.type.name) && item.world === this.#parent.world) return item;
    } else if (isData(item) && !beingMade.has(item)) {
      if (isGeometry(item.type) && types.includes(item.type)) return this.#geometry(name, item);
      const made = this.#make(item, types);
      if (made) return made;
    }
    this.#refuse(name, types, item);
    return undefined;
  }

  /** It stays data, of our own. */
  #geometry(name: string, data: NodeData): Geometry | undefined {
    const { geometry, fault } = soundGeometry(data);
    if (fault === undefined) return geometry;
    this.#parent.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: name,
      value: data.type,
      used: 'nothing',
      message: `${this.#parent.label}: ${name}: ${fault}; it is left out`,
    });
    return undefined;
  }

  #make(data: NodeData, types: readonly string[]): PhysicsNode | undefined {
    // Bare geometry comes by once more, as the shape of the collidable made for it; it holds no nodes.
    if (!isGeometry(data.type)) beingMade.add(data);
    try {
      return this.#parent.world.addData(data, this.#parent, types);
    } finally {
      beingMade.delete(data);
    }
  }

  #refuse(name: string, types: readonly string[], item: unknown): void {
    const parent = this.#parent;
    const stranger = item instanceof PhysicsNode && item.world !== parent.world;
    const why = stranger ? 'stands in another world' : `is no ${cut(types.join(' or '))}`;
    parent.report({
      code: 'misplaced',
      severity: 'warning',
      attribute: name,
      value: isData(item) ? item.type : item,
      used: 'nothing',
      message: `${parent.label}: ${name}: ${show(item)} ${why}; it is left out`,
    });
  }

  get all(): PhysicsNode[] {
    return [...this.#byField.values()].flat();
  }

  remove(): void {
    for (const children of this.#byField.values()) for (const child of children) child.remove();
  }
}

/** Data that holds itself would never be done. */
const beingMade = new Set<object>();

const isData = (item: unknown): item is NodeData =>
  typeof item === 'object' && item !== null && 'type' in item && typeof item.type === 'string';
