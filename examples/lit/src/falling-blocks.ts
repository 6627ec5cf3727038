import { html, LitElement, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { css, newBlock, type Block } from './block.ts';
import { scene } from './scene.ts';

export class FallingBlocks extends LitElement {
  static override properties = {
    blocks: { state: true },
    shown: { state: true },
    lamp: { state: true },
    renders: { state: true },
  };

  private blocks = [1, 2, 3].map(newBlock);
  private shown = true;
  private lamp = true;
  private renders = 0;

  /** x3dom does not look into shadow roots. */
  protected override createRenderRoot(): this {
    return this;
  }

  private edit(id: number, change: (block: Block) => Partial<Block>): void {
    this.blocks = this.blocks.map((block) =>
      block.id === id ? { ...block, ...change(block) } : block,
    );
  }

  private add(): void {
    const last = Math.max(0, ...this.blocks.map(({ id }) => id));
    this.blocks = [...this.blocks, newBlock(last + 1)];
  }

  private async again(): Promise<void> {
    for (let i = 0; i < 1000; i++) {
      this.renders++;
      await this.updateComplete;
    }
  }

  private row(block: Block) {
    return html`<li>
      <span class="swatch" style="background: ${css(block.color)}"></span>
      <label>
        Mass
        <input
          type="number"
          min="1"
          .valueAsNumber=${block.mass}
          @input=${({ target }: { target: HTMLInputElement }) =>
            this.edit(block.id, () => ({ mass: target.valueAsNumber || 1 }))}
        />
      </label>
      <span class="hits">${block.hits} hits</span>
      <button
        aria-label="Remove block ${block.id}"
        @click=${() => (this.blocks = this.blocks.filter(({ id }) => id !== block.id))}
      >
        Remove
      </button>
    </li>`;
  }

  private get tools() {
    return html`<div class="tools">
      <button @click=${this.add}>Add</button>
      <button @click=${() => (this.blocks = this.blocks.toReversed())}>Reverse</button>
      <button @click=${this.again}>Render 1000 times</button>
      <output>${this.renders}</output>
      <label>
        <input type="checkbox" .checked=${this.shown} @change=${() => (this.shown = !this.shown)} />
        Scene
      </label>
      <label>
        <input type="checkbox" .checked=${this.lamp} @change=${() => (this.lamp = !this.lamp)} />
        Lamp
      </label>
    </div>`;
  }

  protected override render() {
    const hit = (id: number) => this.edit(id, ({ hits }) => ({ hits: hits + 1 }));
    return html`<h1>Falling blocks</h1>
      <p>A list of bodies, kept by Lit. Where they are knows the physics.</p>
      <main>
        <div class="scene">${this.shown ? scene(this.blocks, this.lamp, hit) : nothing}</div>
        <section>
          ${this.tools}
          <ul>
            ${repeat(
              this.blocks,
              ({ id }) => id,
              (block) => this.row(block),
            )}
          </ul>
        </section>
      </main>`;
  }
}
