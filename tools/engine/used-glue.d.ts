export function usedGlue(code: string): { code: string; unused: string[] };
