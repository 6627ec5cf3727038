// What the rest of elements/ may use of the bridge.
export { ownBinding, type Binding } from './nodes/binding.js';
export { keepInternals, setState } from './base/states.js';
export { STRUCTURE } from './words/attributes.js';
export { camel, kebab, tagOf, type Field, type NodeType } from './words/dom.js';
export type { Explanation } from './outward/explain.js';
export { loadFailed } from './words/load-failed.js';
export { attributeNames } from './words/fields.js';
export { adoptStyles } from './base/sheets.js';
export { checkPlace, tellPage } from './document/misplaced.js';
export { worldShown } from './page/shown.js';
export { page, yieldsToFirst } from './page/page.js';
export { learnTypes } from './scene/node-types.js';
export { deformableTags, particleTags, ropeTags, waterTags } from './scene/late-tags.js';
export { attachListener, detachListener } from './x3dom/listeners.js';
