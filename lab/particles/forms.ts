/** What particles are drawn as, one row of the tables each. */
export interface Form {
  id: string;
  name: string;
  geometryType: string;
  /** They fade, and what is behind them is drawn first. */
  fades?: boolean;
  /** They have this many bodies to meet. */
  bodies?: number;
  /** It has no more: what a frame costs by itself. */
  alone?: boolean;
  /** Who has something of the kind. */
  sides: readonly string[];
}

const X3D = ['ours', 'x-ite'];
const ALL = [...X3D, 'babylon'];

export const forms: readonly Form[] = [
  { id: 'alone', name: 'one SPRITE', geometryType: 'SPRITE', alone: true, sides: ALL },
  { id: 'sprite', name: 'SPRITE', geometryType: 'SPRITE', sides: ALL },
  {
    id: 'fading',
    name: 'SPRITE that fades',
    geometryType: 'SPRITE',
    fades: true,
    sides: ALL,
  },
  { id: 'quad', name: 'QUAD', geometryType: 'QUAD', sides: X3D },
  { id: 'point', name: 'POINT', geometryType: 'POINT', sides: X3D },
  { id: 'line', name: 'LINE', geometryType: 'LINE', sides: X3D },
  { id: 'geometry', name: 'GEOMETRY, a tetrahedron', geometryType: 'GEOMETRY', sides: X3D },
  {
    id: 'bodies',
    name: 'SPRITE among 50 bodies',
    geometryType: 'SPRITE',
    bodies: 50,
    sides: ['ours'],
  },
];

/** How many live of it, of so many. */
export const countOf = ({ alone }: Form, count: number): number => (alone ? 1 : count);

export function formOf(id: string): Form {
  const found = forms.find((form) => form.id === id);
  if (!found) throw new Error(`no form ${id}`);
  return found;
}
