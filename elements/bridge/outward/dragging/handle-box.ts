import { adoptStyles } from '../../base/sheets.js';

/** Where a button shows: its middle in the window, and its radius; CSS pixels. */
interface Circle {
  x: number;
  y: number;
  radius: number;
}

/** CSS pixels: what can still be seen, and what does not surround the whole picture. */
const LEAST = 14;
const MOST = 400;

/** Buttons without focus are there for Tab and screen readers only. Two colours show on any picture. */
const CSS = `
  :host { all: initial; position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
  button, [role='status'], p {
    position: absolute; margin: 0; padding: 0; border: 0; background: none; color: inherit;
    width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap;
  }
  button:focus {
    clip-path: none; border-radius: 50%; translate: -50% -50%; outline: 2px dashed #fff;
    box-shadow: 0 0 0 4px #0b5cad, inset 0 0 0 2px #0b5cad;
  }
  button[aria-pressed='true'] {
    outline: 4px solid #fff; box-shadow: 0 0 0 6px #b34700, inset 0 0 0 2px #b34700;
  }
  @media (forced-colors: active) { button:focus { outline-color: Highlight; } }
`;

const HELP =
  'Enter takes hold of it and lets go. While it is held, arrow keys move it, Page Up and Page Down move it away and nearer, Escape cancels. Else arrow keys go to the next one.';

const html = <Tag extends keyof HTMLElementTagNameMap>(tag: Tag): HTMLElementTagNameMap[Tag] =>
  document.createElementNS('http://www.w3.org/1999/xhtml', tag) as HTMLElementTagNameMap[Tag];

/** What the handles stand in: a layer over the picture that takes no room, no pointer, and none of the page's styles. */
export class HandleBox {
  readonly #box = html('div');
  readonly #root = this.#box.attachShadow({ mode: 'open' });
  readonly #group = html('div');
  readonly #status = html('div');

  constructor(x3d: Element) {
    this.#box.className = 'x3d-physics-handles';
    adoptStyles(this.#root, CSS);
    const help = html('p');
    help.id = 'help';
    help.textContent = HELP;
    this.#group.setAttribute('role', 'group');
    this.#group.setAttribute('aria-label', 'Bodies to drag');
    this.#status.setAttribute('role', 'status');
    this.#root.append(help, this.#group, this.#status);
    x3d.append(this.#box);
  }

  remove(): void {
    this.#box.remove();
  }

  button(): HTMLButtonElement {
    const button = html('button');
    button.type = 'button';
    button.tabIndex = -1;
    button.setAttribute('aria-pressed', 'false');
    button.setAttribute('aria-describedby', 'help');
    return button;
  }

  insert(button: HTMLButtonElement, before: HTMLButtonElement | undefined): void {
    this.#group.insertBefore(button, before ?? null);
  }

  get focused(): Element | null {
    return this.#root.activeElement;
  }

  /** Around a body; in the middle of the picture where that is out of sight. */
  show({ style }: HTMLButtonElement, circle: Circle | undefined): void {
    const { left, top, width, height } = this.#box.getBoundingClientRect();
    const { x, y, radius } = circle ?? { x: left + width / 2, y: top + height / 2, radius: 0 };
    const across = `${2 * Math.max(LEAST, Math.min(MOST, radius))}px`;
    Object.assign(style, {
      left: `${x - left}px`,
      top: `${y - top}px`,
      width: across,
      height: across,
    });
  }

  /** To who can't see it. */
  say(text: string): void {
    this.#status.textContent = text;
  }
}
