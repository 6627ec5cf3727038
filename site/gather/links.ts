// Links of the repository's own pages, as addresses of the site.

/** What a link of docs/ or of the repository's root leads to, and where the site has it. */
const PLACES: [RegExp, string][] = [
  [/\]\((?:docs\/)?pictures\//g, '](/pictures/'],
  [/\]\(docs\//g, '](/docs/'],
  [/\]\((\w[\w-]*\.md)/g, '](/docs/$1'],
  // The report's pages are drawn with the stories, which serve them.
  [
    /\]\((?:\.\.\/)?lab\/report(?:\/[\w.-]*)?\)/g,
    '](/stories/lab/report/index.html){target="_self"}',
  ],
];

export const forSite = (text: string): string =>
  PLACES.reduce((page, [from, to]) => page.replaceAll(from, to), text);
