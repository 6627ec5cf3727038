// What Bullet could call and never does here, though nothing in its code says so: by kinds of objects, and slots in their
// tables of virtual functions (Bullet 2.82). Calls by the same slot with numbers of the same type stand elsewhere, for
// other kinds. Whoever came to one of these all the same would trap, and no test, no fuzz and no case of stability does.

/** By the name of a kind, without the figures that C++ writes before it: slots that nobody calls. */
const UNCALLED = [
  // Nobody has a btSerializer, which is not bound: nothing is written to files or read from them.
  [/^bt(Collision|DiscreteDynamics)World$/, 12],
  [/^bt(CollisionObject|RigidBody)$/, 4, 5, 6],
  [/^bt\w*Shape(Ex|Part|Interface)?$/, 13, 14, 15],
  [/^bt\w*Constraint$/, 9, 10],
  [/^bt(Quantized|Optimized)Bvh$/, 2, 3, 4, 5, 6],
  [/^bt(TriangleMesh|TriangleIndexVertexArray|StridingMeshInterface)$/, 13, 14],
  // Times of impact of two bodies: what is fast is sent ahead by `continuous collision`, and Bullet's world asks for none.
  [/^bt\w*Algorithm$/, 3],
];

/** Kinds of which no object is ever made, or that nobody asks for anything. */
const UNMADE = [
  // There are no planes without an end.
  /^btConvexPlaneCollisionAlgorithm$/,
  // Depths are found by the other way, EPA, where a configuration is not told otherwise.
  /Minkowski/,
  // No shape is made of tetrahedra.
  /^bt(TetrahedronShapeEx|BU_Simplex1to4)$/,
];

const plain = (name) => name.replace(/^N?\d+/, '');

export const isMade = (kind) => !UNMADE.some((pattern) => pattern.test(plain(kind)));

export const isCalled = (kind, slot) =>
  !UNCALLED.some(([pattern, ...slots]) => slots.includes(slot) && pattern.test(plain(kind)));
