import {
  addBody,
  addJoint,
  below,
  box,
  close,
  height,
  position,
  sphere,
  spin,
  velocity,
  world,
  WEIGHTLESS,
} from '../../../helpers.js';
import type { Vec3, World } from '../../../../../physics-core/inside.js';
import type { BodyNode } from '../../../../../physics-core/nodes/body/body.js';
import type { JointNode } from '../../../../../physics-core/nodes/joints/joint.js';
import { RowSystem } from '../../../../../physics-core/solver/joints/row-system.js';
import type { Row } from '../row.js';

/** Knots above a ball, each joined to its neighbours half-way: metres from knot to knot. */
function addNet(w: World, size: number, mesh: number): JointNode[] {
  addBody(w, { fixed: true, geometry: [sphere(0.7)] });
  const joints: JointNode[] = [];
  const knots: BodyNode[] = [];
  for (let n = 0; n < size * size; n++) {
    const [x, z] = [n % size, Math.floor(n / size)].map((i) => (i - (size - 1) / 2) * mesh);
    const knot = addBody(w, { position: [x!, 1.1, z!], mass: 0.1, geometry: [sphere(0.1)] });
    const tie = (other: BodyNode | undefined, at: Vec3): unknown =>
      other &&
      joints.push(addJoint(w, 'BallJoint', { body1: other, body2: knot, anchorPoint: at }));
    tie(n % size ? knots[n - 1] : undefined, [x! - mesh / 2, 1.1, z!]);
    tie(knots[n - size], [x!, 1.1, z! - mesh / 2]);
    knots.push(knot);
  }
  return joints;
}

/** What the direct solution of joints does, beyond what each field of a joint says. */
export const jointSolveRows: Row[] = [
  {
    effect: 'joint solve',
    fact: 'a chain of eight balls, the last twenty times as heavy, swings without gaping',
    run: async () => {
      const w = await world();
      const balls = Array.from({ length: 8 }, (_, i) =>
        addBody(w, { position: [i + 1, 0, 0], mass: i === 7 ? 2 : 0.1, geometry: [sphere(0.1)] }),
      );
      const joints = balls.map((ball, i) =>
        addJoint(w, 'BallJoint', {
          body1: ball,
          body2: balls[i - 1] ?? null,
          anchorPoint: [i, 0, 0],
        }),
      );
      for (let i = 0; i < 120; i++) {
        w.step();
        // Bullet's own iterations let it open by 18 mm; poses of 8 m in single precision.
        for (const joint of joints) below(joint.gap, 4e-6, 'm, gap');
      }
    },
  },
  {
    effect: 'joint solve',
    fact: 'a net that lands at the coarsest level is led on in its step: its matrix is made about once a step',
    run: async () => {
      const w = await world({ accuracy: 'game' });
      const joints = addNet(w, 6, 0.3);
      const { prototype } = RowSystem;
      const solve = Reflect.get(prototype, 'solve') as RowSystem['solve'];
      let matrices = 0;
      prototype.solve = function (component) {
        matrices++;
        return solve.call(this, component);
      };
      try {
        for (let i = 0; i < 90; i++) {
          w.step();
          for (const joint of joints) below(joint.gap, 1e-4, 'm, gap');
        }
      } finally {
        prototype.solve = solve;
      }
      // 225 where all is left to the closing after the step.
      below(matrices, 135, 'matrices');
    },
  },
  {
    effect: 'joint solve',
    fact: 'a joint that a blow opens is whole again before anybody sees it',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const links = [1, 2, 3].map((x) =>
        addBody(w, { position: [x, 0, 0], mass: 0.1, geometry: [sphere(0.2)] }),
      );
      const joints = links.map((link, i) =>
        addJoint(w, 'BallJoint', {
          body1: link,
          body2: links[i - 1] ?? null,
          anchorPoint: [i, 0, 0],
        }),
      );
      const hammer = addBody(w, { position: [2, -1, 0], mass: 50, linearVelocity: [0, 10, 0] });
      for (let i = 0; i < 30; i++) {
        w.step();
        for (const joint of joints) below(joint.gap, 1e-3, 'm, gap');
      }
      below(10 - velocity(hammer)[1], 1, 'm/s, the hammer goes on');
      below(1, velocity(links[1]!)[1], 'm/s, the link was struck');
    },
  },
  {
    effect: 'joint solve',
    fact: 'bodies that an edit tore apart come together, and then stand still',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b] = [addBody(w), addBody(w, { position: [2, 0, 0] })];
      const joint = addJoint(w, 'BallJoint', { body1: a, body2: b, anchorPoint: [1, 0, 0] });
      w.step();
      b.event('position', [2, 1, 0]);
      w.advance(0.5);
      below(joint.gap, 1e-4, 'm, gap');
      close(
        [...velocity(a), ...velocity(b), ...spin(a), ...spin(b)],
        new Array(12).fill(0),
        1e-3,
        'm/s, rad/s',
      );
      below(0.05, Math.hypot(position(a)[1]), 'm, moved by the repair');
    },
  },
  {
    effect: 'joint solve',
    fact: 'a rod that spins about its length, torn off its joint, turns back to it and takes its spin along',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const rod = addBody(w, {
        position: [1, 0, 0],
        geometry: [box(2, 0.1, 0.1)],
        angularVelocity: [20, 0, 0],
      });
      addJoint(w, 'BallJoint', { body1: rod, anchorPoint: [0, 0, 0] });
      w.step();
      rod.event('position', [1, 0.1, 0]);
      w.step();
      below(0.07, position(rod)[1], 'm, turned aside');
      // As much as the rod itself turns would be 1.6.
      below(1, spin(rod)[1], 'rad/s, turned along');
      close(Math.hypot(...spin(rod)), 20, 0.01, 'rad/s in all');
    },
  },
  {
    effect: 'joint solve',
    fact: 'what lies heavily on a light body is held up by its joint, too',
    run: async () => {
      // Directly, and by the iterations of whoever asks for some.
      for (const fields of [{}, { iterations: 10 }]) {
        const w = await world(fields);
        const held = addBody(w, { geometry: [box(1)] });
        addJoint(w, 'SliderJoint', { body1: held, axis: [0, 0, 1] });
        const load = addBody(w, { position: [0, 1, 0], mass: 50, geometry: [box(1)] });
        w.advance(1);
        // Alone, the light one would give way within half a second.
        close(height(load), 1, 0.05, 'm');
      }
    },
  },
];
