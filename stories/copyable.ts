// Text that people take along: they read it, or press a button.
import { html, type TemplateResult } from 'lit';

/** Milliseconds for which the button says what it did. */
const TOLD = 2000;

async function copy({ currentTarget }: Event): Promise<void> {
  const button = currentTarget as HTMLButtonElement;
  const text = button.nextElementSibling!;
  try {
    await navigator.clipboard.writeText(text.textContent!);
    button.textContent = 'Copied';
  } catch {
    // No clipboard without HTTPS, except at localhost: the person's own way to copy has only to be used.
    getSelection()!.selectAllChildren(text);
    button.textContent = 'Selected';
  }
  setTimeout(() => (button.textContent = 'Copy'), TOLD);
}

/** Some of the text may be marked. */
export const copyable = (text: string | (string | TemplateResult)[]): TemplateResult =>
  html`<div class="copyable">
    <button type="button" aria-live="polite" @click=${copy}>Copy</button>
    <pre tabindex="0">${text}</pre>
  </div>`;
