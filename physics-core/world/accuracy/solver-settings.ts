import {
  ACCURATE_LEVEL,
  AUTO,
  DEFAULT_LEVEL,
  levelNamed,
  perStep,
  type Level,
  type LevelName,
} from '../../dynamics/levels.js';
import type { SolverDemands } from '../../effects/contacts/solver-demands.js';
import type { SolverSettings } from '../../engine/bullet-world.js';
import type { JointSettings } from '../../nodes/node/node-world.js';
import type { PhysicsNode } from '../../nodes/node/node.js';

/** Bullet corrects overlaps deeper than this without adding velocity: best for stacks and plastic hits alike (measured). */
const SPLIT_THRESHOLD = -0.005;

/**
 * Resting contacts are left this deep, so that they can be told from gaps: single precision has 1e-6 m at ten metres from
 * the origin. What Bullet's iterations hold is repaired at this share per 1/60 s (six boxes come to rest so, measured).
 */
const CONTACT_DEPTH = 1e-5;
const CONTACT_CORRECTION = 0.19;

/** The level that a collection asks for: authored level > preferAccuracy > standard. Undefined: whichever fits (`auto`). */
export function levelOf(settings: PhysicsNode): Level | undefined {
  const asked = settings.asked<LevelName | typeof AUTO>('accuracy');
  if (settings.authored('accuracy')) return asked === AUTO ? undefined : levelNamed(asked);
  return levelNamed(settings.asked<boolean>('preferAccuracy') ? ACCURATE_LEVEL : DEFAULT_LEVEL);
}

/** An authored field wins over the level. */
const authored = <T>(settings: PhysicsNode, field: string, otherwise: T): T =>
  settings.authored(field) ? settings.asked<T>(field) : otherwise;

/** Of steps of so many seconds. */
export function jointSettings(settings: PhysicsNode, level: Level, seconds: number): JointSettings {
  return {
    errorCorrection: settings.authored('errorCorrection')
      ? perStep(settings.asked('errorCorrection'), seconds)
      : level.errorCorrection,
    constantForceMix: authored(settings, 'constantForceMix', 0),
    stepSeconds: seconds,
  };
}

/** `demands`: what the contact parameters of the world need. Pushing overlaps apart by velocity falsifies a bounce. */
export function solverSettings(
  settings: PhysicsNode,
  level: Level,
  seconds: number,
  { pushing, directed }: SolverDemands,
): SolverSettings {
  return {
    iterations: Math.max(1, authored(settings, 'iterations', level.iterations)),
    givenFrictionDirections: directed,
    twoFrictionDirections: directed || level.twoFrictionDirections,
    splitImpulseThreshold: pushing ? 0 : SPLIT_THRESHOLD,
    contactErrorReduction: perStep(CONTACT_CORRECTION, seconds),
    linearSlop: Math.max(CONTACT_DEPTH, settings.asked<number>('contactSurfaceThickness')),
    // Who says how often Bullet is to iterate wants its iterations.
    direct: !settings.authored('iterations'),
    effort: level.effort,
    miss: level.miss,
  };
}
