/** A page of the site. */
export interface OwnPage {
  path: string;
  what: string;
  /** Kilobytes that it may weigh: a fifth more than it does. With a scene come x3dom and the library. */
  most: number;
}

/** One or two of each kind. */
export const OWN_PAGES: readonly OwnPage[] = [
  { path: '/index.html', what: 'front page', most: 850 },
  { path: '/gallery/index.html', what: 'gallery', most: 750 },
  { path: '/gallery/cradle.html', what: 'a scene of the gallery', most: 920 },
  { path: '/guide/why.html', what: 'a page of the guide', most: 280 },
  { path: '/recipes/door.html', what: 'a recipe', most: 890 },
  // With its story, 995: less where that takes longer to begin than the page is looked at.
  { path: '/reference/SliderJoint.html', what: 'a node of the reference', most: 1200 },
  { path: '/docs/stability.html', what: 'stability', most: 290 },
  { path: '/docs/price.html', what: 'what a step costs', most: 290 },
  { path: '/playground.html', what: 'playground', most: 1290 },
];
