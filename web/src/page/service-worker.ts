// Keeps the page in the browser, so that it opens and works without a network. A new version is fetched beside the one that runs and
// waits until it is asked for.

import { PrecacheController, PrecacheRoute } from "workbox-precaching";
import { registerRoute } from "workbox-routing";
import { CacheFirst } from "workbox-strategies";

/** What we use of a service worker; its types exclude those of a page. */
interface Scope {
  readonly __WB_MANIFEST: Parameters<PrecacheController["addToCacheList"]>[0];
  readonly clients: { claim(): Promise<void>; matchAll(which: { type: "window"; includeUncontrolled: true }): Promise<readonly unknown[]> };
  skipWaiting(): Promise<void>;
  addEventListener(name: string, listener: (event: Lasting) => void): void;
}
type Lasting = Parameters<PrecacheController["install"]>[0] & { readonly data?: { readonly type: string } };
declare const self: Scope;

const kept = new PrecacheController();
kept.addToCacheList(self.__WB_MANIFEST); // written in by the build, see vite.config.ts
registerRoute(new PrecacheRoute(kept));

// Film and rare decoders are kept once they were used; parts of an older version are there for tabs that still run it.
const assets = new URL("assets/", location.href).href;
registerRoute(({ url }) => url.href.startsWith(assets), new CacheFirst({ cacheName: kept.strategy.cacheName }));

self.addEventListener("install", kept.install);
self.addEventListener("activate", (event) => event.waitUntil(begin(event)));
self.addEventListener("message", ({ data }) => {
  if (data?.type === "SKIP_WAITING") void self.skipWaiting();
});

async function begin(event: Lasting): Promise<void> {
  const pages = await self.clients.matchAll({ type: "window", includeUncontrolled: true });
  if (pages.length <= 1) await kept.activate(event); // lets go of what the version before had
  await self.clients.claim();
}
