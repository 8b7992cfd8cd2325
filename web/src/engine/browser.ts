// The engine in a page: the core runs in a module worker, so that the page never waits for it.

import { EngineClient } from "./client";
import type { WorkerPort } from "./client";
import type { Engine } from "./types";

export function createBrowserEngine(): Engine {
  const name = `rigless ${Math.random()}`;
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name });
  const client = new EngineClient(worker as WorkerPort, fetchBytes(new URL("./rigless.wasm", import.meta.url)), () =>
    fetchBytes(new URL("./shape-analysis.wasm", import.meta.url)),
  );
  // A browser that needs memory may end a worker without a word. By its first message it holds the lock of its name.
  const watch = () => void navigator.locks?.request(name, () => client.lose("The engine stopped: the browser ended it."));
  worker.addEventListener("message", watch, { once: true });
  return client;
}

async function fetchBytes(url: URL): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname} answered ${response.status}`);
  return response.arrayBuffer();
}
