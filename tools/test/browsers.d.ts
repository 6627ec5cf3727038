export const CHROMIUM_ARGUMENTS: string[];
export const WITHOUT_WEBGL: string[];
export function ensureChromium(): Promise<string>;
