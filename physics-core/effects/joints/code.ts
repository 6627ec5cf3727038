// The chunk `joints`.
import { jointSolve, motors, stops, suspension } from './effects.js';
import { JointSolve } from './joint-solve.js';
import { Motors } from './motors.js';
import { Stops } from './stops.js';
import { Suspension } from './suspension.js';

export function provide(): void {
  jointSolve.load = (simulation, effects) => new JointSolve(simulation, effects);
  suspension.load = (simulation, effects) => new Suspension(simulation, effects);
  motors.load = () => new Motors();
  stops.load = (simulation) => new Stops(simulation);
}
