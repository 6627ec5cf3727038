// npm run lab: the accuracy lab; npm run lab -- stability: the matrix of hard cases; npm run lab -- price: what steps cost.
// Options: see there.
const LABS: Record<string, string> = {
  stability: './stability/index.js',
  price: './price/index.js',
};
void import(LABS[process.argv[2] ?? ''] ?? './run.js');
