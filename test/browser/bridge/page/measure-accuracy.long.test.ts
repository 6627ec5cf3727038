import { expect } from 'chai';
import type { LevelMeasurement } from '../../../../elements/index.js';
import '../../console.js';
import { open, openText, worldIn, type PageWindow } from '../../page.js';
import { nextFrame, until } from '../../scene.js';
import type { World } from '../../inside.js';

const JOB = { seconds: 0.25 };

/** Poses of all bodies, to the last bit. */
const bits = (world: World): string => JSON.stringify([...world.bodies].map((body) => body.pose()));

/** What a measurement might change; what frames cost goes on. */
function noticed(world: World): unknown {
  const { ms: _, ...counts } = world.stats;
  return { bits: bits(world), counts, level: world.accuracy, problems: world.problems.length };
}

/** Measures a world that stands still, and sees that it still does. */
async function measured(world: World): Promise<LevelMeasurement[]> {
  world.paused = true;
  world.reset();
  world.advance(0.25);
  const before = noticed(world);
  const rows = await world.measureAccuracy(JOB);
  expect(noticed(world)).to.deep.equal(before);
  return rows;
}

const errors = (rows: LevelMeasurement[]): string => JSON.stringify(rows.map(({ error }) => error));

const MODULE = `<!doctype html>
  <script src="/node_modules/x3dom/x3dom.js"></script>
  <script type="module" src="/dist/x3d-physics.js"></script>
  <x3d width="300px" height="200px"><scene>
    <x3d-rigid-body-collection id="collection"><x3d-rigid-body position="0 5 0"></x3d-rigid-body></x3d-rigid-body-collection>
  </scene></x3d>`;

async function worldOfModule(page: PageWindow): Promise<World> {
  const body = page.document.querySelector('x3d-rigid-body') as unknown as { world?: World };
  await until(() => body.world !== undefined);
  return body.world!.ready;
}

describe('measureAccuracy in a page', () => {
  it('works in a worker beside the classic script, in HTML and XHTML', async () => {
    const seen: string[] = [];
    for (const path of ['classic.html', 'classic.xhtml']) {
      const rows = await measured(await worldIn(await open(path)));
      expect(rows.map(({ level }) => level)).to.deep.equal([
        'game',
        'standard',
        'fine',
        'precise',
        'reference',
      ]);
      for (const { inWorker, msPerSecond } of rows) {
        expect(inWorker, path).to.equal(true);
        expect(msPerSecond).to.be.above(0);
      }
      seen.push(errors(rows));
    }
    expect(seen[1]).to.equal(seen[0]);
  });

  it('works in a worker of the module build', async () => {
    const [row] = await measured(await worldOfModule(await openText(MODULE)));
    expect(row!.inWorker).to.equal(true);
    expect(row!.error.position).to.be.above(0);
  });

  it('works in a worker with particles that push', async () => {
    const sand = `<x3d-particle-system pushes="true" collides="true">
        <x3d-point-emitter position="0 9 0" direction="0 -1 0" speed="20" mass="0.1"></x3d-point-emitter>
      </x3d-particle-system>`;
    const world = await worldOfModule(
      await openText(MODULE.replace('</scene>', `${sand}</scene>`)),
    );
    await until(() => world.effects.some(({ name, active }) => name === 'particles' && active));
    const [row] = await measured(world);
    expect(row!.inWorker).to.equal(true);
    expect(world.problems).to.deep.equal([]);
  });

  it('works in slices where the page allows no workers, and lets frames through', async () => {
    const page = await open('no-workers.html');
    const world = await worldIn(page);
    let [frames, running] = [0, true];
    const count = async (): Promise<void> => {
      for (; running; frames++) await nextFrame();
    };
    const counted = count();
    const rows = await measured(world);
    running = false;
    await counted;
    expect(rows.every(({ inWorker }) => !inWorker)).to.equal(true);
    expect(frames).to.be.above(3);
  });

  it('names what acts from outside by its elements', async () => {
    const page = await open('classic.html');
    const world = await worldIn(page);
    const ball = page.document.querySelector('[def=ball]')!;
    ball.addEventListener('collisionstart', () => {});
    world.paused = true;
    const [row] = await world.measureAccuracy({ seconds: 0.1, levels: ['game'] });
    const [first] = row!.leftOut;
    expect(first!.element).to.equal(ball);
    expect(first!.reason).to.equal('collisionstart listeners');
  });

  it('ends its worker when it is cancelled', async () => {
    const world = await worldIn(await open('classic.html'));
    const stop = new AbortController();
    const measuring = world.measureAccuracy({ seconds: 10, signal: stop.signal });
    stop.abort(new Error('enough'));
    const reason = await measuring.then(
      () => 'measured',
      (error: Error) => error.message,
    );
    expect(reason).to.equal('enough');
  });
});
