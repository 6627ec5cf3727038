import { DRAG_MODES } from '../../dynamics/body.js';
import { rotationOf } from '../../base/math.js';
import { LEAST_MASS } from '../../fields/bounds.js';
import { geometryTypes, type Geometry } from '../../shapes/geometry.js';
import { codeFor } from '../../shapes/meshes.js';
import { BodyNode } from './body.js';
import { OwnedGeometry } from './body-geometry.js';
import { updateRest } from './body-rest.js';
import { defineNode } from '../node/define.js';

const mass = (body: BodyNode): void => body.build.updateMass();
const damping = (body: BodyNode): void => body.loads.updateDamping();
const forces = (body: BodyNode): void => body.loads.updateForces();

/** Only the part that was asked for goes there at once; the other stays where the simulation has it. */
const placed =
  (part: 'p' | 'q') =>
  (body: BodyNode): void => {
    const field = part === 'p' ? 'position' : 'orientation';
    if (!body.authored(field) && body.motion.start) return;
    body.carryTo({ ...body.pose(), [part]: body.motion.startPose()[part] });
    body.presence.unpark();
  };

const moved = (): string => 'teleport() moves it';

/** What is fixed takes no velocity. */
const kicked = (body: BodyNode): string | undefined =>
  body.movable ? 'applyImpulse() kicks it, and teleport() takes velocities, too' : undefined;

/** Of all four live fields. */
const LIVE =
  'Live. What differs from the value last set acts at once; to set an equal one again is no edit';

export const rigidBody = defineNode<BodyNode>({
  name: 'RigidBody',
  containerField: 'bodies',
  clause: '37.4.11',
  doc: 'A body that moves by its mass, velocity and the forces on it.',
  rank: 2,
  bounded: true,
  needs: (body) => [codeFor([body.asked<Geometry | null>('massDensityModel')]), ...body.grip.needs],
  make: (context) => new BodyNode(context, (body) => new OwnedGeometry(body)),
  fields: {
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: (body) => body.presence.update(),
      doc: 'FALSE takes it out of the simulation: no motion, no contact, its joints idle.',
    },
    fixed: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: (body) => body.build.updateFixed(),
      doc: 'TRUE: never moves, but is collided with and holds joints.',
    },
    mass: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 1,
      range: [0, Infinity],
      least: LEAST_MASS,
      dimension: { mass: 1 },
      edit: 'live',
      patch: mass,
      doc: 'Mass, kg. 0 means fixed.',
    },
    inertia: {
      type: 'SFMatrix3f',
      access: 'inputOutput',
      default: [1, 0, 0, 0, 1, 0, 0, 0, 1],
      implied: true,
      dimension: { mass: 1, length: 2 },
      edit: 'live',
      patch: mass,
      doc: 'Inertia tensor about the centre of mass in body axes, kg·m². Not authored: from massDensityModel or the geometry.',
    },
    centerOfMass: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      edit: 'live',
      patch: mass,
      doc: 'Centre of mass in the body frame, metres.',
    },
    massDensityModel: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: [...geometryTypes],
      edit: 'live',
      patch: mass,
      doc: 'Sphere, Box or Cone whose solid gives the distribution of the mass; never drawn.',
    },
    geometry: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      nodes: ['CollidableShape', 'CollidableOffset'],
      edit: 'live',
      patch: (body) => body.geometry.update(),
      doc: 'The collidables that make its shape.',
    },
    position: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      edit: 'live',
      patch: placed('p'),
      read: (body) => body.pose().p,
      instead: moved,
      doc: `Position, metres, world frame. ${LIVE}: teleport() always moves it.`,
    },
    orientation: {
      type: 'SFRotation',
      access: 'inputOutput',
      default: [0, 0, 1, 0],
      dimension: { angle: 1 },
      edit: 'live',
      patch: placed('q'),
      read: (body) => rotationOf(body.pose().q),
      instead: moved,
      doc: `Orientation, axis and angle, radians. ${LIVE}: teleport() always turns it.`,
    },
    linearVelocity: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      edit: 'live',
      patch: (body) => body.motion.updateVelocity('linearVelocity'),
      read: (body) => body.motion.velocityShown().linear,
      instead: kicked,
      doc: `Velocity of the body's origin, m/s. ${LIVE}: applyImpulse() always kicks it.`,
    },
    angularVelocity: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { angle: 1 },
      edit: 'live',
      patch: (body) => body.motion.updateVelocity('angularVelocity'),
      read: (body) => body.motion.velocityShown().angular,
      instead: kicked,
      doc: `Angular velocity, rad/s, world frame. ${LIVE}: applyImpulse() off the centre of mass always spins it.`,
    },
    forces: {
      type: 'MFVec3f',
      access: 'inputOutput',
      default: [],
      dimension: { force: 1 },
      edit: 'live',
      patch: forces,
      doc: 'Forces at the centre of mass, newtons, world frame; their sum acts in every step.',
    },
    torques: {
      type: 'MFVec3f',
      access: 'inputOutput',
      default: [],
      dimension: { force: 1, length: 1 },
      edit: 'live',
      patch: forces,
      doc: 'Torques, newton metres, world frame; their sum acts in every step.',
    },
    useGlobalGravity: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: (body) => body.loads.updateGravity(),
      doc: "FALSE: the collection's gravity does not act on it.",
    },
    autoDamp: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: damping,
      doc: 'TRUE switches both damping factors on.',
    },
    linearDampingFactor: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.001,
      range: [0, 1],
      edit: 'live',
      patch: damping,
      doc: 'Damping force = -factor × velocity, N·s/m.',
    },
    angularDampingFactor: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.001,
      range: [0, 1],
      edit: 'live',
      patch: damping,
      doc: 'Damping torque = -factor × angular velocity, N·m·s.',
    },
    autoDisable: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: updateRest,
      doc: 'TRUE: sleeps by the fields below. FALSE, authored: never. Not authored: as its collection, else unnoticed at rest.',
    },
    disableTime: {
      type: 'SFTime',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      edit: 'live',
      patch: updateRest,
      doc: 'Seconds below both speeds before it sleeps.',
    },
    disableLinearSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: updateRest,
      doc: 'Speed below which it may sleep, m/s.',
    },
    disableAngularSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { angle: 1 },
      edit: 'live',
      patch: updateRest,
      doc: 'Angular speed below which it may sleep, rad/s.',
    },
    dragMode: {
      type: 'SFString',
      access: 'inputOutput',
      default: 'spring',
      values: DRAG_MODES,
      own: true,
      edit: 'live',
      patch: (body) => body.grip.updateMode(),
      doc: '`spring` pulls it at the grabbed point, `kinematic` carries it, pushing others aside, `teleport` sets it down. Not authored: as its collection.',
    },
    draggableBody: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'live',
      patch: (body) => body.grip.update(),
      doc: 'TRUE: people may drag it by mouse, touch, pen and keyboard. Not authored: as its collection, if it moves.',
    },
    useFiniteRotation: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'passive',
      doc: 'Bullet always turns bodies by finite rotations, so both values do the same.',
    },
    finiteRotationAxis: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 1, 0],
      range: [-1, 1],
      edit: 'passive',
      doc: 'All axes turn by finite rotations, so there is none to choose.',
    },
  },
});
