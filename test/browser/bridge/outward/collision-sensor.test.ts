import { expect } from 'chai';
import { bothSpellings } from '../../forms.js';
import { type Contact, scene, SENSOR, paused } from './contacts.js';

interface Sensor extends Element {
  contacts: Contact[];
  intersections: Element[];
  isActive: boolean;
}

describe('CollisionSensor', () => {
  for (const [spelling, markup] of scene(0.5, SENSOR)) {
    it(`${spelling} tags: says what touches as elements, by event and by value`, async () => {
      const { x3d, world } = await paused(markup);
      const sensor = x3d.querySelector('#sensor') as Sensor;
      const heard: [string, unknown][] = [];
      sensor.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: unknown };
        heard.push([fieldName, value]);
      });
      world.advance(0.5);
      const shapes = ['floorshape', 'ballshape'].map((name) => x3d.querySelector(`[def=${name}]`));
      expect(heard.filter(([name]) => name === 'isActive')).to.eql([['isActive', true]]);
      const lists = heard.filter(([name]) => name === 'intersections').map(([, value]) => value);
      expect(lists.at(-1)).to.have.members(shapes);
      const contacts = heard.filter(([name]) => name === 'contacts').map(([, value]) => value);
      const [contact] = contacts.at(-1) as Contact[];
      expect([contact!.geometry1, contact!.geometry2]).to.have.members(shapes);
      expect(contact!.position[1]).to.be.closeTo(0, 0.01);
      x3d.querySelector('#ball')!.setAttribute('position', '0 5 0');
      world.step(3);
      expect(heard.slice(-3).map(([name, value]) => [name, value])).to.deep.include.members([
        ['isActive', false],
        ['intersections', []],
        ['contacts', []],
      ]);
      if (spelling === 'custom') {
        expect([sensor.isActive, sensor.intersections, sensor.contacts]).to.eql([false, [], []]);
        x3d.querySelector('#ball')!.setAttribute('position', '0 0.5 0');
        world.advance(0.2);
        expect(sensor.isActive).to.equal(true);
        expect(sensor.intersections).to.have.members(shapes);
        expect(sensor.contacts[0]!.depth).to.be.closeTo(0, 0.01);
      }
    });
  }
});

describe('a ROUTE from a CollisionSensor', () => {
  for (const [spelling, markup] of scene(
    0.5,
    `${SENSOR}<ROUTE fromNode="S" fromField="isActive" toNode="FREE" toField="fixed"></ROUTE>`,
  ))
    it(`${spelling} tags: sends each change once, and FALSE where the world begins anew`, async () => {
      const free = bothSpellings(
        '<x3d-rigid-body def="FREE" id="free" position="9 9 0"></x3d-rigid-body>',
      );
      const [, body] = free.find(([name]) => name === spelling)!;
      const { x3d, world } = await paused(`${markup}${body}`);
      const sensor = x3d.querySelector('#sensor')!;
      const sent: unknown[] = [];
      sensor.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: unknown };
        if (fieldName === 'isActive') sent.push(value);
      });
      world.advance(0.2);
      expect(sent).to.eql([true]);
      world.reset();
      expect(sent).to.eql([true, false]);
      world.advance(0.2);
      expect(sent).to.eql([true, false, true]);
    });
});
