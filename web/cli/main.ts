// The command line: the page's readers, engine and writers without a page. A verb is a file in verbs/.

import { version } from "../package.json";
import { DocumentError } from "../src/document/project";
import { EngineError } from "../src/engine/types";
import { ModelError } from "../src/io/named-file";
import { FileError } from "./files";
import { UsageError, type Verb } from "./verb";

const VERBS: ReadonlyMap<string, () => Promise<Verb>> = new Map(
  Object.entries(import.meta.glob<Verb>("./verbs/*.ts")).map(([path, load]) => [path.replace(/^.*\/|\.ts$/g, ""), load]),
);

const EXPECTED = [UsageError, FileError, DocumentError, ModelError, EngineError];

/** Runs one command; answers the exit code: 0 done, 1 could not, 2 was not understood, 130 interrupted. */
export async function main(args: readonly string[]): Promise<number> {
  const interrupt = new AbortController();
  const onSignal = (): void => interrupt.abort();
  process.on("SIGINT", onSignal);
  process.on("SIGTERM", onSignal);
  try {
    await run(args, interrupt.signal);
    return 0;
  } catch (error) {
    if (interrupt.signal.aborted) {
      process.stderr.write("rigless: interrupted, nothing was written.\n");
      return 130;
    }
    const message = error instanceof Error ? error.message : String(error);
    const expected = EXPECTED.some((kind) => error instanceof kind);
    process.stderr.write(`rigless: ${expected ? "" : "this should not have happened: "}${message}\n`);
    return error instanceof UsageError ? 2 : 1;
  } finally {
    process.off("SIGINT", onSignal);
    process.off("SIGTERM", onSignal);
  }
}

async function run(args: readonly string[], signal: AbortSignal): Promise<void> {
  const [name = "--help", ...rest] = args;
  const asked = (...options: string[]): boolean => args.some((arg) => options.includes(arg));
  const load = VERBS.get(name);
  if (asked("--help", "-h") || args.length === 0) process.stdout.write(await help(load ? [name] : [...VERBS.keys()]));
  else if (asked("--version", "-v")) process.stdout.write(`${version}\n`);
  else if (load) await (await load()).run(rest, signal);
  else throw new UsageError(`"${name}" is no command. See rigless --help.`);
}

async function help(names: readonly string[]): Promise<string> {
  const verbs = await Promise.all(names.map((name) => VERBS.get(name)?.()));
  return `Human motion on any mesh, without a rig.

${verbs.map((verb) => verb?.help ?? "").join("\n\n")}

  -q, --quiet    say nothing but errors
  -h, --help     this page
  -v, --version  ${version}
`;
}
