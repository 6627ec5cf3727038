'use client';

import { useState } from 'react';
import 'x3d-physics';
import 'x3d-physics/react';

/** A scene that the server writes: every value is a text, as an attribute is. */
export function Served() {
  const [mass, setMass] = useState(2);
  return (
    <>
      <h1>Written by the server</h1>
      <p>A ball on a joint. The browser takes over the markup that it was sent.</p>
      <main>
        <div className="scene">
          <x3d>
            <scene>
              <viewpoint position="0 4 14" orientation="1 0 0 -0.15" />
              <navigationinfo headlight="false" />
              <directionallight direction="-0.5 -1 -0.4" intensity="0.8" ambientintensity="0.35" />
              <directionallight direction="0.6 -0.3 -0.7" intensity="0.3" />
              <transform translation="0 -0.5 0" scale="7 0.5 3">
                <shape>
                  <appearance>
                    <material diffusecolor="0.55 0.62 0.7" />
                  </appearance>
                  <box />
                </shape>
                <x3d-rigid-body id="floor" fixed="true" />
              </transform>
              <transform translation="3 5 0">
                <shape>
                  <appearance>
                    <material diffusecolor="0.9 0.4 0.2" />
                  </appearance>
                  <sphere radius="0.4" />
                </shape>
                <x3d-rigid-body id="ball" mass={String(mass)} />
              </transform>
              <x3d-ball-joint body1="ball" anchorPoint="0 5 0" />
            </scene>
          </x3d>
        </div>
        <section>
          <button onClick={() => setMass(mass + 1)}>Heavier</button> <output>{mass} kg</output>
        </section>
      </main>
    </>
  );
}
