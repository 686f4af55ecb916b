// What was read back from the files of a design, the joint as exported, and the files.
import { bytesText, counted, deg, isKnown, kUnknown, newtonMetres, number } from "../../kit/format.js";
import { html } from "../../kit/markup.js";
import { foldedSection, paragraph, tag } from "../../kit/sections.js";
import { cell, code, faint, num, table } from "../../kit/table.js";

const share = (value, digits) => num(`${number(isKnown(value) ? 100 * value : null, digits)} %`);

export function readBackSection({ parts, mirrored, plate }) {
  const errors = [...parts, ...mirrored].flatMap((part) => part.read_back).concat(plate);
  if (!errors.length) return null;
  const rows = errors.map((e) => [tag(e.severity, e.severity), code(e.file), e.mirror_of ? `mirror image of ${e.mirror_of}, ${e.reader}` : e.reader, share(e.worst_relative, 3),
    num(`\u2264 ${number(100 * e.allowed, 3)} %`), num(`${deg(e.worst_angle_rad)} deg`), num(String(e.rows))]);
  return foldedSection("Read back from the files", counted(rows.length, "reading"), [
    paragraph("Another library read every file. Rays to the groove floor and a taut cable give the lever arm, without any code of the synthesis. A file whose bytes are the exact mirror image of one that was read has its arms."),
    table("Arm errors of every file and reader", ["", "file", "reader", "worst arm error", "allowed", "at cam angle", "positions"], rows)]);
}

const width = (rad) => num(isKnown(rad) ? `${deg(rad, 5)} deg` : kUnknown);
const springCells = (spring) => (spring.file === null ? [faint("nominal"), "", ""] : [code(spring.file), share(spring.worst_arm_relative, 2), share(spring.worst_law_relative, 2)]);

function jointRow({ reader, binding, k_se, k_pe, dead_band_rad, refusal }) {
  const row = [reader + (binding ? "" : ", a print"), ...springCells(k_se), ...springCells(k_pe), ...dead_band_rad.map(width)];
  if (refusal) row[row.length - 1] = faint(refusal);
  return row;
}

export function exportedSection({ tau_Nm, nominal_dead_band_rad: nominal, joints }) {
  if (!joints.length) return null;
  const designed = [faint("as designed"), "", ""], head = ["reader", "K_SE", "arm error", "law error", "K_PE", "arm error", "law error", ...tau_Nm.map((tau) => `at ${newtonMetres(tau)}`)];
  return foldedSection("The joint as exported", `${counted(joints.length, "joint")} of the files`, [
    paragraph("The last columns are the exact dead-band, edge to edge, at least, peak and overdrive torque. It is computed from the springs whose arms were read back from the files. Arm and law error: the largest relative error over the working range. A part without such a file has its nominal law."),
    table("Dead-band of the joint with the springs of its files", head, [["nominal", ...designed, ...designed, ...nominal.map(width)], ...joints.map(jointRow)])]);
}

function fileRow({ name, bytes, triangles, chordal_error_mm: error, sha256 }) {
  return [code(name), num(bytesText(bytes)), num(triangles > 0 ? String(triangles) : kUnknown), num(error > 0 ? `${number(error)} mm` : kUnknown), cell(html`<span title="${sha256}">${sha256}</span>`, "code")];
}

export function filesSection({ parts, mirrored, files }) {
  const all = [...parts, ...mirrored].flatMap((part) => part.files).concat(files);
  if (!all.length) return null;
  const sides = mirrored.length ? paragraph("Files named _mirrored are the antagonist's parts: mirror images in the plane of axis and timing mark, for a torsion spring of the other hand. The law is the same.") : null;
  return foldedSection("Files", `${counted(all.length, "file")}, with SHA-256`, [sides, table("Files with size and hash", ["name", "size", "triangles", "chordal error", "SHA-256"], all.map(fileRow))]);
}
