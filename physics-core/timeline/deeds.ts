/** What somebody did while it could not act, to be done when it can. */
interface Deed {
  who: object;
  method: string;
  args: readonly unknown[];
}

/** What comes about by itself again, or has come about; whoever took hold of a body was told that he holds it no more. */
const NOT_AGAIN = ['add', 'flush', 'remove', 'belongTo', 'drag', 'move', 'end', 'cancel'];

/** The last word about a field counts. */
const OF_FIELDS = ['set', 'event', 'unset'];

/** What was put off. */
export class Deeds {
  #all: Deed[] = [];

  putOff(deed: Deed): void {
    const { who, method, args } = deed;
    if (NOT_AGAIN.includes(method)) return;
    if (OF_FIELDS.includes(method))
      this.#all = this.#all.filter(
        (one) => one.who !== who || !OF_FIELDS.includes(one.method) || one.args[0] !== args[0],
      );
    this.#all.push(deed);
  }

  /** Now it can. */
  do(): void {
    for (const { who, method, args } of this.#all.splice(0))
      (who as Record<string, (...args: readonly unknown[]) => void>)[method]!(...args);
  }
}
