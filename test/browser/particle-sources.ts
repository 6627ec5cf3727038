const SIDES = '0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1';
const TETRAHEDRON = '0 0 0 1 0 0 0 1 0 0 0 1';

/** What an emitter has, as markup, so that it has somewhere to bear particles: attributes, and what stands in it. */
const SOURCES: Record<string, { attributes?: Record<string, string>; content: string }> = {
  PolylineEmitter: {
    content: '<coordinate containerfield="coord" point="0 0 0 1 0 0"></coordinate>',
  },
  SurfaceEmitter: { content: '<sphere containerfield="surface"></sphere>' },
  VolumeEmitter: {
    attributes: { coordindex: SIDES },
    content: `<coordinate containerfield="coord" point="${TETRAHEDRON}"></coordinate>`,
  },
};

export const contentOf = (type: string): string => SOURCES[type]?.content ?? '';
export const attributesOf = (type: string): [name: string, text: string][] =>
  Object.entries(SOURCES[type]?.attributes ?? {});
