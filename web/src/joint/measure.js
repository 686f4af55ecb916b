// The distance between two places that were clicked, on surfaces or on the cut.
import { bodyName } from "../kit/names.js";
import { BufferGeometry, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, SphereGeometry } from "three";

const COLOUR = 0xc800a0;

export function makeMeasure(stage, say) {
  const ends = [0, 1].map(() => new Mesh(new SphereGeometry(1, 16, 12), new MeshBasicMaterial({ color: COLOUR, depthTest: false })));
  const line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: COLOUR, depthTest: false }));
  for (const mark of [...ends, line]) Object.assign(mark, { visible: false, renderOrder: 3000 });
  stage.scene.add(...ends, line);
  const measure = { on: false, points: [], mm: null };

  measure.clear = () => {
    Object.assign(measure, { points: [], mm: null });
    for (const mark of [...ends, line]) mark.visible = false;
    stage.invalidate();
  };
  measure.toggle = (on = !measure.on) => {
    measure.on = on;
    measure.clear();
    say(on ? "Measure: click two places." : "");
  };
  measure.add = (hit) => {
    if (measure.points.length === 2) measure.clear();
    measure.points.push(hit.point.clone());
    const count = measure.points.length;
    ends[count - 1].position.copy(hit.point);
    ends[count - 1].visible = true;
    if (count === 1) say(`First place on the ${bodyName(hit.solid.name)}${hit.cut ? ", on the cut" : ""}. Click the second.`);
    if (count === 2) finish(measure, line, say);
    stage.invalidate();
  };
  stage.before.push(() => {
    const size = stage.camera.position.distanceTo(stage.controls.target) / 250;
    for (const end of ends) end.scale.setScalar(size);
  });
  return measure;
}

function finish(measure, line, say) {
  const [a, b] = measure.points;
  measure.mm = a.distanceTo(b);
  line.geometry.setFromPoints([a, b]);
  line.geometry.computeBoundingSphere();
  line.visible = true;
  const parts = ["x", "y", "z"].map((axis) => `${axis} ${(b[axis] - a[axis]).toFixed(2)}`);
  say(`${measure.mm.toFixed(2)} mm apart (${parts.join(", ")} mm).`);
}
