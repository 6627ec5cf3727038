import { page } from '../../elements/bridge/index.js';

export type { PhysicsNode, Run, World } from '../../physics-core/inside.js';

/** What `worldOf` of the package gives, with what people are not shown of it. */
export const worldOf = (element: Element | null | undefined) => page.worldOf(element);
