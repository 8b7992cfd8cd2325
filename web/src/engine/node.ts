// The engine in Node: the same server and client, joined by a message channel in one thread.

import { readFile } from "node:fs/promises";
import { EngineClient } from "./client";
import type { WorkerPort } from "./client";
import { serve } from "./serve";
import type { ServerPort } from "./serve";
import type { Engine } from "./types";

/** Keeps the process alive until close(). `wasm`: where rigless.wasm lies, and shape-analysis.wasm beside it; default: beside this file. */
export async function createNodeEngine(wasm: URL = new URL("./rigless.wasm", import.meta.url)): Promise<Engine> {
  const bytes = async (url: URL) => new Uint8Array(await readFile(url)).buffer;
  const core = await bytes(wasm); // before there is a channel, which keeps the process alive
  return new EngineClient(channelWorker(), core, () => bytes(new URL("./shape-analysis.wasm", wasm)));
}

// Not a message to itself as in a browser: Node empties one port before it looks at the next.
const turn = () => new Promise<void>((resolve) => setImmediate(resolve));

/** A WorkerPort whose other end is served in this thread. */
export function channelWorker(): WorkerPort {
  const { port1, port2 } = new MessageChannel();
  const stop = serve(port2 as ServerPort, turn);
  const worker: WorkerPort = {
    postMessage: (message, transfer) => port1.postMessage(message, transfer),
    terminate: () => {
      stop();
      port1.close();
    },
    onmessage: null,
    onerror: null,
    onmessageerror: null,
  };
  port1.onmessage = (event) => worker.onmessage?.(event);
  port1.onmessageerror = (event) => worker.onmessageerror?.(event);
  return worker;
}
