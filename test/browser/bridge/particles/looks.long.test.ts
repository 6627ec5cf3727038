import { expect } from 'chai';
import type { X3DNode } from '../../../../elements/bridge/x3dom/x3dom.js';
import { drawn } from '../../scene.js';
import { documentOf } from '../batch/pictures.js';
import { lookFrom, Sight, still, WHITE, type Light } from './light.js';

/** Metres from the viewer to what is seen. */
const FAR = 6;
/** Of the particles, metres. */
const [WIDTH, HEIGHT] = [0.6, 0.4];
/** Of a picture: edges between two pixels, which engines share out in their own ways. */
const SHARE = 0.05;
const PIXEL = 1;

/** Five particles, a metre from one to the next, the third at the origin; `along` is as long as 1, `metre` in the file's unit. */
function row(type: string, along: number[], look: string, metre = 1): string {
  const start = along.map((each) => -2.25 * metre * each).join(' ');
  const size = [WIDTH * metre, HEIGHT * metre].join(' ');
  return `<x3d-particle-system id="s" geometrytype="${type}" particlesize="${size}" maxparticles="5" particlelifetime="5" lifetimevariation="0">
     <x3d-point-emitter position="${start}" direction="${along.join(' ')}" speed="${metre}" variation="0"></x3d-point-emitter>${look}
   </x3d-particle-system>`;
}
const SECONDS = 4.25;
const UPWARDS = [0, 1, 0];

const rowOf = (type: string, look = WHITE, along = UPWARDS, beside = '') =>
  still(SECONDS, row(type, along, look) + beside, FAR);

/** The light about each particle, none of which is elsewhere; `reach`: pixels. */
function lights(sight: Sight, places: number[][], reach: number): Light[] {
  const metre = sight.perMetre(FAR);
  const each = places.map(([x, y]) => sight.light([x! * metre, y! * metre], reach));
  const all = each.reduce((sum, light) => sum + light.sum, 0);
  expect(all).to.be.closeTo(sight.light().sum, 0.01 * all);
  expect(places.length).to.equal(5);
  places.forEach(([x, y], i) => {
    expect(each[i]!.middle[0]).to.be.closeTo(x! * metre, PIXEL);
    expect(each[i]!.middle[1]).to.be.closeTo(y! * metre, PIXEL);
  });
  return each;
}

const near = (value: number, expected: number, share = SHARE): void =>
  void expect(value).to.be.closeTo(expected, share * expected);

/** What x3dom has of it. */
const cloudOf = (x3d: Element): X3DNode =>
  documentOf(x3d)._scene._childNodes.find((node) => node._cf.geometry && node._xmlNode === null)!;

/** How low and how high x3dom takes it to be. */
function boundsOf(x3d: Element): number[] {
  const { min, max } = cloudOf(x3d).getVolume() as Record<'min' | 'max', { y: number }>;
  return [min.y, max.y];
}

