// docs/chunks.md, from the files of the module build: what each weighs, and what has a page fetch it.
import { readdirSync, readFileSync } from 'node:fs';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { deformableChunk } from '../../../physics-core/effects/deformables/effects.js';
import { particleSystems as particles } from '../../../physics-core/effects/particles/effects.js';
import { ropeChunk } from '../../../physics-core/effects/soft/effects.js';
import { waters, swimming, waveChunk } from '../../../physics-core/effects/water/effects.js';
import {
  contacts,
  costs,
  drags,
  joints,
  meshes,
  outlines,
  threads,
} from '../../../physics-core/inside.js';

export const PAGE = 'docs/chunks.md';

/** Files by how their names begin, and what has them fetched. */
const FILES: readonly [name: string, causes: string][] = [
  ['x3d-physics.js', 'every page: the entry'],
  ['chunk-page', 'every page: elements, and the bridge to x3dom'],
  ['chunk-core', 'every page: worlds and bodies'],
  ['chunk-ammo.wasm', 'the first physics element: Bullet’s glue'],
  ['ammo.wasm', 'the first physics element: Bullet'],
  ['chunk-contact-code', `${contacts.causes}; debug lines and measurement look at contacts, too`],
  ['chunk-joint-code', joints.causes],
  ['chunk-mesh-code', meshes.causes],
  ['chunk-drag-code', drags.causes],
  [
    'chunk-arithmetic',
    'joints, contacts, hands, particles, a Rope, a Cloth, a SoftBody, the timeline: what they reckon with alike',
  ],
  ['chunk-cost-code', costs.causes],
  ['chunk-particle-code', `${particles.causes}: what moves its particles`],
  [
    'chunk-particle-elements',
    `${particles.causes}, an emitter or a model: their tags, and what draws`,
  ],
  ['chunk-water-code', `${waters.causes}: what floats in it`],
  ['chunk-wave-code', `${waveChunk.causes}: its surface, and what it does to what floats`],
  ['chunk-draw-surface', `${waveChunk.causes}: what draws it`],
  ['chunk-swim-code', `${swimming.causes}: what water does to it`],
  ['chunk-water-elements', `${waters.causes}: its tag`],
  ['chunk-rope-code', `${ropeChunk.causes}: what moves it, and what it is tied to`],
  ['chunk-rope-elements', `${ropeChunk.causes} or a SoftBodyAttachment: their tags`],
  ['chunk-draw-rope', `${ropeChunk.causes} with a Shape: what draws it`],
  [
    'chunk-deformable-code',
    `${deformableChunk.causes}: what moves it, and what it is tied to and touches`,
  ],
  ['chunk-deformable-elements', `${deformableChunk.causes}: their tags`],
  ['chunk-draw-deformable', `${deformableChunk.causes} with a Shape: what draws it`],
  [
    'chunk-own-shapes',
    `${particles.causes}, ${waters.causes}, ${ropeChunk.causes}, ${deformableChunk.causes}: what draws them has this in common`,
  ],
  [
    'chunk-obstacles',
    `${particles.causes}, ${ropeChunk.causes}, ${deformableChunk.causes}: what they meet`,
  ],
  [
    'chunk-silhouettes',
    `${particles.causes}, or ${waters.causes}: what wind and water see of a body`,
  ],
  [
    'chunk-soft-hands',
    `${ropeChunk.causes}, ${deformableChunk.causes}: how they are taken by hand`,
  ],
  ['chunk-hands', 'a body, a rope, a cloth or a soft body that may be dragged'],
  ['chunk-debug-code', outlines.causes],
  ['chunk-faults-code', 'a fault in the markup'],
  ['chunk-advice-code', 'a tag or an attribute that there is not'],
  [
    'chunk-shapes-code',
    'an ElevationGrid, an Extrusion, a set of fans, strips or quads, a Rectangle2D or a Disk2D, where x3dom lacks it',
  ],
  ['chunk-take-over', 'a build of x3dom that has a physics engine of its own'],
  ['chunk-batch-code', 'eight bodies of one geometry, drawn in one call where they look alike'],
  ['chunk-sketch', 'debug of a RigidBodyCollection, or a ghost of the timeline'],
  ['chunk-measure', '`measureAccuracy()`'],
  ['x3d-physics.classic.js', 'the same, and a world with `thread`, for its worker'],
  ['chunk-dense-code', '`world.snapshot()`, `world.record()`'],
  ['chunk-timeline-code', '`world.record()`, `world.importRun()`'],
  ['chunk-copy', 'a second world made of a snapshot: `measureAccuracy()` and the timeline'],
  ['chunk-thread-code', `${threads.causes} of a RigidBodyCollection, \`world.ask()\``],
  ['chunk-refuse', 'the timeline, and worlds in a worker'],
  ['chunk-worker', 'measurement, and worlds in a worker'],
  ['ui/monitor.js', 'an `<x3d-physics-monitor>` in sight'],
  ['ui/chart.js', 'an `<x3d-accuracy-chart>` in sight'],
  ['ui/chunk-styles', 'either of these two'],
  ['chunk-ammo-wasm-as-text', 'an ammo.wasm that can’t be had'],
];

/** Not of the module build, or fetched by who imports them alone. */
const OTHERS = /^(elements\/|core\.js|x3d-physics\.single\.js|types\/)/;

const HEAD = `# Files

A page pays for what stands in it: the first rows come with every page that has physics, the others with the first thing
that calls for them. Where that stands in the markup its files are fetched together with the engine, and the world starts
when they are there. Where it comes later, time stands still until they are (\`waiting-for-effect\`). The classic scripts
have all but the engine and the ui in one file; in Node all of it is there when \`createWorld\` answers.

Kilobytes of 1000 bytes, as a server sends them by gzip, and by Brotli, which is in the package beside each file (\`.br\`).
Written anew by \`npm run write -- chunks\` after a build.

| file | gzip | Brotli | fetched by |
| --- | ---: | ---: | --- |
`;

export interface BuiltFile {
  name: string;
  causes: string;
  bytes: number;
  brotli: number;
}

/** The files of the module build; throws where one is not known here. */
export function builtFiles(dist = 'dist'): BuiltFile[] {
  const names = readdirSync(dist, { recursive: true, encoding: 'utf8' })
    .map((name) => name.replaceAll('\\', '/'))
    .filter((name) => /\.(js|wasm)$/.test(name) && !OTHERS.test(name));
  const strangers = names.filter((name) => !FILES.some(([begin]) => name.startsWith(begin)));
  if (strangers.length > 0)
    throw new Error(`tools/docs/effects/chunks.ts does not know ${strangers}`);
  return FILES.flatMap(([begin, causes]) => {
    const found = names.filter((name) => name.startsWith(begin));
    if (found.length === 0) return [];
    const files = found.map((name) => readFileSync(`${dist}/${name}`));
    const sum = (pack: (file: Buffer) => Buffer): number =>
      files.reduce((bytes, file) => bytes + pack(file).length, 0);
    const name = begin.replace(/-$/, '');
    return [{ name, causes, bytes: sum(gzipSync), brotli: sum(brotliCompressSync) }];
  });
}

const kilobytes = (bytes: number): string => (bytes / 1000).toFixed(bytes < 10_000 ? 1 : 0);

export const chunksPage = (): string =>
  HEAD +
  builtFiles()
    .map(
      ({ name, causes, bytes, brotli }) =>
        `| ${name} | ${kilobytes(bytes)} | ${kilobytes(brotli)} | ${causes} |\n`,
    )
    .join('');
