// The tags of x3dom's own that scenes with physics are made of, for the types of templates. Of each its fields: numbers
// may be given as such, flags only as words, since templates leave boolean attributes out or empty.

interface SceneTag {
  numbers?: string;
  flags?: string;
  texts?: string;
}

const GEOMETRY: SceneTag = { flags: 'solid ccw lit useGeoCache' };
const LIGHT: SceneTag = {
  numbers: 'color intensity ambientIntensity shadowIntensity shadowMapSize zNear zFar',
  flags: 'on global',
};
const GROUPING: SceneTag = { numbers: 'bboxCenter bboxSize', flags: 'render visible' };
const FACES: SceneTag = {
  numbers: 'coordIndex normalIndex colorIndex texCoordIndex creaseAngle',
  flags: 'solid ccw convex colorPerVertex normalPerVertex lit useGeoCache',
};
const VIEW: SceneTag = {
  numbers: 'position orientation centerOfRotation zNear zFar',
  flags: 'set_bind',
  texts: 'description',
};
const TRIANGLES: SceneTag = {
  numbers: 'index',
  flags: 'solid ccw colorPerVertex normalPerVertex lit useGeoCache',
};

const join = (...words: (string | undefined)[]): string => words.filter(Boolean).join(' ');
const more = (base: SceneTag, { numbers, flags, texts }: SceneTag): SceneTag => ({
  numbers: join(base.numbers, numbers),
  flags: join(base.flags, flags),
  texts: join(base.texts, texts),
});

/** `switch` and `text` are missing: templates have SVG's own under these names. */
export const SCENE_TAGS: Record<string, SceneTag> = {
  x3d: {
    numbers: 'width height backend',
    flags:
      'showStat showLog showProgress disableDoubleClick disableRightDrag disableTouch keysEnabled',
    texts: 'profile version',
  },
  scene: { numbers: 'pickMode', flags: 'doPickPass', texts: 'shadowObjectIdMapping' },
  environment: {
    flags: 'frustumCulling smallFeatureCulling shadowExcludeObjects',
    texts: 'id gammaCorrectionDefault',
  },
  worldinfo: { texts: 'title info' },
  navigationinfo: {
    numbers: 'avatarSize speed transitionTime typeParams visibilityLimit explorationMode',
    flags: 'headlight set_bind',
    texts: 'type',
  },
  viewpoint: more(VIEW, { numbers: 'fieldOfView' }),
  orthoviewpoint: more(VIEW, { numbers: 'fieldOfView' }),
  background: {
    numbers: 'skyColor skyAngle groundColor groundAngle transparency',
    flags: 'set_bind',
    texts: 'backUrl bottomUrl frontUrl leftUrl rightUrl topUrl',
  },
  fog: { numbers: 'color visibilityRange', texts: 'fogType' },
  directionallight: more(LIGHT, { numbers: 'direction' }),
  pointlight: more(LIGHT, { numbers: 'location attenuation radius' }),
  spotlight: more(LIGHT, {
    numbers: 'location direction attenuation radius beamWidth cutOffAngle',
  }),
  transform: more(GROUPING, {
    numbers: 'translation rotation scale scaleOrientation center',
  }),
  matrixtransform: more(GROUPING, { numbers: 'matrix' }),
  group: GROUPING,
  inline: more(GROUPING, {
    flags: 'load mapDEFToID',
    texts: 'url nameSpaceName contentType',
  }),
  shape: more(GROUPING, { flags: 'isPickable' }),
  appearance: { numbers: 'alphaClipThreshold', texts: 'sortType' },
  material: {
    numbers: 'ambientIntensity diffuseColor emissiveColor shininess specularColor transparency',
  },
  physicalmaterial: {
    numbers: 'baseColor emissiveColor metallic roughness transparency',
  },
  imagetexture: { flags: 'repeatS repeatT', texts: 'url' },
  box: more(GEOMETRY, { numbers: 'size' }),
  sphere: more(GEOMETRY, { numbers: 'radius subdivision' }),
  cylinder: more(GEOMETRY, {
    numbers: 'radius height subdivision',
    flags: 'top bottom side',
  }),
  cone: more(GEOMETRY, {
    numbers: 'bottomRadius topRadius height subdivision',
    flags: 'top bottom side',
  }),
  plane: more(GEOMETRY, { numbers: 'size center subdivision' }),
  elevationgrid: more(FACES, {
    numbers: 'height xDimension xSpacing zDimension zSpacing',
  }),
  extrusion: more(FACES, {
    numbers: 'crossSection orientation scale spine',
    flags: 'beginCap endCap',
  }),
  indexedfaceset: FACES,
  indexedlineset: { numbers: 'coordIndex colorIndex', flags: 'colorPerVertex' },
  indexedtriangleset: TRIANGLES,
  triangleset: TRIANGLES,
  coordinate: { numbers: 'point' },
  normal: { numbers: 'vector' },
  color: { numbers: 'color' },
  colorrgba: { numbers: 'color' },
  texturecoordinate: { numbers: 'point' },
  timesensor: {
    numbers: 'cycleInterval startTime stopTime pauseTime resumeTime',
    flags: 'enabled loop',
  },
  positioninterpolator: { numbers: 'key keyValue' },
  orientationinterpolator: { numbers: 'key keyValue' },
  scalarinterpolator: { numbers: 'key keyValue' },
  route: { texts: 'fromNode fromField toNode toField' },
};

const lines = (words: string | undefined, type: string): string[] =>
  (words ?? '')
    .split(' ')
    .filter(Boolean)
    .map((name) => `    ${name}?: ${type};`);

/** The interface of all of them, by tag. */
export const sceneTags = (): string => {
  const tags = Object.entries(SCENE_TAGS).map(([tag, { numbers, flags, texts }]) =>
    [
      `  ${tag}: SceneAttributes & {`,
      ...lines(numbers, 'NumberText'),
      ...lines(flags, "'true' | 'false'"),
      ...lines(texts, 'string'),
      '  };',
    ].join('\n'),
  );
  return `export interface SceneTags {\n${tags.join('\n')}\n}\n`;
};
