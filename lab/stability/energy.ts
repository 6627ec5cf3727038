import {
  add,
  cross,
  dot,
  length,
  scale,
  subtract,
  type Quaternion,
} from '../../physics-core/base/math.js';
import { isJointed } from '../../physics-core/dynamics/jointed.js';
import type { Vec3, World } from '../../physics-core/inside.js';
import { BodyNode } from '../../physics-core/nodes/body/body.js';
import { axesOf, kineticEnergy } from '../../references/kinetic-energy.js';

/** What moves, at the end of a step. */
interface Moment {
  body: BodyNode;
  /** Of its centre of mass. */
  at: Vec3;
  velocity: Vec3;
  spin: Vec3;
  axes: Quaternion;
}

function momentOf(body: BodyNode): Moment {
  const at = body.centerOfMassWorld();
  const { linear, angular } = body.velocityAtOrigin();
  const velocity = add(linear, cross(angular, subtract(at, body.pose().p)));
  return { body, at, velocity, spin: angular, axes: axesOf(body) };
}

const momentsIn = (world: World): Moment[] =>
  [...world.nodes].flatMap((node) =>
    node instanceof BodyNode && node.movable ? [momentOf(node)] : [],
  );

const mean = (a: Vec3, b: Vec3): Vec3 => scale(add(a, b), 0.5);

/**
 * The velocity of jointed bodies belongs to the middle of the step that was: at a pose it is the mean of the steps before
 * and after.
 */
function moving({ body, velocity, spin, axes }: Moment, next: Moment): number {
  return isJointed(body)
    ? kineticEnergy(body, mean(velocity, next.velocity), mean(spin, next.spin), axes)
    : kineticEnergy(body, velocity, spin, axes);
}

/** Kinetic and potential energy of all that moves, joules, counted from the lowest place, metres. */
export class EnergyWatch {
  readonly #world: World;
  readonly #gravity: Vec3;
  readonly #lowest: number;
  #before: Moment[];
  readonly start: number;

  constructor(world: World, lowest: number) {
    this.#world = world;
    this.#gravity = world.get('gravity') as Vec3;
    this.#lowest = lowest;
    this.#before = momentsIn(world);
    this.start = this.#sum(({ body, velocity, spin, axes }) =>
      kineticEnergy(body, velocity, spin, axes),
    );
  }

  #sum(kinetic: (moment: Moment, i: number) => number): number {
    const ground = length(this.#gravity) * this.#lowest;
    return this.#before.reduce((sum, moment, i) => {
      const height = -dot(this.#gravity, moment.at) - ground;
      return sum + moment.body.mass.mass * height + kinetic(moment, i);
    }, 0);
  }

  /** Of one step ago: to be asked after each step, of bodies that stay the same. */
  look(): number {
    const now = momentsIn(this.#world);
    const energy = this.#sum((moment, i) => moving(moment, now[i]!));
    this.#before = now;
    return energy;
  }
}