describe('a picture of particles', () => {
  for (const type of ['QUAD', 'TRIANGLE', 'SPRITE'])
    it(`${type}: each where it is, as large as particleSize, and nothing beside`, async () => {
      const { x3d, places } = await rowOf(type);
      const sight = new Sight(x3d);
      const metre = sight.perMetre(FAR);
      for (const { sum, span } of lights(sight, places, metre / 2)) {
        near(sum, WIDTH * HEIGHT * metre ** 2);
        expect(span[0]).to.be.closeTo(WIDTH * metre, PIXEL);
        expect(span[1]).to.be.closeTo(HEIGHT * metre, PIXEL);
      }
    });

  it('from the side a SPRITE is as wide as before; a QUAD and a TRIANGLE are half as wide, and thin', async () => {
    for (const type of ['QUAD', 'TRIANGLE', 'SPRITE']) {
      const { x3d } = await rowOf(type);
      const before = new Sight(x3d).light().sum;
      await lookFrom(x3d, Math.PI / 3, FAR);
      near(new Sight(x3d).light().sum, type === 'SPRITE' ? before : before / 2);
      await lookFrom(x3d, Math.PI / 2, FAR);
      const { sum } = new Sight(x3d).light();
      if (type === 'SPRITE') near(sum, before);
      else expect(sum).to.be.below(0.01 * before);
    }
  });

  it('LINE: a thin one along the way that each goes, as long as the second number of particleSize', async () => {
    const { x3d, places } = await rowOf('LINE', WHITE, [0.6, 0.8, 0]);
    const sight = new Sight(x3d);
    const metre = sight.perMetre(FAR);
    for (const { sum, span } of lights(sight, places, metre / 2)) {
      expect(span[0]).to.be.closeTo(0.6 * HEIGHT * metre, 2 * PIXEL);
      expect(span[1]).to.be.closeTo(0.8 * HEIGHT * metre, 2 * PIXEL);
      // About a pixel thick.
      expect(sum).to.be.within(0.5 * HEIGHT * metre, 2 * HEIGHT * metre);
    }
  });

  it('POINT: a few pixels each', async () => {
    const { x3d, places } = await rowOf('POINT');
    const sight = new Sight(x3d);
    for (const { sum } of lights(sight, places, 5)) expect(sum).to.be.within(1, 9);
  });

  it('POINT with texture coordinates: it has none, and WebGL refuses nothing', async () => {
    const point = '<texturecoordinate containerfield="texCoord" point="0 0"></texturecoordinate>';
    const { x3d, world } = await rowOf('POINT', WHITE + point);
    world.advance(0.25);
    await drawn();
    expect(documentOf(x3d).ctx.ctx3d.getError()).to.equal(0);
  });

  it('GEOMETRY is lit as any Shape: a ball by the cosine, from the side where the light is', async () => {
    const radius = 0.4;
    const { x3d, places } = await rowOf(
      'GEOMETRY',
      `<appearance><material diffusecolor="1 1 1" ambientintensity="0"></material></appearance><sphere radius="${radius}"></sphere>`,
      UPWARDS,
      '<directionallight direction="1 0 0"></directionallight>',
    );
    const sight = new Sight(x3d);
    const metre = sight.perMetre(FAR);
    expect(places.length).to.equal(5);
    for (const [x, y] of places) {
      const { sum, middle } = sight.light([x! * metre, y! * metre], metre / 2);
      // The integral of cos over the half of the disc that is lit, and its first moment; a ball of corners is a little less.
      near(sum, (2 / 3) * (radius * metre) ** 2, 2 * SHARE);
      expect(middle[0]).to.be.closeTo(((-3 * Math.PI) / 16) * radius * metre, PIXEL);
      expect(middle[1]).to.be.closeTo(y! * metre, PIXEL);
    }
  });

  it('SPRITE: who looks from the side with a light on the head sees them as bright as from before', async () => {
    const matt =
      '<appearance><material diffusecolor="1 1 1" specularcolor="0 0 0"></material></appearance>';
    const { x3d } = await rowOf('SPRITE', matt);
    x3d.querySelector('navigationinfo')!.setAttribute('headlight', 'true');
    for (const turn of [1e-3, Math.PI / 2, Math.PI]) {
      await lookFrom(x3d, turn, FAR);
      const sight = new Sight(x3d);
      near(sight.light().sum, 5 * WIDTH * HEIGHT * sight.perMetre(FAR) ** 2);
    }
  });

  it('what fades is drawn from back to front, from wherever one looks', async () => {
    const { x3d, places } = await rowOf(
      'SPRITE',
      `${WHITE}<colorrgba containerfield="color" color="1 0 0 0.5, 0 1 0 0.5"></colorrgba>`,
      [0, 0, 1],
    );
    x3d.querySelector('#s')!.setAttribute('colorkey', '0 5');
    // The oldest first: it came farthest along z, to who looks, and is the greenest.
    expect(places[0]![2]).to.be.closeTo(2, 1e-6);
    const ages = places.map(([, , z]) => z! + 2.25);
    for (const [turn, nearestLast] of [
      [0, [...ages].reverse()],
      [Math.PI, ages],
    ] as const) {
      await lookFrom(x3d, turn, FAR);
      const expected = nearestLast.reduce(
        ([red, green], age) => [(red! + 1 - age / 5) / 2, (green! + age / 5) / 2],
        [0, 0],
      );
      const [red, green] = new Sight(x3d).at([0, 0]);
      expect(red).to.be.closeTo(expected[0]!, 0.02);
      expect(green).to.be.closeTo(expected[1]!, 0.02);
    }
  });

  it('in a file of centimetres it is the same, and x3dom knows how far they reach', async () => {
    const unit = '<unit category="length" name="cm" conversionfactor="0.01"></unit>';
    for (const type of ['QUAD', 'LINE', 'SPRITE']) {
      const inMetres = new Sight((await rowOf(type)).x3d).light();
      const { x3d } = await still(SECONDS, unit + row(type, UPWARDS, WHITE, 100), 100 * FAR);
      const light = new Sight(x3d).light();
      near(light.sum, inMetres.sum);
      expect(light.span).to.eql(inMetres.span);
      // One that was born a quarter of a second ago, at 2 m below the origin.
      const one = await still(0.25, unit + row(type, UPWARDS, WHITE, 100), 100 * FAR);
      const [low, high] = boundsOf(one.x3d);
      expect(low).to.be.within(-280, -219.999);
      expect(high).to.be.within(-180.001, -120);
    }
  });

  it('a Transform that turns turns a QUAD, in the same Shape', async () => {
    const { x3d } = await still(
      SECONDS,
      `<transform id="t">${row('QUAD', UPWARDS, WHITE)}</transform>`,
      FAR,
    );
    const [cloud, before] = [cloudOf(x3d), new Sight(x3d).light().sum];
    x3d.querySelector('#t')!.setAttribute('rotation', `0 1 0 ${Math.PI / 3}`);
    await drawn();
    near(new Sight(x3d).light().sum, before / 2);
    expect(cloudOf(x3d) === cloud).to.be.true;
  });
});
