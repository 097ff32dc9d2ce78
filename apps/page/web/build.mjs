// SPDX-License-Identifier: Apache-2.0
// Builds the page: node build.mjs [--out FOLDER] | --tests
import { cpSync, mkdirSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const given = process.argv.indexOf("--out");
const common = { bundle: true, logLevel: "warning", legalComments: "none", absWorkingDir: here };

if (process.argv.includes("--tests")) {
  const tests = readdirSync(join(here, "tests/unit")).filter((name) => name.endsWith("_test.ts"));
  await build({
    ...common, platform: "node", target: "node18", format: "esm", outExtension: { ".js": ".mjs" },
    entryPoints: tests.map((name) => join(here, "tests/unit", name)), outdir: join(here, "build/tests"),
  });
} else {
  const out = given > 0 ? process.argv[given + 1] : join(here, "build/page");
  mkdirSync(out, { recursive: true });
  const page = { ...common, minify: true, target: "es2022" };
  await build({ ...page, format: "iife", entryPoints: ["src/main.ts"], outfile: join(out, "page.js") });
  await build({ ...page, format: "iife", entryPoints: ["src/speaker.ts"], outfile: join(out, "speaker.js") });
  await build({ ...page, entryPoints: ["src/page.css"], outfile: join(out, "page.css") });
  cpSync(join(here, "src/index.html"), join(out, "index.html"));
}
