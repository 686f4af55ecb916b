// Bundles src/*.js and src/*.css into built/. Each bundle begins with the hash of its sources and the licences of its libraries.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const bundles = { page: ["uplot"], joint: ["three", "three-mesh-bvh"] };

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

async function bundled(entry) {
  const result = await build({
    entryPoints: [entry], bundle: true, minify: true, write: false, format: "iife", target: ["es2022"],
    legalComments: "none", charset: "ascii", logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

/** The look of the pages stays as it is written: `fusee render` reads its colours and rules. */
async function styleOf(name) {
  return name === "page" ? readFileSync("src/page.css", "utf8") + (await bundled("src/kit/live.css")) : bundled(`src/${name}.css`);
}

function write(name, code) {
  if (/<\/(script|style)/i.test(code)) throw new Error(`${name} would end its element`);
  const head = `/*! fusee, sources sha256:${sourceHash()} */\n` + bundles[name.split(".")[0]].map(licence).join("");
  writeFileSync(`built/${name}`, head + code);
  process.stdout.write(`built/${name}: ${head.length + code.length} bytes\n`);
}

for (const name of Object.keys(bundles)) {
  write(`${name}.js`, await bundled(`src/${name}.js`));
  write(`${name}.css`, await styleOf(name));
}
