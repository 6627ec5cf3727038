// The page around a live example: what an author's own page would have in its head.

/** Scripts of the example's page, as the site serves them. */
const scripts = (base: string): string => `
<script src="${base}x3dom/x3dom.js"></script>
<script type="importmap">{ "imports": { "x3d-physics": "${base}x3d-physics/x3d-physics.js" } }</script>
<script type="module" src="${base}x3d-physics/x3d-physics.js"></script>
<script type="module" src="${base}kit/shadows.js"></script>`;

/** In a page of the site: light or dark as that is, whatever the system says; on a phone no higher than what is in it. */
const WITHIN = `
<script>
  if (parent !== window) {
    const [site, own] = [parent.document.documentElement, document.documentElement];
    const follow = () => {
      own.style.colorScheme = site.classList.contains('dark') ? 'dark' : 'light';
    };
    follow();
    new MutationObserver(follow).observe(site, { attributeFilter: ['class'] });
    const { height, style } = frameElement;
    const fit = new ResizeObserver(() => {
      style.height = innerWidth < 500 ? Math.min(height, own.offsetHeight + 2) + 'px' : '';
    });
    // Not before all of it is there.
    addEventListener('DOMContentLoaded', () => fit.observe(own));
  }
</script>`;

export const frame = (markup: string, base: string): string => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Example</title>
<link rel="stylesheet" href="${base}x3dom/x3dom.css">
<link rel="stylesheet" href="${base}frame.css">${WITHIN}${scripts(base)}
${markup}`;
