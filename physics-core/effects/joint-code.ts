// The chunk `joints`.
import { JointConstraint } from '../engine/joint-constraint.js';
import type { JointCode } from './effect/chunks.js';
import { direction, notAlong, reportAxis } from './joints/axes.js';
import { jointSolve, motors, stops, suspension } from './joints/effects.js';
import { leverRatio, orientations } from './joints/joint-frames.js';
import { reportBodies, reportIdle, reportMassRatio } from './joints/joint-reports.js';
import { JointSolve } from './joints/joint-solve.js';
import { Motors } from './joints/motors.js';
import { Stops } from './joints/stops.js';
import { Suspension } from './joints/suspension.js';

export function provide(): JointCode {
  jointSolve.load = (simulation, effects) => new JointSolve(simulation, effects);
  suspension.load = (simulation, effects) => new Suspension(simulation, effects);
  motors.load = () => new Motors();
  stops.load = (simulation) => new Stops(simulation);
  return {
    constraint: (...parts) => new JointConstraint(...parts),
    orientations,
    leverRatio,
    direction,
    notAlong,
    reportAxis,
    reportBodies,
    reportIdle,
    reportMassRatio,
  };
}
