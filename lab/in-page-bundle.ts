import { build } from 'esbuild';

/** What a benchmark runs in its page, as one classic script. */
export async function inPageBundle(file: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [file],
    bundle: true,
    format: 'iife',
    target: 'es2022',
    tsconfig: 'tsconfig.json',
    logLevel: 'warning',
    write: false,
  });
  return outputFiles[0]!.text;
}
