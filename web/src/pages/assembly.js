// The guide of an assembly with its pictures and bill of materials, to read and to print (docs/assembly.md).
import { number } from "../kit/format.js";
import { guideSections } from "../kit/markdown.js";

export function assemblyPage({ provenance, ...joint }, data) {
  const { title, sections } = guideSections(data("guide"), "The joint", data("pictures"));
  return {
    head: { kind: "fusee assembly", title, sentence: "For paper, print this page (Ctrl+P): A4, with its pictures and the bill of materials.", stamp: `fusee ${provenance.fusee}, ${provenance.name}`,
      tiles: [["Capstan radius", `${number(joint.capstan_radius_mm)} mm`], ["Radius of the joint's pulley", `${number(joint.joint_radius_mm)} mm`], ["Cable", `${number(joint.cable_diameter_mm)} mm`], ["Bodies", joint.bodies.length]] },
    sections,
  };
}
