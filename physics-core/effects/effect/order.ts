import type { EffectDescriptor } from './effect.js';

/** Effects in an order in which each comes after those that it names; else as they are listed. */
export function inOrder(listed: readonly EffectDescriptor[]): EffectDescriptor[] {
  const byName = new Map(listed.map((each) => [each.name, each]));
  const ordered: EffectDescriptor[] = [];
  const visit = (effect: EffectDescriptor, below: readonly EffectDescriptor[]): void => {
    if (ordered.includes(effect)) return;
    if (below.includes(effect)) throw new Error(`effects wait for each other: ${effect.name}`);
    for (const name in effect.after) {
      const before = byName.get(name);
      if (!before) throw new Error(`${effect.name} comes after "${name}", which is no effect`);
      visit(before, [...below, effect]);
    }
    ordered.push(effect);
  };
  for (const effect of listed) visit(effect, []);
  return ordered;
}
