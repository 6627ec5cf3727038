import 'x3d-physics/react';
import { startOf, type Block } from './block.ts';

/** React takes `size` for HTML's own, a single number, and leaves out what is none. */
const Box = ({ size }: { size: string }) => (
  <box ref={(element) => element?.setAttribute('size', size)} />
);

interface Props {
  blocks: Block[];
  lamp: boolean;
  onHit: (id: number) => void;
}

export const Scene = ({ blocks, lamp, onHit }: Props) => (
  <x3d>
    <scene>
      <viewpoint position="0 4 14" orientation="1 0 0 -0.15" />
      <navigationinfo headlight="false" />
      <directionallight direction="-0.5 -1 -0.4" intensity="0.8" ambientintensity="0.35" />
      <directionallight direction="0.6 -0.3 -0.7" intensity="0.3" />
      <transform translation="0 -0.5 0">
        <shape>
          <appearance>
            <material diffusecolor="0.55 0.62 0.7" />
          </appearance>
          <Box size="14 1 6" />
        </shape>
        <x3d-rigid-body id="floor" fixed />
      </transform>
      {blocks.map((block) => (
        <transform key={block.id} translation={startOf(block)}>
          <shape>
            <appearance>
              <material diffusecolor={block.color} />
            </appearance>
            <Box size="1 1 1" />
          </shape>
          <x3d-rigid-body
            id={`block-${block.id}`}
            mass={block.mass}
            draggableBody
            oncollisionstart={() => onHit(block.id)}
          />
        </transform>
      ))}
      {lamp && (
        <>
          <transform translation="3 7 -2">
            <shape>
              <appearance>
                <material diffusecolor="1 0.9 0.5" emissivecolor="0.5 0.4 0.1" />
              </appearance>
              <sphere radius="0.4" />
            </shape>
            <x3d-rigid-body id="lamp" />
          </transform>
          <x3d-ball-joint body1="lamp" anchorPoint={[0, 7, -2]} />
        </>
      )}
    </scene>
  </x3d>
);
