export function usedGlue(code: string, sources?: string[]): { code: string; unused: string[] };
