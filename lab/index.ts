// npm run lab: the accuracy lab; npm run lab -- stability: the matrix of hard cases. Options: see there.
const lab = process.argv[2] === 'stability' ? './stability/index.js' : './run.js';
void import(lab);
