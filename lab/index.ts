// npm run lab: the accuracy lab. npm run lab -- <name>: what else is measured, by the options that stand there; --list names all.
const LABS: Record<string, string> = {
  contacts: './contacts/index.js',
  content: './content/index.js',
  drawing: './drawing/index.js',
  edits: './edits/index.js',
  effects: './effects/index.js',
  joints: './joints/index.js',
  page: './page/index.js',
  particles: './particles/index.js',
  predict: './predict.js',
  price: './price/index.js',
  site: './site.js',
  soft: './soft/index.js',
  stability: './stability/index.js',
};
const [asked = ''] = process.argv.slice(2);
if (asked === '--list') console.log(Object.keys(LABS).join('\n'));
else if (Object.hasOwn(LABS, asked)) {
  // It reads its options alone.
  process.argv.splice(2, 1);
  void import(LABS[asked]!);
} else if (/^\w/.test(asked)) {
  console.error(`There is no lab "${asked}": ${Object.keys(LABS).join(', ')}.`);
  process.exitCode = 1;
} else void import('./run.js');
