// In the process of Node's tests, between two of them: the event loop has its turn, and who follows the run hears at once
// of what has ended. Facts that wait for nothing but promises would be told of all together, at the end.
import { beforeEach } from 'node:test';

beforeEach(() => new Promise((resolve) => void setImmediate(resolve)));
