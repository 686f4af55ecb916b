"""A diagnosis from arrays. The "measurements" are those of a model with more Coulomb friction in the agonist's gear.

    python3 python/examples/diagnosis.py profiles/pnrvsa.toml
"""

import json
import sys

import numpy as np

import fusee

TRUE = {"effects": [{"id": "gear.coulomb", "side": "agonist", "parameter": {"value": 0.08, "unit": "Nm"}}]}


def measured(template: fusee.CaseTemplate) -> "dict[str, dict[str, np.ndarray]]":
    """Columns named as in the files of a case (docs/gap.md): here of a model with sensor noise, on a bench of the rig."""
    noise = np.random.default_rng(7)
    rows = fusee.predict(template, fusee.Diagnosis.parse(json.dumps(TRUE)))
    taken = {name: dict(rows[name]) for name in ("breakaway", "dead_band", "cocontraction")}
    for columns in taken.values():
        for name, values in columns.items():
            if name.endswith("_rad"):
                columns[name] = values + noise.normal(0.0, 6e-4, len(values))
            if name == "load_torque_Nm":
                columns[name] = values * (1.0 + noise.normal(0.0, 0.005, len(values)))
    return taken


def main(path: str) -> None:
    template = fusee.case_template(path)
    case = template.filled(measured(template))
    found = fusee.diagnose(case)
    print(f"{case}: {found.verdict}")
    for effect in found.effects:
        low, high = effect.ci95
        print(f"{effect.id} on {effect.side}: {effect.value:.3f} {effect.unit}, 95 % {low:.3f} to {high:.3f}, probability {effect.probability:.2f}")
    print(f"gap {found.gap.before:.1f} sigma before, {found.gap.after:.2f} after")
    corrected = fusee.predict(case, found)["dead_band"]
    print(f"{len(corrected['cocontraction_Nm'])} rows of the dead-band predicted with the effect")


if __name__ == "__main__":
    main(sys.argv[1])
