// Compares a screenshot with the stored one. Browsers of another version draw letters a little differently.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import pixelmatch from "pixelmatch";
import { PNG } from "pngjs";

const kColour = 0.25, kMostDifferent = 0.03;  // of the range of a colour; of all pixels

/** @returns "" if they agree, else what is wrong; the picture as it is now is in `output` */
export function comparePicture(bytes, name, stored, output, update) {
  const file = `${stored}/${name}.png`;
  writeFileSync(`${output}/${name}.png`, bytes);
  if (update) {
    mkdirSync(stored, { recursive: true });
    writeFileSync(file, bytes);
    return "";
  }
  if (!existsSync(file)) return `${file} is missing: run the test with update`;
  const now = PNG.sync.read(bytes), then = PNG.sync.read(readFileSync(file));
  if (now.width !== then.width || now.height !== then.height) return `${file} has another size: run the test with update`;
  const different = pixelmatch(now.data, then.data, null, now.width, now.height, { threshold: kColour }) / (now.width * now.height);
  return different <= kMostDifferent ? "" : `${(100 * different).toFixed(1)} % of the pixels differ from ${file}; now: ${output}/${name}.png`;
}
