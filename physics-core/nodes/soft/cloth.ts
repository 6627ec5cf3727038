import { defineNode } from '../node/define.js';
import { ClothNode } from './cloth-node.js';
import { deformableFields, deformableNeeds, deformableNumber } from './deformable-fields.js';

const changed = (cloth: ClothNode): void => cloth.changed();

const { enabled, geometry, mass, damping, friction, fixedIndex, draggableBody, positions } =
  deformableFields;

export const cloth = defineNode<ClothNode>({
  name: 'Cloth',
  containerField: 'softBodies',
  clause: '',
  doc: 'A sheet of threads: it hangs, folds, blows in the wind, and lies on bodies, which it holds and pushes.',
  rank: 4,
  needs: deformableNeeds,
  make: (context) => new ClothNode(context),
  bounded: true,
  fields: {
    enabled: enabled!,
    geometry: geometry!,
    size: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      range: [0, Infinity],
      dimension: { length: 1 },
      own: true,
      edit: 'rebuild',
      doc: 'Width and height of a sheet around its origin in the x-y plane, as X3DOM’s Plane lies, metres; without it there is what geometry says.',
    },
    subdivision: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [16, 16],
      range: [1, 200],
      own: true,
      edit: 'rebuild',
      doc: 'How many cells such a sheet has along its width and its height: its points are counted from its lower left corner, row by row.',
    },
    mass: mass!,
    thickness: deformableNumber(
      0.01,
      { doc: 'How thick it is, metres; 0: it touches nothing.' },
      { dimension: { length: 1 } },
    ),
    stretchStiffness: deformableNumber(0, {
      doc: 'Newtons for each metre of width that would stretch it to twice its length along its threads, if it went on as it begins; 0: it does not stretch.',
    }),
    shearStiffness: deformableNumber(10, {
      doc: 'The same for what makes its squares slanted, N/m.',
    }),
    bendStiffness: deformableNumber(0, {
      doc: 'What it takes to bend a metre of width of it, N m; 0: it bends freely. More than a step follows is told (soft-too-stiff).',
    }),
    damping: damping!,
    friction: friction!,
    fixedIndex: fixedIndex!,
    selfCollision: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'TRUE: its points do not come nearer to each other than it is thick.',
    },
    tearStrain: deformableNumber(0, {
      doc: 'A thread that is stretched by more than this share of its length tears, and the triangles it borders with it; 0: none does.',
    }),
    wind: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'Where the air goes and how fast, m/s, in the world; 0 0 0: there is none.',
    },
    draggableBody: draggableBody!,
    positions: positions!,
  },
});
