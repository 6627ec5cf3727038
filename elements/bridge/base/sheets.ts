const sheets = new Map<string, CSSStyleSheet>();

/** One sheet per text, shared by all that use it. */
function sheetOf(text: string): CSSStyleSheet {
  const known = sheets.get(text);
  if (known) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  sheets.set(text, sheet);
  return sheet;
}

/** Styles without a style element, which pages forbid whose security policy says `style-src 'self'`. */
export function adoptStyles(root: DocumentOrShadowRoot, ...texts: string[]): void {
  const more = texts.map(sheetOf).filter((sheet) => !root.adoptedStyleSheets.includes(sheet));
  root.adoptedStyleSheets = [...root.adoptedStyleSheets, ...more];
}
