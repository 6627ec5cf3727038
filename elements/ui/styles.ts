import theme from '../../styles/ui.css';

const sheets = new Map<string, CSSStyleSheet>();

/** One sheet per text, shared by all elements that use it. */
function sheetOf(css: string): CSSStyleSheet {
  const known = sheets.get(css);
  if (known) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  sheets.set(css, sheet);
  return sheet;
}

/** Gives a view the colours and controls that all share, and its own styles. */
export function applyStyles(host: Element, css: string): void {
  host.shadowRoot!.adoptedStyleSheets = [theme, css].map(sheetOf);
}
