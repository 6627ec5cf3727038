import type { NodeData } from '../conformance/fact.js';
import {
  body,
  box,
  collection,
  collidable,
  joint,
  offset,
  sphere,
  use,
} from '../conformance/scenes.js';
import { particleTypes } from '../../physics-core/particles.js';
import { deformableTypes } from '../../physics-core/deformables.js';
import { softTypes } from '../../physics-core/ropes.js';
import { waterTypes } from '../../physics-core/water.js';
import { PARTICLE_SUBJECTS, particleScene, POINT_SPARES } from './particles.js';
import { deformableScene, deformableSubjects, SURFACE_SPARES } from './deformables.js';
import { LINE_SPARES, ropeScene, ropeSubjects } from './ropes.js';
import { waterScene } from './water.js';

/** Two arms on a joint of each type, high above the ground and out of each other's way: they swing when they are edited. */
const JOINTS = [
  'BallJoint',
  'SingleAxisHingeJoint',
  'DoubleAxisHingeJoint',
  'SliderJoint',
  'UniversalJoint',
  'MotorJoint',
];

const arms = (type: string, row: number): NodeData[] => {
  const at = (x: number): number[] => [x, 20, 10 * row];
  const arm = (DEF: string, x: number): NodeData =>
    body(DEF, {
      position: at(x),
      angularVelocity: [0.1, 0.2, 0.3],
      geometry: [collidable(box(1, 0.2, 0.3), { DEF: `${DEF}Shape` })],
    });
  const place = /Slider|Motor/.test(type) ? {} : { anchorPoint: at(0) };
  const made = joint(type, { body1: `${type}1`, body2: `${type}2` }, { DEF: type, ...place });
  return [arm(`${type}1`, -0.6), arm(`${type}2`, 0.6), made];
};

/**
 * One node of every type among neighbours; particles where one of their nodes is walked, since a world with them takes its
 * steps on the page's own thread. When it is edited the sledge slides over the ground, touches it and pulls a
 * trailer by a joint, the stone sleeps, and everything else flies. What the walk edits has hardly a field authored, so
 * that un-authoring it leads back to where it was.
 */
export const scene = (type: string): NodeData[] => {
  const joints = JOINTS.flatMap(arms);
  return [
    collection({
      rest: 'never',
      bodies: [
        body('ground', {
          fixed: true,
          position: [0, -0.5, 0],
          geometry: [collidable(box(60, 1, 60), { DEF: 'groundShape' })],
        }),
        body('sledge', {
          position: [0, 0.25, 0],
          linearVelocity: [3, 0, 0],
          geometry: [collidable(box(1, 0.5, 1), { DEF: 'sledgeShape' })],
        }),
        body('trailer', {
          position: [-1.5, 0.25, 0],
          linearVelocity: [3, 0, 0],
          geometry: [collidable(box(1, 0.5, 1), { DEF: 'trailerShape' })],
        }),
        body('stone', {
          position: [10, 0.5, 0],
          autoDisable: true,
          disableLinearSpeed: 1,
          disableAngularSpeed: 1,
          geometry: [collidable(box(1), { DEF: 'stoneShape' })],
        }),
        body('pole', {
          position: [0, 10, -5],
          angularVelocity: [0, 0, 1],
          geometry: [
            offset([0, 1, 0], collidable(box(0.2, 2, 0.4), { DEF: 'poleShape' }), {
              DEF: 'poleOffset',
            }),
            collidable(sphere(0.3), { DEF: 'poleFoot' }),
          ],
        }),
        body('spare', {
          position: [0, 20, -10],
          geometry: [collidable(sphere(0.5), { DEF: 'spareShape' })],
        }),
        ...joints.filter(({ type }) => type === 'RigidBody'),
      ],
      joints: [
        joint(
          'BallJoint',
          { body1: 'sledge', body2: 'trailer' },
          { DEF: 'hitch', anchorPoint: [-0.75, 0.25, 0] },
        ),
        ...joints.filter(({ type }) => type !== 'RigidBody'),
      ],
    }),
    {
      type: 'CollisionCollection',
      DEF: 'colliders',
      collidables: [
        use('groundShape'),
        {
          type: 'CollisionSpace',
          DEF: 'space',
          collidables: [use('sledgeShape'), use('poleShape')],
        },
      ],
    },
    { type: 'CollisionSensor', DEF: 'sensor', collider: use('colliders') },
    { type: 'Contact', DEF: 'contact' },
    // Obstacles far below everything, until a body takes them.
    {
      type: 'CollisionCollection',
      DEF: 'store',
      collidables: [
        collidable(sphere(0.4), { DEF: 'looseShape', translation: [0, -50, 0] }),
        collidable(box(0.4), { DEF: 'looseBox', translation: [0, -60, 0] }),
      ],
    },
    { type: 'CollisionCollection', DEF: 'others', collidables: [use('spareShape')] },
    ...(type in particleTypes ? particleScene() : []),
    ...(type in softTypes ? ropeScene() : []),
    ...(type in deformableTypes ? deformableScene(type) : []),
    ...(type in waterTypes ? waterScene() : []),
  ];
};

/** Seconds after which the walk begins. */
export const SECONDS = 0.3;

/** What is walked of each type. */
export const SUBJECTS: Record<string, string> = {
  RigidBodyCollection: 'world',
  RigidBody: 'sledge',
  CollidableShape: 'poleShape',
  CollidableOffset: 'poleOffset',
  CollisionCollection: 'colliders',
  CollisionSpace: 'space',
  CollisionSensor: 'sensor',
  Contact: 'contact',
  ...Object.fromEntries(JOINTS.map((type) => [type, type])),
  ...PARTICLE_SUBJECTS,
  ...ropeSubjects,
  ...deformableSubjects,
  WaterVolume: 'water',
};

/** Nodes that are no physics, for the fields that take such. */
export const SPARES: Record<string, NodeData> = {
  flat: box(2, 0.2, 2),
  long: box(0.2, 3, 0.2),
  data: { type: 'MetadataString', name: 'a' },
  moreData: { type: 'MetadataString', name: 'b' },
  ...POINT_SPARES,
  ...LINE_SPARES,
  ...SURFACE_SPARES,
};
