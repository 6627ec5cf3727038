export function matches(file: string, pattern: string): boolean;
export function globSync(pattern: string): string[];
