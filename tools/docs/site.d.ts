export const FOLDER: string;
export function buildSite(): Promise<void>;
export function buildDocs(): Promise<void>;
export function serveDocs(
  port: number,
  made?: Record<string, string>,
): Promise<{ port: number; close(): Promise<void> }>;
