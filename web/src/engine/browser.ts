// The engine in a page: the core runs in a module worker, so that the page never waits for it.

import { EngineClient } from "./client";
import type { WorkerPort } from "./client";
import type { Engine } from "./types";

export function createBrowserEngine(): Engine {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "rigless" });
  return new EngineClient(worker as WorkerPort, fetchBytes(new URL("./rigless.wasm", import.meta.url)), () =>
    fetchBytes(new URL("./shape-analysis.wasm", import.meta.url)),
  );
}

async function fetchBytes(url: URL): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname} answered ${response.status}`);
  return response.arrayBuffer();
}
