/** What follows the steps of a world while they are recorded. */
export interface StepRecorder {
  /** Whether somebody looks at what was. */
  readonly looking: boolean;
  /** Whether what was recorded is being shown. */
  readonly playing: boolean;
  /** A step is over, and nobody has heard of it. */
  stepped(): void;
  /** Goes on from where somebody looks. */
  resume(): void;
  /** Time passes on the clock while somebody looks, seconds. */
  frame(seconds: number): void;
}
