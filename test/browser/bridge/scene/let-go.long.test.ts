import { executeServerCommand } from '@web/test-runner-commands';
import { expect } from 'chai';
import { worldOf } from '../../../../elements/index.js';
import { drawn, show, wait } from '../../scene.js';

// What has left the page is held by nothing of ours. Only Chromium collects garbage when it is told to.

const inChromium = 'userAgentData' in navigator;

const collectGarbage = (): Promise<unknown> =>
  executeServerCommand('devtools', { method: 'HeapProfiler.collectGarbage', params: {} });

const ball = '<shape><sphere radius="0.5"></sphere></shape>';
const collidable = `<x3d-collidable-shape>${ball}</x3d-collidable-shape>`;

/** Subtrees with nodes of every kind, which name each other and what stays; `i` makes names of their own. */
const SUBTREES: Record<string, (i: number) => string> = {
  'nested Transforms with bodies': (i) => `
    <transform id="outer${i}" translation="0 ${3 * i} 0"><transform def="mid${i}">${ball}
      <transform translation="2 0 0">${ball}<x3d-rigid-body id="inner${i}" draggable-body></x3d-rigid-body></transform>
      <x3d-rigid-body id="body${i}"></x3d-rigid-body></transform></transform>`,
  'a collection with joints, a sensor and a collider': (i) => `
    <group><x3d-rigid-body-collection ${i % 2 ? `shared-world="w${i}"` : ''} debug>
      <x3d-rigid-body def="one${i}">${collidable}</x3d-rigid-body>
      <x3d-rigid-body def="two${i}"><x3d-collidable-offset>${collidable}</x3d-collidable-offset></x3d-rigid-body>
      <x3d-ball-joint body1="one${i}" body2="two${i}"></x3d-ball-joint>
      <x3d-collision-collection def="all${i}" collidables="*" containerfield="collider"></x3d-collision-collection>
    </x3d-rigid-body-collection>
    <x3d-collision-sensor def="sensor${i}"><x3d-collision-collection use="all${i}"></x3d-collision-collection></x3d-collision-sensor>
    <switch def="lamp${i}" whichchoice="0"></switch>
    <route fromnode="sensor${i}" fromfield="isActive" tonode="lamp${i}" tofield="render"></route></group>`,
  'plain tags that name what stays': (i) => `
    <group><RigidBody DEF="plain${i}"><CollidableShape for="there"></CollidableShape></RigidBody>
    <SliderJoint body1="plain${i}" body2="stays"></SliderJoint>
    <transform def="to${i}"></transform>
    <ROUTE fromNode="plain${i}" fromField="position" toNode="to${i}" toField="translation"></ROUTE></group>`,
  'a joint whose body script named': () => `
    <group><x3d-rigid-body>${collidable}</x3d-rigid-body><x3d-ball-joint class="by-script"></x3d-ball-joint></group>`,
  'what lists everything, outside any collection': () => `
    <group><x3d-collision-collection collidables="*"></x3d-collision-collection>${collidable}</group>`,
};

const STAYS = `
  <transform id="there">${ball}</transform>
  <transform translation="0 -3 0"><shape><box></box></shape><x3d-rigid-body id="stays" fixed></x3d-rigid-body></transform>`;

describe('what has left the page', () => {
  for (const [kind, markup] of Object.entries(SUBTREES))
    it(`is held by nothing: ${kind}`, async function () {
      if (!inChromium) return this.skip();
      const { x3d } = await show(STAYS, '#stays');
      const scene = x3d.querySelector('scene')!;
      const gone: WeakRef<Element>[] = [];
      for (let i = 0; i < 8; i++) {
        scene.insertAdjacentHTML('beforeend', markup(i));
        const added = scene.lastElementChild!;
        for (const joint of added.querySelectorAll('.by-script'))
          Object.assign(joint, { body1: x3d.querySelector('#stays') });
        await worldOf(added.querySelector('x3d-rigid-body, RigidBody, x3d-collidable-shape')!)!
          .ready;
        await drawn();
        gone.push(new WeakRef(added));
        added.remove();
        await drawn();
      }
      const held = (): number => gone.filter((each) => each.deref()).length;
      // x3dom holds on to what it drew last. What a collection calls finalizers of is let go by one of the next.
      for (let i = 0; i < 10 && held() > 1; i++) {
        await wait(50);
        await collectGarbage();
      }
      expect(held()).to.be.below(2);
    });
});
