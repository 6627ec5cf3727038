// Written by `npm run write -- types` from the tables in physics-core/nodes.

/** Properties of `<x3d-rigid-body-collection>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface RigidBodyCollectionProperties {
  /** The bodies; membership is kept at each body. (MFNode) */
  get bodies(): Element[];
  set bodies(value: Iterable<Element> | null | undefined);
  /** The joints; membership is kept at each joint. (MFNode) */
  get joints(): Element[];
  set joints(value: Iterable<Element> | null | undefined);
  /** Set: exactly the pairs inside that CollisionCollection collide. Not set: every pair of the world. (SFNode) */
  get collider(): Element | null;
  set collider(value: Element | null | undefined);
  /** Contacts for the next step, as page code changed those of a CollisionSensor: what the list leaves out does not push, what page code added does. With a collider it only changes parameters. (MFNode) */
  set set_contacts(value: Iterable<Element | Record<string, unknown>> | null | undefined);
  /** FALSE freezes the simulation; it resumes without a jump in time. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Acceleration of every body that uses global gravity, m/s². (SFVec3f) Default 0 -9.8 0. */
  get gravity(): number[];
  set gravity(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** TRUE asks for accuracy level `precise` where no level is authored. (SFBool) Default false. */
  get preferAccuracy(): boolean;
  set preferAccuracy(value: boolean | string | null | undefined);
  /** Solver iterations per step; authored, it wins over the accuracy level. 0 counts as 1. Range [0, Infinity]. (SFInt32) Default 10. */
  get iterations(): number;
  set iterations(value: number | string | null | undefined);
  /** Share of a joint error repaired per 1/60 s; authored, it wins over the accuracy level. Range [0, 1]. (SFFloat) Default 0.8. */
  get errorCorrection(): number;
  set errorCorrection(value: number | string | null | undefined);
  /** Softness of joints, m/(N·s); acts where authored. Range [0, Infinity]. (SFFloat) Default 0.0001. */
  get constantForceMix(): number;
  set constantForceMix(value: number | string | null | undefined);
  /** Depth that resting contacts keep, metres. Range [0, Infinity]. (SFFloat) Default 0. */
  get contactSurfaceThickness(): number;
  set contactSurfaceThickness(value: number | string | null | undefined);
  /** Greatest speed at which overlaps are pushed apart, m/s; -1 is unlimited. The push adds no velocity. Range [-1, Infinity]. (SFFloat) Default -1. */
  get maxCorrectionSpeed(): number;
  set maxCorrectionSpeed(value: number | string | null | undefined);
  /** Default of the bodies. Not authored: bodies at rest may sleep unnoticed. FALSE: never. TRUE: by the fields below. (SFBool) Default false. */
  get autoDisable(): boolean;
  set autoDisable(value: boolean | string | null | undefined);
  /** Seconds below both speeds before a body sleeps. Range [0, Infinity]. (SFTime) Default 0. */
  get disableTime(): number;
  set disableTime(value: number | string | null | undefined);
  /** Speed below which a body may sleep, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get disableLinearSpeed(): number;
  set disableLinearSpeed(value: number | string | null | undefined);
  /** Angular speed below which a body may sleep, rad/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get disableAngularSpeed(): number;
  set disableAngularSpeed(value: number | string | null | undefined);
  /** Accuracy level: game, standard (default), fine, precise, reference; auto takes the finest that fits the time budget. (SFString) Default standard. */
  get accuracy(): string;
  set accuracy(value: string | null | undefined);
  /** Milliseconds per frame that accuracy auto lets the physics take, in nine of ten frames. Range [0, Infinity]. (SFFloat) Default 6. */
  get timeBudget(): number;
  set timeBudget(value: number | string | null | undefined);
  /** `never` keeps bodies awake whose autoDisable nobody wrote. (SFString) Default auto. */
  get rest(): string;
  set rest(value: string | null | undefined);
  /** `strict` follows the standard to the letter: without a collider nothing collides but the contacts of a CollisionSensor that page code hands to set_contacts, and friction is what frictionCoefficients say. (SFString) Default lenient. */
  get collisionRules(): string;
  set collisionRules(value: string | null | undefined);
  /** How its bodies are dragged: spring (default), kinematic, teleport. (SFString) Default spring. */
  get dragMode(): string;
  set dragMode(value: string | null | undefined);
  /** TRUE: people may drag all of its bodies that move, and its ropes, cloth and soft bodies. (SFBool) Default false. */
  get draggableBody(): boolean;
  set draggableBody(value: boolean | string | null | undefined);
  /** Keeps running while the page is hidden or the scene scrolled away. (SFBool) Default false. */
  get runHidden(): boolean;
  set runHidden(value: boolean | string | null | undefined);
  /** Draws its world as Bullet has it: shapes (awake green, asleep blue, fixed grey, carried orange), centres of mass, joints with their limits, contacts. (SFBool) Default false. */
  get debug(): boolean;
  set debug(value: boolean | string | null | undefined);
  /** Where steps are taken: on the page’s own thread (main), on another (worker), or there from a hundred bodies on (auto). Acts when the world starts or is reset. (SFString) Default main. */
  get thread(): string;
  set thread(value: string | null | undefined);
  /** Greatest size of the wasm heap, MB; looked at whenever something is made. Range [16, 2048]. (SFFloat) Default 512. */
  get heapLimit(): number;
  set heapLimit(value: number | string | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** It gives the default world of its x3d element its fields. */
  default: boolean;
  /** Collections of one x3d element with the same name here share a world. */
  sharedWorld: string;
  /** Whether bodies are drawn in one call with others that look alike; "false": by themselves. */
  batch: boolean;
}

/** Properties of `<x3d-rigid-body>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface RigidBodyProperties {
  /** FALSE takes it out of the simulation: no motion, no contact, its joints idle. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** TRUE: never moves, but is collided with and holds joints. (SFBool) Default false. */
  get fixed(): boolean;
  set fixed(value: boolean | string | null | undefined);
  /** Mass, kg. 0 means fixed. Range [0, Infinity]. (SFFloat) Default 1. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Inertia tensor about the centre of mass in body axes, kg·m². Not authored: from massDensityModel or the geometry. (SFMatrix3f) Default 1 0 0 0 1 0 0 0 1. */
  get inertia(): number[];
  set inertia(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Centre of mass in the body frame, metres. (SFVec3f) Default 0 0 0. */
  get centerOfMass(): number[];
  set centerOfMass(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Sphere, Box or Cone whose solid gives the distribution of the mass; never drawn. (SFNode) */
  get massDensityModel(): Element | null;
  set massDensityModel(value: Element | null | undefined);
  /** The collidables that make its shape. (MFNode) */
  get geometry(): Element[];
  set geometry(value: Iterable<Element> | null | undefined);
  /** Position, metres, world frame. Live. What differs from the value last set acts at once; to set an equal one again is no edit: teleport() always moves it. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Orientation, axis and angle, radians. Live. What differs from the value last set acts at once; to set an equal one again is no edit: teleport() always turns it. (SFRotation) Default 0 0 1 0. */
  get orientation(): number[];
  set orientation(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Velocity of the body's origin, m/s. Live. What differs from the value last set acts at once; to set an equal one again is no edit: applyImpulse() always kicks it. (SFVec3f) Default 0 0 0. */
  get linearVelocity(): number[];
  set linearVelocity(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Angular velocity, rad/s, world frame. Live. What differs from the value last set acts at once; to set an equal one again is no edit: applyImpulse() off the centre of mass always spins it. (SFVec3f) Default 0 0 0. */
  get angularVelocity(): number[];
  set angularVelocity(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Forces at the centre of mass, newtons, world frame; their sum acts in every step. (MFVec3f) */
  get forces(): number[][];
  set forces(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Torques, newton metres, world frame; their sum acts in every step. (MFVec3f) */
  get torques(): number[][];
  set torques(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** FALSE: the collection's gravity does not act on it. (SFBool) Default true. */
  get useGlobalGravity(): boolean;
  set useGlobalGravity(value: boolean | string | null | undefined);
  /** TRUE switches both damping factors on. (SFBool) Default false. */
  get autoDamp(): boolean;
  set autoDamp(value: boolean | string | null | undefined);
  /** Damping force = -factor × velocity, N·s/m. Range [0, 1]. (SFFloat) Default 0.001. */
  get linearDampingFactor(): number;
  set linearDampingFactor(value: number | string | null | undefined);
  /** Damping torque = -factor × angular velocity, N·m·s. Range [0, 1]. (SFFloat) Default 0.001. */
  get angularDampingFactor(): number;
  set angularDampingFactor(value: number | string | null | undefined);
  /** TRUE: sleeps by the fields below. FALSE, authored: never. Not authored: as its collection, else unnoticed at rest. (SFBool) Default false. */
  get autoDisable(): boolean;
  set autoDisable(value: boolean | string | null | undefined);
  /** Seconds below both speeds before it sleeps. Range [0, Infinity]. (SFTime) Default 0. */
  get disableTime(): number;
  set disableTime(value: number | string | null | undefined);
  /** Speed below which it may sleep, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get disableLinearSpeed(): number;
  set disableLinearSpeed(value: number | string | null | undefined);
  /** Angular speed below which it may sleep, rad/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get disableAngularSpeed(): number;
  set disableAngularSpeed(value: number | string | null | undefined);
  /** `spring` pulls it at the grabbed point, `kinematic` carries it, pushing others aside, `teleport` sets it down. Not authored: as its collection. (SFString) Default spring. */
  get dragMode(): string;
  set dragMode(value: string | null | undefined);
  /** TRUE: people may drag it by mouse, touch, pen and keyboard. Not authored: as its collection, if it moves. (SFBool) Default false. */
  get draggableBody(): boolean;
  set draggableBody(value: boolean | string | null | undefined);
  /** Bullet always turns bodies by finite rotations, so both values do the same. (SFBool) Default false. */
  get useFiniteRotation(): boolean;
  set useFiniteRotation(value: boolean | string | null | undefined);
  /** All axes turn by finite rotations, so there is none to choose. Range [-1, 1]. (SFVec3f) Default 0 1 0. */
  get finiteRotationAxis(): number[];
  set finiteRotationAxis(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
  /** Whether bodies are drawn in one call with others that look alike; "false": by themselves. */
  batch: boolean;
}

/** Properties of `<x3d-collidable-shape>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface CollidableShapeProperties {
  /** FALSE takes it out of collision; it is still drawn. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Place, metres. In a body it is the body that says where; in a CollidableOffset it is the offset. (SFVec3f) Default 0 0 0. */
  get translation(): number[];
  set translation(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Orientation, axis and angle in radians; as translation. (SFRotation) Default 0 0 1 0. */
  get rotation(): number[];
  set rotation(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** The Shape whose geometry collides. (MFNode) */
  get shape(): Element[];
  set shape(value: Iterable<Element> | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
}

/** Properties of `<x3d-collidable-offset>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface CollidableOffsetProperties {
  /** FALSE takes it out of collision; it is still drawn. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Place, metres. In a body it is the body that says where; in a CollidableOffset it is the offset. (SFVec3f) Default 0 0 0. */
  get translation(): number[];
  set translation(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Orientation, axis and angle in radians; as translation. (SFRotation) Default 0 0 1 0. */
  get rotation(): number[];
  set rotation(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** The collidable that is placed. (SFNode) */
  get collidable(): Element | null;
  set collidable(value: Element | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-collision-collection>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface CollisionCollectionProperties {
  /** What it is for, in words for people. (SFString) */
  get description(): string;
  set description(value: string | null | undefined);
  /** The members; `*` means every collidable of the world. (MFNode) */
  get collidables(): Element[] | '*';
  set collidables(value: Iterable<Element> | string | null | undefined);
  /** FALSE: its pairs are not tested. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Which parameters act: BOUNCE, FRICTION_COEFFICIENT-2, SPEED-1, SPEED-2, SLIP-1, SLIP-2, ERROR_REDUCTION, CONSTANT_FORCE; hyphen or underscore. USER_FRICTION means something on a Contact only. (MFString) Default "BOUNCE". */
  get appliedParameters(): string[];
  set appliedParameters(value: string[] | string | null | undefined);
  /** Share of the approach speed that comes back. Range [0, 1]. (SFFloat) Default 0. */
  get bounce(): number;
  set bounce(value: number | string | null | undefined);
  /** Approach speed below which nothing bounces, m/s. Range [0, Infinity]. (SFFloat) Default 0.1. */
  get minBounceSpeed(): number;
  set minBounceSpeed(value: number | string | null | undefined);
  /** Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both. Not authored: 0.5. Direction 1 is the world’s x axis laid into the surface (z where the surface faces along x), direction 2 is across: z on a floor. Two different ones act each along its own direction, so that sliding obliquely meets both. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  get frictionCoefficients(): number[];
  set frictionCoefficients(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Speed at which the surface carries bodies along friction direction 1 and 2, m/s (a conveyor belt); needs SPEED-1, SPEED-2. What does not move is the belt; of two bodies that move, the one made earlier. (SFVec2f) Default 0 0. */
  get surfaceSpeed(): number[];
  set surfaceSpeed(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Sliding speed per tangential force along friction direction 1 and 2, (m/s)/N; needs SLIP-1, SLIP-2. Below 0 counts as 0. (SFVec2f) Default 0 0. */
  get slipFactors(): number[];
  set slipFactors(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Softness of contacts, (m/s)/N; needs CONSTANT_FORCE. A load F sinks in by F · softness / (60 · error correction). No more than a quarter of the thinner body, so that nothing falls through. It yields but does not spring back. Range [0, 1]. (SFFloat) Default 0.0001. */
  get softnessConstantForceMix(): number;
  set softnessConstantForceMix(value: number | string | null | undefined);
  /** Share of an overlap repaired per 1/60 s; needs ERROR_REDUCTION. Range [0, 1]. (SFFloat) Default 0.8. */
  get softnessErrorCorrection(): number;
  set softnessErrorCorrection(value: number | string | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-collision-space>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface CollisionSpaceProperties {
  /** FALSE: its collidables are in the collection only where they are in it by another way. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** The members: collidables and further spaces; `*` means every collidable of the world. (MFNode) */
  get collidables(): Element[] | '*';
  set collidables(value: Iterable<Element> | string | null | undefined);
  /** FALSE: a moving mesh may collide as its convex hull. TRUE: its own triangles. (SFBool) Default false. */
  get useGeometry(): boolean;
  set useGeometry(value: boolean | string | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-collision-sensor>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface CollisionSensorProperties {
  /** What it is for, in words for people. (SFString) */
  get description(): string;
  set description(value: string | null | undefined);
  /** The collection it watches; both members of a pair must be in it. (SFNode) */
  get collider(): Element | null;
  set collider(value: Element | null | undefined);
  /** FALSE: it sends nothing. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Whether anything touched in the last step. (SFBool) Default false. */
  get isActive(): boolean;
  /** The collidables that touch, each once. (MFNode) */
  get intersections(): Element[];
  /** One Contact for each point where members touch, new with every step; made only where it is read or ROUTEd. (MFNode) */
  get contacts(): Record<string, unknown>[];
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-contact>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ContactProperties {
  /** Which parameters act, as on a CollisionCollection; USER_FRICTION gives frictionDirection. (MFString) Default "BOUNCE". */
  get appliedParameters(): string[];
  set appliedParameters(value: string[] | string | null | undefined);
  /** The body that the normal points into: the one that moves, of two that do the one made later. NULL: none. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The other body; NULL where the collidable belongs to none. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Share of the approach speed that comes back. Range [0, 1]. (SFFloat) Default 0. */
  get bounce(): number;
  set bounce(value: number | string | null | undefined);
  /** Unit vector into body1: moved along it, body1 comes free. World frame. (SFVec3f) Default 0 1 0. */
  get contactNormal(): number[];
  set contactNormal(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Depth of the overlap, metres; negative is a gap. (SFFloat) Default 0. */
  get depth(): number;
  set depth(value: number | string | null | undefined);
  /** Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  get frictionCoefficients(): number[];
  set frictionCoefficients(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Friction direction 1, world frame; acts with USER_FRICTION. Along the normal it says nothing. (SFVec3f) Default 0 1 0. */
  get frictionDirection(): number[];
  set frictionDirection(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** The collidable of body1. (SFNode) */
  get geometry1(): Element | null;
  set geometry1(value: Element | null | undefined);
  /** The collidable of body2. (SFNode) */
  get geometry2(): Element | null;
  set geometry2(value: Element | null | undefined);
  /** Approach speed below which nothing bounces, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get minBounceSpeed(): number;
  set minBounceSpeed(value: number | string | null | undefined);
  /** Where they touch, metres, world frame. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Sliding speed per tangential force along direction 1 and 2, (m/s)/N. Below 0 counts as 0. (SFVec2f) Default 0 0. */
  get slipCoefficients(): number[];
  set slipCoefficients(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Softness: speed per normal force, (m/s)/N. Range [0, 1]. (SFFloat) Default 0.0001. */
  get softnessConstantForceMix(): number;
  set softnessConstantForceMix(value: number | string | null | undefined);
  /** Share of the overlap repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  get softnessErrorCorrection(): number;
  set softnessErrorCorrection(value: number | string | null | undefined);
  /** Speed at which body1 is carried along body2, direction 1 and 2, m/s. (SFVec2f) Default 0 0. */
  get surfaceSpeed(): number[];
  set surfaceSpeed(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-ball-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface BallJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  get anchorPoint(): number[];
  set anchorPoint(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** The anchor as body1 carries it, world frame. (SFVec3f) Default 0 0 0. */
  get body1AnchorPoint(): number[];
  /** The anchor as body2 carries it; apart from body1AnchorPoint the joint gapes. (SFVec3f) Default 0 0 0. */
  get body2AnchorPoint(): number[];
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-single-axis-hinge-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface SingleAxisHingeJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  get anchorPoint(): number[];
  set anchorPoint(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** The anchor as body1 carries it, world frame. (SFVec3f) Default 0 0 0. */
  get body1AnchorPoint(): number[];
  /** The anchor as body2 carries it; apart from body1AnchorPoint the joint gapes. (SFVec3f) Default 0 0 0. */
  get body2AnchorPoint(): number[];
  /** Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  get axis(): number[];
  set axis(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default -3.141592653589793. */
  get minAngle(): number;
  set minAngle(value: number | string | null | undefined);
  /** Upper stop, radians. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 3.141592653589793. */
  get maxAngle(): number;
  set maxAngle(value: number | string | null | undefined);
  /** Share of the turning speed that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  get stopBounce(): number;
  set stopBounce(value: number | string | null | undefined);
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  get stopErrorCorrection(): number;
  set stopErrorCorrection(value: number | string | null | undefined);
  /** Angle of body1 relative to body2, radians in (-π, π]. (SFFloat) Default 0. */
  get angle(): number;
  /** Its rate, rad/s. (SFFloat) Default 0. */
  get angleRate(): number;
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-double-axis-hinge-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface DoubleAxisHingeJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  get anchorPoint(): number[];
  set anchorPoint(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** The anchor as body1 carries it, world frame. (SFVec3f) Default 0 0 0. */
  get body1AnchorPoint(): number[];
  /** The anchor as body2 carries it; apart from body1AnchorPoint the joint gapes. (SFVec3f) Default 0 0 0. */
  get body2AnchorPoint(): number[];
  /** Axis of steering and suspension, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  get axis1(): number[];
  set axis1(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Axis of spin, world frame, when the joint is made; body2 carries it. The angle between the axes stays as it is then. (SFVec3f) Default 0 1 0. */
  get axis2(): number[];
  set axis2(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Lower stop of the angle about axis 1, radians from the pose the joint was made at. Above maxAngle1: no stops. Equal to it: held there. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default -3.141592653589793. */
  get minAngle1(): number;
  set minAngle1(value: number | string | null | undefined);
  /** Upper stop of the angle about axis 1, radians. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 3.141592653589793. */
  get maxAngle1(): number;
  set maxAngle1(value: number | string | null | undefined);
  /** Share of the rate about axis 1 that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  get stop1Bounce(): number;
  set stop1Bounce(value: number | string | null | undefined);
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop1ErrorCorrection(): number;
  set stop1ErrorCorrection(value: number | string | null | undefined);
  /** How far the stops give way: a steady torque sinks in by constantForceMix / (60 · errorCorrection) radians per newton metre. 0: not at all. Range [0, Infinity]. (SFFloat) Default 0.001. */
  get stop1ConstantForceMix(): number;
  set stop1ConstantForceMix(value: number | string | null | undefined);
  /** Rate that the motor about axis 1 strives for, rad/s, body1 relative to body2. (SFFloat) Default 0. */
  get desiredAngularVelocity1(): number;
  set desiredAngularVelocity1(value: number | string | null | undefined);
  /** Torque that the motor about axis 1 can muster, newton metres; 0: no motor. Range [0, Infinity]. (SFFloat) Default 0. */
  get maxTorque1(): number;
  set maxTorque1(value: number | string | null | undefined);
  /** Rate that the motor about axis 2 strives for, rad/s, body1 relative to body2. (SFFloat) Default 0. */
  get desiredAngularVelocity2(): number;
  set desiredAngularVelocity2(value: number | string | null | undefined);
  /** Torque that the motor about axis 2 can muster, newton metres; 0: no motor. Range [0, Infinity]. (SFFloat) Default 0. */
  get maxTorque2(): number;
  set maxTorque2(value: number | string | null | undefined);
  /** Softness of the suspension along axis 1, despite its name: stiffness 60 · suspensionErrorCorrection / suspensionForce N/m, damping (1 - suspensionErrorCorrection) / suspensionForce N s/m. 0: rigid. Range [0, Infinity]. (SFFloat) Default 0. */
  get suspensionForce(): number;
  set suspensionForce(value: number | string | null | undefined);
  /** Share of the spring against the damper in the suspension: 1 has no damper, 0 no spring. Range [0, 1]. (SFFloat) Default 0.8. */
  get suspensionErrorCorrection(): number;
  set suspensionErrorCorrection(value: number | string | null | undefined);
  /** Angle about axis 1 of body1 relative to body2, radians in (-π, π]. (SFFloat) Default 0. */
  get hinge1Angle(): number;
  /** Its rate, rad/s. (SFFloat) Default 0. */
  get hinge1AngleRate(): number;
  /** Angle about axis 2 of body1 relative to body2, radians in (-π, π]. (SFFloat) Default 0. */
  get hinge2Angle(): number;
  /** Its rate, rad/s. (SFFloat) Default 0. */
  get hinge2AngleRate(): number;
  /** Where axis1 points now, as body1 carries it: a unit vector, world frame. (SFVec3f) Default 0 0 0. */
  get body1Axis(): number[];
  /** Where axis2 points now, as body2 carries it: a unit vector, world frame. (SFVec3f) Default 0 0 0. */
  get body2Axis(): number[];
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-slider-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface SliderJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** Direction in which they slide, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  get axis(): number[];
  set axis(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Lower stop, metres from the pose the joint was made at; negative is allowed. Above maxSeparation: no stops. (SFFloat) Default 0. */
  get minSeparation(): number;
  set minSeparation(value: number | string | null | undefined);
  /** Upper stop, metres. (SFFloat) Default 1. */
  get maxSeparation(): number;
  set maxSeparation(value: number | string | null | undefined);
  /** Newtons along the axis on both bodies in every step: positive pushes them apart, negative pulls them together. (SFFloat) Default 0. */
  get sliderForce(): number;
  set sliderForce(value: number | string | null | undefined);
  /** Share of the speed that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  get stopBounce(): number;
  set stopBounce(value: number | string | null | undefined);
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 1. */
  get stopErrorCorrection(): number;
  set stopErrorCorrection(value: number | string | null | undefined);
  /** Metres that the bodies moved apart since the joint was made; where neither lay ahead of the other, metres that body1 moved along the axis. (SFFloat) Default 0. */
  get separation(): number;
  /** Its rate, m/s. (SFFloat) Default 0. */
  get separationRate(): number;
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-universal-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface UniversalJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  get anchorPoint(): number[];
  set anchorPoint(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** The anchor as body1 carries it, world frame. (SFVec3f) Default 0 0 0. */
  get body1AnchorPoint(): number[];
  /** The anchor as body2 carries it; apart from body1AnchorPoint the joint gapes. (SFVec3f) Default 0 0 0. */
  get body2AnchorPoint(): number[];
  /** First arm of the cross, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  get axis1(): number[];
  set axis1(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Second arm, at right angles to the first, world frame, when the joint is made; body2 carries it. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  get axis2(): number[];
  set axis2(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0. */
  get stop1Bounce(): number;
  set stop1Bounce(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop1ErrorCorrection(): number;
  set stop1ErrorCorrection(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0. */
  get stop2Bounce(): number;
  set stop2Bounce(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop2ErrorCorrection(): number;
  set stop2ErrorCorrection(value: number | string | null | undefined);
  /** Where axis1 points now, as body1 carries it: a unit vector, world frame. (SFVec3f) Default 0 0 0. */
  get body1Axis(): number[];
  /** Where axis2 points now, as body2 carries it: a unit vector, world frame. (SFVec3f) Default 0 0 0. */
  get body2Axis(): number[];
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-motor-joint>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface MotorJointProperties {
  /** The first body; without it the other side is the world. (SFNode) */
  get body1(): Element | null;
  set body1(value: Element | null | string | undefined);
  /** The second body; without it the other side is the world. (SFNode) */
  get body2(): Element | null;
  set body2(value: Element | null | string | undefined);
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  get forceOutput(): string[];
  set forceOutput(value: string[] | string | null | undefined);
  /** TRUE: the angles are measured, as Euler angles about axis 1 (of body1), axis 3 (of body2) and the one across. FALSE: the author tells them. (SFBool) Default false. */
  get autoCalc(): boolean;
  set autoCalc(value: boolean | string | null | undefined);
  /** How many axes are driven: 0 to 3. Range [0, 3]. (SFInt32) Default 1. */
  get enabledAxes(): number;
  set enabledAxes(value: number | string | null | undefined);
  /** Direction of axis 1, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  get motor1Axis(): number[];
  set motor1Axis(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Angle about axis 1 as the author measured it, radians: motor1Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  get axis1Angle(): number;
  set axis1Angle(value: number | string | null | undefined);
  /** Torque about axis 1, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  get axis1Torque(): number;
  set axis1Torque(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0. */
  get stop1Bounce(): number;
  set stop1Bounce(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop1ErrorCorrection(): number;
  set stop1ErrorCorrection(value: number | string | null | undefined);
  /** Angle about axis 1, radians: of body1 relative to body2 with autoCalc, else axis1Angle. (SFFloat) Default 0. */
  get motor1Angle(): number;
  /** Rate about axis 1 of body1 relative to body2, rad/s. (SFFloat) Default 0. */
  get motor1AngleRate(): number;
  /** Direction of axis 2, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  get motor2Axis(): number[];
  set motor2Axis(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Angle about axis 2 as the author measured it, radians: motor2Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  get axis2Angle(): number;
  set axis2Angle(value: number | string | null | undefined);
  /** Torque about axis 2, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  get axis2Torque(): number;
  set axis2Torque(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0. */
  get stop2Bounce(): number;
  set stop2Bounce(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop2ErrorCorrection(): number;
  set stop2ErrorCorrection(value: number | string | null | undefined);
  /** Angle about axis 2, radians: of body1 relative to body2 with autoCalc, else axis2Angle. (SFFloat) Default 0. */
  get motor2Angle(): number;
  /** Rate about axis 2 of body1 relative to body2, rad/s. (SFFloat) Default 0. */
  get motor2AngleRate(): number;
  /** Direction of axis 3, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 0 0 1. */
  get motor3Axis(): number[];
  set motor3Axis(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Angle about axis 3 as the author measured it, radians: motor3Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  get axis3Angle(): number;
  set axis3Angle(value: number | string | null | undefined);
  /** Torque about axis 3, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  get axis3Torque(): number;
  set axis3Torque(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 3. Range [0, 1]. (SFFloat) Default 0. */
  get stop3Bounce(): number;
  set stop3Bounce(value: number | string | null | undefined);
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 3. Range [0, 1]. (SFFloat) Default 0.8. */
  get stop3ErrorCorrection(): number;
  set stop3ErrorCorrection(value: number | string | null | undefined);
  /** Angle about axis 3, radians: of body1 relative to body2 with autoCalc, else axis3Angle. (SFFloat) Default 0. */
  get motor3Angle(): number;
  /** Rate about axis 3 of body1 relative to body2, rad/s. (SFFloat) Default 0. */
  get motor3AngleRate(): number;
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-particle-system>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ParticleSystemProperties {
  /** What its particles are drawn with. (SFNode) */
  get appearance(): Element | null;
  set appearance(value: Element | null | undefined);
  /** Whether its particles cast shadows. (SFBool) Default true. */
  get castShadow(): boolean;
  set castShadow(value: boolean | string | null | undefined);
  /** Colours that particles are drawn in, one for each colorKey. (SFNode) */
  get color(): Element | null;
  set color(value: Element | null | undefined);
  /** Ages of particles, seconds, at which they have the colours of color. Range [0, Infinity]. (MFFloat) */
  get colorKey(): number[];
  set colorKey(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get createParticles(): boolean;
  set createParticles(value: boolean | string | null | undefined);
  /** FALSE: it has no particles. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** What each particle is drawn as where geometryType is GEOMETRY. (SFNode) */
  get geometry(): Element | null;
  set geometry(value: Element | null | undefined);
  /** What particles are drawn as: QUAD, LINE, POINT, SPRITE, TRIANGLE, or GEOMETRY, which is that of geometry. (SFString) Default QUAD. */
  get geometryType(): string;
  set geometryType(value: string | null | undefined);
  /** Greatest share of particleLifetime by which a particle lives longer or less long, evenly spread. Range [0, 1]. (SFFloat) Default 0.25. */
  get lifetimeVariation(): number;
  set lifetimeVariation(value: number | string | null | undefined);
  /** How many particles may live at once. Range [0, Infinity]. (SFInt32) Default 200. */
  get maxParticles(): number;
  set maxParticles(value: number | string | null | undefined);
  /** How long a particle lives, seconds. Range [0, Infinity]. (SFFloat) Default 5. */
  get particleLifetime(): number;
  set particleLifetime(value: number | string | null | undefined);
  /** Width and height of a particle, metres. Range [0, Infinity]. (SFVec2f) Default 0.02 0.02. */
  get particleSize(): number[];
  set particleSize(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Whether it has particles, or some will be born by themselves. (SFBool) Default false. */
  get isActive(): boolean;
  /** Texture coordinates that particles are drawn with, a set for each texCoordKey. (SFNode) */
  get texCoord(): Element | null;
  set texCoord(value: Element | null | undefined);
  /** Ages of particles, seconds, from which on they have the next set of texCoord. Range [0, Infinity]. (MFFloat) */
  get texCoordKey(): number[];
  set texCoordKey(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Where particles are born, and how; NULL: none are. (SFNode) */
  get emitter(): Element | null;
  set emitter(value: Element | null | undefined);
  /** What moves particles: all of these models act together. (MFNode) */
  get physics(): Element[];
  set physics(value: Iterable<Element> | null | undefined);
  /** TRUE: particles bounce off bodies. (SFBool) Default false. */
  get collides(): boolean;
  set collides(value: boolean | string | null | undefined);
  /** TRUE: particles that bounce off bodies push them by their mass, and its winds push bodies. (SFBool) Default false. */
  get pushes(): boolean;
  set pushes(value: boolean | string | null | undefined);
  /** Share of the approach speed that comes back when a particle meets a body. Range [0, 1]. (SFFloat) Default 0. */
  get bounce(): number;
  set bounce(value: number | string | null | undefined);
  /** Coulomb friction of particles on bodies. Range [0, Infinity]. (SFFloat) Default 0.5. */
  get friction(): number;
  set friction(value: number | string | null | undefined);
  /** What is random about particles follows from it: the same number gives the same particles. (SFInt32) Default 0. */
  get seed(): number;
  set seed(value: number | string | null | undefined);
  /** Share of its speed that a particle loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get damping(): number;
  set damping(value: number | string | null | undefined);
  /** The body that its emitter stands on and moves with; NULL: the emitter stands in the world. (SFNode) */
  get body(): Element | null;
  set body(value: Element | null | undefined);
  /** Where its particles are, metres, the oldest first. (MFVec3f) */
  get positions(): number[][];
  /** How many particles live. (SFInt32) Default 0. */
  get count(): number;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-cone-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ConeEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  get direction(): number[];
  set direction(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Greatest angle between direction and the way of a particle, radians. Range [0, 3.141592653589793]. (SFFloat) Default 0.7853981633974483. */
  get angle(): number;
  set angle(value: number | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-explosion-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ExplosionEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-point-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface PointEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  get direction(): number[];
  set direction(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-polyline-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface PolylineEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  get direction(): number[];
  set direction(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Its points, metres, in the frame of the system: a Coordinate, or the flat list of its numbers. (SFNode) */
  get coord(): Element | null;
  set coord(value: Element | null | undefined);
  /** Which points make a line, counted from 0, with -1 after each line; -1 alone: all in order make one. Range [-1, Infinity]. (MFInt32) Default -1. */
  get coordIndex(): number[];
  set coordIndex(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-surface-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface SurfaceEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** The geometry on which particles are born; NULL: none are. (SFNode) */
  get surface(): Element | null;
  set surface(value: Element | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-volume-emitter>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface VolumeEmitterProperties {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  get on(): boolean;
  set on(value: boolean | string | null | undefined);
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  get variation(): number;
  set variation(value: number | string | null | undefined);
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  get surfaceArea(): number;
  set surfaceArea(value: number | string | null | undefined);
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  get direction(): number[];
  set direction(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Its points, metres, in the frame of the system: a Coordinate, or the flat list of its numbers. (SFNode) */
  get coord(): Element | null;
  set coord(value: Element | null | undefined);
  /** Which points make a face, counted from 0, with -1 after each face: together they are closed. Range [-1, Infinity]. (MFInt32) Default -1. */
  get coordIndex(): number[];
  set coordIndex(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** TRUE: particles are born anywhere inside; FALSE: only on the surface. (SFBool) Default true. */
  get internal(): boolean;
  set internal(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-bounded-physics-model>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface BoundedPhysicsModelProperties {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** The geometry that particles bounce off, in the frame of their system. (SFNode) */
  get geometry(): Element | null;
  set geometry(value: Element | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-force-physics-model>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ForcePhysicsModelProperties {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Force on each particle, newtons, in the frame of their system; divided by its mass it is an acceleration. (SFVec3f) Default 0 -9.8 0. */
  get force(): number[];
  set force(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-wind-physics-model>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface WindPhysicsModelProperties {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Where the wind blows, in the frame of the system, whatever its length; 0 0 0: each time elsewhere. (SFVec3f) Default 1 0 0. */
  get direction(): number[];
  set direction(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Speed of the wind between gusts, m/s. Range [0, Infinity]. (SFFloat) Default 0.1. */
  get speed(): number;
  set speed(value: number | string | null | undefined);
  /** Greatest share of the speed by which that of a gust is more or less. Range [0, Infinity]. (SFFloat) Default 0.1. */
  get gustiness(): number;
  set gustiness(value: number | string | null | undefined);
  /** How far particles and bodies are pushed off the way of the wind, each another way: 0 not at all, 1 anywhere. Range [0, 1]. (SFFloat) Default 0. */
  get turbulence(): number;
  set turbulence(value: number | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-rope>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface RopeProperties {
  /** FALSE: it stands still, and holds nothing. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** A LineSet or an IndexedLineSet: its first line is the rope as it is laid. (SFNode) */
  get geometry(): Element | null;
  set geometry(value: Element | null | undefined);
  /** The line along which it is laid, metres; it wins over geometry. An edit lays it anew. (MFVec3f) */
  get points(): number[][];
  set points(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** How many links of one length it is divided into; 0: as many as its line has. Range [0, 10000]. (SFInt32) Default 0. */
  get segments(): number;
  set segments(value: number | string | null | undefined);
  /** kg, of the whole rope. Range (0, Infinity]. (SFFloat) Default 1. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** Half of its thickness, metres; 0: it touches nothing. Range [0, Infinity]. (SFFloat) Default 0.01. */
  get radius(): number;
  set radius(value: number | string | null | undefined);
  /** Newtons that would stretch it to twice its length, if it went on as it begins; 0: it does not stretch. Range [0, Infinity]. (SFFloat) Default 0. */
  get stretchStiffness(): number;
  set stretchStiffness(value: number | string | null | undefined);
  /** What it takes to bend it, N m²: E I of a beam; 0: it bends freely. More than a step follows is told (soft-too-stiff). Range [0, Infinity]. (SFFloat) Default 0. */
  get bendStiffness(): number;
  set bendStiffness(value: number | string | null | undefined);
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get damping(): number;
  set damping(value: number | string | null | undefined);
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  get friction(): number;
  set friction(value: number | string | null | undefined);
  /** TRUE: its links do not go through each other. It costs, so it is off. (SFBool) Default false. */
  get selfCollision(): boolean;
  set selfCollision(value: boolean | string | null | undefined);
  /** Points that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  get fixedIndex(): number[];
  set fixedIndex(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  get draggableBody(): boolean;
  set draggableBody(value: boolean | string | null | undefined);
  /** Where its points are, metres. (MFVec3f) */
  get positions(): number[][];
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
}

/** Properties of `<x3d-soft-body-attachment>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface SoftBodyAttachmentProperties {
  /** The rope, the cloth or the soft body. (SFNode) */
  get softBody(): Element | null;
  set softBody(value: Element | null | undefined);
  /** Which of its points, counted from 0. Range [0, Infinity]. (SFInt32) Default 0. */
  get index(): number;
  set index(value: number | string | null | undefined);
  /** The body; NULL: the world. (SFNode) */
  get body(): Element | null;
  set body(value: Element | null | undefined);
  /** Where on the body, metres, in its frame; without a body in the world. The point is taken there. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
}

/** Properties of `<x3d-cloth>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ClothProperties {
  /** FALSE: it stands still, touches nothing and holds nothing. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Its surface as it is laid: an IndexedTriangleSet, an IndexedFaceSet, or any other geometry by its triangles. (SFNode) */
  get geometry(): Element | null;
  set geometry(value: Element | null | undefined);
  /** Width and height of a sheet around its origin in the x-y plane, as X3DOM’s Plane lies, metres; without it there is what geometry says. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  get size(): number[];
  set size(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** How many cells such a sheet has along its width and its height: its points are counted from its lower left corner, row by row. Range [1, 200]. (SFVec2f) Default 16 16. */
  get subdivision(): number[];
  set subdivision(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** kg, of all of it. Range (0, Infinity]. (SFFloat) Default 1. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** How thick it is, metres; 0: it touches nothing. Range [0, Infinity]. (SFFloat) Default 0.01. */
  get thickness(): number;
  set thickness(value: number | string | null | undefined);
  /** Newtons for each metre of width that would stretch it to twice its length along its threads, if it went on as it begins; 0: it does not stretch. Range [0, Infinity]. (SFFloat) Default 0. */
  get stretchStiffness(): number;
  set stretchStiffness(value: number | string | null | undefined);
  /** The same for what makes its squares slanted, N/m. Range [0, Infinity]. (SFFloat) Default 10. */
  get shearStiffness(): number;
  set shearStiffness(value: number | string | null | undefined);
  /** What it takes to bend a metre of width of it, N m; 0: it bends freely. More than a step follows is told (soft-too-stiff). Range [0, Infinity]. (SFFloat) Default 0. */
  get bendStiffness(): number;
  set bendStiffness(value: number | string | null | undefined);
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get damping(): number;
  set damping(value: number | string | null | undefined);
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  get friction(): number;
  set friction(value: number | string | null | undefined);
  /** Points of its geometry that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  get fixedIndex(): number[];
  set fixedIndex(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** TRUE: its points do not come nearer to each other than it is thick. (SFBool) Default false. */
  get selfCollision(): boolean;
  set selfCollision(value: boolean | string | null | undefined);
  /** A thread that is stretched by more than this share of its length tears, and the triangles it borders with it; 0: none does. Range [0, Infinity]. (SFFloat) Default 0. */
  get tearStrain(): number;
  set tearStrain(value: number | string | null | undefined);
  /** Where the air goes and how fast, m/s, in the world; 0 0 0: there is none. (SFVec3f) Default 0 0 0. */
  get wind(): number[];
  set wind(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  get draggableBody(): boolean;
  set draggableBody(value: boolean | string | null | undefined);
  /** Where the points of its geometry are, metres. (MFVec3f) */
  get positions(): number[][];
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
}

/** Properties of `<x3d-soft-body>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface SoftBodyProperties {
  /** FALSE: it stands still, touches nothing and holds nothing. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Its surface as it is laid: an IndexedTriangleSet, an IndexedFaceSet, or any other geometry by its triangles. (SFNode) */
  get geometry(): Element | null;
  set geometry(value: Element | null | undefined);
  /** kg, of all of it. Range (0, Infinity]. (SFFloat) Default 1. */
  get mass(): number;
  set mass(value: number | string | null | undefined);
  /** What it takes to stretch it, Pa: rubber has 1e6 and more, jelly 1e4. More than a step follows is told (soft-too-stiff). Range (0, Infinity]. (SFFloat) Default 10000. */
  get youngsModulus(): number;
  set youngsModulus(value: number | string | null | undefined);
  /** How much thinner it gets where it is stretched: 0.5 would keep its volume. Range [0, 0.499]. (SFFloat) Default 0.3. */
  get poissonsRatio(): number;
  set poissonsRatio(value: number | string | null | undefined);
  /** Pa above that of the air, as it is laid: it is hollow then, a ball or a cushion. 0: it is solid. Range [0, Infinity]. (SFFloat) Default 0. */
  get pressure(): number;
  set pressure(value: number | string | null | undefined);
  /** How thick its skin is where it is hollow, metres; 0: as thick as its mass is of rubber, 1000 kg/m³. Range [0, Infinity]. (SFFloat) Default 0. */
  get thickness(): number;
  set thickness(value: number | string | null | undefined);
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  get damping(): number;
  set damping(value: number | string | null | undefined);
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  get friction(): number;
  set friction(value: number | string | null | undefined);
  /** Points of its geometry that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  get fixedIndex(): number[];
  set fixedIndex(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  get draggableBody(): boolean;
  set draggableBody(value: boolean | string | null | undefined);
  /** Where the points of its geometry are, metres. (MFVec3f) */
  get positions(): number[][];
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
}

/** Properties of `<x3d-water-volume>`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface WaterVolumeProperties {
  /** FALSE: it is not there. (SFBool) Default true. */
  get enabled(): boolean;
  set enabled(value: boolean | string | null | undefined);
  /** Where its middle is, metres; in a page in the frame of the Transform that it stands in, or for. (SFVec3f) Default 0 0 0. */
  get position(): number[];
  set position(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** How it is turned: its surface looks along its y. (SFRotation) Default 0 0 1 0. */
  get orientation(): number[];
  set orientation(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Its width, depth and length, metres; in a page, where nothing is said, those of the Box of the Shape beside it. Range [0, Infinity]. (SFVec3f) Default 10 2 10. */
  get size(): number[];
  set size(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** kg/m³: where volumes overlap there is what is denser. Range [0, Infinity]. (SFFloat) Default 1000. */
  get density(): number;
  set density(value: number | string | null | undefined);
  /** Quadratic drag: half of the density times this, the wetted cross-section and the square of the speed through the water, newtons. Range [0, Infinity]. (SFFloat) Default 1. */
  get dragCoefficient(): number;
  set dragCoefficient(value: number | string | null | undefined);
  /** Lift: what wetted faces that stand aslant are pushed aside by, as drag is reckoned. It takes no energy. Range [0, Infinity]. (SFFloat) Default 1. */
  get liftCoefficient(): number;
  set liftCoefficient(value: number | string | null | undefined);
  /** Linear drag, 1/s: of its speed through the water and of its spin what floats loses this share in a second; what is wetted by more or less than it weighs loses more or less. Range [0, Infinity]. (SFFloat) Default 1. */
  get damping(): number;
  set damping(value: number | string | null | undefined);
  /** Share of the mass of the displaced water that has to be moved along with a body that moves freely: a ball in deep water has 0.5. Range [0, Infinity]. (SFFloat) Default 0. */
  get addedMass(): number;
  set addedMass(value: number | string | null | undefined);
  /** Where the water goes and how fast, m/s, in its own frame: what floats goes along. (SFVec3f) Default 0 0 0. */
  get flow(): number[];
  set flow(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** TRUE: its surface moves. What goes through it makes waves, and what floats rides on them. (SFBool) Default false. */
  get waves(): boolean;
  set waves(value: boolean | string | null | undefined);
  /** Cells of a surface that moves along its width and its length: one number counts for both. More show shorter waves, and cost more. Other cells begin flat. Range [1, 256]. (MFInt32) Default 64 64. */
  get subdivision(): number[];
  set subdivision(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** REFLECTING: waves come back from its sides, as in a pool. OPEN: they go on, as in a sea. (SFString) Default REFLECTING. */
  get edges(): string;
  set edges(value: string | null | undefined);
  /** Share of its speed that the water of a surface that moves loses in a second: waves lose half of that of their height. Range [0, Infinity]. (SFFloat) Default 0.2. */
  get waveDamping(): number;
  set waveDamping(value: number | string | null | undefined);
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  get bboxCenter(): number[];
  set bboxCenter(
    value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined,
  );
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  get bboxSize(): number[];
  set bboxSize(value: ArrayLike<number> | readonly ArrayLike<number>[] | string | null | undefined);
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  get bboxDisplay(): boolean;
  set bboxDisplay(value: boolean | string | null | undefined);
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  get visible(): boolean;
  set visible(value: boolean | string | null | undefined);
  /** Data about the node, for programs that read them. (SFNode) */
  get metadata(): Element | null;
  set metadata(value: Element | null | undefined);
  /** DEF or id of the Transform, Shape or group that it stands for. */
  for: string;
}

/** By type of node. */
export interface ElementProperties {
  RigidBodyCollection: RigidBodyCollectionProperties;
  RigidBody: RigidBodyProperties;
  CollidableShape: CollidableShapeProperties;
  CollidableOffset: CollidableOffsetProperties;
  CollisionCollection: CollisionCollectionProperties;
  CollisionSpace: CollisionSpaceProperties;
  CollisionSensor: CollisionSensorProperties;
  Contact: ContactProperties;
  BallJoint: BallJointProperties;
  SingleAxisHingeJoint: SingleAxisHingeJointProperties;
  DoubleAxisHingeJoint: DoubleAxisHingeJointProperties;
  SliderJoint: SliderJointProperties;
  UniversalJoint: UniversalJointProperties;
  MotorJoint: MotorJointProperties;
  ParticleSystem: ParticleSystemProperties;
  ConeEmitter: ConeEmitterProperties;
  ExplosionEmitter: ExplosionEmitterProperties;
  PointEmitter: PointEmitterProperties;
  PolylineEmitter: PolylineEmitterProperties;
  SurfaceEmitter: SurfaceEmitterProperties;
  VolumeEmitter: VolumeEmitterProperties;
  BoundedPhysicsModel: BoundedPhysicsModelProperties;
  ForcePhysicsModel: ForcePhysicsModelProperties;
  WindPhysicsModel: WindPhysicsModelProperties;
  Rope: RopeProperties;
  SoftBodyAttachment: SoftBodyAttachmentProperties;
  Cloth: ClothProperties;
  SoftBody: SoftBodyProperties;
  WaterVolume: WaterVolumeProperties;
}

/** The events of all physics elements. They bubble, so that they can be listened to anywhere above. */
export interface PhysicsEventMap {
  /** It has begun to touch another one. */
  collisionstart: CustomEvent<{
    other: Element;
    impulse: number;
    contacts: { position: number[]; normal: number[]; depth: number; impulse: number }[];
    time: number;
    reason?: string;
  }>;
  /** It no longer touches the other one; `reason` says why. */
  collisionend: CustomEvent<{
    other: Element;
    impulse: number;
    contacts: { position: number[]; normal: number[]; depth: number; impulse: number }[];
    time: number;
    reason?: string;
  }>;
  /** It has come to rest and is simulated no longer. */
  sleep: CustomEvent<{ time: number }>;
  /** It moves again. */
  wake: CustomEvent<{ time: number }>;
  /** It has come into water. */
  waterenter: CustomEvent<{ water: Element; depth: number; speed: number; time: number }>;
  /** It is in water no more. */
  waterleave: CustomEvent<{ water: Element; depth: number; speed: number; time: number }>;
  /** It has reached one of its stops. */
  jointlimit: CustomEvent<{ limit: 'min' | 'max'; value: number; axis?: number; time: number }>;
  /** Somebody takes hold of it; `preventDefault` forbids that. */
  bodydragstart: CustomEvent<{
    point: number[];
    mode: string;
    by: 'mouse' | 'touch' | 'pen' | 'keyboard';
    time: number;
    reason?: string;
  }>;
  /** Who holds it moved. */
  bodydrag: CustomEvent<{
    point: number[];
    mode: string;
    by: 'mouse' | 'touch' | 'pen' | 'keyboard';
    time: number;
    reason?: string;
  }>;
  /** It is held no more; `reason` says why. */
  bodydragend: CustomEvent<{
    point: number[];
    mode: string;
    by: 'mouse' | 'touch' | 'pen' | 'keyboard';
    time: number;
    reason?: string;
  }>;
  /** Its world has started. */
  physicsready: CustomEvent<Record<string, unknown>>;
  /** Time was dropped. */
  physicslag: CustomEvent<{ dropped: number; time: number }>;
  /** Another accuracy level is in force; `because` says why (`asked`, or with auto `over budget`, `room for more`). */
  physicsaccuracy: CustomEvent<{ level: string; from: string; because: string; p90?: number }>;
  /** A step begins; what is done now acts in it. */
  beforestep: CustomEvent<{ time: number; timeStep: number }>;
  /** A step is over. */
  afterstep: CustomEvent<{ time: number; timeStep: number }>;
  /** Something that the author should know. */
  physicsproblem: CustomEvent<{
    code: string;
    severity: string;
    message: string;
    element: Element;
  }>;
}
