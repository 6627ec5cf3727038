// The scenes of the gallery, in their order: each is a page in site/gallery.
export const GALLERY = {
  trebuchet: 'Trebuchet',
  cards: 'House of cards',
  drum: 'Washing drum',
  dominoes: 'Dominoes',
  gears: 'Gears',
  cradle: 'Newton’s cradle',
  'wrecking-ball': 'Wrecking ball',
  tops: 'Gyroscope and tops',
};
