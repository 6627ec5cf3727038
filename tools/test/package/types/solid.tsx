/** @jsxImportSource solid-js */
import type { JSX } from 'solid-js';
import type { X3DRigidBodyElement } from 'x3d-physics';
import 'x3d-physics/solid';

export const body = <x3d-rigid-body mass={2} on:collisionstart={({ detail }) => detail.other} />;
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;

export function Scene(): JSX.Element {
  let element!: X3DRigidBodyElement;
  return (
    <x3d width="600px" class="scene">
      <scene>
        <x3d-rigid-body
          ref={element}
          def="upper"
          bool:fixed={true}
          prop:linearVelocity={[0, 1, 0]}
          attr:position="0 3 0"
          title="The upper one"
          style={{ color: 'red' }}
          class="body"
          id="upper"
          onClick={() => element.applyImpulse([0, 1, 0])}
          aria-label="upper"
          data-testid="upper"
        />
        <x3d-ball-joint body1="upper" anchorPoint={[0, 3, 0]} />
        <transform id="ball" translation={[0, 1, 0]}>
          <shape>
            <appearance>
              <material diffuseColor="1 0 0" />
            </appearance>
            <box size="1 1 1" />
          </shape>
        </transform>
      </scene>
    </x3d>
  );
}
// @ts-expect-error A material has no such field.
export const paint = <material colour="1 0 0" />;
