// Effects of the chunk `joints`.
import { jointSolve, motors, stops, suspension } from './joints/effects.js';
import { JointSolve } from './joints/joint-solve.js';
import { Motors } from './joints/motors.js';
import { Stops } from './joints/stops.js';
import { Suspension } from './joints/suspension.js';

export function provideJointEffects(): void {
  jointSolve.load = (simulation, effects) => new JointSolve(simulation, effects);
  suspension.load = (simulation, effects) => new Suspension(simulation, effects);
  motors.load = () => new Motors();
  stops.load = (simulation) => new Stops(simulation);
}
