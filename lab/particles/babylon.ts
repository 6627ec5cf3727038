import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js';
import { Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { ParticleSystem } from '@babylonjs/core/Particles/particleSystem.js';
import type { Scene } from '@babylonjs/core/scene.js';
import { FADING, FOUNTAIN } from './fountain.js';

/** So much of a second goes by in a frame of a sixtieth. */
const FRAME = 1 / 60;

/** Without a texture it draws nothing: one white pixel. */
const white = (scene: Scene): RawTexture =>
  RawTexture.CreateRGBATexture(new Uint8Array([255, 255, 255, 255]), 1, 1, scene);

/** The fountain as Babylon's own particles on the processor, which face the viewer. */
export function babylonFountain(scene: Scene, count: number, fades: boolean): ParticleSystem {
  const { life, angle, speed, variation, size, gravity, colors } = FOUNTAIN;
  const system = new ParticleSystem('fountain', count, scene);
  system.particleTexture = white(scene);
  system.emitter = new Vector3(0, 0, 0);
  // Theirs is the whole angle of the cone, and particles go on from where they begin in it: next to its tip.
  const cone = system.createConeEmitter(1, 2 * angle);
  cone.emitFromSpawnPointOnly = true;
  cone.directionRandomizer = 0;
  system.emitRate = count / life;
  system.minLifeTime = system.maxLifeTime = life;
  system.minEmitPower = speed * (1 - variation);
  system.maxEmitPower = speed * (1 + variation);
  system.minSize = system.maxSize = size;
  system.gravity = new Vector3(0, gravity, 0);
  system.updateSpeed = FRAME;
  system.blendMode = ParticleSystem.BLENDMODE_STANDARD;
  const ramp = fades ? FADING : colors;
  ramp.forEach(([r, g, b, a], i) =>
    system.addColorGradient(i / (ramp.length - 1), new Color4(r, g, b, a)),
  );
  system.start();
  return system;
}
