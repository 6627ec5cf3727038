import { show, type ProblemReport } from '../../../physics-core/inside.js';
import { attribute } from '../words/dom.js';

/** A USE of what it stands in. */
export function circle(use: Element): ProblemReport {
  const name = attribute(use, 'USE');
  return {
    code: 'use-circle',
    severity: 'warning',
    attribute: 'USE',
    value: name,
    used: 'nothing',
    message: `<${use.localName} USE="${show(name)}"> stands in what it means, and would go on without end`,
  };
}
