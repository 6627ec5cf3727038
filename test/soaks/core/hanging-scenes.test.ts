import { levels } from '../../../physics-core/inside.js';
import {
  above,
  addBody,
  addJoint,
  below,
  box,
  distance,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  world,
  type Body,
} from '../../core/helpers.js';

// The paper's scenes, as long as continuous integration bears.

/** Kinetic energy and that of height where gravity acts, joules. */
function energy(bodies: Body[]): number {
  return bodies.reduce((sum, body) => {
    const { mass, moments } = body.mass;
    const [v, w] = [velocity(body), spin(body)];
    const kinetic =
      (mass * Math.hypot(...v) ** 2) / 2 +
      // All of them are spheres.
      (moments[0] * Math.hypot(...w) ** 2) / 2;
    return sum + kinetic + (body.asked('useGlobalGravity') ? mass * 9.8 * height(body) : 0);
  }, 0);
}

fact(
  'scene 1: a chain of eight balls holds within 0.001 % of a link and gains no energy in 60 s',
  async () => {
    const w = await world({ accuracy: 'standard' });
    const d = Math.SQRT1_2;
    const balls = Array.from({ length: 8 }, (_, i) =>
      addBody(w, {
        position: [i * d, -i * d, 0],
        fixed: i === 0,
        mass: i < 7 ? 0.1 : 2,
        useGlobalGravity: i === 7,
        geometry: [sphere(0.1)],
      }),
    );
    const joints = balls
      .slice(1)
      .map((ball, i) =>
        addJoint(w, 'BallJoint', { body1: balls[i], body2: ball, anchorPoint: [i * d, -i * d, 0] }),
      );
    w.step(0);
    const start = energy(balls.slice(1));
    let [gap, most, lowest] = [0, -Infinity, Infinity];
    for (let i = 0; i < 60 * 120; i++) {
      w.step();
      for (const joint of joints) gap = Math.max(gap, joint.gap);
      most = Math.max(most, energy(balls.slice(1)));
      lowest = Math.min(lowest, height(balls[7]!));
    }
    // 1.9 µm were measured.
    below(gap, 1e-5, 'm, widest gap of a link of 1 m');
    // Of the energy between its start and its lowest place.
    const swing = 2 * 9.8 * 7 * (1 - d);
    below((most - start) / swing, 0.01, 'of the energy of the swing gained');
    below(lowest, -6.5, 'm, it did swing');
  },
);

fact(
  'scene 2: a hull driven by a motor on a ball joint circles, strikes others, and nothing tears',
  async () => {
    const w = await world();
    const tetra = {
      type: 'IndexedFaceSet',
      coord: [0.3, 0.3, 0.3, -0.3, -0.3, 0.3, -0.3, 0.3, -0.3, 0.3, -0.3, -0.3],
      coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
    };
    const pin = addBody(w, { fixed: true, geometry: [sphere(0.1)] });
    const hanging = [1, 2, 3, 4].map((i) =>
      addBody(w, { position: [0, -i, 0], mass: 0.5, geometry: [sphere(0.2)] }),
    );
    const joints = hanging.map((body, i) =>
      addJoint(w, 'BallJoint', {
        body1: hanging[i - 1] ?? pin,
        body2: body,
        anchorPoint: [0, -i, 0],
      }),
    );
    const hull = addBody(w, { position: [2, 0, 0], geometry: [tetra] });
    joints.push(addJoint(w, 'BallJoint', { body1: hull, body2: pin, anchorPoint: [0, 0, 0] }));
    w.add('MotorJoint', { body1: hull, motor1Axis: [0, 0, 1], axis1Torque: 30 });
    let [gap, fastest, struck] = [0, 0, 0];
    for (let i = 0; i < 10 * 120; i++) {
      w.step();
      for (const joint of joints) gap = Math.max(gap, joint.gap);
      fastest = Math.max(fastest, Math.hypot(...velocity(hull)));
      struck = Math.max(struck, ...hanging.map((body) => Math.abs(position(body)[0])));
    }
    above(fastest, 2, 'm/s, the motor drives');
    above(struck, 0.2, 'm, the hull strikes the others');
    // 0.15 mm were measured.
    below(gap, 1e-3, 'm, widest gap');
    below(fastest, 100, 'm/s');
  },
);

fact(
  'every level is near the truth, and a finer one nearer: rod pendulum against RK4',
  async () => {
    // A rod of 1 m and 1 kg held at its end, let go level: θ'' = -(3 g / 2 l) sin θ, θ from the vertical.
    const truth = (t: number): number => {
      let [theta, omega] = [Math.PI / 2, 0];
      const k = -1.5 * 9.8;
      const n = 40_000;
      const h = t / n;
      for (let i = 0; i < n; i++) {
        const f = (a: number, o: number): [number, number] => [o, k * Math.sin(a)];
        const [a1, b1] = f(theta, omega);
        const [a2, b2] = f(theta + (h * a1) / 2, omega + (h * b1) / 2);
        const [a3, b3] = f(theta + (h * a2) / 2, omega + (h * b2) / 2);
        const [a4, b4] = f(theta + h * a3, omega + h * b3);
        theta += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
        omega += (h / 6) * (b1 + 2 * b2 + 2 * b3 + b4);
      }
      return theta;
    };
    const theta = truth(2);
    const expected = [0.5 * Math.sin(theta), -0.5 * Math.cos(theta), 0];
    // Second order in the step, down to what single precision tells apart in 2 s (measured, × 2).
    const bounds = { game: 9e-4, standard: 2.2e-4, fine: 6e-5, precise: 2e-5, reference: 8e-6 };
    for (const { name } of levels) {
      const w = await world({ accuracy: name });
      const rod = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 0.001, 0.001)] });
      addJoint(w, 'SingleAxisHingeJoint', { body1: rod, axis: [0, 0, 1] });
      w.advance(2);
      below(distance(position(rod), expected), bounds[name], `m at ${name}`);
    }
  },
);
