import { defineConfig } from "@playwright/test";

const port = Number(process.env.PORT ?? 5174);

export default defineConfig({
  testDir: "tests/e2e",
  workers: 1,
  timeout: 120_000,
  expect: { timeout: 20_000 },
  forbidOnly: true,
  use: {
    baseURL: `http://localhost:${port}`,
    viewport: { width: 1280, height: 720 },
    deviceScaleFactor: 0.5, // a quarter of the pixels: a fifth less time
    contextOptions: { reducedMotion: "reduce" }, // the page opens paused: drawing without a card takes what the engine needs
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: [
        "--no-sandbox",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--disable-background-networking",
        "--webgl-antialiasing-mode=none",
        "--disable-gpu-compositing", // without a card it is the stage alone that its stand-in draws
      ],
    },
    trace: { mode: "retain-on-failure", screenshots: false },
  },
  webServer: {
    command: `node_modules/.bin/vite preview --port ${port} --strictPort`,
    url: `http://localhost:${port}`,
    reuseExistingServer: false,
  },
});
