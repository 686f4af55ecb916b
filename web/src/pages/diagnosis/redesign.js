// The consequences of a diagnosis for the cams: redesign.json (docs/guides/close-the-loop.md).
import { findingLine } from "../../kit/findings.js";
import { deg, degrees, general, isKnown, number } from "../../kit/format.js";
import { Plot } from "../../kit/plot.js";
import { bulletList, foldedSection, grid, paragraph, subheading } from "../../kit/sections.js";
import { code, num, table } from "../../kit/table.js";
import { causeName, withNames } from "./causes.js";

/** 0.0312 is "3.1 %"; rounding errors are "less than 0.001 %". */
const errorText = (share) => (!isKnown(share) ? number(share) : share < 1e-5 ? "less than 0.001 %" : `${general(100 * share, 2)} %`);
const kWhich = ["promised", "old_cams", "new_cams"];

function chart(levels) {
  const plot = new Plot("Dead-band as a push-and-release test measures it", "co-contraction [Nm]", "dead-band [deg]"), tau = levels.map((level) => level.tau_Nm);
  const add = (label, key, css, dashed) => plot.curve(label, tau, levels.map((level) => degrees(level[key].measured_rad)), css, dashed);
  add("profile", "promised", "sum", true);
  add("rig as diagnosed, old cams", "old_cams", "pe");
  add("rig as diagnosed, new cams", "new_cams", "se");
  return grid(plot.fromZero().svg());
}

function widthsTable(levels) {
  const rows = levels.map((level) => [num(level.tau_Nm, 3), ...["measured_rad", "exact_rad"].flatMap((key) => kWhich.map((which) => num(deg(level[which][key], 3))))]);
  return [table("Dead-bands of the profile, of the old and of the new cams", ["co-contraction [Nm]", "measured, profile [deg]", "old cams", "new cams", "exact, profile [deg]", "old cams", "new cams"], rows, "dense"),
    paragraph("Measured: by a push-and-release test. Exact: between the outermost resting places; a dash where the laws of the springs do not reach them.")];
}

function summary(redesign) {
  const { at_peak: peak, dead_band: levels } = redesign, three = (key) => `${deg(peak.promised[key], 3)} deg by the profile, ${deg(peak.old_cams[key], 3)} with the old cams, ${deg(peak.new_cams[key], 3)} with new cams`;
  return paragraph(`Largest error of the springs on the rig against the law of their cams: ${errorText(redesign.torque_error_old)} with the old cams, ${errorText(redesign.torque_error_new)} with new cams. Mean error of the dead-band as measured by a push-and-release test against the profile, over ${levels.length} levels: ${errorText(redesign.off_with_old_cams)} with the old cams, ${errorText(redesign.off_with_new_cams)} with new cams; at peak torque, ${general(peak.tau_Nm, 4)} Nm: exact dead-band as in fusee make ${three("exact_rad")}; measured by the push-and-release test ${three("measured_rad")}.`);
}

function profileBlock({ file, changes, can_be_cut, findings, coverage }) {
  const name = file.split("/").pop();
  return [subheading(name), table(`Changes of ${name}`, ["key", "was", "is", "why"], changes.map((c) => [code(c.key), num(c.was), num(c.is), withNames(c.why)])),
    paragraph(can_be_cut ? "fusee make can make these cams." : "fusee make will refuse these cams."), coverage ? paragraph(`The profile ${coverage}.`) : null, bulletList(findings.map(findingLine))];
}

export function redesignSection(redesign) {
  if (!redesign) return null;
  const { dead_band: levels } = redesign, remarks = [...redesign.not_mended.map((n) => `Cams do not correct ${causeName(n)}: ${n.instead}`), ...redesign.remarks.map(withNames)];
  return foldedSection("Cams for the rig as diagnosed", `error of the springs: ${errorText(redesign.torque_error_old)} with the old cams, ${errorText(redesign.torque_error_new)} with new ones`, [levels.length ? [summary(redesign), chart(levels), widthsTable(levels)] : null, redesign.profiles.map(profileBlock), bulletList(remarks)]);
}
