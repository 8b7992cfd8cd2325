// The page's parse worker as a thread of Node: a long file can be interrupted, and what its reader leaves behind ends with it.

import { parentPort } from "node:worker_threads";

import "../src/io/parse-worker";

interface Scope {
  onmessage(event: { data: unknown }): void;
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
}

const scope = globalThis as unknown as Scope;
scope.postMessage = (message, transfer) => parentPort?.postMessage(message, transfer);
parentPort?.on("message", (data) => scope.onmessage({ data }));
