// Hard cases that are not run on the other side of a line, by why: all others are, to the same numbers.
const HERE: Record<string, readonly string[]> = {
  'it takes more than two seconds there': [
    'net on a ball',
    'S4',
    'tower of 30',
    'S6',
    'small boxes',
    'card house',
    'arch',
    'heap of boxes',
    'ragdolls',
    'dominoes',
    'S27 swing',
    'storm',
  ],
  'it measures the heap, which both sides share here': ['S28'],
};

export const casesHere: ReadonlySet<string> = new Set(Object.values(HERE).flat());
