// The scene as a page by itself, which runs from disk with two scripts beside it.
import { print } from './text/print.js';
import type { TreeNode } from './text/tree.js';

export const pageOf = (roots: readonly TreeNode[]): string => `<!doctype html>
<meta charset="utf-8" />
<!-- Beside this file: x3dom.js and x3d-physics.single.js. -->
<style>
  x3d {
    width: 100%;
    height: 90vh;
  }
</style>
<script src="x3dom.js"></script>
<script src="x3d-physics.single.js"></script>
${print(roots)}
`;

export function download(name: string, text: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'text/html' }));
  link.download = name;
  link.click();
  // The browser has taken it by then.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
