import type { Body } from '../../dynamics/body.js';
import { Effect, type Numbered } from '../effect/effect.js';

/** An effect that concerns what moved far in the last step: who that was lasts until the next one is over. */
export abstract class FastBodies extends Effect {
  override need(body: Body, reason = 'moves far in a step'): void {
    super.need(body, reason);
  }

  override reset(): void {
    for (const cause of [...this.causes]) this.release(cause);
  }

  /** In the order in which they became so fast. */
  override save(): number[] | undefined {
    return this.active ? [...this.causes].map((cause) => (cause as Body).id) : undefined;
  }

  override load(kept: readonly number[], nodes: Numbered): void {
    this.reset();
    for (const id of kept) {
      const body = nodes.body(id);
      if (body) this.need(body);
    }
  }
}

/** Two bodies of one joint don't collide. */
export function areJoined({ joints }: Body, other: Body): boolean {
  for (const { attached, body1, body2 } of joints)
    if (attached && (body1 === other || body2 === other)) return true;
  return false;
}
