// What editors and other tools read of the elements.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Ajv } from 'ajv';
import { packageOf, projectOf } from './entries.js';

const read = (application, file) =>
  JSON.parse(readFileSync(join(packageOf(application), file), 'utf8'));

const SCHEMA = createRequire(import.meta.url)('custom-elements-manifest/schema.json');

export function manifestIsValid(application) {
  const validate = new Ajv({ allErrors: true, strict: false }).compile(SCHEMA);
  const manifest = read(application, projectOf(application).customElements);
  validate(manifest);
  assert.deepEqual(validate.errors, null);
  for (const { path } of manifest.modules)
    assert.ok(existsSync(join(packageOf(application), path)), `${path} is not in the package`);
}

const namesOf = (list) => new Set(list?.map(({ name }) => name));

export function manifestIsWhole(application) {
  const { modules } = read(application, 'dist/custom-elements.json');
  const declared = modules.flatMap(({ declarations }) => declarations ?? []);
  const body = declared.find(({ tagName }) => tagName === 'x3d-rigid-body');
  for (const name of ['mass', 'teleport', 'applyImpulse', 'sleeping', 'world', 'explain'])
    assert.ok(namesOf(body.members).has(name), `a body has ${name}`);
  for (const name of ['def', 'use', 'containerfield', 'mass', 'draggable-body', 'for'])
    assert.ok(namesOf(body.attributes).has(name), `a body has the attribute ${name}`);
  assert.ok(namesOf(body.events).has('collisionstart') && namesOf(body.cssStates).has('sleeping'));
  const [entry] = modules;
  assert.deepEqual(
    entry.exports.map(({ name }) => name),
    declared.map(({ tagName }) => tagName),
  );
  const monitor = declared.find(({ tagName }) => tagName === 'x3d-physics-monitor');
  assert.ok(namesOf(monitor.cssProperties).has('--x3d-ui-accent'));
  assert.doesNotMatch(
    JSON.stringify(declared.map(({ attributes }) => attributes.map(({ type }) => type))),
    /[SM]F[A-Z]/,
  );
}

/** Both kinds of editors know each tag, and the two words that a flag takes. */
export function editorsKnowAll(application) {
  const { tags, valueSets } = read(application, 'dist/vscode.html-custom-data.json');
  const { contributions, version } = read(application, projectOf(application)['web-types']);
  const { elements } = contributions.html;
  assert.equal(version, projectOf(application).version);
  assert.deepEqual(namesOf(elements), namesOf(tags));
  const fixed = ({ attributes }) => attributes.find(({ name }) => name === 'fixed');
  const body = ({ name }) => name === 'x3d-rigid-body';
  assert.equal(fixed(tags.find(body)).valueSet, valueSets[0].name);
  assert.equal(fixed(elements.find(body)).value.type, 'boolean');
}
