// Bundles src/*.js and src/*.css into built/. Each bundle begins with the hash of its sources and the licences of its libraries.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const bundles = { plot: ["uplot"], joint: ["three", "three-mesh-bvh"] };

/** The hash that tests/house/web_test.sh computes too: SHA-256 of the lines "hash  path" of all sources, by path. */
function sourceHash() {
  const sha256 = (bytes) => createHash("sha256").update(bytes).digest("hex");
  const files = ["build.mjs", "package-lock.json", "package.json"];
  for (const entry of readdirSync("src", { recursive: true, withFileTypes: true }))
    if (entry.isFile()) files.push(`${entry.parentPath}/${entry.name}`);
  return sha256(files.sort().map((file) => `${sha256(readFileSync(file))}  ${file}\n`).join(""));
}

/** A comment with the licence of a library, which its MIT licence asks of every copy. */
function licence(library) {
  const folder = `node_modules/${library}`;
  const { version } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  return `/*! ${library} ${version}\n${readFileSync(`${folder}/LICENSE`, "utf8").replaceAll("\r", "").trim()}\n*/\n`;
}

async function bundle(name, kind) {
  const result = await build({
    entryPoints: [`src/${name}.${kind}`], bundle: true, minify: true, write: false, format: "iife", target: ["es2021"],
    legalComments: "none", charset: "ascii", logLevel: "warning",
  });
  const code = result.outputFiles[0].text;
  if (/<\/(script|style)/i.test(code)) throw new Error(`${name}.${kind} would end its element`);
  const head = `/*! fusee, sources sha256:${sourceHash()} */\n` + bundles[name].map(licence).join("");
  writeFileSync(`built/${name}.${kind}`, head + code);
  process.stdout.write(`built/${name}.${kind}: ${head.length + code.length} bytes\n`);
}

for (const name of Object.keys(bundles)) for (const kind of ["js", "css"]) await bundle(name, kind);
