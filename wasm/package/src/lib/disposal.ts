// For engines without explicit resource management, whose compilers look for these symbols.

const named = Symbol as unknown as Record<'dispose' | 'asyncDispose', symbol | undefined>;

/** @internal */
export function defineDisposal(prototype: object): void {
  for (const name of ['dispose', 'asyncDispose'] as const) {
    // Without the symbol, a class has its method under the name 'undefined'.
    const method = Object.getOwnPropertyDescriptor(prototype, 'undefined');
    if (named[name] === undefined && method)
      Object.defineProperty(prototype, Symbol.for(`Symbol.${name}`), method);
  }
}
