import { expect } from 'chai';
import {
  deformableTags,
  particleTags,
  ropeTags,
  waterTags,
} from '../../../../elements/bridge/index.js';
import { allTypes } from '../../../../physics-core/all-types.js';
import { waveChunk } from '../../../../physics-core/effects/water/effects.js';
import type { Field, NodeType } from '../../../../physics-core/inside.js';
import { attributesOf, contentOf } from '../../particle-sources.js';
import { claim } from '../../console.js';
import { plain } from '../../forms.js';
import { kebab, sample, written } from '../../samples.js';
import { drawn, show, until } from '../../scene.js';
import type { World } from '../../inside.js';

// ROUTEs into and out of every field of every node, generated over the tables.

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), particleTags.load(), ropeTags.load(), waterTags.load()]);
await waveChunk.load();

interface X3DNode {
  _vf: Record<string, unknown>;
  fieldChanged(name: string): void;
  postMessage(name: string, value: unknown): void;
}
const nodeOf = (x3d: Element, name: string): X3DNode =>
  (x3d.querySelector(`[def=${name}]`) as unknown as { _x3domNode: X3DNode })._x3domNode;

/** x3dom's own nodes that send values of a type; what they send stands in their keys. */
const SOURCES: Record<string, [tag: string, output: string]> = {
  SFFloat: ['ScalarInterpolator', 'value_changed'],
  SFVec3f: ['PositionInterpolator', 'value_changed'],
  SFVec2f: ['PositionInterpolator2D', 'value_changed'],
  SFRotation: ['OrientationInterpolator', 'value_changed'],
  MFVec3f: ['CoordinateInterpolator', 'value_changed'],
  SFBool: ['TimeSensor', 'isActive'],
  SFTime: ['TimeSensor', 'cycleTime'],
};

const flat = (value: unknown): string => [value].flat(2).join(' ');

/** Has the source send: interpolators compute it from their keys, a TimeSensor sends what it finds. */
function send(source: X3DNode, [tag, output]: [string, string], value: unknown): void {
  if (tag === 'TimeSensor') return source.postMessage(output, value);
  source._vf.set_fraction = 1;
  source.fieldChanged('set_fraction');
}

/** Collections and what they need, with the node under test as `n`. */
function sceneFor(type: NodeType, inside: string): string {
  const { name } = type;
  const tag = `x3d-${kebab(name)}`;
  const node = (attributes = '', content = ''): string =>
    `<${tag} def="n" ${attributes}>${content}</${tag}>`;
  const shape = '<shape><sphere></sphere></shape>';
  const body = (content = ''): string =>
    `<x3d-rigid-body def="b" useglobalgravity="false">${content}</x3d-rigid-body>`;
  const collection = (content: string): string =>
    `<x3d-rigid-body-collection id="c">${content}</x3d-rigid-body-collection>`;
  const scenes: Record<string, () => string> = {
    RigidBodyCollection: () =>
      `<x3d-rigid-body-collection id="c" def="n"></x3d-rigid-body-collection>`,
    RigidBody: () => collection(node()),
    CollidableShape: () => collection(body(node('', shape))),
    CollidableOffset: () =>
      collection(body(node('', `<x3d-collidable-shape>${shape}</x3d-collidable-shape>`))),
    CollisionCollection: () => collection(node('collidables="*"')),
    CollisionSpace: () =>
      collection(`<x3d-collision-collection>${node()}</x3d-collision-collection>`),
    CollisionSensor: () =>
      `${collection('<x3d-collision-collection def="k" collidables="*"></x3d-collision-collection>')}
       ${node('', '<x3d-collision-collection use="k"></x3d-collision-collection>')}`,
    ParticleSystem: () => collection('') + node(),
    WaterVolume: () => collection(node()),
    Rope: () => collection(node('points="0 5 0 1 5 0"')),
    Cloth: () => collection(node('size="1 1"')),
    SoftBody: () => collection(node('', '<sphere></sphere>')),
    SoftBodyAttachment: () => collection(node()),
  };
  const joint = (): string => collection(`${body()}${node('body1="b"')}`);
  const system = (content: string): string =>
    `${collection('')}<x3d-particle-system>${content}</x3d-particle-system>`;
  const source = attributesOf(name).map(([attribute, text]) => `${attribute}="${text}"`);
  const part = (): string => system(node(source.join(' '), contentOf(name)));
  const rest = /Emitter$|PhysicsModel$/.test(name) ? part : joint;
  return (scenes[name] ?? rest)() + inside;
}

const accepts = (field: Field): boolean =>
  field.access !== 'initializeOnly' && field.type in SOURCES;

