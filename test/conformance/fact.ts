/**
 * X3D nodes as data. Fields that hold nodes hold NodeData; `{ USE: 'name' }` stands for a node that is DEFed before or
 * after it.
 */
export interface NodeData {
  type?: string;
  DEF?: string;
  USE?: string;
  [field: string]: unknown;
}

/** One measurement. Numbers and lists of numbers may be off by `tolerance`; anything else is exactly equal. */
export interface Check {
  what: string;
  actual: number | number[] | boolean | string | string[];
  expected: number | number[] | boolean | string | string[];
  tolerance?: number;
  unit?: string;
}

/** One sentence about one field of one node, and the scene that shows it in any X3D browser. */
export interface Fact {
  /** The field that this proves; the node is the one whose list the fact stands in. */
  field: string;
  says: string;
  /** The reading it measures, where the standard leaves one open. */
  open?: string;
  /** The field is about no motion, and the fact says only that. */
  inert?: true;
  /** Why our own library does not meet it yet; its tests then expect that it fails. */
  unmet?: string;
  /** Page code acts in it once a frame; our library then takes one step a frame. */
  frameByFrame?: true;
  /** What our library tells its author meanwhile, by problem code; nothing else may be told. */
  tells?: string[];
  /** What stands in the Scene. */
  scene: NodeData[];
  run(x: Driver): Promise<Check[]>;
}

/** An X3D browser that shows a fact's scene. Asynchronous, since some browsers live in another process. */
export interface Driver {
  /** The live value: nodes as their DEF names (null and [] where there is none), Contacts as plain objects. */
  get(def: string, field: string): Promise<any>;
  /** Sends an X3D event. Fields that hold nodes take NodeData. */
  set(def: string, field: string, value: unknown): Promise<void>;
  advance(seconds: number): Promise<void>;
}

/** A Driver with its scene, until it is closed. */
export interface Stage extends Driver {
  close(): Promise<void>;
}

/** Shows the scene of a fact. */
export type Open = (fact: Fact) => Promise<Stage>;

/** The scene as our library gets it: at level `game` a step is a frame. */
export const ownScene = ({ scene, frameByFrame }: Fact): NodeData[] =>
  frameByFrame
    ? scene.map((node) =>
        node.type === 'RigidBodyCollection' ? { ...node, accuracy: 'game' } : node,
      )
    : scene;
