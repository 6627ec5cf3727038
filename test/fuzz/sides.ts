import { createWorld } from '../../physics-core/create.js';
import { hashOf } from '../../physics-core/timeline/hash.js';
import { goAway } from '../core/thread/sides.js';
import { softPlaces } from './numbers.js';
import type { NodePlan, Plan } from './plan.js';
import { Scene } from './scene.js';

/** What a world on another thread can't be asked for at once. */
const AT_ONCE = ['step', 'raycast', 'snapshot', 'restore'];

/** What acts in its very step brings the world back: a fact of its own. */
const acts = ({ act }: Plan['edits'][number]): boolean =>
  'field' in act && act.field === 'set_contacts';

function withoutGiven(node: NodePlan): NodePlan {
  const { set_contacts: _, ...fields } = node.fields;
  return { ...node, fields };
}

/** Steps from one look at both to the next. */
const APART = 10;

/**
 * Plays a plan on this side of a channel and, beside it, with its steps taken on the other: throws where bodies are not
 * in the same places to the bit, or other problems are told of.
 */
export async function playOnBothSides(plan: Plan): Promise<void> {
  const kept = plan.edits
    .filter((edit) => 'step' in edit.when && !AT_ONCE.includes(edit.act.act) && !acts(edit))
    .map(({ when, act }) => ({
      when,
      act: act.act === 'add' ? { ...act, node: withoutGiven(act.node) } : act,
    }));
  const one = { ...plan, wild: true, nodes: plan.nodes.map(withoutGiven), edits: kept };
  const [here, there] = [await begun(one), await begun(one)];
  try {
    const scenes = [new Scene(here, one), new Scene(there, one)] as const;
    // It makes what was added so far: an edit of what is not made yet would say how that begins.
    goAway(there);
    here.flush();
    for (let step = 0; step < plan.steps; step++) {
      for (const scene of scenes) scene.edit(step, kept);
      here.step();
      await there.ask('step');
      if (step % APART === 0 || step === plan.steps - 1) compare(here, there, step);
    }
  } finally {
    here.destroy();
    there.destroy();
  }
}

type World = Awaited<ReturnType<typeof begun>>;

const begun = ({ gravity, level }: Plan) => createWorld({ gravity, accuracy: level });

const told = ({ problems }: World): string =>
  problems
    .map(({ code, attribute }) => `${code} ${attribute ?? ''}`)
    .sort()
    .join();

function compare(here: World, there: World, step: number): void {
  if (hashOf(here) !== hashOf(there)) throw new Error(`at step ${step} it is elsewhere there`);
  const [ours, theirs] = [softPlaces(here), softPlaces(there)];
  if (ours.length !== theirs.length || ours.some((x, i) => !Object.is(x, theirs[i])))
    throw new Error(`at step ${step} what is soft is elsewhere there`);
  if (told(here) !== told(there))
    throw new Error(`at step ${step} is told here: ${told(here)}; there: ${told(there)}`);
}
