// A page that keeps a list of its own, and writes what it says into the document: there is nothing to be told of what
// stands there, and what is said twice is no edit.
import 'x3d-physics';

const COLORS = ['0.9 0.4 0.2', '0.25 0.55 0.85', '0.3 0.7 0.4', '0.85 0.7 0.2', '0.6 0.4 0.8'];

const newBlock = (id) => ({ id, color: COLORS[id % COLORS.length], mass: 1, hits: 0 });

let blocks = [1, 2, 3].map(newBlock);
let shown = true;
let lamp = true;
let renders = 0;

const $ = (selector, root = document) => root.querySelector(selector);
const from = (template) => $(template).content.firstElementChild.cloneNode(true);

/** Where it starts: side by side, so that each falls upon the floor. */
const startOf = ({ id }) => `${((id * 3) % 11) - 5} ${4 + (id % 3)} 0`;

/** X3D's colours are numbers from 0 to 1. */
const css = (color) =>
  `rgb(${color
    .split(' ')
    .map((part) => Number(part) * 255)
    .join(' ')})`;

function bodyOf(block) {
  const transform = from('#block');
  transform.setAttribute('translation', startOf(block));
  $('material', transform).setAttribute('diffuseColor', block.color);
  const body = $('x3d-rigid-body', transform);
  body.id = `block-${block.id}`;
  body.addEventListener('collisionstart', () => {
    block.hits++;
    render();
  });
  return transform;
}

function rowOf(block) {
  const row = from('#row');
  $('.swatch', row).style.background = css(block.color);
  $('input', row).addEventListener('input', ({ target }) => {
    block.mass = target.valueAsNumber || 1;
    render();
  });
  const remove = $('button', row);
  remove.setAttribute('aria-label', `Remove block ${block.id}`);
  remove.addEventListener('click', () => {
    blocks = blocks.filter((each) => each !== block);
    render();
  });
  return row;
}

/** What stands for each block in the scene and in the list, for as long as it is there. */
const bodies = new Map();
const rows = new Map();

/** Puts what stands for each block into a parent, in order; what stands there already is left alone. */
function put(parent, made, make) {
  for (const [block, element] of made)
    if (!blocks.includes(block)) {
      element.remove();
      made.delete(block);
    }
  blocks.forEach((block, i) => {
    if (!made.has(block)) made.set(block, make(block));
    const element = made.get(block);
    if (parent.children[i] !== element) parent.insertBefore(element, parent.children[i] ?? null);
  });
}

function renderScene() {
  const there = $('#scene x3d');
  if (!shown) {
    there?.remove();
    bodies.clear();
    return;
  }
  if (!there) $('#scene').append(from('#empty'));
  put($('.blocks'), bodies, bodyOf);
  for (const [block, element] of bodies) $('x3d-rigid-body', element).mass = block.mass;
  if (lamp && !$('.lamp')) $('scene').append(from('#hanging'));
  if (!lamp) $('.lamp')?.remove();
}

function renderList() {
  put($('#list'), rows, rowOf);
  for (const [{ mass, hits }, row] of rows) {
    $('input', row).value = mass;
    $('.hits', row).textContent = `${hits} hits`;
  }
  $('#renders').value = renders;
}

function render() {
  renderScene();
  renderList();
}

function onClick(selector, act) {
  $(selector).addEventListener('click', (event) => {
    act(event.currentTarget);
    render();
  });
}

onClick('#add', () => blocks.push(newBlock(Math.max(0, ...blocks.map(({ id }) => id)) + 1)));
onClick('#reverse', () => blocks.reverse());
onClick('#shown', ({ checked }) => (shown = checked));
onClick('#lit', ({ checked }) => (lamp = checked));
onClick('#again', () => {
  for (; renders < 1000; renders++) render();
});
render();
