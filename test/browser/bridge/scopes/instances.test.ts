import { expect } from 'chai';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, show, until } from '../../scene.js';
import { worldOf } from '../../inside.js';

interface X3DOM {
  fields: { SFVec3f: new (x: number, y: number, z: number) => object };
}

interface Source {
  _x3domNode: { postMessage(field: string, value: object): void };
}

interface Fields {
  getFieldValue(name: string): { x: number; y: number; z: number };
}
const fields = (element: Element): Fields => element as unknown as Fields;

/** The node that an instance is, in the clone of its prototype's body. */
const inside = (instance: Element, name: string): Element =>
  (
    instance as unknown as { _x3domNode: { protoBodyClone: Element } }
  )._x3domNode.protoBodyClone.querySelector(`[def=${name}]`)!;

const declare = (fieldsText: string, body: string): string => `
  <ProtoDeclare name="Thing"><ProtoInterface>${fieldsText}</ProtoInterface><ProtoBody>${body}</ProtoBody></ProtoDeclare>`;
const field = (name: string, type: string, value = ''): string =>
  `<field name="${name}" type="${type}" accessType="inputOutput" value="${value}"></field>`;
const is = (...pairs: [string, string][]): string =>
  `<IS>${pairs.map(([node, proto]) => `<connect nodeField="${node}" protoField="${proto}"></connect>`).join('')}</IS>`;

describe('an instance of a prototype', () => {
  for (const [spelling, markup] of bothSpellings(`
    ${declare(
      field('at', 'SFVec3f', '0 4 0') + field('weight', 'SFFloat', '3'),
      `<x3d-rigid-body def="pb" useglobalgravity="false">${is(['position', 'at'], ['mass', 'weight'])}
         <x3d-collidable-shape><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`,
    )}
    <x3d-rigid-body-collection id="c">
      <ProtoInstance name="Thing" DEF="one"><fieldValue name="at" value="1 2 3"></fieldValue></ProtoInstance>
      <ProtoInstance name="Thing" DEF="two"></ProtoInstance>
    </x3d-rigid-body-collection>
    <transform def="t"></transform><transform def="s"></transform>
    <ROUTE fromNode="one" fromField="at" toNode="t" toField="translation"></ROUTE>
    <ROUTE fromNode="s" fromField="translation_changed" toNode="two" toField="set_at"></ROUTE>`)) {
    it(`${spelling} tags: is a body of the collection it stands in, with the values of its fields`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      const [one, two] = [...x3d.querySelectorAll('thing')].map((each) => inside(each, 'pb'));
      await until(() => world.stats.bodies === 2);
      expect(worldOf(one)).to.equal(world);
      expect(world.node(one)!.get('position')).to.eql([1, 2, 3]);
      expect(world.node(two)!.get('position')).to.eql([0, 4, 0]);
      expect(world.node(one)!.get('mass')).to.equal(3);
      expect((world.node(one)!.get('geometry') as unknown[]).length).to.equal(1);
    });

    it(`${spelling} tags: takes edits and ROUTEs of its fields, and sends them`, async () => {
      const { x3d, world } = await show(markup, '#c');
      await until(() => world.stats.bodies === 2);
      const [first, second] = [...x3d.querySelectorAll('thing')];
      const [one, two] = [inside(first, 'pb'), inside(second, 'pb')];
      first.setAttribute('weight', '5');
      await until(() => world.node(one)!.get('mass') === 5);
      const { fields: values } = (globalThis as unknown as { x3dom: X3DOM }).x3dom;
      const source = x3d.querySelector('[def=s]') as unknown as Source;
      source._x3domNode.postMessage('translation', new values.SFVec3f(7, 8, 9));
      world.node(one)!.set('linearVelocity', [2, 0, 0]);
      await until(() => drawnAt(x3d.querySelector('[def=t]')!)[0] > 1.1);
      await until(() => (world.node(two)!.get('position') as number[])[0] === 7);
      const at = (world.node(one)!.get('position') as number[])[0];
      expect(fields(first).getFieldValue('at').x).to.be.closeTo(at, 0.5);
    });
  }

  for (const [spelling, markup] of bothSpellings(`
    ${declare(
      field('shapes', 'MFNode') + field('hit', 'SFNode'),
      `<x3d-rigid-body-collection def="pc">${is(['collider', 'hit'])}
         <x3d-rigid-body def="pb" position="0 3 0">${is(['geometry', 'shapes'])}</x3d-rigid-body>
         <x3d-rigid-body def="floor" fixed="true"><x3d-collidable-shape def="floorshape"><shape><box size="9 1 9"></box></shape></x3d-collidable-shape></x3d-rigid-body>
       </x3d-rigid-body-collection>`,
    )}
    <ProtoInstance name="Thing" DEF="one">
      <fieldValue name="shapes"><x3d-collidable-shape def="given"><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape></fieldValue>
    </ProtoInstance>
    <x3d-rigid-body id="own"></x3d-rigid-body>`)) {
    it(`${spelling} tags: fields that hold nodes take them from the instance`, async () => {
      const { x3d } = await show(markup, '#own');
      await until(() => x3d.querySelector('thing') !== null);
      const body = inside(x3d.querySelector('thing')!, 'pb');
      const world = worldOf(body)!;
      await world.ready;
      world.paused = true;
      world.reset();
      const [shape] = world.node(body)!.get('geometry') as { host: Element }[];
      expect(shape?.host).to.equal(x3d.querySelector('[def=given]'));
      world.advance(3);
      // Its given sphere of 0.5 m lies on the floor's upper side at 0.5 m.
      expect((world.node(body)!.get('position') as number[])[1]).to.be.closeTo(1, 0.02);
      await drawn();
    });
  }
});
