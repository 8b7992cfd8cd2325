#!/usr/bin/env node
import { existsSync } from "node:fs";

const bundle = new URL("../dist-node/rigless.js", import.meta.url);
if (existsSync(bundle)) {
  const { main } = await import(bundle.href);
  process.exitCode = await main(process.argv.slice(2));
} else {
  console.error("rigless: not built yet. Run: npm run build:node");
  process.exitCode = 1;
}
