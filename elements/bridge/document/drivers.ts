import type { Binding } from '../nodes/binding.js';
import { byPlace } from './order.js';
import type { StandIn } from '../nodes/stand-in.js';
import type { Readers } from '../scopes/readers.js';
import { Sets } from '../base/sets.js';
import { standInOf } from './shortcuts.js';
import { bodyOf } from './structure.js';

/** What a body or collidable stands for: the Transform it moves; where there is none, what its Shapes are in. */
const meantBy = (standIn: StandIn | undefined): Element | undefined =>
  standIn && (standIn.transform ?? standIn.shapes);

/** Which bodies, or collidables of theirs, stand for which Transform: the first in document order moves it. */
export class Drivers {
  readonly #readers: Readers;
  readonly #all = new Sets<Element, Binding>();
  readonly #first = new Map<Element, Binding>();

  constructor(readers: Readers) {
    this.#readers = readers;
  }

  /** Finds out what a body or collidable stands for. */
  update(binding: Binding): void {
    const before = meantBy(binding.standIn);
    binding.standIn = standInOf(binding);
    this.#note(binding, before, meantBy(binding.standIn));
  }

  stop(binding: Binding): void {
    const before = meantBy(binding.standIn);
    binding.standIn = undefined;
    this.#note(binding, before, undefined);
  }

  #note(binding: Binding, before: Element | undefined, after: Element | undefined): void {
    if (before && before !== after) this.#all.delete(before, binding);
    if (after) this.#all.add(after, binding);
    for (const element of new Set([before, after])) if (element) this.#findFirst(element, binding);
  }

  /** Where that is another than before, those that read the Transform hear of it, and those that wait for it. */
  #findFirst(element: Element, binding: Binding): void {
    const all = this.#all.list(element);
    const [first] = all.length > 1 ? all.sort(byPlace) : all;
    if (first === this.#first.get(element)) return;
    if (first) this.#first.set(element, first);
    else this.#first.delete(element);
    for (const other of [...this.#readers.of(element), ...all])
      if (other !== binding) other.dirty();
  }

  of(transform: Element): Binding | undefined {
    return this.#first.get(transform);
  }

  /** The body that moves what `binding` stands for, where that is not the one that `binding` is or is a part of. */
  rivalOf(binding: Binding): Binding | undefined {
    const element = meantBy(binding.standIn);
    const own = element && bodyOf(binding);
    if (!own) return undefined;
    const bodies = this.#all.list(element).sort(byPlace).map(bodyOf);
    const first = bodies.find((body) => body !== undefined);
    return first === own ? undefined : first;
  }
}
