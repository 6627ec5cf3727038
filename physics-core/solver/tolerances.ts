// The room's numbers, all of them: what a method may leave, how long it may go on, and which one a part gets. Each has its
// unit, why it is there, and the case that fixes it; one that a law makes needless goes.

// ---- What a method may leave -----------------------------------------------------------------------------------------

/** Steps of Newton for one set of impulses, and sets of impulses, at most. */
export const NEWTON_STEPS = 30;
export const NEWTON_ROUNDS = 12;

/** A change of velocities that is none any more, m/s and rad/s. */
export const STILL = 1e-7;

/**
 * Of many bodies this share of what one bears is none, either: Bullet keeps impulses in single precision, so what stood at
 * the end of a step is off by as much in the next (the lowest bricks of a wall of 25 rows by 1e-6 m/s). Two units in the
 * last place.
 */
export const ROUNDED = 2 ** -22;

/** More bodies of one part than this are many. */
export const MANY = 24;

/**
 * What a contact or a joint may miss by, m/s; of many bodies more, and a share of the greatest speed, too. What few drive
 * or brake in a step is less than that share of their speed.
 */
export const MISS = 2e-6;
export const MISS_OF_MANY = 1e-5;
export const MISS_SHARE = 1e-3;
export const STILL_SHARE = 1e-5;

/**
 * Slower sliding than this may lift, m/s: by less than a micrometre in a step. Of many bodies faster ones may, too: there
 * some contacts would go to and fro for ever (300 boxes rest after 7 s instead of never, measured).
 */
export const CREEPING = 1e-4;
export const CREEPING_OF_MANY = 1e-2;

/**
 * A level that lets joints miss by more than this share of their speed (`game`) solves parts of many bodies and heaps roughly:
 * what touches there may miss by as much as what hangs, costs this many effective masses of the contact where it does (a
 * tenth of what it costs elsewhere), and a step of Newton that changes less than this share of that is the last one. A heap of
 * 100 boxes takes 34 matrices in a step so, and not 80; 200 hinged boxes 2 and not 7; 20 ragdolls 75 and not 128.
 */
export const ROUGH = 1e-3;
export const ROUGH_STIFFNESS = 100;
export const ROUGH_STILL = 0.1;

/** Tries to find how far a step should go. */
export const LINE_TRIES = 10;

/** Share of the slope that a step may leave. */
export const LINE_FLAT = 0.1;

/** Overlaps that are let stand: single precision has 1e-6 m at ten metres from the origin. */
export const SHALLOW = 1e-6;

/** Impulses that miss their end come nearer by so much in a round; from there on they go to and fro. */
export const TO_AND_FRO = 0.7;

/**
 * Many bodies that miss by so many times what they may, and come nearer by less than this in a round, contradict each other
 * (the joints and the contacts of a chain that lies on the ground): they are as near as they get.
 */
export const NEARLY = 10;
export const STUCK = 0.95;

// ---- Sweeps ----------------------------------------------------------------------------------------------------------

/**
 * Times that all contacts are gone over in a step, there and back by turns; and where all are slow: with as few as before
 * heaps of hundreds slip for ever, by a millimetre in a second (measured).
 */
export const SWEEPS = 16;
export const SWEEPS_OF_SLOW = 32;

/** With joints, which are stiff; only what no matrix could solve comes to this. */
export const SWEEPS_OF_JOINTED = 64;

/** Times that overlaps are, there and back by turns. */
export const PUSHES = 4;

// ---- What matrices may cost ------------------------------------------------------------------------------------------

/** Products of blocks, for each body, beyond which Bullet's iterations are the cheaper way. */
export const PRODUCTS_PER_BODY = 400;

/** Matrices that are saved up in a step, at most so many: 400 boxes of a wall need 40 in their first step, then one or none. */
export const MATRICES_PER_STEP = 0.5;
export const MOST_SAVED = 60;

// ---- The first step of what stands -----------------------------------------------------------------------------------

/** What bears gives this share of all in directions in which it gives nothing: four feet in a plane have three of six. */
export const SINGULAR = 1e-12;

/** What lies farther above than the depth that contacts keep was not built to touch, metres: single precision at 10 m. */
export const FARTHEST_BUILT = 2e-6;

/** What bears has a face that is more level than steep. */
export const LEVEL = Math.SQRT1_2;

/**
 * By so much a contact may lie less deep than it should and still bear, metres: what stands on four legs would else stand
 * on three, as single precision has it.
 */
export const BAND = 8e-6;

