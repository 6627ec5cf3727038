import { close, fact, world, type Vec3 } from '../../helpers.js';
import { addSea, G } from './helpers.js';

/** Of a speed, as a share: what is asked of bodies. */
const EXACT = 1e-3;

const RADIUS = 0.01;
const VOLUME = (4 / 3) * Math.PI * RADIUS ** 3;

/** One particle of a density, kg/m³, that is let go so deep; its heights after each second. */
async function drop(density: number, depth: number, sea: Record<string, unknown>, seconds: number) {
  const w = await world();
  addSea(w, sea);
  const mass = density * VOLUME;
  const system = w.add('ParticleSystem', {
    emitter: { type: 'ExplosionEmitter', position: [0, -depth, 0], speed: 0, mass },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -mass * G, 0] }],
    particleSize: [2 * RADIUS, 2 * RADIUS],
    particleLifetime: 100,
    maxParticles: 1,
  });
  const at = (): Vec3 => (system.get('positions') as Vec3[])[0]!;
  const heights: Vec3[] = [];
  for (let i = 0; i < seconds; i++) {
    w.advance(1);
    heights.push(at());
  }
  return heights;
}

fact('particles sink and rise with the speed at which drag carries them', async () => {
  for (const density of [2500, 300]) {
    const heights = await drop(density, 50, { dragCoefficient: 0.5, damping: 0 }, 4);
    const weight = Math.abs(density - 1000) * VOLUME * G;
    // ½ ρ C A v² = |m - ρ V| g.
    const speed = Math.sqrt(weight / (0.5 * 1000 * 0.5 * Math.PI * RADIUS ** 2));
    close(Math.abs(heights[3]![1] - heights[2]![1]) / speed, 1, EXACT);
  }
});

fact('what is lighter than water comes up and stays at the surface', async () => {
  const heights = await drop(20, 0.5, {}, 6);
  close(heights[5]![1], 0, RADIUS);
});

fact('a river takes them along', async () => {
  const heights = await drop(1000, 5, { flow: [2, 0, 0], damping: 4 }, 6);
  close(heights[5]![0] - heights[4]![0], 2, 2 * EXACT);
});
