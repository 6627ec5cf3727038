/** @jsxImportSource preact */
import type { JSX } from 'preact';
import { useRef } from 'preact/hooks';
import type { X3DRigidBodyElement } from 'x3d-physics';
import 'x3d-physics/preact';

export const body = <x3d-rigid-body mass={2} oncollisionstart={({ detail }) => detail.other} />;
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;
// @ts-expect-error A mass is no list.
export const heavy = <x3d-rigid-body mass={[2]} />;
// @ts-expect-error A body has no stops.
export const limit = <x3d-rigid-body onjointlimit={() => {}} />;

export function Scene(): JSX.Element {
  const ref = useRef<X3DRigidBodyElement>(null);
  return (
    <x3d width="600px" class="scene">
      <scene>
        <x3d-rigid-body
          ref={ref}
          key="upper"
          def="upper"
          fixed
          title="The upper one"
          style={{ color: 'red' }}
          class="body"
          id="upper"
          onClick={() => ref.current?.applyImpulse([0, 1, 0])}
          aria-label="upper"
          data-testid="upper"
        />
        <x3d-ball-joint body1="upper" anchorPoint={[0, 3, 0]} />
        <transform id="ball" translation={[0, 1, 0]}>
          <shape>
            <appearance>
              <material diffuseColor="1 0 0" emissivecolor="0 0 0" />
            </appearance>
            <box size="1 1 1" />
          </shape>
        </transform>
      </scene>
    </x3d>
  );
}

// @ts-expect-error The element has no such method.
export const wrong = <x3d-rigid-body ref={(element) => element?.jump()} />;
// @ts-expect-error A material has no such field.
export const paint = <material colour="1 0 0" />;
