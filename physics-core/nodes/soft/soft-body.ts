import { defineNode } from '../node/define.js';
import { deformableFields, deformableNeeds, deformableNumber } from './deformable-fields.js';
import { SoftBodyNode } from './soft-body-node.js';

const { enabled, geometry, mass, damping, friction, fixedIndex, draggableBody, positions } =
  deformableFields;

export const softBody = defineNode<SoftBodyNode>({
  name: 'SoftBody',
  containerField: 'softBodies',
  clause: '',
  doc: 'A solid of one soft material within a closed surface, or, with pressure, a skin around what presses against it.',
  rank: 4,
  needs: deformableNeeds,
  make: (context) => new SoftBodyNode(context),
  bounded: true,
  fields: {
    enabled: enabled!,
    geometry: geometry!,
    mass: mass!,
    youngsModulus: deformableNumber(
      1e4,
      {
        doc: 'What it takes to stretch it, Pa: rubber has 1e6 and more, jelly 1e4. More than a step follows is told (soft-too-stiff).',
      },
      { open: true },
    ),
    poissonsRatio: deformableNumber(
      0.3,
      { doc: 'How much thinner it gets where it is stretched: 0.5 would keep its volume.' },
      { range: [0, 0.499] },
    ),
    pressure: deformableNumber(0, {
      doc: 'Pa above that of the air, as it is laid: it is hollow then, a ball or a cushion. 0: it is solid.',
    }),
    thickness: deformableNumber(
      0,
      {
        doc: 'How thick its skin is where it is hollow, metres; 0: as thick as its mass is of rubber, 1000 kg/m³.',
      },
      { dimension: { length: 1 }, edit: 'rebuild', patch: undefined },
    ),
    damping: damping!,
    friction: friction!,
    fixedIndex: fixedIndex!,
    draggableBody: draggableBody!,
    positions: positions!,
  },
});
