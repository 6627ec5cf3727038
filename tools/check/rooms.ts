// npm run rooms [-- core bridge]: whether the rooms of each tree keep their order (tools/check/rooms.config.js), what goes in
// circles, and what is long. Fails where an arrow points up, or a circle of files is too large and not named.
import { readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { trees } from './rooms.config.js';
import { circlesOf, type Graph } from './rooms/circles.js';
import { readTree, roomOf, type Tree } from './rooms/imports.js';

/** The most files that may import each other in a circle. */
const LARGEST_CIRCLE = 4;
const LONG = 300;

const lengthOf = (file: string): number => readFileSync(file, 'utf8').split('\n').length - 1;

function median(numbers: number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 0;
}

function list(title: string, lines: string[]): void {
  console.log(`\n${title}: ${lines.length === 0 ? 'none' : lines.length}`);
  for (const line of lines) console.log(`  ${line}`);
}

/** The same graph, of folders: rooms, and what is within them. */
function betweenFolders(files: Graph): Graph {
  const folders: Graph = new Map();
  for (const [file, targets] of files) {
    const from = posix.dirname(file);
    const reached = folders.get(from) ?? new Set();
    for (const target of targets)
      if (posix.dirname(target) !== from) reached.add(posix.dirname(target));
    folders.set(from, reached);
  }
  return folders;
}

function showRooms(tree: Tree, files: Graph): void {
  const all = [...files.keys()];
  const lines = (of: string[]): string =>
    `${String(of.length).padStart(4)} files, median ${String(median(of.map(lengthOf))).padStart(3)} lines`;
  for (const room of [...tree.order, ...strays(tree, files)])
    console.log(`  ${room.padEnd(12)}${lines(all.filter((file) => roomOf(tree, file) === room))}`);
  console.log(`  ${'together'.padEnd(12)}${lines(all)}`);
}

/** Folders that the list leaves out. */
const strays = (tree: Tree, files: Graph): string[] =>
  [...new Set([...files.keys()].map((file) => roomOf(tree, file)))].filter(
    (room) => !tree.order.includes(room),
  );

function arrowsUp(tree: Tree, files: Graph): string[] {
  const rank = (file: string): number => tree.order.indexOf(roomOf(tree, file));
  return [...files].flatMap(([file, targets]) =>
    [...targets]
      .filter((target) => rank(file) < 0 || rank(target) < 0 || rank(target) > rank(file))
      .map((target) => `${tree.short(file)} -> ${tree.short(target)}`),
  );
}

/** Whether the tree is as it is to be. */
function check(name: string): boolean {
  const described = trees[name];
  if (!described) throw new Error(`${name} is none of ${Object.keys(trees).join(', ')}`);
  const tree = readTree(described);
  const files = tree.imports;
  console.log(`\n${name} (${tree.root}), from the bottom up`);
  showRooms(tree, files);
  const up = arrowsUp(tree, files);
  list('Arrows against the order', up);
  const members = (circle: string[]): string =>
    `${circle.length}: ${circle.map((each) => tree.short(each)).join(', ')}`;
  const folders = circlesOf(betweenFolders(files));
  list(
    'Circles of folders',
    folders.map((circle) => circle.join(', ')),
  );
  const circles = circlesOf(files);
  list('Circles of files', circles.map(members));
  const long = [...files.keys()].filter((file) => lengthOf(file) > LONG);
  list(
    `Files of more than ${LONG} lines`,
    long.map((file) => `${lengthOf(file)} ${tree.short(file)}`),
  );
  const tooLarge = circles.filter(
    (circle) => circle.length > LARGEST_CIRCLE && !tree.allows(circle.map(tree.short)),
  );
  return up.length === 0 && folders.length === 0 && tooLarge.length === 0;
}

const asked = process.argv.slice(2);
const names = asked.length > 0 ? asked : Object.keys(trees);
const failed = names.filter((name) => !check(name));
if (failed.length > 0) {
  console.error(`\nNot in order: ${failed.join(', ')}`);
  process.exitCode = 1;
}
