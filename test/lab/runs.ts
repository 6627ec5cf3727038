import type { Case, Vec3 } from '../../lab/case.js';
import type { Engine, Setting } from '../../lab/engines/engine.js';
import { engines } from '../../lab/engines/index.js';
import { follow } from '../../lab/run/follow.js';
import type { Row } from '../../lab/run/row.js';

export const engine = (id: string): Engine => engines.find((one) => one.id === id)!;

export const level = (name: string): Setting =>
  engine('ours').settings.find((setting) => setting.level === name)!;

export async function run(which: Case, id: string, setting: Setting = engine(id).settings[0]!) {
  const running = await engine(id).make(which.scene, setting);
  const found = follow(which, running);
  running.destroy();
  return found;
}

export const GRAVITY = 9.81;

export const THROWN: Vec3 = [3, 8, 1];

/** A thrown ball of a size that gives floors a meaning. */
export const thrown: Case = {
  id: 'T1',
  name: 'Thrown ball',
  says: 'A thrown ball, against x = v t + ½ g t².',
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [{ name: 'ball', shape: { type: 'Sphere', radius: 0.1 }, linearVelocity: THROWN }],
  },
  seconds: 2,
  unit: 'm',
  size: 10,
  singlePrecision: 1e-6,
  watch({ position }) {
    let last = 0;
    return {
      look: (t) => {
        const fallen = (GRAVITY / 2) * t ** 2;
        const way = THROWN.map((v) => v * t).with(1, THROWN[1] * t - fallen);
        last = Math.hypot(...position('ball').map((x, i) => x - way[i]!));
      },
      error: () => last,
    };
  },
};

export const row = (ms: number, error: number, of: Partial<Row> = {}): Row =>
  ({ case: 'T1', engine: 'ammo', level: null, ms, error, ...of }) as Row;
