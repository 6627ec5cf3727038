import type { DragMode } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';

/** Why a drag ended. */
export type DragEnd = 'released' | 'cancelled' | 'removed' | 'disabled' | 'reset';

/** Something that somebody holds: a body, a rope, a cloth or a soft body. */
export interface Hold {
  readonly body: { readonly id: number };
  readonly mode: DragMode;
  /** Until it is let go, by whomever. */
  readonly held: boolean;
  /** Where the grabbed point is: world frame, metres. */
  readonly point: Vec3;
  /** The grabbed point is to be here, world frame, metres. */
  move(point: Vec3): void;
  /** Lets go. `still`: at rest, whatever it was doing. */
  end(still?: boolean): void;
  cancel(): void;
}
