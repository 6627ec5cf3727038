import { For, Show } from 'solid-js';
import { startOf, type Block } from './block.ts';

interface Props {
  blocks: Block[];
  lamp: boolean;
  onHit: (id: number) => void;
}

export const Scene = (props: Props) => (
  <x3d>
    <scene>
      <viewpoint position="0 4 14" orientation="1 0 0 -0.15" />
      <navigationinfo headlight="false" />
      <directionallight direction="-0.5 -1 -0.4" intensity="0.8" ambientIntensity="0.35" />
      <directionallight direction="0.6 -0.3 -0.7" intensity="0.3" />
      <transform translation="0 -0.5 0">
        <shape>
          <appearance>
            <material diffuseColor="0.55 0.62 0.7" />
          </appearance>
          <box size="14 1 6" />
        </shape>
        <x3d-rigid-body id="floor" fixed />
      </transform>
      <For each={props.blocks}>
        {(block) => (
          <transform translation={startOf(block)}>
            <shape>
              <appearance>
                <material diffuseColor={block.color} />
              </appearance>
              <box size="1 1 1" />
            </shape>
            <x3d-rigid-body
              id={`block-${block.id}`}
              mass={block.mass}
              draggableBody
              on:collisionstart={() => props.onHit(block.id)}
            />
          </transform>
        )}
      </For>
      <Show when={props.lamp}>
        <transform translation="3 7 -2">
          <shape>
            <appearance>
              <material diffuseColor="1 0.9 0.5" emissiveColor="0.5 0.4 0.1" />
            </appearance>
            <sphere radius="0.4" />
          </shape>
          <x3d-rigid-body id="lamp" />
        </transform>
        <x3d-ball-joint body1="lamp" anchorPoint={[0, 7, -2]} />
      </Show>
    </scene>
  </x3d>
);
