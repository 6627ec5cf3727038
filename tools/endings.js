// How we end, and what ends with us.
import { readFileSync } from 'node:fs';

const children = new Set();
let isListening = false;

/** A signal ends us without our listeners of `exit`, unless it is listened to itself. */
const exitBy = (signal, number) => process.once(signal, () => process.exit(128 + number));

/** Ends a process with ours, however ours ends (short of SIGKILL). */
export function endWithUs(child) {
  if (!isListening) {
    isListening = true;
    process.on('exit', () => {
      for (const each of children) each.kill();
    });
    exitBy('SIGTERM', 15);
  }
  children.add(child);
  child.once('exit', () => children.delete(child));
  return child;
}

const SIGNALS = { SIGHUP: 1, SIGINT: 2, SIGTERM: 15 };

/** Milliseconds between two looks. */
const APART = 300;

/** The parent of a process, where the system says so in a file; our own is known everywhere. */
function parentOf(pid) {
  if (pid === process.pid) return process.ppid;
  try {
    return Number(/^PPid:\s*(\d+)/m.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]);
  } catch {
    return undefined;
  }
}

/** Who started us, and who started that: between npm and us some shells stay. */
function starters() {
  const parent = parentOf(process.pid);
  return `${parent} ${parentOf(parent)}`;
}

/**
 * Ends us by any signal, and when who started us has ended: npm, killed by one that it can't hand on, would leave a server
 * on its port.
 */
export function endWithStarters() {
  for (const [signal, number] of Object.entries(SIGNALS)) exitBy(signal, number);
  const first = starters();
  setInterval(() => {
    if (starters() !== first) process.exit(1);
  }, APART).unref();
}
