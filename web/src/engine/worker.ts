// Entry of the page's worker.

import { serve } from "./serve";
import type { ServerPort } from "./serve";

// A message to itself waits behind those that have arrived; a timer would cost 4 ms, a promise would let none in.
const { port1, port2 } = new MessageChannel();
const turn = () =>
  new Promise<void>((resolve) => {
    port1.onmessage = () => resolve();
    port2.postMessage(null);
  });

// Held as long as the worker lives: whoever gets this lock knows that it is gone.
void navigator.locks?.request(self.name, () => new Promise(() => {}));

serve(globalThis as unknown as ServerPort, turn);
