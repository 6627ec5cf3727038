/** What one run of a case came to: a line of rows.json. */
export interface Row {
  case: string;
  scene: string;
  engine: string;
  level: string | null;
  /** Seconds. */
  step: number;
  iterations: number;
  effects: string[];
  /** Null where what is measured never came about, or is not finite. */
  error: number | null;
  unit: string;
  /** Widest joint at any look, metres. */
  gap: number | null;
  /** Of the whole scene from the first look to the last, joules; motors, friction and drag change it rightly. */
  energyChange: number | null;
  /** Milliseconds of work per simulated second. */
  ms: number;
  /** Contact points at the end; null where the engine does not tell. */
  contacts: number | null;
  joints: number;
  /** Of all poses and velocities at the end, bit for bit. */
  hash: string;
}

/** A case that an engine has no words for. */
export interface NotOfferedRow {
  case: string;
  engine: string;
  reason: string;
}

/** Cases that were measured together. */
export interface Run {
  machine: string;
  /** As in 2026-11-21. */
  date: string;
  cases: string[];
}

/** All that is known of some cases. */
export interface Measured {
  rows: Row[];
  notOffered: NotOfferedRow[];
}

/** The report's numbers. */
export interface Results extends Measured {
  runs: Run[];
}
