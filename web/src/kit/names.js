// Bodies, parts and causes by the names that a person uses. Left and right are those of a reader who looks from the motors to the joint, as the view of the joint in 3D
// does: the agonist is on the right.

const kBodies = {
  k_se: "series spool", k_pe: "parallel cam", k_se_spring: "series spring", k_pe_spring: "parallel spring", leg_in_carriage: "spring leg in the carriage", leg_in_k_se: "spring leg in the spool",
  k_pe_seat: "seat of the parallel spring", k_pe_cap: "cap of the parallel spring", axle: "spool axle", axle_sleeve: "sleeve of the axle", axle_rings: "rings of the axle", rods: "carriage rods", bushes: "bushes of the carriage",
  k_pe_posts: "posts of the parallel springs", frame_plate: "plate of the frame", frame_front: "front of the frame", frame_rear: "rear of the frame",
};
const kSides = { agonist: "right", antagonist: "left" };
export const kSidesMeaning = "Right: the agonist's side, as seen from the motors.";

/** "k_pe_antagonist" is "parallel cam, left"; "series cable, agonist" is "series cable, right". */
export function bodyName(name) {
  const [, base, side] = name.match(/^(.*?)(?:(?:_|, )(agonist|antagonist))?$/), words = kBodies[base] ?? base.replaceAll("_", " ");
  return side ? `${words}, ${kSides[side]}` : words;
}

/** A part of a design: "k_se mirrored" is "series spool, left". */
export const partName = (part) => bodyName(part.replace(/ mirrored$/, "_antagonist"));
/** A text in which parts stand by their ids. */
export const withPartNames = (text) => text.replace(/\bk_(se|pe)\b(?![._])/g, (part) => kBodies[part]);
