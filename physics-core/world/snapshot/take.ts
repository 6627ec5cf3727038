import type { LevelName } from '../../dynamics/levels.js';
import { extentOf } from './check.js';
import { keptMoment, takeBodies, type BodiesWorld } from './bodies.js';
import { jointsOf, nodesOf } from './states.js';
import { FORMAT, type Snapshot } from './snapshot.js';

/** The world that a snapshot is taken of. */
interface SnapshotWorld extends BodiesWorld {
  readonly accuracy: LevelName;
  readonly control: { readonly parts: number };
}

export function takeSnapshot(world: SnapshotWorld): Snapshot {
  world.flush();
  const snapshot: Omit<Snapshot, 'extent'> = {
    x3dPhysics: FORMAT,
    time: world.time,
    taken: world.stepsTaken,
    level: world.accuracy,
    parts: world.control.parts,
    origin: [...world.poses.origin],
    nodes: nodesOf(world),
    heard: [...world.nodes].flatMap(({ id, heardEvents }) =>
      heardEvents.length > 0 ? [[id, heardEvents]] : [],
    ),
    joints: jointsOf(world),
    bodies: keptMoment(takeBodies(world), world.partOfStep),
    effects: world.registry.save(),
  };
  return { ...snapshot, extent: extentOf(snapshot) };
}
