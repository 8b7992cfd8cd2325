// What a verb of the command line is: a file in verbs/, called as the file is, that exports `help` and `run`.

import { parseArgs, type ParseArgsConfig } from "node:util";

import { Progress } from "./progress";

export interface Verb {
  /** How it is called, and its own options, one a line. */
  readonly help: string;
  /** Errors: UsageError, and what the parts it uses say. */
  run(args: readonly string[], signal: AbortSignal): Promise<void>;
}

/** The command line was not understood. */
export class UsageError extends Error {}

type Options = NonNullable<ParseArgsConfig["options"]>;

/** What every verb knows besides its own options. */
const COMMON = { quiet: { type: "boolean", short: "q" } } as const;

/** A verb's arguments. Errors (UsageError): an option that it does not have, with a value too many or none. */
export function readArguments<O extends Options>(args: readonly string[], options: O) {
  const { values, positionals } = strictly(() =>
    parseArgs({ args: [...args], allowPositionals: true, options: { ...options, ...COMMON } as O & typeof COMMON }),
  );
  return { values, inputs: positionals, progress: new Progress("quiet" in values && values.quiet === true) };
}

function strictly<T>(parse: () => T): T {
  try {
    return parse();
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const option = /'(?:-\w, )?(--?[^\s']+)/.exec(message)?.[1];
    if (option === undefined) throw new UsageError(message);
    if (message.startsWith("Unknown")) throw new UsageError(`There is no option ${option}. See rigless --help.`);
    throw new UsageError(message.includes("does not take") ? `${option} takes no value.` : `${option} needs a value after it.`);
  }
}
