import { expect } from 'chai';
import { position } from '../../scene.js';
import { type Contact, scene, SENSOR, paused } from './contacts.js';

interface Collection extends Element {
  set_contacts: unknown;
  setFieldValue(name: string, value: unknown): void;
}

const ROUTE = '<ROUTE fromNode="S" fromField="contacts" toNode="C" toField="set_contacts"></ROUTE>';

describe('set_contacts', () => {
  for (const [spelling, markup] of scene(0.5, SENSOR + ROUTE))
    it(`${spelling} tags: ROUTEd from a sensor nothing changes`, async () => {
      const { world } = await paused(markup);
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(0.5, 0.01);
    });

  for (const [spelling, markup] of scene(0.5, SENSOR)) {
    it(`${spelling} tags: contacts that page code drops do not push`, async () => {
      const { x3d, world } = await paused(markup);
      const collection = x3d.querySelector('#c') as Collection;
      const sensor = x3d.querySelector('#sensor')!;
      const drop = (event: Event): void => {
        if ((event as unknown as { fieldName: string }).fieldName === 'contacts')
          collection.setFieldValue('set_contacts', []);
      };
      sensor.addEventListener('outputchange', drop);
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.below(-0.3);
    });

    it(`${spelling} tags: what is listened to and not handed back pushes`, async () => {
      const { x3d, world } = await paused(markup);
      x3d.querySelector('#sensor')!.addEventListener('outputchange', () => {});
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.closeTo(0.5, 0.01);
    });

    it(`${spelling} tags: contacts that page code changes act as changed`, async () => {
      const { x3d, world } = await paused(markup);
      const collection = x3d.querySelector('#c') as Collection;
      let given = 0;
      x3d.querySelector('#sensor')!.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: Contact[] };
        if (fieldName !== 'contacts') return;
        given += value.length;
        const changed = value.map((contact) => ({
          ...contact,
          frictionCoefficients: [0.0001, 0.0001],
          bounce: 0,
        }));
        collection.setFieldValue('set_contacts', changed);
      });
      x3d.querySelector('#ball')!.setAttribute('linearvelocity', '1 0 0');
      world.advance(1);
      expect(given).to.be.above(0);
      // Without friction it slides on and does not roll; only in the first step nobody knew of the contact yet.
      const ball = world.node('ball') as unknown as { get(field: string): number[] };
      expect(ball.get('linearVelocity')[0]).to.be.closeTo(1, 0.05);
      expect(Math.abs(ball.get('angularVelocity')[2]!)).to.be.below(0.3);
    });
  }

  it('takes plain objects and Contact elements of the page’s own making', async () => {
    const { x3d, world } = await paused(scene(3)[0]![1]);
    const collection = x3d.querySelector('#c') as Collection;
    const [ball, floor] = ['ballshape', 'floorshape'].map((name) =>
      x3d.querySelector(`[def=${name}]`)!,
    );
    const own = {
      geometry1: ball,
      geometry2: floor,
      position: [0, 2.5, 0],
      contactNormal: [0, 1, 0],
      depth: 0.001,
    };
    const element = Object.assign(document.createElement('x3d-contact'), own);
    for (const given of [own, element]) {
      world.reset();
      const give = (): void => void (collection.set_contacts = [given]);
      x3d.addEventListener('beforestep', give);
      world.advance(0.5);
      x3d.removeEventListener('beforestep', give);
      expect(position(world, 'ball')[1]).to.be.closeTo(3, 0.05);
      world.advance(0.3);
      expect(position(world, 'ball')[1]).to.be.below(2.8);
    }
  });
});