// ---- Joints ----------------------------------------------------------------------------------------------------------

/**
 * Added to the response of each row that closes a loop, as a share of what the row would do to its bodies by themselves:
 * loops that are closed more than once would be singular. Where they are, the rounding of poses makes them all but rigid,
 * and less than this brakes them (measured: at 1e-9 a cardan shaft on two hinges loses 2 % of its energy in 4 s at 1/960 s).
 */
export const LOOP_COMPLIANCE = 1e-6;

/** The same of what is taut: what hangs on a chain that is nearly straight pulls it a thousand times as hard. */
export const FIRM_COMPLIANCE = 1e-9;

/** The same of all other rows, as a share of their response: a motor and a stop on one axis are the same row twice. */
export const LEAST_COMPLIANCE = 1e-12;

/**
 * Products of blocks in one factor: a tenth of a second. A net of 40 × 40 balls has 620,000; 230 joints on one body
 * that close loops, which all act on each other, have as many as this.
 */
export const MOST_PRODUCTS = 2e6;

/** Rounds of the search for which bounded rows hold and which give way. */
export const SEARCH_ROUNDS = 8;

/** Rounds, at most, in which joints are brought together after a step. */
export const CLOSING_ROUNDS = 30;

/**
 * How far rows give way at first, where rounds do not help, at least, and at most: shares of what a row does to its bodies.
 * They stop giving way by degrees: at once, every second round is undone again (a net that lands on a ball: 31 rounds, not 9).
 */
export const FIRST_GIVE = 1e-5;
export const LEAST_GIVE = 1e-7;
export const MOST_GIVE = 10;

/** An error that shrinks by less in a round is hardly worth it, and so many of those are the last. */
export const CLOSING_PROGRESS = 0.9;
export const CLOSING_TRIES = 3;

// ---- Joints of what is in touch --------------------------------------------------------------------------------------

/**
 * What a miss costs, in effective masses of the row; and where many bodies hang together: all that a net weighs
 * hangs on a knot (with 1e4 a step takes 25 matrices for ten contacts, or finds no end; with this, ten).
 */
export const ROW_STIFFNESS = 1e4;
export const ROW_STIFFNESS_OF_MANY = 1e7;

/**
 * Misses of joints at the end of a step, m or rad: those that straight rows may leave, since bringing joints together after
 * the step is enough for them; and those that the rounds end with, which nobody brings together.
 */
export const LEFT_OPEN = 1e-4;
export const CLOSED = 2e-5;

/**
 * Rounds, at most: a hit of 1:200 on what is taut takes all of them, what lies on a net one. And matrices, in all of them: a box
 * that strikes a chain of 15 takes a dozen in each (with 100 in all a load of 1:840 falls through a net).
 */
export const CURVED_ROUNDS = 20;
export const CURVED_MATRICES = 240;

/** Below LEFT_OPEN a round that leaves more than this share of a miss is the last one. */
export const CURVED_SLOW = 0.7;

/** A round may lead to a greater miss than the one before as long as that is smaller than this, m or rad: a hit begins with none. */
export const FIRST_MISS = 1e-3;

/** What holds bodies back, in times their mass, after a round that did not help; and by how much more after the next. */
export const HELD_BACK = 1;
export const HELD_BACK_MORE = 10;
export const MOST_HELD_BACK = 1e6;

/** Times that a way apart is halved, at most: then nothing is left of it. */
export const HALVES = 8;

// ---- Which method ----------------------------------------------------------------------------------------------------

/**
 * Bodies of one part that get a matrix, however fast they are; and those that may, once all are slower than this, m/s, spin
 * and all: what a ball stirs without going anywhere has new contacts in each step.
 */
export const FEW = 24;
export const MOST_BODIES = 600;
export const SLOW = 0.25;

/** Bodies of one part that is slow from which on a matrix is too dear for each step of a busy world. */
export const LARGE = 200;

/** Share of bodies that are not slow from which on a part is Bullet's. */
export const FAST_SHARE = 0.25;

/**
 * Share of a part's bodies that touch something, up to which the rest hangs on joints: a net on a ball. The matrix has those
 * that touch last, so that finding what they hold costs little more than one matrix of the joints does.
 */
export const TOUCHING_SHARE = 0.25;

/** Seconds: in longer steps what falls comes in so deep that a net which is held where it touches is torn. */
export const COARSE = 1 / 90;

/** Pairs in touch that make a busy world. */
export const BUSY = 400;

