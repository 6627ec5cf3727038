import type { Value } from '../../fields/types.js';
import type { RestRule } from '../../dynamics/body.js';
import type { BodyNode } from './body.js';

const sameRule = (a: RestRule, b: RestRule): boolean =>
  a.mode === b.mode &&
  a.time === b.time &&
  a.linearSpeed === b.linearSpeed &&
  a.angularSpeed === b.angularSpeed;

/** A body's own fields where they are authored, else its collection's. */
function restRuleOf(body: BodyNode): RestRule {
  const from = (name: string): Value =>
    body.authored(name) ? body.asked(name) : body.settings.asked(name);
  const authored = body.authored('autoDisable') || body.settings.authored('autoDisable');
  const never = authored ? !from('autoDisable') : body.settings.asked('rest') === 'never';
  return {
    mode: never ? 'never' : authored ? 'authored' : 'library',
    time: from('disableTime') as number,
    linearSpeed: from('disableLinearSpeed') as number,
    angularSpeed: from('disableAngularSpeed') as number,
  };
}

/** One of the fields that say so was edited. */
export function updateRest(body: BodyNode): void {
  const rest = restRuleOf(body);
  if (!sameRule(rest, body.rest)) body.wake();
  body.rest = rest;
  body.changed('rest');
}
