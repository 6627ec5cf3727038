import { html, raw, type Markup } from './html.js';
import { INK_STYLE } from './inks.js';

const STYLE = `${INK_STYLE}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 80rem; color: var(--ink); background: var(--ground); font: 1rem/1.5 system-ui, sans-serif; }
a { color: var(--link); }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0.75rem 0; }
h2 { font-size: 1.15rem; margin: 1.75rem 0 0.5rem; }
p { max-width: 46rem; margin: 0.5rem 0; }
nav { display: flex; flex-wrap: wrap; gap: 0.25rem 1.25rem; }
nav a { padding: 0.25rem 0; }
svg { display: block; max-width: 100%; height: auto; }
.narrow { display: none; }
@media (max-width: 54rem) { .wide { display: none; } .narrow { display: block; } }
.scroll { overflow-x: auto; margin: 0.5rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.9rem; }
th, td { padding: 0.25rem 0.6rem; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
tr > :first-child { text-align: left; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; }
tbody th { font-weight: 400; position: sticky; left: 0; background: var(--ground); }
ul { max-width: 60rem; padding-left: 1.25rem; }
.good::before { content: "✓ "; }
.bad { font-weight: 600; }
.bad::before { content: "✗ "; }
th .long { display: inline-block; min-width: 16rem; max-width: 24rem; white-space: normal; }
.cell.good { color: var(--ours); }
.cell.bad { color: var(--jolt); }
.promised { text-decoration: underline; text-underline-offset: 3px; }
.small { color: var(--soft); font-size: 0.9rem; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }`;

/** A page that needs nothing beside itself. */
export const page = (title: string, navigation: Markup, content: Markup): string =>
  html`<!doctype html>
    <html lang="en">
      <meta charset="utf-8" />
      <meta name="viewport" content="width=device-width, initial-scale=1" />
      <title>${title}</title>
      <style>
        ${raw(STYLE)}
      </style>
      <nav aria-label="Report">${navigation}</nav>
      <main>
        <h1>${title}</h1>
        ${content}
      </main>
    </html> `.text;

/** One drawing for a desk, one for a telephone. */
export const chart = (what: string, wide: string, narrow: string): Markup =>
  html`<div class="wide" role="img" aria-label="${what}">${raw(wide)}</div>
    <div class="narrow" role="img" aria-label="${what}">${raw(narrow)}</div>`;