/**
 * Where small parts of a busy world have so many bodies that are not calm, it tumbles: only those of them get a matrix whose
 * bodies are all slower than this, m/s. Fewer are the last ones of a heap to lie down.
 */
export const TUMBLING = 100;
export const CALM = 0.05;

/**
 * Where a step has an effort, what is slower than this moves no more, m/s: a step of 1/60 s gives that to what falls, and
 * iterations leave some of it in heaps. Those of 100 boxes rest then; of what is slower than CALM alone they never do.
 */
export const FALL = 0.16;

/** Share of the bodies that parts solved here have to have at least, in a busy world. */
export const WORTH = 0.1;

/** Where so many bodies of a large part are faster than this, m/s, it sways: sweeps alone do not hold it. Fewer slip. */
export const SWAYING = { speed: 0.02, share: 0.1 };

/** Steps before what is too dear is tried again, and before a busy world without a calm part is looked at again. */
export const PAUSE = 8;

// ---- How far a step may turn what it moves -----------------------------------------------------------------------------

/** Radians that a step turns what joints hold: a wheel on an arm, at its steady precession, then stays level to 4 mm of 1 m. */
export const MOST_TURN = 0.6;

/** The same of what touches something: less than half a turn (wheels of a car at 60 m/s, `game`, in two parts). */
export const MOST_TURN_IN_TOUCH = 2.5;

/**
 * The same of what rolls elsewhere than about its centre of mass, on a ball beside it or as an egg: by longer steps a tippe
 * top of 60 rad/s turns over that should not (by parts of 0.19 rad it is right to 1 degree after 7 s).
 */
export const MOST_TURN_ROLLING = 0.2;

/**
 * What comes nearer than this share of the smaller one's reach is met as if it touched: Bullet's gContactBreakingThreshold.
 * Ends of sheets, which have no thickness, may go so far in a part of a step (sheets that lie on each other split none).
 */
export const MET_AHEAD = 0.02;

/** Parts, at most, that a step is split into: 1000 rad/s have 0.52 rad in each at `game`. */
export const MOST_PARTS = 32;

// ---- Ropes -----------------------------------------------------------------------------------------------------------

/**
 * How a link that does not stretch gives way all the same, as a share of what its points give way by themselves: between two
 * ends that do not move at all, too far apart, there would be no solution. 500 kg on a rope of 1 kg stretch it by 1e-7 m.
 */
export const LINK_COMPLIANCE = 1e-9;

/**
 * The same of what holds a point along a surface: it remembers how it was held, and so does not creep. A cord of 10 g on a drum
 * goes by 5 µm to hold 10 N.
 */
export const GRIP_COMPLIANCE = 1e-6;

/** Times that links are gone over one at a time where no search finds an end: a step is usable, and no more. */
export const ROPE_SWEEPS = 40;

/**
 * Where a rope meets itself: its places are gone over so many times, with its links and what it touches, or until none is off by
 * more than COIL_NEAR, m/s; then all is searched for anew, at most so often, until none is off by more than COIL_MISS. By less, a
 * coil of five turns trembles and does not rest, and a knot lets go of twice what its rope weighs; searches that are to end nearer
 * go round and round in a coil.
 */
export const COIL_SWEEPS = 60;
export const COIL_NEAR = 3e-4;
export const COIL_MISS = 3e-3;
export const COIL_TRIES = 6;

/** Rounds of each of those searches, at most: they begin near their end, those of a knot that is drawn tight need ten. */
export const ROPE_ROUNDS_AGAIN = 15;

/** How fast what is within itself comes out, m/s. */
export const COIL_RETURN = 0.2;

/**
 * What is nearer to itself than this share of its thickness has no side any more, and goes through: pushed out either way, three
 * turns that lie in one would writhe at 7 m/s.
 */
export const COIL_SIDE = 0.25;

/** How fast a link comes back that an edit, or such a step, has left too long, m/s. */
export const ROPE_RETURN = 1;

/** A link that lacks no more than this share of its length may be taut from the start: those that are not let go at once. */
export const TAUT = 0.02;

/** Metres: what is no farther away when a step begins may be touched from its start. Single precision at ten metres. */
export const ROPE_NEAR = 1e-6;

/** Halvings of the share of a round in which friction turns: a millionth is left. (A cord on a drum: two rounds, not thirty.) */
export const SHARE_TRIES = 20;

/** Metres: points in one place are as far apart, so that no link is without a length. */
export const SHORTEST_LINK = 1e-6;

