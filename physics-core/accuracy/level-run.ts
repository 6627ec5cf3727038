import type { Vec3 } from '../fields/types.js';
import { AXES, dot, rotate } from '../base/math.js';
import { deepestOverlap } from '../world/pairs/overlaps.js';
import { jointSolve } from '../effects/joints/effects.js';
import type { BodyNode } from '../nodes/body/body.js';
import { isJoint } from '../nodes/joints/is-joint.js';
import type { JointNode } from '../nodes/joints/joint.js';
import type { World } from '../world/world.js';
import type { Level } from '../dynamics/levels.js';

/** A world that runs at one level, and what is compared of it at the moments where all levels stop. */
export class LevelRun {
  readonly level: Level;
  readonly world: World;
  /** Those that move. */
  readonly bodies: readonly BodyNode[];
  /** x y z of each at this moment. */
  readonly positions: Float64Array;
  /** The widest gap of a joint and the deepest overlap so far, metres. */
  joint = 0;
  penetration = 0;
  /** Energy of motion and of height at the moment before this one, joules: velocities are known around it only now. */
  motion = 0;
  height = 0;
  /** Milliseconds of work for each moment, the present one last. */
  readonly work: number[] = [];
  readonly #joints: readonly JointNode[];
  #heightNow = 0;
  /** Energy of motion of the bodies whose velocity belongs to this moment, and of the others half a step ago. */
  #settled = 0;
  #lag = 0;
  #lagging: BodyNode[] = [];

  constructor(world: World, level: Level) {
    this.world = world;
    this.level = level;
    this.bodies = [...world.bodies].filter((body) => body.movable && !body.isObstacle);
    this.positions = new Float64Array(this.bodies.length * 3);
    this.#joints = [...world.nodes].filter(isJoint);
    this.look(true);
  }

  /** One step of its level. */
  step(): void {
    const start = performance.now();
    this.world.step();
    this.work[this.work.length - 1]! += performance.now() - start;
  }

  /** After the first step beyond a moment: velocities of the middle of steps are known on both sides of it now. */
  lookBack(): void {
    this.motion = this.#settled + (this.#lag + motionOf(this.#lagging)) / 2;
    this.height = this.#heightNow;
  }

  /** At a moment where all levels stop. `early`: gaps and overlaps may still be those it began with. */
  look(early = false): void {
    const joints = this.world.registry.find(jointSolve);
    this.bodies.forEach((body, i) => this.positions.set(body.pose().p, 3 * i));
    this.#lagging = this.bodies.filter((body) => joints !== undefined && joints.lastStep(body) > 0);
    this.#lag = motionOf(this.#lagging);
    this.#settled = motionOf(this.bodies) - this.#lag;
    this.#heightNow = this.bodies.reduce((sum, body) => sum + heightOf(body), 0);
    if (early) return;
    for (const joint of this.#joints) this.joint = Math.max(this.joint, gapOf(joint));
    this.penetration = Math.max(this.penetration, deepestOverlap(this.world));
  }
}

/** Kinetic energy, joules. */
const motionOf = (bodies: readonly BodyNode[]): number =>
  bodies.reduce((sum, body) => sum + motionOfBody(body), 0);

function motionOfBody(body: BodyNode): number {
  const { mass, moments } = body.mass;
  const [x, y, z, wx, wy, wz] = body.world.bodies.velocityOf(body);
  const spin: Vec3 = [wx!, wy!, wz!];
  const { q } = body.pose();
  const turning = AXES.reduce((sum, axis, i) => {
    const along = rotate(q, rotate(body.centerOfMass.q, axis));
    return sum + moments[i]! * dot(along, spin) ** 2;
  }, 0);
  return (mass * (x! ** 2 + y! ** 2 + z! ** 2) + turning) / 2;
}

/** Energy of height, joules, above the origin. */
const heightOf = (body: BodyNode): number =>
  -body.mass.mass * dot(body.gravity, body.centerOfMassWorld());

/** How far the bodies of a joint are apart where it holds them together, metres. */
function gapOf(joint: JointNode): number {
  let sum = 0;
  for (const row of joint.lockedRows) if (row < 3) sum += joint.valueOf(row) ** 2;
  return Math.sqrt(sum);
}
