// The page around a live example: what an author's own page would have in its head.

/** Scripts of the example's page, as the site serves them. */
const scripts = (base: string): string => `
<script src="${base}x3dom/x3dom.js"></script>
<script type="importmap">{ "imports": { "x3d-physics": "${base}x3d-physics/x3d-physics.js" } }</script>
<script type="module" src="${base}x3d-physics/x3d-physics.js"></script>`;

export const frame = (markup: string, base: string): string => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Example</title>
<link rel="stylesheet" href="${base}x3dom/x3dom.css">
<link rel="stylesheet" href="${base}frame.css">${scripts(base)}
${markup}`;
