/** Pages of the site, one or two of each kind. */
export const OWN_PAGES: readonly (readonly [path: string, what: string])[] = [
  ['/index.html', 'front page'],
  ['/gallery/index.html', 'gallery'],
  ['/gallery/cradle.html', 'a scene of the gallery'],
  ['/guide/why.html', 'a page of the guide'],
  ['/recipes/door.html', 'a recipe'],
  ['/reference/SliderJoint.html', 'a node of the reference'],
  ['/docs/stability.html', 'stability'],
  ['/docs/price.html', 'what a step costs'],
  ['/playground.html', 'playground'],
];
