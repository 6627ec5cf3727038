import { expect } from 'chai';
import {
  deformableTags,
  particleTags,
  ropeTags,
  waterTags,
} from '../../../../elements/bridge/index.js';
import { waveChunk } from '../../../../physics-core/effects/water/effects.js';
import { allTypes } from '../../../../physics-core/all-types.js';
import { codecs, type NodeType } from '../../../../physics-core/inside.js';
import { contentOf } from '../../particle-sources.js';
import { attributeOf, kebab, sample, written } from '../../samples.js';
import { claim } from '../../console.js';
import { show } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';

// Every tag, in both spellings, generated over the tables.

const SCENE = `
  <x3d-rigid-body-collection id="c">
    <x3d-rigid-body id="b" position="0 3 0" usegLobalgravity="false"></x3d-rigid-body>
    <x3d-rigid-body id="free" position="9 3 0"></x3d-rigid-body>
    <x3d-collision-collection id="k" def="K" collidables="*" containerfield="collider"></x3d-collision-collection>
  </x3d-rigid-body-collection>
  <x3d-particle-system id="p"></x3d-particle-system>
  <x3d-particle-system id="q"><x3d-point-emitter></x3d-point-emitter></x3d-particle-system>
  <group id="scene"></group>`;

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), particleTags.load(), ropeTags.load(), waterTags.load()]);
await waveChunk.load();

/** Where a node belongs, as a selector in the scene. */
const PARENTS: Record<string, string> = {
  RigidBodyCollection: '#scene',
  CollisionSensor: '#scene',
  ParticleSystem: '#scene',
  // Field by field it encloses nothing, and whether that is told in time is up to who draws: the system has another one.
  VolumeEmitter: '#q',
  CollidableShape: '#b',
  CollidableOffset: '#b',
  CollisionSpace: '#k',
};
const lower = (name: string): string => name.toLowerCase();
const isPart = (name: string): boolean => /Emitter$|PhysicsModel$/.test(name);
const parentOf = ({ name }: NodeType): string => PARENTS[name] ?? (isPart(name) ? '#p' : '#c');

const TRIANGLES =
  '<indexedtriangleset index="0 1 2 0 2 3"><coordinate point="0 9 0 1 9 0 1 9 1 0 9 1"></coordinate></indexedtriangleset>';

/** What it needs to be made, beside its own fields. */
function furnish(element: Element, { name }: NodeType): void {
  if (name.endsWith('Joint')) element.setAttribute('body1', 'b');
  const inside: Record<string, string> = {
    CollidableShape: '<shape><sphere></sphere></shape>',
    CollidableOffset:
      '<x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape>',
    Rope: '<lineset><coordinate point="0 5 0 1 5 0 2 5 0"></coordinate></lineset>',
    Cloth: TRIANGLES,
    SoftBody: '<sphere></sphere>',
    CollisionSensor: '<x3d-collision-collection use="K"></x3d-collision-collection>',
  };
  element.innerHTML = inside[name] ?? contentOf(name);
}

const tags = (type: NodeType): [string, string][] => [
  ['custom', `x3d-${kebab(type.name)}`],
  ['plain', type.name],
];

async function add(type: NodeType, tag: string) {
  const { x3d, world: paused } = await show(SCENE, '#c');
  paused.paused = true;
  paused.step(0);
  const parent = x3d.querySelector(parentOf(type))!;
  const element = document.createElement(tag);
  element.id = 'new';
  furnish(element, type);
  parent.append(element);
  const world = worldOf(element)! as World;
  await world.ready;
  world.paused = true;
  world.step(0);
  return { parent, element, world };
}

/** A motor whose fields are written one by one says which of them turn nothing yet. */
function claimIdle({ name }: NodeType, ...fields: string[]): void {
  if (name === 'MotorJoint') claim(...fields.map((field) => `MotorJoint "new": ${field}`));
}
const ALONE = ['axis1Angle', 'axis2Angle', 'axis2Torque', 'axis3Angle', 'axis3Torque'];

type Asked = { asked(name: string): unknown; type: { name: string } };
const node = (world: World, element: Element): Asked | undefined =>
  world.node(element) as unknown as Asked | undefined;

for (const type of Object.values(allTypes)) {
  // A Contact is handed over by script and lives in no world.
  if (type.name === 'Contact') continue;
  describe(type.name, () => {
    for (const [spelling, tag] of tags(type)) {
      it(`${spelling} tag: comes, goes and comes back at any time`, async () => {
        const { parent, element, world } = await add(type, tag);
        expect(node(world, element)!.type.name).to.equal(type.name);
        element.remove();
        world.step(1);
        expect(node(world, element)).to.equal(undefined);
        parent.append(element);
        const again = worldOf(element)!;
        await again.ready;
        again.step(1);
        expect(node(again, element)!.type.name).to.equal(type.name);
        element.remove();
        again.step(1);
      });

      it(`${spelling} tag: takes every field as an attribute, and the default when it goes`, async () => {
        claimIdle(type, ...ALONE);
        const { element, world } = await add(type, tag);
        for (const [name, field] of written(type)) {
          const value = sample(name, field);
          const codec = codecs[field.type];
          expect(codec.equal(value, field.default), `${name} has another value`).to.equal(false);
          element.setAttribute(attributeOf(name, field), codec.format(value));
          world.step(0);
          expect(node(world, element)!.asked(name), name).to.eql(value);
          element.removeAttribute(attributeOf(name, field));
          world.step(0);
          expect(node(world, element)!.asked(name), name).to.eql(field.default);
        }
      });
    }

    it('is defined as a custom element with every field as a property', async () => {
      const [[, tag]] = tags(type) as [[string, string]];
      claimIdle(type, 'axis1Angle');
      expect(customElements.get(tag)?.name).to.equal(`X3D${type.name}Element`);
      const { element, world } = await add(type, tag);
      const own = element as unknown as Record<string, unknown>;
      for (const [name, field] of written(type)) {
        const value = sample(name, field);
        own[name] = value;
        world.step(0);
        expect(node(world, element)!.asked(name), name).to.eql(value);
        expect(element.getAttribute(attributeOf(name, field)), name).to.equal(null);
      }
      for (const name of Object.keys(type.fields)) expect(name in element, name).to.equal(true);
    });

    it('takes each field by the property in lower case, too, and lists it once', async () => {
      const [[, tag]] = tags(type) as [[string, string]];
      claimIdle(type, 'axis1Angle');
      const { element, world } = await add(type, tag);
      const own = element as unknown as Record<string, unknown>;
      for (const [name, field] of written(type)) {
        const value = sample(name, field);
        own[name.toLowerCase()] = value;
        world.step(0);
        expect(node(world, element)!.asked(name), name).to.eql(value);
      }
      const listed = Object.keys(Object.getPrototypeOf(customElements.get(tag)!.prototype));
      expect(listed).to.include.members(Object.keys(type.fields));
      expect(
        listed.filter((name) => name !== name.toLowerCase()).map(lower),
      ).to.not.include.members(listed.filter((name) => name === name.toLowerCase()));
    });
  });
}
