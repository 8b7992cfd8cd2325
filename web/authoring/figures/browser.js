// A page of this folder, in a headless browser over a server of its own.
import { createServer as createSocket } from "node:net";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { createServer } from "vite";

export const WEB = fileURLToPath(new URL("../../", import.meta.url));
/** A free one: several may draw at once. */
const PORT = await new Promise((resolve) => {
  const socket = createSocket();
  socket.listen(0, "127.0.0.1", () => {
    const { port } = socket.address();
    socket.close(() => resolve(port));
  });
});
/** The address of `web`. */
export const BASE = `http://127.0.0.1:${PORT}/`;

/**
 * CHROMIUM names the browser; the page's WASM must have been built. call(name, input) opens the page anew and calls the function that it
 * puts into `window`; it fails if anything in the page does. outside: files beyond the project may be read as /@fs/path; stay: the page
 * is opened once for all calls.
 */
export async function openPage(html, { outside = false, stay = false } = {}) {
  const server = await createServer({
    root: WEB,
    configFile: false,
    logLevel: "error",
    appType: "mpa",
    cacheDir: `${WEB}../build/figures-cache`,
    assetsInclude: ["**/*.glb", "**/*.bvh"],
    server: { host: "127.0.0.1", port: PORT, strictPort: true, hmr: false, fs: { strict: !outside } },
  });
  await server.listen();
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
  });
  const page = await browser.newPage();
  page.on("pageerror", (error) => {
    throw error;
  });
  const url = `${BASE}authoring/figures/${html}`;
  return {
    async call(name, input) {
      if (!stay || page.url() !== url) await page.goto(url, { timeout: 120_000 });
      await page.waitForFunction((key) => key in window, name, { timeout: 60_000 });
      return page.evaluate(([key, value]) => window[key](value), [name, input]);
    },
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/** Where a character of the list lies: the address of its folder, and its project's name in it. */
export function placeOf({ project }) {
  const url = new URL(project, `${BASE}assets/characters/`);
  return { folder: new URL(".", url).href, project: url.pathname.split("/").at(-1) };
}

/** The bytes of a data URL. */
export const bytesOf = (url) => Buffer.from(url.split(",")[1], "base64");
