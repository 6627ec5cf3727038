import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { startOf, type Block } from './block.ts';

const blockOf = (block: Block, hit: (id: number) => void) =>
  html`<transform translation=${startOf(block)}>
    <shape>
      <appearance><material diffuseColor=${block.color}></material></appearance>
      <box size="1 1 1"></box>
    </shape>
    <x3d-rigid-body
      id="block-${block.id}"
      .mass=${block.mass}
      draggable-body
      @collisionstart=${() => hit(block.id)}
    ></x3d-rigid-body>
  </transform>`;

const lampOnItsJoint = html`<transform translation="3 7 -2">
    <shape>
      <appearance>
        <material diffuseColor="1 0.9 0.5" emissiveColor="0.5 0.4 0.1"></material>
      </appearance>
      <sphere radius="0.4"></sphere>
    </shape>
    <x3d-rigid-body id="lamp"></x3d-rigid-body>
  </transform>
  <x3d-ball-joint body1="lamp" .anchorPoint=${[0, 7, -2]}></x3d-ball-joint>`;

export const scene = (blocks: Block[], lamp: boolean, hit: (id: number) => void) =>
  html`<x3d>
    <scene>
      <viewpoint position="0 4 14" orientation="1 0 0 -0.15"></viewpoint>
      <navigationinfo headlight="false"></navigationinfo>
      <directionallight
        direction="-0.5 -1 -0.4"
        intensity="0.8"
        ambientIntensity="0.35"
      ></directionallight>
      <directionallight direction="0.6 -0.3 -0.7" intensity="0.3"></directionallight>
      <transform translation="0 -0.5 0">
        <shape>
          <appearance><material diffuseColor="0.55 0.62 0.7"></material></appearance>
          <box size="14 1 6"></box>
        </shape>
        <x3d-rigid-body id="floor" fixed></x3d-rigid-body>
      </transform>
      ${repeat(
        blocks,
        ({ id }) => id,
        (block) => blockOf(block, hit),
      )}
      ${lamp ? lampOnItsJoint : nothing}
    </scene>
  </x3d>`;
