import type { Bound } from '../world/threading.js';
import type { World } from '../world/world.js';

const GIVEN = 'set_contacts acts in the very next step';

/** Why what is done to a world keeps it here. */
export const whyHere = (what: unknown): string | undefined =>
  what === 'set_contacts' ? GIVEN : undefined;

export const BEFORE_STEP: Bound = {
  why: 'beforestep is listened to, and what is done then acts in that very step',
};

/** Of the world in the worker: it goes nowhere. */
export const THERE: Bound = { why: 'it runs in a worker' };

/** What keeps a world on the page's own thread. */
export function boundHere(world: World): Bound | undefined {
  if (world.heard('beforestep')) return BEFORE_STEP;
  for (const node of world.nodes)
    if (node.authored('set_contacts')) return { why: GIVEN, host: node.host };
  return world.bound ?? ('Worker' in globalThis ? undefined : { why: 'there are no workers here' });
}

export function reportMain(world: World, { why, host }: Bound): void {
  world.report(
    {
      code: 'thread-main',
      severity: 'info',
      attribute: 'thread',
      value: world.settings.asked('thread'),
      used: 'main',
      message: `its steps are taken on the page's own thread, since ${why}`,
    },
    host ?? world.settings,
  );
}
