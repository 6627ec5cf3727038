/** What stands in an emitter so that it has somewhere to bear particles, as markup. */
const SOURCES: Record<string, string> = {
  PolylineEmitter: '<coordinate containerfield="coord" point="0 0 0 1 0 0"></coordinate>',
  SurfaceEmitter: '<sphere containerfield="surface"></sphere>',
  VolumeEmitter: '<coordinate containerfield="coord" point="0 0 0 1 0 0 0 1 0 0 0 1"></coordinate>',
};

export const sourceOf = (type: string): string => SOURCES[type] ?? '';
