// Once the page has danced for a while: Save is in memory, and the browser keeps everything else for a visit without a network.

import { Workbox } from "workbox-window";
import type { Session } from "../app/session";
import script from "./service-worker?worker&url";

/** `./dev demo` may serve something else from the same address tomorrow. */
const OWN_MACHINE = /^(localhost|127\.0\.0\.1|\[::1\])$/;

export async function prepareOffline(session: Session): Promise<void> {
  await import("../app/project-saving");
  if (!("serviceWorker" in navigator) || OWN_MACHINE.test(location.hostname)) return;
  const worker = new Workbox(script);
  const registration = worker.register();
  const reload = async (): Promise<void> => {
    await session.keeping?.flush();
    if (!(await registration)?.waiting) location.reload(); // another tab has asked for it already
    worker.addEventListener("controlling", () => location.reload());
    worker.messageSkipWaiting();
  };
  worker.addEventListener("waiting", () =>
    session.context.notices.say({ title: "A new version is there.", actions: [{ label: "Reload", run: () => void reload() }] }),
  );
  await registration;
}
