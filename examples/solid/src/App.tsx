import { createSignal, For, Show } from 'solid-js';
import { createStore, reconcile } from 'solid-js/store';
import { css, newBlock } from './block.ts';
import { Scene } from './Scene.tsx';

export function App() {
  const [blocks, setBlocks] = createStore([1, 2, 3].map(newBlock));
  const [shown, setShown] = createSignal(true);
  const [lamp, setLamp] = createSignal(true);
  const [renders, setRenders] = createSignal(0);

  const add = () =>
    setBlocks(blocks.length, newBlock(Math.max(0, ...blocks.map(({ id }) => id)) + 1));
  const again = () => {
    for (let i = 0; i < 1000; i++) {
      // Other objects with the same values in them.
      setBlocks(
        reconcile(
          blocks.map((block) => ({ ...block })),
          { key: 'id' },
        ),
      );
      setRenders(renders() + 1);
    }
  };

  return (
    <>
      <h1>Falling blocks</h1>
      <p>A list of bodies, kept by Solid. Where they are knows the physics.</p>
      <main>
        <div class="scene">
          <Show when={shown()}>
            <Scene
              blocks={blocks}
              lamp={lamp()}
              onHit={(hit) =>
                setBlocks(
                  ({ id }) => id === hit,
                  'hits',
                  (hits) => hits + 1,
                )
              }
            />
          </Show>
        </div>
        <section>
          <div class="tools">
            <button onClick={add}>Add</button>
            <button onClick={() => setBlocks((all) => all.toReversed())}>Reverse</button>
            <button onClick={again}>Render 1000 times</button>
            <output>{renders()}</output>
            <label>
              <input type="checkbox" checked={shown()} onChange={() => setShown(!shown())} /> Scene
            </label>
            <label>
              <input type="checkbox" checked={lamp()} onChange={() => setLamp(!lamp())} /> Lamp
            </label>
          </div>
          <ul>
            <For each={blocks}>
              {(block) => (
                <li>
                  <span class="swatch" style={{ background: css(block.color) }} />
                  <label>
                    Mass{' '}
                    <input
                      type="number"
                      min="1"
                      value={block.mass}
                      onInput={({ target }) =>
                        setBlocks(({ id }) => id === block.id, 'mass', target.valueAsNumber || 1)
                      }
                    />
                  </label>
                  <span class="hits">{block.hits} hits</span>
                  <button
                    aria-label={`Remove block ${block.id}`}
                    onClick={() => setBlocks((all) => all.filter(({ id }) => id !== block.id))}
                  >
                    Remove
                  </button>
                </li>
              )}
            </For>
          </ul>
        </section>
      </main>
    </>
  );
}