for (const type of Object.values(allTypes)) {
  if (type.name === 'Contact') continue;
  const fields = written(type);
  for (const [spelling, form] of [
    ['custom', (markup: string) => markup],
    ['plain', plain],
  ] as const)
    describe(`ROUTEs into ${type.name}, ${spelling} tag`, () => {
      it('act on every field that takes events, by its name and with set_', async () => {
        const routed = fields.filter(([, field]) => accepts(field));
        const inside = routed.map(([name, field], i) => {
          const [tag, output] = SOURCES[field.type]!;
          const value = flat(sample(name, field));
          const keys = tag === 'TimeSensor' ? '' : `key="0 1" keyvalue="${value} ${value}"`;
          return `<${tag} def="s${i}" ${keys}></${tag}>
            <ROUTE fromNode="s${i}" fromField="${output}" toNode="n" toField="${i % 2 ? 'set_' : ''}${name}"></ROUTE>`;
        });
        const { x3d, world } = await show(form(sceneFor(type, inside.join(''))), '#c');
        world.paused = true;
        world.step(0);
        const node = world.node('n') as unknown as { asked(name: string): unknown };
        for (const [i, [name, field]] of routed.entries()) {
          const value = sample(name, field);
          send(nodeOf(x3d, `s${i}`), SOURCES[field.type]!, value);
          const asked = [node.asked(name)].flat(2) as number[];
          const expected = [value].flat(2) as number[];
          expect(asked.length, name).to.equal(expected.length);
          for (const [k, each] of expected.entries())
            if (typeof each === 'number') expect(asked[k], name).to.be.closeTo(each, 1e-6);
            else expect(asked[k], name).to.equal(each);
        }
        // Both fixed and to be dragged: told when these events reach Bullet, at the latest now.
        if (type.name === 'RigidBody') claim('not-draggable');
        // No source sends whole numbers: enabledAxes stays 1.
        if (type.name === 'MotorJoint') claim('idle-motor');
        world.step(0);
      });

      const fixed = fields.filter(([, { access }]) => access === 'initializeOnly');
      if (fixed.length > 0)
        it('are refused by fields that are initializeOnly, and that is said', async () => {
          claim(...fixed.map(() => 'bad-access'));
          const inside = fixed.map(
            ([name]) =>
              `<ROUTE fromNode="s" fromField="value_changed" toNode="n" toField="${name}"></ROUTE>`,
          );
          const source =
            '<PositionInterpolator def="s" key="0 1" keyvalue="1 1 1 1 1 1"></PositionInterpolator>';
          const { x3d, world } = await show(form(sceneFor(type, source + inside.join(''))), '#c');
          world.paused = true;
          world.step(0);
          send(nodeOf(x3d, 's'), SOURCES.SFVec3f!, [1, 1, 1]);
          const node = world.node('n')! as unknown as { asked(name: string): unknown };
          for (const [name, field] of fixed) expect(node.asked(name), name).to.eql(field.default);
          const told = world.problems.map(({ code, attribute }) => [code, attribute]);
          expect(told).to.have.deep.members(fixed.map(([name]) => ['bad-access', name]));
        });
    });
}

/** A while of the world's own time, and what came of it drawn. */
async function later(world: World): Promise<void> {
  const { time } = world;
  await until(() => world.time > time + 0.2);
  await drawn();
}

describe('ROUTEs out of joints', () => {
  const joints = Object.values(allTypes).filter(({ name }) => name.endsWith('Joint'));
  for (const type of joints) {
    const outputs = Object.entries(type.fields as Record<string, Field>)
      .filter(([, { access }]) => access === 'outputOnly')
      .map(([name]) => name);
    for (const asked of ['NONE', 'ALL', outputs[0]!])
      it(`${type.name}: forceOutput ${asked} sends ${asked === 'ALL' ? 'every output' : asked === 'NONE' ? 'nothing' : 'that one only'}`, async () => {
        const anchor = 'anchorPoint' in type.fields ? 'anchorpoint="0 1 0"' : '';
        const scene = sceneFor(type, '').replace(
          'body1="b"',
          `body1="b" forceoutput='"${asked}"' ${anchor}`,
        );
        const { x3d, world } = await show(scene, '#c');
        world.paused = true;
        const heard = new Set<string>();
        const node = x3d.querySelector('[def=n]')!;
        node.addEventListener('outputchange', (event) => {
          const { fieldName } = event as unknown as { fieldName: string };
          if (outputs.includes(fieldName)) heard.add(fieldName);
        });
        world.paused = false;
        await later(world);
        const expected = asked === 'ALL' ? outputs : asked === 'NONE' ? [] : [asked];
        expect([...heard].sort()).to.eql([...expected].sort());
      });
  }

  for (const asked of ['NONE', 'body1AnchorPoint'])
    it(`a ROUTE of an output sends ${asked === 'NONE' ? 'nothing where forceOutput does not ask for it' : 'where it does'}`, async () => {
      const { x3d, world } = await show(
        `<x3d-rigid-body-collection id="c"><x3d-rigid-body def="b" useglobalgravity="false"></x3d-rigid-body>
          <x3d-ball-joint def="n" body1="b" anchorpoint="0 1 0" forceoutput='"${asked}"'></x3d-ball-joint></x3d-rigid-body-collection>
        <Transform def="t"></Transform>
        <ROUTE fromNode="n" fromField="body1AnchorPoint" toNode="t" toField="translation"></ROUTE>`,
        '#c',
      );
      await later(world);
      const { y } = nodeOf(x3d, 't')._vf.translation as { y: number };
      expect(y).to.be.closeTo(asked === 'NONE' ? 0 : 1, 0.01);
    });
});
