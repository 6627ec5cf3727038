import { ApplicationRef, Component, inject, signal } from '@angular/core';
import { css, newBlock, type Block } from './block';
import { Scene } from './scene';

@Component({
  selector: 'app-root',
  imports: [Scene],
  templateUrl: './app.html',
})
export class App {
  private readonly application = inject(ApplicationRef);

  protected readonly blocks = signal([1, 2, 3].map(newBlock));
  protected readonly shown = signal(true);
  protected readonly lamp = signal(true);
  protected readonly renders = signal(0);
  protected readonly css = css;

  protected add(): void {
    this.blocks.update((all) => [...all, newBlock(Math.max(0, ...all.map(({ id }) => id)) + 1)]);
  }

  protected remove(gone: Block): void {
    this.blocks.update((all) => all.filter(({ id }) => id !== gone.id));
  }

  protected reverse(): void {
    this.blocks.update((all) => all.toReversed());
  }

  protected edit(id: number, change: (block: Block) => Partial<Block>): void {
    this.blocks.update((all) =>
      all.map((block) => (block.id === id ? { ...block, ...change(block) } : block)),
    );
  }

  protected hit(id: number): void {
    this.edit(id, ({ hits }) => ({ hits: hits + 1 }));
  }

  protected weigh({ id }: Block, { target }: Event): void {
    this.edit(id, () => ({ mass: (target as HTMLInputElement).valueAsNumber || 1 }));
  }

  protected again(): void {
    for (let i = 0; i < 1000; i++) {
      // Other objects with the same values in them.
      this.blocks.update((all) => all.map((block) => ({ ...block })));
      this.renders.update((count) => count + 1);
      this.application.tick();
    }
  }
}
