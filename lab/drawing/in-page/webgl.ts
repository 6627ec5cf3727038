/** What gives an answer that scripts go by. */
const ANSWERS = /^(get|create|is|compile|link|attach|shaderSource|bindAttrib|read|check)/;

/** Counts what WebGL is asked for. `stub`: it does nothing, so that script alone is measured. */
export function countCalls(context: WebGL2RenderingContext, stub: boolean): { calls: number } {
  const gl = context as unknown as Record<string, unknown>;
  const counter = { calls: 0 };
  for (const name in gl) {
    const method = gl[name];
    if (typeof method !== 'function') continue;
    gl[name] = (...args: unknown[]): unknown => {
      counter.calls++;
      return stub && !ANSWERS.test(name) ? undefined : (method.apply(gl, args) as unknown);
    };
  }
  return counter;
}
