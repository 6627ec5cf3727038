// Facts that are not run on the other side of a line, by why: all others of the core are, word by word (see at-once.ts).
const HERE: Record<string, readonly string[]> = {
  'an answer is told to its end, though who hears it begins the world anew, ends it or stops it': [
    'reset() in a sleep event leaves nobody asleep in the new run',
    'reset() in a collision event: who was told of a start is told of its end, and the new run is the first one',
    'destroy() in a listener: the others hear of whole contacts, and step() says how far it came',
    'a listener that pauses the world stops it there, and it goes on from there',
    'of a sensor that was not told to be active nothing is taken back',
    'a problem of a step is told after it: who hears that a body broke may remove it',
  ],
  'what an edit brings about is told with the next answer': [
    'an edit tells what it brings about when it is over: who is woken finds it done',
    'a box that nobody forbade to rests after two seconds, tells so, and stands still',
    'a step asked for by a listener of the step does nothing; ready may ask for some',
  ],
  'what a frame draws is as old as an answer, and who listens to steps hears after those of the frame':
    [
      'an edit asks for a frame again, and the world calls for it',
      'the motion is the same, bit for bit, at 30, 60, 144 and 240 frames per second',
      'accuracy: auto takes the finest level whose frames fit the time budget',
      'timeBudget: a smaller one makes auto take a coarser level, while it runs',
    ],
  'which effects work is known with the next answer': [
    'nothing is read where nobody listens, and nothing any more when they cease',
    'suspensionForce: bears a car whose wheels stand on the ground: it sinks by its weight over the stiffness',
    'sliderForce: acts as long as it is asked for, and no longer',
    'debug: whoever draws is told when the first collection asks for it, and when the last no longer does',
  ],
  'contacts come from when they are first asked for': [
    'contacts: has a Contact for the point where a ball touches, a new one with every step, and none when they part',
  ],
  'there is no ghost of what a worker recorded': [
    "a ghost at the run's own level coincides, to the last bit: game",
    "a ghost at the run's own level coincides, to the last bit: standard",
    "a ghost at the run's own level coincides, to the last bit: fine",
    'a ghost of a run at standard is where a run at game is, to the last bit, with what was done at its time',
    'a ghost of a run at standard is where a run at precise is, to the last bit, with what was done at its time',
    'a ghost of a run at game is where a run at fine is, to the last bit, with what was done at its time',
    'what is done between two steps of the ghost is done in the next one',
    'where the run has a step and the ghost has none, it is between its two: a falling ball, within half a millimetre',
    'a force that is asked for in each step has the same impulse in the ghost: game',
    'a force that is asked for in each step has the same impulse in the ghost: reference',
    'the level stays that of the ghost, whatever the run was asked for',
    'apart is the greatest distance of a body from its ghost',
    'bodies that one of the runs does not have are left out',
    'nobody looks: there is nothing to compare or to draw',
    'taken away, nothing of it is left',
    'aborted in the middle, nothing of it is left',
    'a later call takes the place of one that is under way, which settles',
    'while a ghost is on its way the world goes on as it would have, and ends as it would',
    'what came after it was run is run the next time one looks',
    'gone on from an earlier moment, the ghost is one of what has been',
    'a reset begins the ghost anew, too',
    'what is no level is told, and the ghost that is there stays',
    'an exported run says nothing of ghosts',
    'the debug drawing has ghosts of what moves, in a colour of their own, and can draw nothing else',
  ],
  'what was done while it was recorded comes with the answer after somebody asked': [
    'marks tell what was done, and when',
  ],
  'the first list that page code hands over brings its world back: lists act from the next step on':
    [
      'bounce: a landing stone bounces by the contact as page code changed it',
      'contactNormal: points into body1; turned by page code the push turns with it, for that step only',
      'depth: is the overlap; a greater one from page code is pushed out, without velocity',
      'frictionCoefficients: a stone on contacts that page code made smooth slides on',
    ],
  'it measures the milliseconds of this thread': [
    'is measured in one step of 17: in the others effects never look at the clock',
    'count each millisecond in one phase',
    'has a measure for each phase while profile is true, and keeps none',
  ],
  'it looks into the Bullet world, whose steps are taken elsewhere': [
    'without the solve the same chain is more than a hundred times as far off',
    'boxes that slide are asked nothing, and go the same way where each is asked',
    'a body without finite numbers goes back to where it was, and its neighbours go on',
    'touched is what lies against it, without anybody listening',
    'what a hit passed on is written into no point that Bullet has taken back',
    'position: a fixed body that is moved along carries what stands on it, and is static again when it stops',
    'autoDisable: a body at rest that may sleep does so after its time, and wakes when it may not',
    'contact reading: reads no contact any more from the step on after the last listener has gone',
    'heapLimit: beyond the limit a body is not made and the world pauses; the rest of it is untouched',
  ],
  'its world has come back to this thread, and that is told': [
    'a listener that throws stops neither the step nor the others',
    'an import that is given up leaves the world as it was',
    'thread: where there are no workers it runs here, and says so when it is reset',
  ],
};

export const factsHere: ReadonlyMap<string, string> = new Map(
  Object.entries(HERE).flatMap(([why, facts]) => facts.map((fact) => [fact, why] as const)),
);
