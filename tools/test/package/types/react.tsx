/** @jsxImportSource react */
import { useRef } from 'react';
import type { X3DRigidBodyElement } from 'x3d-physics';
import 'x3d-physics/react';

export const body = <x3d-rigid-body mass={2} oncollisionstart={({ detail }) => detail.other} />;
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;
// @ts-expect-error A mass is no list.
export const heavy = <x3d-rigid-body mass={[2]} />;
// @ts-expect-error A body has no stops.
export const limit = <x3d-rigid-body onjointlimit={() => {}} />;

/** What any tag takes, and a ref that is the element. */
export function Scene(): React.JSX.Element {
  const ref = useRef<X3DRigidBodyElement>(null);
  const hold = (element: X3DRigidBodyElement | null): void => element?.applyImpulse([0, 1, 0]);
  return (
    <x3d width="600px" height="400px" className="scene" id="scene">
      <scene>
        <navigationinfo type='"EXAMINE" "ANY"' />
        <viewpoint position={[0, 3, 12]} fieldofview={0.8} />
        <directionallight direction="0 -1 0" intensity={0.8} />
        <background skycolor="0 0 0" />
        <x3d-rigid-body-collection gravity={[0, -9.8, 0]} onphysicsready={() => {}}>
          <x3d-rigid-body
            ref={ref}
            key="upper"
            def="upper"
            fixed
            title="The upper one"
            style={{ color: 'red' }}
            className="body"
            class="body"
            id="upper"
            onClick={({ currentTarget }) => currentTarget.applyImpulse([0, 1, 0])}
            aria-label="upper"
            data-testid="upper"
          />
          <x3d-rigid-body ref={hold} def="lower" for="ball" position={new Float32Array(3)} />
          <x3d-ball-joint body1="upper" body2="lower" anchorPoint={[0, 3, 0]} />
        </x3d-rigid-body-collection>
        <group>
          <environment gammacorrectiondefault="linear" />
          <inline url='"a.x3d"' />
          <transform id="ball" translation={[0, 1, 0]} onClick={() => {}}>
            <shape>
              <appearance>
                <material diffusecolor="1 0 0" transparency={0.5} />
              </appearance>
              <sphere radius={0.2} />
            </shape>
            <shape>
              <indexedfaceset coordindex="0 1 2 -1" solid="false">
                <coordinate point="0 0 0 1 0 0 0 1 0" />
              </indexedfaceset>
            </shape>
            <shape>
              <box ref={(box) => box?.setAttribute('size', '1 1 1')} />
            </shape>
            <shape>
              {/* @ts-expect-error React would leave it out. */}
              <box size="1 1 1" />
            </shape>
          </transform>
        </group>
      </scene>
    </x3d>
  );
}

// @ts-expect-error The element has no such method.
export const wrong = <x3d-rigid-body ref={(element) => element?.jump()} />;
// @ts-expect-error A material has no such field.
export const paint = <material colour="1 0 0" />;
