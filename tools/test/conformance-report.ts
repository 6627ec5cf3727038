import { writeFileSync } from 'node:fs';
import { describeValue, type Judged, type Verdict } from '../../test/conformance/judge.js';
import type { Column, Line } from './conformance.js';

const FILE = 'docs/conformance.md';

/** Text in a cell of a Markdown table. */
const cell = (text: string): string => text.replace(/\|/g, '\\|').replace(/</g, '&lt;');

const unit = ({ unit: name }: Verdict): string => (name ? ` ${name}` : '');

const expected = (check: Verdict): string =>
  `${check.what}: ${describeValue(check.expected)}${check.tolerance ? ` ± ${describeValue(check.tolerance)}` : ''}${unit(check)}`;

const join = (texts: string[]): string => texts.map(cell).join('<br>');

/** For what a browser has no field that would tell. */
const UNTOLD = '—';

/** What one browser measured: its verdict, then number by number where it is off. */
function measured({ pass, error, untold, checks }: Judged): string {
  if (untold) return UNTOLD;
  if (error) return cell(`✗ ${error}`);
  return (
    (pass ? '✓ ' : '✗ ') + join(checks.map((check) => describeValue(check.actual) + unit(check)))
  );
}

function row({ fact, judged }: Line): string {
  const checks = judged.find(({ error, untold }) => !error && !untold)?.checks ?? [];
  const says = cell(fact.says) + (fact.open ? `<br>*Reading:* ${cell(fact.open)}` : '');
  return `| \`${fact.field}\` | ${says} | ${join(checks.map(expected))} | ${judged.map(measured).join(' | ')} |`;
}

export function verdict({ pass, untold }: Judged): string {
  if (untold) return UNTOLD;
  return pass ? '✓' : '✗';
}

/** Fields that are about no motion, in one line. */
function inertFields(lines: Line[], columns: Column[]): string {
  const inert = lines.filter(({ fact }) => fact.inert);
  const names = inert.map(
    ({ fact, judged }) => `\`${fact.field}\` ${judged.map(verdict).join(' ')}`,
  );
  const titles = columns.map(({ title }) => title).join(', ');
  return names.length > 0
    ? `\nChanging nothing in the motion (${titles}): ${names.join(', ')}.`
    : '';
}

function section(node: string, lines: Line[], columns: Column[]): string {
  const titles = ['Field', 'Fact', 'Expected', ...columns.map(({ title }) => title)];
  return [
    `## ${node}`,
    '',
    `| ${titles.join(' | ')} |`,
    `|${titles.map(() => '---').join('|')}|`,
    ...lines.filter(({ fact }) => !fact.inert).map(row),
    inertFields(lines, columns),
  ].join('\n');
}

/** Fields all of whose facts hold, of all fields; those that are about no motion stand apart. */
function totals(lines: Line[], columns: Column[]): string {
  const fieldOf = ({ node, fact }: Line): string => `${node}.${fact.field}`;
  const share = (all: Line[], i: number): string[] => {
    const some = all.filter(({ judged }) => !judged[i]!.untold);
    const failed = some.filter(({ judged }) => !judged[i]!.pass);
    const [fields, failedFields] = [some, failed].map((each) => new Set(each.map(fieldOf)).size);
    return [
      `${some.length - failed.length} of ${some.length}`,
      `${fields! - failedFields!} of ${fields}`,
    ];
  };
  const acting = lines.filter(({ fact }) => !fact.inert);
  const inert = lines.filter(({ fact }) => fact.inert);
  const rows = columns.map(({ title, version }, i) => {
    const cells = [title, version, ...share(acting, i), share(inert, i)[1]];
    return `| ${cells.join(' | ')} |`;
  });
  return [
    '| | Version | Facts | Fields | Fields that act on nothing |',
    '|---|---|---|---|---|',
    ...rows,
  ].join('\n');
}

/** Our own failures, said first. */
function ownFailures(lines: Line[], columns: Column[]): string {
  const ours = columns.findIndex(({ title }) => title === 'x3d-physics');
  const failed = lines.filter(({ judged }) => ours >= 0 && !judged[ours]!.pass);
  if (failed.length === 0) return 'x3d-physics passes all of them.';
  const names = failed.map(
    ({ node, fact }) =>
      `\`${node}.${fact.field}\`: ${fact.says}${fact.unmet ? ` (${fact.unmet})` : ''}`,
  );
  return `x3d-physics itself fails ${failed.length}: ${names.join('; ')}.`;
}

const ABOUT = `Every field of every node of X3D's rigid body physics and of its particle systems has at least one fact here: a scene,
what is done with it, and what must be measured then, by a closed form, a reference integrator in double precision or an
exact statement. The scenes are plain X3D and the facts know nothing of the browser that shows them.

- Tolerances are what a good implementation at 60 frames per second can meet: two frames of lag at the speed of the
  motion, or, where the question is whether something moves and not how far, 15 % of its way.
- Where the standard leaves something open, the row names the *reading* that it measures. Another reading is not wrong.
- x3d-physics runs at its default accuracy, and with one step a frame where page code acts once a frame
  (\`set_contacts\`). The column is measured in its core; its tests run the same facts through elements, plain and
  hyphenated, in Chromium, Firefox and WebKit.
- X_ITE runs with a clock of 60 frames per second exactly, and is spared the slow motion with which it begins each
  scene. By default it moves bodies a tenth too slowly for their velocity (one of its ten sub-steps gets lost in each
  frame, with its own clock too), which the 15 % leave room for.
- No field of the standard says where particles are: facts of particle systems ask for \`positions\` and \`count\`, which
  x3d-physics alone has, and say nothing of X_ITE (${UNTOLD}). Means over a thousand particles may be off by four of their
  standard deviations.
- What a browser does not have counts as not passed. A fact that says that something has no effect is passed by a
  browser without it, too.

Again: \`npm run write -- conformance --write\`, or without \`--write\` to see it only.`;

export function writeReport(lines: Line[], columns: Column[]): void {
  const nodes = [...new Set(lines.map(({ node }) => node))];
  const text = [
    '# Conformance',
    '<!-- Written by tools/test/conformance.ts; edits get lost. -->',
    ABOUT,
    `Measured on ${new Date().toISOString().slice(0, 10)}.`,
    totals(lines, columns),
    ownFailures(lines, columns),
    ...nodes.map((node) =>
      section(
        node,
        lines.filter((line) => line.node === node),
        columns,
      ),
    ),
  ].join('\n\n');
  writeFileSync(FILE, `${text}\n`);
  console.log(`${FILE} written`);
}
