export const FOLDER: string;
export function buildDocs(): Promise<void>;
export function serveDocs(port: number): Promise<{ port: number; close(): Promise<void> }>;
