import { readFileSync, writeFileSync } from 'node:fs';
import type { Row } from '../run/row.js';
import type { Cost } from './cost.js';
import type { Endurance } from './endurance.js';

/** What one run of the lab of joints measured. */
export interface JointNumbers {
  machine: string;
  date: string;
  /** Chains by Bullet's iterations alone; with the solve they are cases of the report. */
  iterated: Row[];
  endurance: Endurance[];
  costs: Cost[];
}

const FILE = new URL('../report/joints.json', import.meta.url);

export const readJoints = (): JointNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as JointNumbers;

export const writeJoints = (numbers: JointNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 2)}\n`);
