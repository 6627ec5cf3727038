export type Progress = (doing: string) => void;

/** One line that is written over. */
export const progress: Progress = (doing) => {
  if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${doing}`);
};
