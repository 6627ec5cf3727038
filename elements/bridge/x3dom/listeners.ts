import { nodeOf } from './x3dom.js';

// x3dom calls the listeners of its elements itself, from a list at the node. It fills that list by replacing
// addEventListener on the element, which throws once the element has left the scene; ours does not.

export function attachListener(
  element: Element,
  ...args: Parameters<EventTarget['addEventListener']>
): void {
  const listeners = nodeOf(element)?._listeners;
  if (listeners && args[1]) (listeners[args[0]] ??= []).push(args[1]);
  EventTarget.prototype.addEventListener.apply(element, args);
}

export function detachListener(
  element: Element,
  ...args: Parameters<EventTarget['removeEventListener']>
): void {
  const listeners = nodeOf(element)?._listeners;
  if (listeners?.[args[0]])
    listeners[args[0]] = listeners[args[0]].filter((each) => each !== args[1]);
  EventTarget.prototype.removeEventListener.apply(element, args);
}
