// What the rest of elements/ may use of the bridge.
export { ownBinding, type Binding } from './nodes/binding.js';
export { keepInternals, setState } from './states.js';
export { STRUCTURE } from './document/markup.js';
export { camel, kebab, tagOf, type Field, type NodeType } from './document/dom.js';
export type { Explanation } from './nodes/explain.js';
export { attributeNames } from './nodes/fields.js';
export { adoptStyles } from './sheets.js';
export { checkPlace, tellPage } from './document/misplaced.js';
export { worldShown } from './shown.js';
export { page, yieldsToFirst } from './page.js';
export { attachListener, detachListener } from './x3dom/listeners.js';
