// docs/effects.md, from the descriptors of all effects and the classes that they load, and what the lab found them to cost.
// What pages have no words for comes with it.
import '../../../physics-core/index.js';
import { readFileSync } from 'node:fs';
import { allEffects } from '../../../physics-core/effects/all.js';
import type { Effect, EffectDescriptor } from '../../../physics-core/effects/effect/effect.js';
import { createWorld } from '../../../physics-core/create.js';

export const PAGE = 'docs/effects.md';

/** What an effect may do in a step, in the order in which it comes to that. */
const ACTS = [
  'parts',
  'beforeStep',
  'found',
  'contact',
  'solve',
  'solved',
  'settle',
  'afterStep',
  'stepOver',
] as const;

/** What `npm run lab -- effects` measured last. */
interface Numbers {
  machine: string;
  date: string;
  bodies: number;
  pairs: number;
  turn: number;
}

const numbers = JSON.parse(readFileSync('lab/report/effects.json', 'utf8')) as Numbers;

const HEAD = `# Effects

Bullet moves bodies that fall, touch and hang together. Whatever else a scene may ask for is an effect: switched on by
the first node that needs it, off with the last, and not called at all in between. What each costs:

![Effect by effect: milliseconds that it adds to a step, and kilobytes of the file that its code comes in](pictures/effects.svg)

A scene pays for the effects that it calls for, and for nothing else. Each row is one scene of ${numbers.bodies} bodies twice, without
the effect and with it: what that adds to a step, as a median of ${numbers.pairs} interleaved pairs of ${numbers.turn} steps with its 95 %
interval (bootstrap), at \`standard\` with all bodies awake; hollow is what can't be told from nothing. Bars are the files
([all files](chunks.md)) with their code, which come once for all effects in them, as a server sends them (gzip); 0
comes with every page. Impact propagation comes with contact surface and continuous collision, and is in theirs.
${numbers.date}, ${numbers.machine}. Again: \`npm run build\`, \`npm run lab -- effects\` (\`npm run bench\` ends with it) and \`npm run write -- effects\`;
the numbers are in
[lab/report/effects.json](../lab/report/effects.json).

\`world.effects\` tells for each
whether it is on, because of which elements, its milliseconds and calls per step (measured in one step of 17), and the
bytes of the file that its code came in; \`<x3d-physics-monitor>\` shows them.

The table has them in the order in which they are called at each stage of a step. \`parts\` says into how many parts it must
be split; all but \`stepOver\`, which comes when it is over, is called in each of them. \`beforeStep\` is before Bullet's
step. Within it, between its search and its solver, \`found\` comes first, \`contact\` then at each contact point, and
\`solve\` when all are seen; \`solved\` is after the solver, before bodies move. \`settle\` is right after the step, before
anybody reads where it took the bodies, and \`afterStep\` once poses and velocities are read. An effect without a stage
is asked by others, or only told of. What has no file comes with every page.

| effect | on by | acts in | file | after |
| --- | --- | --- | --- | --- |
`;

/** Those of one reason together; "the same" is the reason before it. */
function after({ after: reasons = {} }: EffectDescriptor): string {
  const groups: { names: string[]; why: string }[] = [];
  for (const [name, why] of Object.entries(reasons)) {
    const last = groups.at(-1);
    if (last && (why === 'the same' || why === last.why)) last.names.push(name);
    else groups.push({ names: [name], why });
  }
  return groups.map(({ names, why }) => `*${names.join(', ')}*: ${why}`).join('; ');
}

const acts = (effect: Effect): string =>
  ACTS.filter((stage) => effect[stage])
    .map((stage) => `\`${stage}\``)
    .join(', ');

export async function effectsPage(): Promise<string> {
  const world = await createWorld();
  const rows = allEffects.map((descriptor) =>
    [
      `**${descriptor.name}**`,
      descriptor.causes,
      acts(world.registry.get(descriptor)),
      descriptor.chunk?.name ?? '',
      after(descriptor),
    ]
      .map((cell) => cell.replaceAll('|', '\\|') || '–')
      .join(' | '),
  );
  world.destroy();
  return `${HEAD}${rows.map((row) => `| ${row} |\n`).join('')}`;
}
