import { cpus, platform, release, totalmem } from 'node:os';

/** What the lab runs on. */
export interface Machine {
  cpu: string;
  cores: number;
  memoryGB: number;
  system: string;
  node: string;
}

export const machine: Machine = {
  cpu: cpus()[0]?.model ?? 'unknown',
  cores: cpus().length,
  memoryGB: Math.round(totalmem() / 2 ** 30),
  system: `${platform()} ${release()}`,
  node: process.version,
};

/** In a sentence. */
export const MACHINE = `${machine.cpu}, ${machine.cores} cores, ${machine.system}, Node ${machine.node}`;

/** As in 2026-11-21. */
export const today = (): string => new Date().toISOString().slice(0, 10);
