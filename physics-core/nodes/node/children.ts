import type { ProblemReport } from '../../base/problems.js';
import type { Value } from '../../fields/types.js';
import { isGeometry, type Geometry } from '../../shapes/geometry.js';
import { soundGeometry } from '../../shapes/sound.js';
import { cut, show } from '../../base/show.js';
import { isNodeData, type NodeData } from './node-data.js';
import type { Field } from './table.js';

/** A node, as far as it may be the value of a field. */
export interface Child {
  readonly type: { readonly name: string };
  readonly world: object;
  remove(): void;
}

/** The node whose children these are. */
interface Parent<N extends Child> {
  readonly label: string;
  readonly world: object;
  isNode(item: unknown): item is N;
  /** A node from plain data in a field that takes `types`; undefined: it takes none such. */
  makeChild(data: NodeData, types: readonly string[]): N | undefined;
  report(report: ProblemReport): void;
}

/** Nodes made from plain data given to the fields of a node; they live and die with it. */
export class Children<N extends Child> {
  readonly #parent: Parent<N>;
  /** By field. */
  readonly of = new Map<string, N[]>();

  constructor(parent: Parent<N>) {
    this.#parent = parent;
  }

  /**
   * Plain data in a node field becomes nodes of our own, in the place of those it had; geometry stays data. What the field
   * does not take is reported and left out.
   */
  adopt(name: string, { nodes: types }: Field, value: Value): Value {
    if (!types || value === '*') return value;
    const items = [value].flat();
    const before = this.of.get(name) ?? [];
    for (const child of before) if (!items.includes(child)) child.remove();
    const made = before.filter((child) => items.includes(child));
    const taken: unknown[] = [];
    for (const item of items) {
      const node = this.#take(name, types, item);
      if (node !== undefined) taken.push(node);
      if (this.#parent.isNode(node) && node !== item) made.push(node);
    }
    this.of.set(name, made);
    return Array.isArray(value) ? taken : (taken[0] ?? null);
  }

  #take(name: string, types: readonly string[], item: unknown): unknown {
    if (item === null) return undefined;
    if (this.#parent.isNode(item)) {
      if (types.includes(item.type.name) && item.world === this.#parent.world) return item;
    } else if (isNodeData(item) && !beingMade.has(item) && beingMade.size < DEEPEST) {
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

  #make(data: NodeData, types: readonly string[]): N | undefined {
    // Bare geometry comes by once more, as the shape of the collidable made for it; it holds no nodes.
    if (!isGeometry(data.type)) beingMade.add(data);
    try {
      return this.#parent.makeChild(data, types);
    } finally {
      beingMade.delete(data);
    }
  }

  #refuse(name: string, types: readonly string[], item: unknown): void {
    const parent = this.#parent;
    const stranger = parent.isNode(item) && item.world !== parent.world;
    const why = stranger
      ? 'stands in another world'
      : beingMade.size >= DEEPEST
        ? `stands in ${DEEPEST} others`
        : `is no ${cut(types.join(' or '))}`;
    parent.report({
      code: 'misplaced',
      severity: 'warning',
      attribute: name,
      value: isNodeData(item) ? item.type : item,
      used: 'nothing',
      message: `${parent.label}: ${name}: ${show(item)} ${why}; it is left out`,
    });
  }

  get all(): N[] {
    return [...this.of.values()].flat();
  }

  remove(): void {
    for (const children of this.of.values()) for (const child of children) child.remove();
  }
}

/** Nodes within nodes, as plain data: deeper ones would be too many calls within calls. */
const DEEPEST = 100;

/** Data that holds itself would never be done. */
const beingMade = new Set<object>();
