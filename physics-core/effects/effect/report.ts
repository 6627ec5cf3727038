import type { Effect, EffectDescriptor } from './effect.js';
import type { Effects } from './effects.js';

/** What `world.effects` shows of an effect. */
export interface EffectReport {
  name: string;
  active: boolean;
  /** What switched it on first, and by what. */
  because: { element: unknown; reason: string } | null;
  /** All that need it now, each once: elements; in the core, nodes. */
  elements: unknown[];
  /** Milliseconds per step, a running mean over one step in 17; what acts once per frame: per frame. */
  ms: number;
  /** Calls per step, in the same steps. Those that see contacts are called for each contact point. */
  calls: number;
  /** The chunk that its code comes in, with that of the others that name it; null: it comes with every page. */
  chunk: string | null;
  /** What was fetched for that chunk, bytes as a server sends them (gzip); 0 before its cause is there, and where all code is one file. */
  bytes: number;
}

/** What one world makes of an effect. */
export function reportOf(descriptor: EffectDescriptor, effects: Effects): EffectReport {
  const { name, chunk } = descriptor;
  const on = effectsBehind(descriptor, effects).filter((effect) => effect.active);
  const first = on[0]?.because;
  const cost = first && effects.find(descriptor)?.cost;
  return {
    name,
    active: on.length > 0,
    because: first ? { element: first.node.host, reason: first.reason } : null,
    elements: [...new Set(on.flatMap(({ causes }) => [...causes].map(({ host }) => host)))],
    ms: cost?.ms ?? 0,
    calls: cost?.calls ?? 0,
    chunk: chunk?.name ?? null,
    bytes: chunk?.bytes ?? 0,
  };
}

/** What it comes and goes with; else itself. */
function effectsBehind(descriptor: EffectDescriptor, effects: Effects): Effect[] {
  if (descriptor.with) return descriptor.with.flatMap((each) => effectsBehind(each, effects));
  const effect = effects.find(descriptor);
  return effect ? [effect] : [];
}
