import { readFileSync } from 'node:fs';
// Particles come with it.
import '../../../physics-core/index.js';
import { fetchGlue, loadAmmo } from '../../../physics-core/engine/ammo.js';
import { Engine } from '../../../physics-core/engine/engine.js';
import { loadEngine } from '../../../physics-core/create.js';
import { World } from '../../../physics-core/inside.js';
import { BodyNode } from '../../../physics-core/nodes/body/body.js';
import { usedWasm } from '../../../tools/build/engine/used-wasm.js';

const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

/** One with a heap of its own. */
async function engineOf(wasm: Uint8Array<ArrayBuffer>): Promise<Engine> {
  const program = await WebAssembly.compile(wasm);
  return new Engine(await loadAmmo(await fetchGlue(), program), { program });
}

/** Ammo, and what pages have of it. With the code of all effects. */
export async function engines(): Promise<[Engine, Engine]> {
  await loadEngine();
  return Promise.all([engineOf(new Uint8Array(readFileSync(WASM))), engineOf(usedWasm())]);
}

export function started(engine: Engine, fields: Record<string, unknown>): World {
  const world = new World({ console: false });
  world.add('RigidBodyCollection', fields);
  world.start(engine);
  return world;
}

/** What there is to tell two runs apart by, to the last bit. */
export const stateOf = (world: World): string =>
  JSON.stringify(
    [...world.nodes]
      .filter((node) => node instanceof BodyNode)
      .map((body) => {
        const { p, q } = body.pose();
        return [p, q, [...world.bodies.velocityOf(body)]];
      }),
  );