/** Metres that the last round of a search may move a point by. */
export const ROPE_MISS = 1e-8;

/** Share of their energy of motion that even pulls may give in a step: of what swings they give a hundred times less. */
export const ROPE_GAIN = 1e-3;

/** A round that takes a point so far, metres, runs away. */
export const ROPE_FLUNG = 1e6;

/**
 * Rounds of Newton, at most: of what swings three or four; what takes more whips round within the step, and has no even pulls.
 * The nearest places are found in twenty and fewer (a rope of 40 links that is let go level with 500 kg at its end).
 */
export const ROPE_ROUNDS = 10;
export const ROPE_ROUNDS_NEAREST = 30;

// ---- Soft bodies -----------------------------------------------------------------------------------------------------

/** Cells of a lattice, at most: 16 along each side. A step of so many, in ten parts, takes about 10 ms. */
export const MOST_CELLS = 4096;

/** Share of a cell that counts as covered where less of it is: less would leave points that weigh all but nothing. */
export const LEAST_COVER = 0.1;

/**
 * How far beside its middle a cell is looked at where but a part of it is covered, at most (1 is its side, where corners bear
 * all); and how far that part reaches around there, at least, by the square, in what a whole cell does: with more and with less
 * some of what is scrambled finds other shapes that last. (Facts: a round bar bends as it should; what is crushed comes back.)
 */
export const MOST_ASIDE = 0.3;
export const LEAST_SPREAD = 0.3;

/** Poisson's ratios that are solved: at .5 nothing would be compressible, and below 0 energies would have no bound. */
export const LEAST_POISSON = 0;
export const MOST_POISSON = 0.495;

/** Of a skin: at .5 it is incompressible, since its thickness gives way. */
export const MOST_SHELL_POISSON = 0.5;

/** Share of its volume below which a gas presses no more than there: it would be as stiff as a wall in what is crumpled. */
export const LEAST_VOLUME = 0.25;

/** Sum of the squares of its stretches along two directions, from which on a gas pushes a triangle no harder: four in each. */
export const MOST_SWOLLEN = 32;

/**
 * Share of the longest part that symplectic steps follow, which is 2 over the greatest frequency. What swings far within it is
 * driven where parts of two lengths take turns: at .9, some of what is let go flat trembles for ever. (Fact: a cube that is
 * pressed flat comes back.)
 */
export const PART_SHARE = 0.7;

/**
 * Rounds in which the greatest frequency is found, at most, and when it is: when its square changes by no more in one, as a
 * share, three times. It comes from below; what is missing then is less than the margin. (Fact: within 15 %, never below.)
 */
export const WAVE_ROUNDS = 60;
export const WAVE_CHANGE = 2e-3;
export const WAVE_MARGIN = 1.05;

// ---- Cloth -----------------------------------------------------------------------------------------------------------

/** Share of the longest part that forces follow (2 / ω): at all of it the shortest wave only just keeps its height. */
export const FOLLOWED = 0.9;

/** Parts of a step, at most, that forces may ask for: what is stiffer is made softer, and told. */
export const MOST_SOFT_PARTS = 32;

/** Least parts of a step: what does not stretch is gone over once in each. (A hanging sheet of 30 × 30 within 2 mm.) */
export const LEAST_SOFT_PARTS = 6;

/** Share of its length by which a diagonal is longer than both other edges of its triangles: of a square 1.41. */
export const DIAGONAL = 1.05;

/** kg/m³: of air at 15 °C and 1013.25 hPa (ISO 2533, standard atmosphere). */
export const AIR = 1.225;

/**
 * How a thread that does not stretch gives way all the same, as a share of what its points give way by themselves: between two
 * ends that do not move at all, too far apart, there would be no solution.
 */
export const THREAD_COMPLIANCE = 1e-6;

/** A thread goes on in another one at a point where these stand at more than this cosine's angle: of squares and of triangles. */
export const STRAIGHT_ON = -0.5;

/** Boxes of space, at most, that a triangle covers along an axis where a cloth meets itself: what is stretched farther meets nothing. */
export const MOST_BOXES = 8;

/** How fast what does not stretch comes back to its length, m/s, where an edit has left it too long. (Fact: pins that jump.) */
export const THREAD_RETURN = 10;

/** Triangles that the hull of a lattice is divided into, at most: a finer surface is its own hull. (Fact: a soft box floats.) */
export const MOST_DIVIDED = 4000;

/** Rounds of that, at most: each halves what is too long. */
export const MOST_HALVINGS = 12;
