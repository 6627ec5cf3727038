import { useState } from 'preact/hooks';
import { flushSync } from 'preact/compat';
import { css, newBlock, type Block } from './block.ts';
import { Scene } from './Scene.tsx';

export function App() {
  const [blocks, setBlocks] = useState(() => [1, 2, 3].map(newBlock));
  const [shown, setShown] = useState(true);
  const [lamp, setLamp] = useState(true);
  const [renders, setRenders] = useState(0);

  const edit = (id: number, change: (block: Block) => Partial<Block>) =>
    setBlocks((all) =>
      all.map((block) => (block.id === id ? { ...block, ...change(block) } : block)),
    );
  const add = () =>
    setBlocks((all) => [...all, newBlock(Math.max(0, ...all.map(({ id }) => id)) + 1)]);
  const again = () => {
    for (let i = 0; i < 1000; i++) flushSync(() => setRenders((count) => count + 1));
  };

  return (
    <>
      <h1>Falling blocks</h1>
      <p>A list of bodies, kept by Preact. Where they are knows the physics.</p>
      <main>
        <div class="scene">
          {shown && (
            <Scene
              blocks={blocks}
              lamp={lamp}
              onHit={(id) => edit(id, ({ hits }) => ({ hits: hits + 1 }))}
            />
          )}
        </div>
        <section>
          <div class="tools">
            <button onClick={add}>Add</button>
            <button onClick={() => setBlocks((all) => all.toReversed())}>Reverse</button>
            <button onClick={again}>Render 1000 times</button>
            <output>{renders}</output>
            <label>
              <input type="checkbox" checked={shown} onInput={() => setShown(!shown)} /> Scene
            </label>
            <label>
              <input type="checkbox" checked={lamp} onInput={() => setLamp(!lamp)} /> Lamp
            </label>
          </div>
          <ul>
            {blocks.map((block) => (
              <li key={block.id}>
                <span class="swatch" style={{ background: css(block.color) }} />
                <label>
                  Mass{' '}
                  <input
                    type="number"
                    min="1"
                    value={block.mass}
                    onInput={({ currentTarget }) =>
                      edit(block.id, () => ({ mass: currentTarget.valueAsNumber || 1 }))
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
            ))}
          </ul>
        </section>
      </main>
    </>
  );
}
