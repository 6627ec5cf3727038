import type { Hinge, PageScene, Thing } from '../scene.js';
import { HOOKS, isDrawn, SIZE, STYLE, text, type Library } from './library.js';

const hex = (color: readonly number[]): string =>
  `#${color
    .map((part) =>
      Math.round(part * 255)
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/** What it collides as. */
const shapeOf = ({ shape }: Thing): string =>
  typeof shape === 'number'
    ? `type: sphere; fit: manual; sphereRadius: ${shape}`
    : `type: box; fit: manual; halfExtents: ${text(shape.map((edge) => edge / 2))}`;

const pictureOf = (thing: Thing): string => {
  if (!isDrawn(thing)) return '';
  const { shape, color } = thing;
  const geometry =
    typeof shape === 'number'
      ? `primitive: sphere; radius: ${shape}`
      : `primitive: box; width: ${shape[0]}; height: ${shape[1]}; depth: ${shape[2]}`;
  return ` geometry="${geometry}" material="color: ${hex(color)}"`;
};

/** Anchors are in the frames of its bodies, which stand upright. */
function local({ position, turn = 0 }: Thing, anchor: readonly number[]): string {
  const [x, y, z] = anchor.map((at, i) => at - position[i]!) as [number, number, number];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return text([x * c - z * s, y, x * s + z * c]);
}

const hinge = ({ bodies: [one, other], anchor }: Hinge): string =>
  ` ammo-constraint="type: hinge; target: #${one.name}; pivot: ${local(other, anchor)}; targetPivot: ${local(one, anchor)}; axis: 0 1 0; targetAxis: 0 1 0"`;

function entityOf(thing: Thing, hinges: readonly Hinge[]): string {
  const { name, mass, position, turn = 0, motor, damping = 0 } = thing;
  const body = isDrawn(thing)
    ? `type: dynamic; mass: ${mass}; linearDamping: 0; angularDamping: ${damping}`
    : 'type: static';
  const joint = hinges.filter(({ bodies }) => bodies[1] === thing).map(hinge);
  const turned = motor ? ` turned="${motor}"` : '';
  return `<a-entity id="${name}" position="${text(position)}" rotation="0 ${(turn * 180) / Math.PI} 0"${pictureOf(thing)} ammo-body="${body}" ammo-shape="${shapeOf(thing)}"${joint.join('')}${turned}></a-entity>`;
}

/** A torque about Y before each step; the package has no motor. */
const TURNED = `<script>AFRAME.registerComponent('turned', {
  schema: { type: 'number' },
  tick() { const { body } = this.el; if (body) { this.torque ??= new Ammo.btVector3(0, this.data, 0); body.applyTorque(this.torque); } },
});</script>`;

/** Its own build of Ammo is in no registry; ours lacks one setting, which only spares what stands still. */
const AMMO = `<script src="/node_modules/ammojs-typed/ammo/ammo.wasm.js"></script><script>{
  const load = Ammo;
  Ammo = async () => {
    const ammo = await load.call({}, { locateFile: () => '/node_modules/ammojs-typed/ammo/ammo.wasm.wasm' });
    ammo.btDiscreteDynamicsWorld.prototype.setForceUpdateAllAabbs ??= () => {};
    return ammo;
  };
}</script>`;

const SCRIPTS = [
  '<script src="/node_modules/aframe/dist/aframe-master.min.js"></script>',
  AMMO,
  '<script src="/node_modules/@c-frame/aframe-physics-system/dist/aframe-physics-system.min.js"></script>',
  TURNED,
].join('');

const page = ({ things, hinges, eye, down }: PageScene): string =>
  `<!DOCTYPE html><meta charset="utf-8">${HOOKS('a-frame')}${STYLE}${SCRIPTS}<body>
<a-scene embedded style="width: ${SIZE.width}px; height: ${SIZE.height}px" physics="driver: ammo" vr-mode-ui="enabled: false" loading-screen="enabled: false">
<a-entity position="${text(eye)}" rotation="${down ? -90 : 0} 0 0"><a-camera position="0 0 0" look-controls="enabled: false" wasd-controls="enabled: false"></a-camera></a-entity>
${things.map((thing) => entityOf(thing, hinges)).join('\n')}
</a-scene></body>`;

export const aFrame: Library = {
  id: 'a-frame',
  name: 'A-Frame with Ammo',
  says: 'A-Frame 1.8.0 with @c-frame/aframe-physics-system 4.2.3 as it comes, on our build of Ammo: one step of 1/60 s',
  type: 'text/html; charset=utf-8',
  page,
};
