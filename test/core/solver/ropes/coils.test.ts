import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sweepCoils } from '../../../../physics-core/solver/ropes/coil-sweeps.js';
import { Coils } from '../../../../physics-core/solver/ropes/coils.js';
import { Links } from '../../../../physics-core/solver/ropes/links.js';
import { HELD, Strand } from '../../../../physics-core/solver/ropes/strand.js';
import { close } from '../../helpers.js';

const DT = 1 / 120;
const UP = [0, 1, 0];

/**
 * Two links that cross in the middle, the upper one 2 cm above the lower, which is held; both are part of one slack strand.
 * Each end of the upper one weighs half a kilogram.
 */
function crossing(friction: number): { strand: Strand; coils: Coils; links: Links } {
  const strand = new Strand(5);
  strand.lay([-1, 0, 0, 1, 0, 0, 2, 3, 2, 0, 0.02, 1, 0, 0.02, -1], 1);
  strand.masses.fill(0.5);
  strand.lengths.fill(10);
  strand.holders.fill(HELD, 0, 2);
  strand.coils = new Coils(strand);
  strand.begin(DT);
  const links = new Links(strand);
  links.begin(DT);
  const { coils } = strand;
  coils.friction = friction;
  coils.add(3, 0, 0.5, 0.5);
  coils.normals.set(UP);
  return { strand, coils, links };
}

/** Both ends of the upper link go so. */
const go = (strand: Strand, velocity: readonly number[]): void => {
  strand.found.set(velocity, 9);
  strand.found.set(velocity, 12);
};

test('what comes at it is pushed by its momentum: m v', () => {
  const { strand, coils, links } = crossing(0);
  go(strand, [0, -3, 0]);
  coils.begin(new Float64Array(0));
  // How far off it was: 3 m/s for a step.
  close(sweepCoils(links, coils, DT), 3 * DT, 1e-12, 'm');
  close(coils.presses[0]!, 3, 1e-9, 'N s');
  for (const i of [10, 13]) close(strand.found[i]!, 0, 1e-12, 'm/s');
});

test('what gets no farther than its gap is not pushed', () => {
  const { strand, coils, links } = crossing(0);
  coils.gaps[0] = 0.02;
  go(strand, [0, -0.02 / DT + 1e-9, 0]);
  coils.begin(new Float64Array(0));
  assert.equal(sweepCoils(links, coils, DT), 0);
  assert.equal(coils.presses[0], 0);
});

test('it rubs by friction times what presses it, and stops what needs less', () => {
  for (const [along, friction, left] of [
    [2, 0.5, 0.5],
    [1, 0.5, 0],
  ] as const) {
    const { strand, coils, links } = crossing(friction);
    go(strand, [along, -3, 0]);
    coils.begin(new Float64Array(0));
    sweepCoils(links, coils, DT);
    close(strand.found[9]!, left, 1e-9, 'm/s');
    close(coils.rubs[0]!, left - along, 1e-9, 'N s');
  }
});

test('what it gave in the last step acts from the start of the next, and is taken back where it is too much', () => {
  const { strand, coils, links } = crossing(0);
  coils.presses[0] = 3;
  coils.begin(new Float64Array(0));
  // Half of it to either end.
  for (const i of [10, 13]) close(strand.free[i]!, 3, 1e-12, 'm/s');
  go(strand, [0, 1, 0]);
  sweepCoils(links, coils, DT);
  close(coils.presses[0]!, 2, 1e-9, 'N s');
  close(strand.found[10]!, 0, 1e-9, 'm/s');
});

test('what presses is kept, with what it gives, and nothing else', () => {
  const { strand, coils } = crossing(0.5);
  coils.add(2, 0, 0.1, 0.2);
  coils.presses[0] = 2;
  coils.rubs.set([0.5, 0, 0.25]);
  const other = new Coils(strand);
  other.load(coils.save());
  assert.equal(other.count, 1);
  assert.deepEqual([...other.links.subarray(0, 2)], [3, 0]);
  assert.equal(other.presses[0], 2);
  assert.deepEqual([...other.rubs.subarray(0, 3)], [0.5, 0, 0.25]);
  assert.deepEqual([...other.normals.subarray(0, 3)], UP);
});
