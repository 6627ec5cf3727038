import { expect } from 'chai';
import { drawn, nextFrame, show, wait } from '../../scene.js';

// A Transform that a body moves has moved on from what its attributes say: what is written into them anew acts,
// attribute by attribute, and what is written as it was does nothing.

const quarter = '0 0 1 1.5708';

type Body = Element & { position: number[]; orientation: number[]; linearVelocity: number[] };

/** A body a second after it was let go at 3 m with 1 m/s to the right, at rest until somebody steps. */
async function fallen(tag = 'transform', placing = 'translation="0 3 0" rotation="0 0 1 0"') {
  const { x3d, world } = await show(
    `<transform id="around"><${tag} id="t" ${placing}><shape><sphere radius="0.5"></sphere></shape>
      <x3d-rigid-body id="b" linearvelocity="1 0 0"></x3d-rigid-body></${tag}></transform>`,
    '#b',
  );
  world.paused = true;
  world.reset();
  world.advance(1);
  await drawn();
  const body = x3d.querySelector('#b') as Body;
  return { x3d, world, body, transform: x3d.querySelector('#t')!, position: body.position };
}

type Fallen = Awaited<ReturnType<typeof fallen>>;

function expectNear(found: number[], wanted: number[]): void {
  wanted.forEach((value, i) => expect(found[i]).to.be.closeTo(value, 1e-3));
}

/** Now, within the task, or a frame later. */
const WHEN: [string, (shown: Fallen) => unknown][] = [
  ['at once', ({ world }) => world.step(0)],
  ['later', () => drawn()],
];

describe('a Transform that a body moves', () => {
  for (const [when, pass] of WHEN) {
    it(`${when}: written as it was, it stays where the body is`, async () => {
      const shown = await fallen();
      const { body, transform, position, world } = shown;
      for (const name of ['translation', 'rotation', 'translation'])
        transform.setAttribute(name, transform.getAttribute(name)!);
      await pass(shown);
      await wait(0);
      expect(body.position).to.eql(position);
      world.step(1);
      await drawn();
      expect(body.position[1]).to.be.below(position[1]!);
      expect(body.linearVelocity[0]).to.be.closeTo(1, 1e-4);
    });

    for (const order of [
      ['translation', 'rotation'],
      ['rotation', 'translation'],
    ])
      it(`${when}: of ${order.join(' and ')} in one task only the new one acts`, async () => {
        const shown = await fallen();
        const { body, transform, position } = shown;
        for (const name of order)
          transform.setAttribute(name, name === 'rotation' ? quarter : '0 3 0');
        await pass(shown);
        expectNear(body.orientation, [0, 0, 1, 1.5708]);
        expectNear(body.position, position);
        await drawn();
        expectNear(body.position, position);
        expectNear(body.orientation, [0, 0, 1, 1.5708]);
      });

    it(`${when}: a new place keeps the rotation that the body has`, async () => {
      const shown = await fallen();
      const { body, transform, world } = shown;
      body.orientation = [0, 0, 1, 1];
      world.step(0);
      await drawn();
      transform.setAttribute('rotation', '0 0 1 0');
      transform.setAttribute('translation', '5 6 7');
      await pass(shown);
      expectNear(body.position, [5, 6, 7]);
      expectNear(body.orientation, [0, 0, 1, 1]);
    });

    it(`${when}: there and back in one task is where it was`, async () => {
      const shown = await fallen();
      const { body, transform, position } = shown;
      transform.setAttribute('translation', '5 6 7');
      transform.setAttribute('translation', '0 3 0');
      await pass(shown);
      await drawn();
      expect(body.position).to.eql(position);
    });
  }

  it('heeds the next translation after another attribute was written as it was', async () => {
    const { body, transform } = await fallen();
    transform.setAttribute('class', 'a');
    await drawn();
    transform.setAttribute('class', 'a');
    await drawn();
    transform.setAttribute('translation', '4 5 6');
    await drawn();
    expectNear(body.position, [4, 5, 6]);
  });

  it('heeds the same words again after others', async () => {
    const { body, transform, world } = await fallen();
    for (const y of [9, 3]) {
      transform.setAttribute('translation', `0 ${y} 0`);
      await drawn();
      expectNear(body.position, [0, y, 0]);
    }
    world.step(12);
    transform.removeAttribute('translation');
    await drawn();
    expectNear(body.position, [0, 0, 0]);
    transform.setAttribute('translation', '1 2 3');
    world.step(0);
    expectNear(body.position, [1, 2, 3]);
  });

  it('moved by script past its attributes, it heeds that', async () => {
    const { body, transform, world } = await fallen();
    const { SFVec3f } = (
      globalThis as unknown as {
        x3dom: { fields: { SFVec3f: new (...xyz: number[]) => object } };
      }
    ).x3dom.fields;
    (transform as unknown as { setFieldValue(name: string, value: object): void }).setFieldValue(
      'translation',
      new SFVec3f(7, 8, 9),
    );
    transform.setAttribute('translation', '0 3 0');
    await nextFrame();
    world.step(0);
    expectNear(body.position, [7, 8, 9]);
  });

  it('a MatrixTransform heeds its matrix at once, and not what it said already', async () => {
    const at = (y: number): string => `1 0 0 0 0 1 0 0 0 0 1 0 0 ${y} 0 1`;
    const { body, transform, position, world } = await fallen(
      'matrixtransform',
      `matrix="${at(3)}"`,
    );
    transform.setAttribute('matrix', at(3));
    await drawn();
    expect(body.position).to.eql(position);
    transform.setAttribute('matrix', at(8));
    world.step(0);
    expectNear(body.position, [0, 8, 0]);
    await drawn();
    expectNear(body.position, [0, 8, 0]);
  });

  it('one around it, written as it was, moves no body; written anew it carries it', async () => {
    const { x3d, body, position, world } = await fallen();
    const around = x3d.querySelector('#around')!;
    around.setAttribute('translation', '1 0 0');
    await drawn();
    expectNear(body.position, [position[0]! + 1, position[1]!, 0]);
    world.step(12);
    const moved = body.position;
    around.setAttribute('translation', '1 0 0');
    around.setAttribute('class', 'a');
    await drawn();
    expect(body.position).to.eql(moved);
    around.setAttribute('translation', '1 0 0');
    around.setAttribute('rotation', '0 1 0 3.14159265');
    await drawn();
    expectNear(body.position, [2 - moved[0]!, moved[1]!, 0]);
  });

  it('in a file with degrees, heeds each of its attributes for itself, by script and within a task too', async () => {
    const { x3d, world } = await show(
      `<unit category="angle" name="degree" conversionfactor="0.017453292519943295"></unit>
      <transform id="t" translation="0 3 0" rotation="0 0 1 90"><shape><sphere radius="0.5"></sphere></shape>
        <x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
      '#b',
    );
    const body = x3d.querySelector('#b') as Body;
    const transform = x3d.querySelector('#t')!;
    world.paused = true;
    world.reset();
    expectNear(body.orientation, [0, 0, 1, 90]);
    world.advance(1);
    await drawn();
    const [, fallenTo] = body.position;
    transform.setAttribute('rotation', '0 0 1 30');
    world.step(0);
    expectNear(body.position, [0, fallenTo!, 0]);
    expectNear(body.orientation, [0, 0, 1, 30]);
    await drawn();
    transform.setAttribute('translation', '4 5 6');
    await drawn();
    expectNear(body.position, [4, 5, 6]);
    expectNear(body.orientation, [0, 0, 1, 30]);
  });
});
