/**
 * One fact about one field, effect or guard. The tests run all of them; the mutation tests break what a row names and
 * expect one of its rows to throw. A row edits the field while the world runs and looks at motion or Bullet's state.
 */
export interface Row {
  field?: string;
  effect?: string;
  guard?: string;
  fact: string;
  run: () => void | Promise<void>;
}
