// Ammo binds a thousand and a half functions of Bullet; the core calls a fifth of them. Its glue without the others, and
// which exports of the wasm nobody calls then.
//
// Kept are the classes that the sources of the core name, those that they inherit from, and those whose objects their
// methods answer; of each the methods and properties whose name is a word anywhere in the sources. So what is called is
// there, whatever it is called on; a computed name would not be seen, and the core has none.
import { readFileSync } from 'node:fs';
import { parseAst } from 'rollup/parseAst';
import { globSync } from '../../files.js';

export const SOURCES = ['physics-core/**/*.ts'];

/** Where the glue has the exports of the wasm. From then on each binding is one of them, and needs no long name. */
const EXPORTS = /\b\w+\.asm=(\w+);/g;

/** Another release of the glue may read differently: better no build than a broken one. */
const FEWEST = 1000;

function wordsIn(sources) {
  const files = sources.flatMap((pattern) => globSync(pattern));
  return new Set(files.flatMap((file) => readFileSync(file, 'utf8').match(/[\w$]+/g)));
}

/** Variables of the glue that a piece of it speaks of: not what it calls so itself. */
function namesIn(node, names = new Set()) {
  if (node === null || typeof node !== 'object') return names;
  if (node.type === 'Identifier') names.add(node.name);
  for (const [key, child] of Object.entries(node))
    if (key !== 'property' || node.computed) namesIn(child, names);
  for (const { name } of node.params ?? []) names.delete(name);
  return names;
}

/** The function with the most statements: all bindings and classes stand in it. */
function longest(node, best = { body: [] }) {
  if (node === null || typeof node !== 'object') return best;
  if (node.type === 'BlockStatement' && node.body.length > best.body.length) best = node;
  for (const child of Object.values(node)) best = longest(child, best);
  return best;
}

/** What the statements of the glue say: bindings by their variable, classes by theirs. */
class Glue {
  #code;
  /** What belongs to no class. */
  others = [];
  /** `Gr = b._emscripten_bind_btRigidBody_getMotionState_0 = function … b.asm.xp …` */
  bindings = new Map();
  /** `K.prototype.getMotionState = function …`, `b.btRigidBody = K`, `K.prototype = Object.create(q.prototype)` */
  classes = new Map();

  constructor(code) {
    this.#code = code;
    for (const statement of longest(parseAst(code)).body) this.#read(statement);
    // Functions that classes have in common, and objects that are none.
    for (const [name, { own, parent }] of this.classes)
      if (!own || !parent) {
        if (own) this.others.push(own);
        this.classes.delete(name);
      }
  }

  #textOf({ start, end }) {
    return this.#code.slice(start, end);
  }

  #class(variable) {
    if (!this.classes.has(variable)) this.classes.set(variable, { methods: [], statements: [] });
    return this.classes.get(variable);
  }

  #read(statement) {
    const { type, id, declarations = [], expression } = statement;
    if (type === 'FunctionDeclaration') this.#class(id.name).own = statement;
    for (const each of declarations) this.#readBinding(each);
    if (expression?.type === 'CallExpression') this.#readProperty(statement, expression.arguments);
    const { left, right } = expression ?? {};
    if (left?.type !== 'MemberExpression') return;
    // Accessors have a second, shorter name: `x.prototype.get_m_a = x.prototype.bC = function …`
    this.#readMember(statement, left, right.type === 'AssignmentExpression' ? right.right : right);
  }

  #readBinding({ id, init }) {
    const name = init?.left?.property?.name ?? '';
    const [, export_] = /\.asm\.([\w$]+)\)/.exec(init ? this.#textOf(init) : '') ?? [];
    if (!name.startsWith('_emscripten_bind_') || !export_) return;
    this.bindings.set(id.name, { start: id.end, end: init.end, export: export_ });
  }

  /** `Object.defineProperty(x.prototype, 'm_a', …)` */
  #readProperty(statement, [on, name]) {
    if (on?.property?.name !== 'prototype' || name?.type !== 'Literal') return;
    this.#class(on.object.name).methods.push({ name: name.value, statement });
  }

  #readMember(statement, { object, property }, right) {
    const isOfPrototype = object.property?.name === 'prototype';
    if (isOfPrototype && right.type === 'FunctionExpression') {
      this.#class(object.object.name).methods.push({ name: property.name, statement });
      return;
    }
    const isNamed = object.type === 'Identifier' && right.type === 'Identifier';
    const variable = isNamed ? right.name : (object.object ?? object).name;
    const own = this.#class(variable);
    own.statements.push(statement);
    if (property.name === 'prototype') own.parent = right;
    else if (isNamed) own.name ??= property.name;
  }
}

const isUsed = ({ name }, words) =>
  name === '__destroy__' || words.has(name) || words.has(name.replace(/^[gs]et_/, ''));

/** Goes from the classes that the sources name to all that they lead to. */
function reach({ classes, others }, words) {
  const seen = new Set();
  const kept = { names: new Set(), methods: new Set(), classes: seen };
  const waiting = [...classes.keys()].filter((variable) => words.has(classes.get(variable).name));
  const take = (node) => {
    for (const name of namesIn(node)) {
      kept.names.add(name);
      if (classes.get(name)?.name) waiting.push(name);
    }
  };
  take(others);
  while (waiting.length > 0) {
    const variable = waiting.pop();
    if (seen.has(variable)) continue;
    seen.add(variable);
    const { own, parent, methods } = classes.get(variable);
    take([own, parent ?? null]);
    for (const method of methods.filter((each) => isUsed(each, words))) {
      kept.methods.add(method);
      take(method.statement);
    }
  }
  return kept;
}

/** The glue without what no source calls, and the exports of the wasm that only that called. */
export function usedGlue(code, sources = SOURCES) {
  const glue = new Glue(code);
  if (glue.bindings.size < FEWEST)
    throw new Error('tools/build/engine/used-glue.js does not know this version of ammojs-typed');
  const kept = reach(glue, wordsIn(sources));
  const cuts = [];
  const unused = [];
  const bound = [];
  for (const [variable, { start, end, export: name }] of glue.bindings) {
    cuts.push({ start, end, by: '' });
    if (kept.names.has(variable)) bound.push(`${name}:${variable}`);
    else unused.push(name);
  }
  for (const [variable, { own, methods, statements }] of glue.classes) {
    const isKept = kept.classes.has(variable);
    for (const { statement } of methods.filter((method) => !kept.methods.has(method)))
      cuts.push({ ...statement, by: '' });
    if (!isKept) for (const statement of [own, ...statements]) cuts.push({ ...statement, by: '' });
  }
  const [{ index, 0: there, 1: exports }] = code.matchAll(EXPORTS);
  cuts.push({ start: index, end: index + there.length, by: `${there}({${bound}}=${exports});` });
  return { code: without(code, cuts), unused };
}

function without(code, cuts) {
  let left = '';
  let at = 0;
  for (const { start, end, by } of cuts.toSorted((a, b) => a.start - b.start)) {
    left += code.slice(at, start) + by;
    at = end;
  }
  return left + code.slice(at);
}
