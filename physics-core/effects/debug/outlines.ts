import { makeLineDrawer, type LineDrawer } from '../../engine/line-drawer.js';
import { Owner } from '../../engine/owner.js';
import { kindOf } from '../../engine/shape-kind.js';
import type { Vec3 } from '../../fields/types.js';
import { length, subtract } from '../../base/math.js';
import type { BtShape } from '../../shapes/build.js';
import type { Simulation } from '../../dynamics/simulation.js';

/** Numbers per line. */
const LINE = 6;
/** Lines are told apart when an end differs by more than this, metres. */
const SAME = 1e-6;
/** Bullet marks where a shape begins by three lines along its axes; the first has this much red. */
const MARK = 0.7;

/** The edges of Bullet's shapes, as Bullet's own debug drawing has them, in the frame of the shape. */
export class Outlines {
  readonly #simulation: Simulation;
  readonly #owner: Owner;
  readonly #drawer: LineDrawer;
  /** Lines by shape drawn: of a compound itself, then of each child from the last to the first. */
  #drawn: number[][] = [];

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
    this.#owner = new Owner(simulation.engine.ammo);
    this.#drawer = this.#makeDrawer();
  }

  #makeDrawer(): LineDrawer {
    const { ammo } = this.#simulation.engine;
    return makeLineDrawer(ammo, this.#owner, (from, to, red) => {
      if (red === 1) this.#drawn.at(-1)!.push(...from, ...to);
      else if (red > MARK / 2) this.#drawn.push([]);
    });
  }

  /** Both ends of each edge, x y z, each edge once. */
  of(shape: BtShape): Float32Array {
    this.#draw(shape);
    const shapes = [shape, ...this.#childrenOf(shape).toReversed()];
    const lines = this.#drawn.flatMap((drawn, i) =>
      this.#isHull(shapes[i]) ? this.#hull(drawn) : drawn,
    );
    return edges(lines);
  }

  #childrenOf(shape: BtShape): BtShape[] {
    const { engine } = this.#simulation;
    if (kindOf(engine, shape) !== 'compound') return [];
    const { ammo } = engine;
    const compound = ammo.castObject(shape, ammo.btCompoundShape);
    return Array.from({ length: compound.getNumChildShapes() }, (_, i) =>
      compound.getChildShape(i),
    );
  }

  #isHull(shape: BtShape | undefined): boolean {
    return shape !== undefined && kindOf(this.#simulation.engine, shape) === 'hull';
  }

  #draw(shape: BtShape): void {
    const { scratch } = this.#simulation.engine;
    this.#drawn = [];
    const origin = scratch.transform([0, 0, 0], [0, 0, 0, 1]);
    const { bullet } = this.#simulation.bullet;
    // Only for this call: in a step Bullet would ask it whether bodies may rest.
    bullet.setDebugDrawer(this.#drawer as never);
    bullet.debugDrawObject(origin, shape, scratch.vector(1, 1, 1, 1));
    bullet.setDebugDrawer(null as never);
  }

  /**
   * Bullet joins the points of a hull in the order in which they were added. A copy of the hull with its faces worked out
   * has its edges; to work them out in the shape itself would change how it collides.
   */
  #hull(chain: readonly number[]): number[] {
    const { ammo, scratch } = this.#simulation.engine;
    const owner = new Owner(ammo);
    const points: Vec3[] = [];
    for (let i = 0; i < chain.length; i += LINE)
      points.push([chain[i]!, chain[i + 1]!, chain[i + 2]!]);
    const copy = owner.own(new ammo.btConvexHullShape());
    for (const point of points) copy.addPoint(scratch.vector(...point), point === points.at(-1));
    copy.initializePolyhedralFeatures(0);
    this.#draw(copy);
    owner.dispose();
    return inPlace(this.#drawn[0]!, points);
  }

  dispose(): void {
    this.#owner.dispose();
  }
}

/** Bullet works out faces in whole numbers, ten thousand across the hull: their corners are put where its points are. */
function inPlace(lines: readonly number[], points: readonly Vec3[]): number[] {
  const placed: number[] = [];
  for (let i = 0; i < lines.length; i += 3) {
    const corner: Vec3 = [lines[i]!, lines[i + 1]!, lines[i + 2]!];
    const far = (point: Vec3): number => length(subtract(point, corner));
    placed.push(...points.reduce((best, point) => (far(point) < far(best) ? point : best)));
  }
  return placed;
}

/** Faces and triangles share edges: each once. */
function edges(lines: readonly number[]): Float32Array {
  const found = new Map<string, number[]>();
  for (let i = 0; i < lines.length; i += LINE) {
    const ends = [lines.slice(i, i + 3), lines.slice(i + 3, i + LINE)];
    const key = ends.map((end) => end.map((value) => Math.round(value / SAME)).join()).sort();
    found.set(key.join(' '), ends.flat());
  }
  return new Float32Array([...found.values()].flat());
}
