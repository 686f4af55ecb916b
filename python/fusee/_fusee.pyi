# Made by python/tools/stubs.py from the module: cmake --build build --target fusee_python_stubs
import os
from collections.abc import Sequence
from typing import Any, Callable, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fusee.results import Absorption, Against, Budget, Calibration, Gap, Identification, PartSprings, SmallestPart

class Place:
    """A place on a part, in its body frame."""
    @property
    def angle(self) -> float:
        """psi, direction of the cable normal [rad]"""
    @property
    def point_mm(self) -> list[float]:
        """x, y, z [mm]"""

class OverriddenLimit:
    """A limit that the profile puts in place of the rule's default."""
    @property
    def limit(self) -> str:
        """
        as in the profile: "required_mm"
        """
    @property
    def value(self) -> float:
        """the profile's"""
    @property
    def normal(self) -> float:
        """the rule's default for this part; NaN: it has none"""
    @property
    def unit(self) -> str:
        """of both"""
    @property
    def reason(self) -> str:
        """the profile's"""

class Finding:
    """Result of a rule or a synthesis step, and what to change. An impossible design is a finding, not an exception."""
    @property
    def rule(self) -> str:
        """
        stable id "group.name", e.g. "cable.bend_ratio"
        """
    @property
    def severity(self) -> Literal["pass", "not judged", "warning", "error"]:
        """
        "pass", "not judged", "warning" or "error"
        """
    @property
    def what(self) -> str:
        """one sentence for a person"""
    @property
    def measured(self) -> float:
        """In `unit`."""
    @property
    def bound(self) -> Literal["at most", "at least"]:
        """The side of `allowed` on which the measured value must be."""
    @property
    def allowed(self) -> float:
        """In `unit`."""
    @property
    def unit(self) -> str:
        """of measured and allowed, e.g. "mm"; "": none"""
    @property
    def where(self) -> str:
        """
        part and place in words, e.g. "k_pe at psi 12.0 deg", "law at 0.5 Nm"
        """
    @property
    def place(self) -> Place | None:
        """On the part; None: nowhere in particular."""
    @property
    def suggestion(self) -> str:
        """the nearest feasible change, with a number; empty when the rule passes"""
    @property
    def changes(self) -> list[dict[str, str]]:
        """The alternatives of the suggestion, the best first: of each the keys that change together, with values as TOML."""
    @property
    def source(self) -> str:
        """of the limit"""
    @property
    def overridden(self) -> list[OverriddenLimit]:
        """limits of this finding that the profile sets"""
    def __repr__(self) -> str:
        ...
    def __str__(self) -> str:
        """
        "error: cable.bend_ratio: <what>: measured 6.1, allowed at least 8 (k_se at psi 3 deg); suggestion". As many digits as
        it takes to tell measured from allowed. A rule that was not judged: "not judged: spring.stress: <what> (k_se); missing:
        <keys>"
        """

class Profile:
    """A profile: all input of a design (docs/profile.md)."""
    def __init__(self, path: str | os.PathLike[str]) -> None:
        """
        Reads a profile and the CSV files that it names (docs/profile.md lists every key). Raises IoError if a file is missing,
        too large or not TOML (line and column); InvalidInput naming file, line, column and key for an unknown, missing or wrong
        value.
        """
    @staticmethod
    def parse(toml: str, path: str | os.PathLike[str]) -> Profile:
        """
        A profile from a text. `path` is the file that the text would have: files that it names are searched beside it; it need
        not exist. Raises InvalidInput and IoError, as the class does.
        """
    @property
    def name(self) -> str:
        """letters, digits, '.', '_', '-': also the name of the design's folder"""
    @property
    def file(self) -> os.PathLike[str]:
        """the file that was read"""
    @property
    def sha256(self) -> str:
        """of the TOML's bytes followed by those of the CSV files it names: `cat a.toml a.csv | sha256sum`"""
    @property
    def has_parts(self) -> bool:
        """False: the file describes no cams; the joint can be simulated but not made."""
    @property
    def toml(self) -> str:
        """The text that it was read from."""
    def __getitem__(self, key: str) -> bool | int | float | str | list[Any]:
        """The value of a key, "rig.gear_friction", in the unit at the key's end."""
    def __repr__(self) -> str:
        ...
    def with_values(self, values: dict[str, Any], why: str = "") -> Profile:
        """
        The profile with other values, each in the unit of its key; comments and order stay. `why` becomes a comment. Raises
        InvalidInput for an unknown key or a wrong value.
        """
    def write(self, file: str | os.PathLike[str], force: bool = False) -> Profile:
        """
        Writes the profile and returns it as it is there; files that it names are reached from the new folder. Raises IoError if
        the file exists, unless `force`.
        """
    def with_table(self, file: str | os.PathLike[str], angle: ArrayLike, series: ArrayLike, parallel: ArrayLike, *, start_torque: float, end_torque: float, knots: int = 16, smoothing: float = -1.0, force: bool = False) -> Profile:
        """
        The profile with a measured law: capstan angles [rad] and the torques of both springs [Nm]. Writes `file` and, beside
        it, the rows as a CSV file, so that `fusee make` takes them too. See `tabulated` for knots and smoothing.
        """

class LawCurve:
    """
    The pair of springs at one capstan, at one level of equal co-contraction (joint at rest, so both springs have the
    capstan's angle). Magnitudes: every torque is positive and rises with theta. theta is 0 at the lowest load of the law.
    """
    @property
    def tau(self) -> NDArray[np.float64]:
        """capstan load F_SE + F_PE [Nm]"""
    @property
    def theta(self) -> NDArray[np.float64]:
        """capstan angle [rad]"""
    @property
    def f_se(self) -> NDArray[np.float64]:
        """series torque U_3' at the capstan [Nm]"""
    @property
    def f_pe(self) -> NDArray[np.float64]:
        """parallel torque U_4' at the capstan [Nm]"""
    @property
    def s(self) -> NDArray[np.float64]:
        """S = dF_SE/dtheta [Nm/rad]"""
    @property
    def p(self) -> NDArray[np.float64]:
        """P = dF_PE/dtheta [Nm/rad]"""
    @property
    def s_slope(self) -> NDArray[np.float64]:
        """dS/dtheta [Nm/rad^2]"""
    @property
    def p_slope(self) -> NDArray[np.float64]:
        """dP/dtheta [Nm/rad^2]"""
    @property
    def u_se(self) -> NDArray[np.float64]:
        """energy of K_SE above its state at theta = 0 [J]"""
    @property
    def u_pe(self) -> NDArray[np.float64]:
        """energy of K_PE above its state at theta = 0 [J]"""
    @property
    def transmission(self) -> NDArray[np.float64]:
        """T = S/(S+P), paper (8): the share of a stiction torque that reaches the joint's cable."""
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...

class Law:
    """A pair of spring laws, K_SE and K_PE at one capstan. Load [Nm] and angle [rad] name the same point: both rise together."""
    @property
    def loads(self) -> tuple[float, float]:
        """Loads that the law covers [Nm], lead-in included."""
    @property
    def angles(self) -> tuple[float, float]:
        """Capstan angles that the law covers [rad]; low is 0."""
    def at_load(self, tau: ArrayLike) -> LawCurve:
        """Points of the law at loads `tau` [Nm]; loads outside of `loads` become its ends."""
    def at_angle(self, theta: ArrayLike) -> LawCurve:
        """Points of the law at capstan angles `theta` [rad]; angles outside of `angles` become its ends."""
    def sample(self, count: int = 401) -> LawCurve:
        """`count` points, evenly spaced in load, both ends included. Raises InvalidInput if count < 2"""
    def __repr__(self) -> str:
        ...

class Potential:
    """One nonlinear spring at the capstan: force = dU/dx [Nm] over deflection x [rad], C3 in U."""
    @property
    def domain(self) -> tuple[float, float]:
        """Least and greatest deflection [rad]."""
    def energy(self, x: ArrayLike) -> NDArray[np.float64]:
        """U(x) [J]"""
    def torque(self, x: ArrayLike) -> NDArray[np.float64]:
        """U'(x) [Nm]"""
    def stiffness(self, x: ArrayLike) -> NDArray[np.float64]:
        """U''(x) [Nm/rad]"""
    def __repr__(self) -> str:
        ...

class Design:
    """A profile's springs and joint, before any cam."""
    @property
    def ok(self) -> bool:
        """Is the law a pair of springs?"""
    @property
    def findings(self) -> list[Finding]:
        """Why the law is no pair of springs, or what to review about it."""
    @property
    def law(self) -> Law:
        """The law of the springs, lead-in included; None if there is none."""
    @property
    def curve(self) -> LawCurve | None:
        """The law at 401 loads; None if there is none."""
    def _repr_html_(self) -> str:
        ...
    def __repr__(self) -> str:
        ...

class Equilibrium:
    """
    The joint at rest under three torques (tau_1, tau_2, tau_q): of both motors at the capstan, and of the joint. NaN if it
    does not rest.
    """
    @property
    def torque(self) -> NDArray[np.float64]:
        """The three torques that were asked for [Nm]."""
    @property
    def z(self) -> NDArray[np.float64]:
        """(theta_1, theta_2, q), paper (1) [rad]"""
    @property
    def sensitivity(self) -> NDArray[np.float64]:
        """paper (2) [rad/Nm]"""
    @property
    def joint_stiffness(self) -> float:
        """Both capstans held [Nm/rad]."""
    @property
    def dead_band(self) -> float | None:
        """Exact width [rad]; None under a joint torque."""
    @property
    def findings(self) -> list[Finding]:
        """why it does not rest"""

class Simulation:
    """
    The simulated joint: arrays over the levels of co-contraction, and the equilibria that were asked for. Of the paper's
    relatives only the linear figures are known.
    """
    @property
    def ok(self) -> bool:
        """Is there a simulation, with every equilibrium that was asked for?"""
    @property
    def findings(self) -> list[Finding]:
        """Of the law, and why an equilibrium that was asked for does not exist."""
    @property
    def condition_6_verdict(self) -> str:
        """Verdict on condition (6), d(T tau_f)/dtau < 0."""
    @property
    def gaps(self) -> list[str]:
        """figures that could not be computed, and why"""
    @property
    def equilibria(self) -> list[Equilibrium]:
        """Of the torques that were asked for."""
    @property
    def release_path(self) -> dict[str, dict[str, NDArray[np.float64]]]:
        """
        Push and release at peak torque, "up" and "down": joint_torque [Nm], q [rad], load_1 and load_2 [Nm]; empty where it is
        not known.
        """
    def __repr__(self) -> str:
        ...
    @property
    def tau(self) -> NDArray[np.float64]:
        """motor torque of both sides, at the capstan [Nm]"""
    @property
    def linear(self) -> NDArray[np.float64]:
        """2 tau_f(tau)/(g P): paper (3)-(4) for a symmetric actuator [rad]"""
    @property
    def exact_width(self) -> NDArray[np.float64]:
        """Exact dead-band, full width at the joint: between the outermost resting places that stiction allows [rad]."""
    @property
    def measured_width(self) -> NDArray[np.float64]:
        """full width at the joint [rad]"""
    @property
    def covered(self) -> NDArray[np.bool_]:
        """False: the springs do not cover the loads that stiction allows at this torque"""
    @property
    def joint_stiffness(self) -> NDArray[np.float64]:
        """dtau_q/dq with both capstans held by stiction: 2 g^2 S [Nm/rad]"""
    @property
    def free_joint_stiffness(self) -> NDArray[np.float64]:
        """with both capstans free: 2 g^2 S P/(S+P) [Nm/rad]"""
    @property
    def theta(self) -> NDArray[np.float64]:
        """capstan angle [rad]"""
    @property
    def condition_6(self) -> NDArray[np.float64]:
        """d(T tau_f)/dtau; below 0: co-contraction shrinks the transmitted stiction (paper (6))"""
    @property
    def built_low(self) -> NDArray[np.float64]:
        """5 to 95 % of joints as a shop builds them, exact extremes [rad]; NaN: not known"""
    @property
    def built_high(self) -> NDArray[np.float64]:
        """5 to 95 % of joints as a shop builds them, exact extremes [rad]; NaN: not known"""
    @property
    def sensitivity(self) -> NDArray[np.float64]:
        """paper (2), d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q) [rad/Nm]; NaN: no springs hold it"""
    @property
    def noise(self) -> NDArray[np.float64]:
        """standard deviations of theta_1, theta_2, q under white torque noise [rad]; NaN: unbounded"""

class Part:
    """A cam as a solid: its mesh, its findings, and its arms over the working range."""
    @property
    def name(self) -> str:
        """
        "k_se", "k_pe"; the antagonist's: "k_se_mirrored", "k_pe_mirrored"
        """
    @property
    def findings(self) -> list[Finding]:
        """Of every rule on this part."""
    @property
    def points_mm(self) -> NDArray[np.float64]:
        """The mesh's points in the body frame [mm], n x 3; not a copy."""
    @property
    def triangles(self) -> NDArray[np.uint32]:
        """Places in points_mm, n x 3, counter-clockwise seen from outside; not a copy."""
    def contour(self, count: int = 721) -> NDArray[np.float64]:
        """The cable's centreline over the groove, count x 3, in the body frame [m]; computed by this call."""
    @property
    def volume_mm3(self) -> float:
        """Signed volume [mm^3]: above 0 when the triangles face outward."""
    @property
    def closed(self) -> bool:
        """Has every edge exactly two triangles, which run along it in opposite directions?"""
    def to_trimesh(self) -> Any:
        """The mesh as a trimesh.Trimesh in millimetres, a copy. Raises ImportError if the package trimesh is not installed."""
    def export(self, file: str | os.PathLike[str], force: bool = False) -> os.PathLike[str]:
        """
        Writes the part as *.stl, *.3mf or *.step (millimetres, body frame) and returns the file's path; the bytes are those of
        `make`. The file is not read back. Raises InvalidInput for another ending, IoError if the file exists, unless `force`.
        """
    def __repr__(self) -> str:
        ...
    @property
    def tau(self) -> NDArray[np.float64]:
        """capstan load [Nm]: names the point"""
    @property
    def angle(self) -> NDArray[np.float64]:
        """rotation of the cam from the law's lowest load [rad], >= 0"""
    @property
    def arm(self) -> NDArray[np.float64]:
        """r, torque over tension [m]; pivot to cable centreline at a fleet angle of 0"""
    @property
    def tension(self) -> NDArray[np.float64]:
        """cable tension [N]"""
    @property
    def state(self) -> NDArray[np.float64]:
        """phi + phi0 [rad] or y + y0 [m] of the base spring"""
    @property
    def psi(self) -> NDArray[np.float64]:
        """Direction of the cable's normal [rad], not wrapped: a helix continues beyond 2 pi."""
    @property
    def h(self) -> NDArray[np.float64]:
        """support function [m]"""
    @property
    def rho(self) -> NDArray[np.float64]:
        """h + h'' = radius of curvature in the plane [m]"""
    @property
    def z(self) -> NDArray[np.float64]:
        """Height of the cable's centreline in the body frame [m]."""
    @property
    def fleet(self) -> NDArray[np.float64]:
        """angle between free cable and the contact's plane [rad]"""

class Made:
    """A design as made: its parts, figures and findings."""
    @property
    def ok(self) -> bool:
        """Can it be made, and does every file carry the law?"""
    @property
    def findings(self) -> list[Finding]:
        """Of every rule, passes too; if it cannot be made, the limits that bind."""
    @property
    def folder(self) -> os.PathLike[str] | None:
        """The folder of its files; None: nothing was written."""
    @property
    def parts(self) -> list[Part]:
        """K_SE, K_PE and, with files, their mirror images; of one spring its part, "cam", of two cables also "cam_back"."""
    @property
    def law(self) -> LawCurve | None:
        """The law as designed at 401 loads, lead-in included; of one spring at 401 angles."""
    @property
    def arm_error(self) -> float:
        """largest relative error of an arm"""
    @property
    def dead_band_error(self) -> float:
        """largest relative change of a dead-band"""
    def _repr_html_(self) -> str:
        ...
    def __repr__(self) -> str:
        ...

class CheckedPart:
    """Findings of the rules for one part."""
    @property
    def name(self) -> str:
        """"k_se", or that of a mesh's file"""
    @property
    def findings(self) -> list[Finding]:
        """Of every rule on this part."""

class CheckedProcess:
    """Parts as one process would make them."""
    @property
    def process(self) -> str:
        """Its name, "fdm"."""
    @property
    def figures(self) -> str:
        """Where its limits come from, and which it does not have."""
    @property
    def parts(self) -> list[CheckedPart]:
        """K_SE and K_PE."""
    @property
    def findings(self) -> list[Finding]:
        """Of the design and of each part."""
    @property
    def ok(self) -> bool:
        """Can this process make every part?"""

class Checked:
    """The result of `fusee check`."""
    @property
    def name(self) -> str:
        """of the design or the mesh"""
    @property
    def ok(self) -> bool:
        """Some process makes every part without an error."""
    @property
    def processes(self) -> list[CheckedProcess]:
        """One for each process that was asked for."""
    def _repr_html_(self) -> str:
        ...
    def __repr__(self) -> str:
        ...

class ComparedFigure:
    """A figure of the design found, and the same figure of the profile's own design."""
    @property
    def name(self) -> str:
        """What was compared."""
    @property
    def unit(self) -> str:
        """Of `found` and `own`."""
    @property
    def found(self) -> float:
        """Of the design found."""
    @property
    def own(self) -> float:
        """Of the profile's own design; NaN: it has none."""
    def __repr__(self) -> str:
        ...

class ParetoPoint:
    """One design of the front."""
    @property
    def file(self) -> str:
        """Its profile, "pareto/03.toml"."""
    @property
    def figure(self) -> float:
        """the dead-band that was minimised [rad]"""
    @property
    def travel(self) -> float:
        """of the capstan [rad]"""
    @property
    def radius(self) -> float:
        """largest contour radius of both cams [m]"""
    @property
    def limited_by(self) -> str:
        """the limits that bind, in words"""

class Search:
    """What a search for springs found."""
    @property
    def ok(self) -> bool:
        """Were springs found?"""
    @property
    def findings(self) -> list[Finding]:
        """Nothing found: the limits that bind; else what has to be known beside the figures."""
    @property
    def summary(self) -> list[str]:
        """The same in sentences."""
    @property
    def profiles(self) -> dict[str, Profile]:
        """The profiles found by their files' names: "NAME-best.toml", "pareto/03.toml"."""
    @property
    def folder(self) -> os.PathLike[str] | None:
        """The folder of its files; None: nothing was written."""
    @property
    def history(self) -> NDArray[np.float64]:
        """best cost of the first population and after each generation"""
    @property
    def law(self) -> LawCurve | None:
        """The law found; None for a Pareto front."""
    @property
    def own_law(self) -> LawCurve | None:
        """The profile's own law."""
    @property
    def figures(self) -> list[ComparedFigure]:
        """Of the design found, beside those of the profile's own design."""
    @property
    def front(self) -> list[ParetoPoint]:
        """by rising figure"""
    def __repr__(self) -> str:
        ...

class Change:
    """A change of the result, with its reason."""
    @property
    def key(self) -> str:
        """The key that changes."""
    @property
    def old(self) -> str:
        """As TOML."""
    @property
    def new(self) -> str:
        """As TOML."""
    @property
    def asks_for(self) -> str:
        """what the change concerns: "the drawing", "another spring", "the law", ..."""
    @property
    def because(self) -> Finding:
        """the finding against the old value"""
    @property
    def follows(self) -> str:
        """the key that it follows, as a breaking load follows the cable's diameter; empty: none"""
    def __repr__(self) -> str:
        ...

class Conflict:
    """Two limits that conflict: a change for the one breaks the other."""
    @property
    def one(self) -> Finding:
        """The finding that the change is for."""
    @property
    def other(self) -> Finding:
        """The finding that it causes."""
    @property
    def key(self) -> str:
        """Of the change made for `one`."""
    @property
    def old(self) -> str:
        """As TOML."""
    @property
    def new(self) -> str:
        """As TOML."""

class Fix:
    """The changes that a profile needs so that it can be made."""
    @property
    def ok(self) -> bool:
        """Can it be made, as it is or with the changes?"""
    @property
    def end(self) -> Literal["nothing to do", "fixed", "shortened", "cannot"]:
        """
        "nothing to do", "fixed", "shortened" or "cannot"
        """
    @property
    def changes(self) -> list[Change]:
        """Of the fixed profile, or of the candidate that is nearest."""
    @property
    def findings(self) -> list[Finding]:
        """findings that remain: errors, or, if fixed, warnings"""
    @property
    def conflicts(self) -> list[Conflict]:
        """between the findings left and other limits; empty if it is fixed"""
    @property
    def unchanged(self) -> list[str]:
        """"cable.diameter_mm: its breaking load is not stated": changes that were not made, and why"""
    @property
    def profile(self) -> Profile | None:
        """The new profile, not written yet; None unless it is fixed."""
    @property
    def band_before(self) -> float | None:
        """
        Exact dead-band at peak torque, full width at the joint [rad]; None where the law does not exist or does not reach that
        far.
        """
    @property
    def band_after(self) -> float | None:
        """The same of the new profile."""
    def __repr__(self) -> str:
        ...

class Case:
    """A gap case: nominal rig and measurements (docs/gap.md)."""
    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """
        Reads the folder of a gap case: case.toml and the CSV files that it names. Figures in another unit (a friction of 22, a
        radius of 15 m) are refused with the unit that is needed. Of a very long log the beginning is used and a large file is
        thinned; `remarks` say so. A row without a number in a measured column is left out. Raises InvalidInput naming file,
        line, column and key, and IoError.
        """
    @staticmethod
    def from_arrays(name: str, rig: dict[str, Any], experiments: dict[str, Any], *, sensors: dict[str, Any] = {}, tolerance: dict[str, Any] = {}, protocol: dict[str, Any] = {}) -> Case:
        """
        A case from memory, read with every check of a folder. Keys and columns are those of docs/gap.md, with their units:
        `rig` with its numbers and `springs`, the columns deflection_rad, se_torque_Nm, pe_torque_Nm; `experiments` by name with
        the columns of their files. Raises InvalidInput naming file, line and column as if the arrays were files.
        """
    @staticmethod
    def from_frame(frame: object, name: str, rig: dict[str, Any], *, experiment: str = "", columns: dict[str, Any] = {}, sensors: dict[str, Any] = {}, tolerance: dict[str, Any] = {}, protocol: dict[str, Any] = {}) -> Case:
        """
        A case from tables with named columns (pandas, polars, dictionaries of arrays), in the units of docs/gap.md. `frame` is
        the table of `experiment`, such as "log", or a dictionary of tables by experiment. `columns` maps names of docs/gap.md
        to those of the table, {"q_rad": "joint"}, or of several tables by experiment; other columns are skipped. `rig` and the
        other tables are as in from_arrays. Raises InvalidInput naming file, line and column as if they were files.
        """
    @property
    def name(self) -> str:
        """of its folder"""
    @property
    def sha256(self) -> str:
        """over every file of it that was read"""
    @property
    def remarks(self) -> list[str]:
        """limitations: few rows, thinned log, a table with defaults"""
    @property
    def experiments(self) -> dict[str, dict[str, NDArray[Any]]]:
        """The rows of each experiment as columns, named as in its file."""
    def __repr__(self) -> str:
        ...

class CaseTemplate:
    """A case without measurements: the rig of a profile, and set points."""
    @property
    def ok(self) -> bool:
        """Is the law a pair of springs?"""
    @property
    def findings(self) -> list[Finding]:
        """Why the law is no pair of springs."""
    @property
    def experiments(self) -> dict[str, dict[str, NDArray[Any]]]:
        """The set points of each experiment as columns, named as in its file; what is to be measured is NaN."""
    def filled(self, experiments: dict[str, Any]) -> Case:
        """The case with measurements, of those experiments only. Raises InvalidInput naming experiment, row and column."""
    def __repr__(self) -> str:
        ...
    @property
    def rig(self) -> dict[str, Any]:
        """As Case.from_arrays takes it."""
    @property
    def sensors(self) -> dict[str, Any]:
        """As Case.from_arrays takes it."""
    @property
    def tolerance(self) -> dict[str, Any]:
        """As Case.from_arrays takes it."""
    @property
    def protocol(self) -> dict[str, Any]:
        """As Case.from_arrays takes it."""

class Model:
    """A simulator of your own: a function and what was measured (docs/guides/my-simulator-does-not-match.md)."""
    def __init__(self, simulate: Callable[..., object], experiments: dict[str, Any], parameters: dict[str, Any], effects: dict[str, Any] = {}, *, name: str = "model") -> None:
        """
        `simulate(experiment, run, parameters, inputs)` gets a name, a number from 0, a float for each parameter and an array
        for each input, and returns a dict of the outputs, a number for each row; it raises Refusal for what it cannot simulate.
        `experiments` by name: `runs` (a list of dicts of columns), `inputs` (names), `outputs` (standard deviation of the noise
        of each, or "estimate"). `parameters` and `effects` by name, with the keys of a case.toml. Columns and parameters end in
        their unit. Raises InvalidInput.
        """
    @property
    def name(self) -> str:
        """As given."""
    @property
    def remarks(self) -> list[str]:
        """Limitations: estimated noise, one run."""
    def __repr__(self) -> str:
        ...

class FoundEffect:
    """
    An effect found: behaviour of the rig that the nominal model lacks. `fusee explain ID` tells what it means and what to
    do.
    """
    @property
    def id(self) -> str:
        """Of the effect, "gear.coulomb"."""
    @property
    def side(self) -> str:
        """"agonist", "antagonist", "both"; "none" for an effect without sides."""
    @property
    def probability(self) -> float:
        """Of the effect, 0 to 1."""
    @property
    def value(self) -> float:
        """Its size in `unit`."""
    @property
    def ci95(self) -> tuple[float, float]:
        """95 % interval of the size."""
    @property
    def unit(self) -> str:
        """Of value and ci95."""
    def __repr__(self) -> str:
        ...

class Alternative:
    """A hypothesis that remains possible."""
    @property
    def effects(self) -> list[tuple[str, str]]:
        """Pairs of effect and side; empty: no effect at all."""
    @property
    def probability(self) -> float:
        """Of this hypothesis, 0 to 1."""

class NextExperiment:
    """A further measurement that distinguishes the alternatives."""
    @property
    def text(self) -> str:
        """one sentence with its set points"""
    @property
    def information(self) -> float:
        """expected [bit]"""
    @property
    def cost(self) -> float:
        """[min]"""

class Trace:
    """Measured values and predictions before and after, of one quantity over one variable."""
    @property
    def experiment(self) -> str:
        """The experiment's name."""
    @property
    def label(self) -> str:
        """What over what: "q_high_rad over cocontraction_Nm"."""
    @property
    def x_name(self) -> str:
        """Column of `x`."""
    @property
    def y_name(self) -> str:
        """Column of the other arrays."""
    @property
    def x(self) -> NDArray[np.float64]:
        """The variable."""
    @property
    def measured(self) -> NDArray[np.float64]:
        """As measured."""
    @property
    def before(self) -> NDArray[np.float64]:
        """Predicted by the nominal rig."""
    @property
    def after(self) -> NDArray[np.float64]:
        """Predicted by the rig with the effects found."""
    @property
    def sigma(self) -> NDArray[np.float64]:
        """One standard deviation of a measured value."""

class Diagnosis:
    """What a diagnosis found: verdict, effects, gap, next measurement."""
    @property
    def verdict(self) -> Literal["identified", "none", "ambiguous", "unknown", "inconclusive", "partly_explained"]:
        """
        "identified", "none", "ambiguous", "unknown", "inconclusive" or "partly_explained"
        """
    @property
    def effects(self) -> list[FoundEffect]:
        """The effects found, with their sizes."""
    @property
    def alternatives(self) -> list[Alternative]:
        """Hypotheses that remain possible, with their probability."""
    @property
    def gap(self) -> Gap:
        """Root mean square of (measured - predicted)/sigma, before and after."""
    @property
    def next_experiment(self) -> str:
        """The best one of `next` in a sentence; empty: none."""
    @property
    def next(self) -> list[NextExperiment]:
        """Further measurements that distinguish the alternatives, the best first."""
    @property
    def traces(self) -> list[Trace]:
        """Measured and predicted curves, for a plot."""
    @property
    def absorption(self) -> Absorption | None:
        """What a fit of all parameters would have claimed, without any effect; None without a cause."""
    @property
    def against(self) -> Against | None:
        """The causes on the other case, where one was given; else None."""
    @property
    def remarks(self) -> list[str]:
        """limitations, disagreeing splits, gaps at the noise floor"""
    def json(self) -> str:
        """The text of diagnosis.json (docs/gap.md lists its keys); NaN is null."""
    @staticmethod
    def parse(json: str, file: str = "diagnosis.json") -> Diagnosis:
        """
        Reads the text of a diagnosis.json, of fusee or of another program, for `predict`: verdict, effects, build parameters,
        next measurements. `file` is its name in messages. Raises InvalidInput naming the key.
        """
    def _repr_html_(self) -> str:
        ...
    def __repr__(self) -> str:
        ...

def keys() -> list[str]:
    """"k_se.guide.direction_deg" and every other key, in the order of the reference."""

def tabulated(x: ArrayLike, torque: ArrayLike, knots: int = 16, smoothing: float = -1.0) -> Potential:
    """
    A quintic smoothing spline through noisy rows of deflection `x` [rad], rising, and `torque` [Nm] (penalised B-spline,
    Eilers and Marx 1996). `knots` is the number of its intervals, `smoothing` the weight of its roughness, below 0: chosen
    by cross-validation. Raises InvalidInput naming the row.
    """

def resolve(profile: Profile | str | os.PathLike[str]) -> Design:
    """
    Springs and joint of a profile, without cams. A law that cannot be made is a result with findings. Raises InvalidInput
    and IoError for a profile that cannot be read.
    """

def simulate(profile: Profile | str | os.PathLike[str], *, levels: int = 0, push_torque: float | None = None, at: Sequence[Sequence[float]] = []) -> Simulation:
    """
    The joint at rest and pushed, at `levels` co-contractions (0: as the profile says), with its stiffness and noise; of the
    paper's relatives the comparison only. `push_torque` is that of the push-and-release test at the joint [Nm]; None: as
    the profile says, 0: as strong as needed. `at` lists torques (tau_1, tau_2, tau_q) [Nm] whose equilibria are wanted; one
    that does not exist is a finding. Needs no parts. Raises InvalidInput and IoError for a profile that cannot be read.
    """

def make(profile: Profile | str | os.PathLike[str], out: str | os.PathLike[str] | None = None, *, via: str = "cgal", force: bool = False, progress: Callable[..., object] | None = None) -> Made:
    """
    Makes the cams of a profile. With `out`, a folder: all files of `fusee make` in out/NAME, read back; a design with
    errors writes nothing. Without it: the parts and the rules, no file, the agonist's side. `progress` is called with a
    text when something long begins. Raises InvalidInput and IoError; a design that cannot be made raises nothing.
    """

def check(profile: Profile | str | os.PathLike[str], processes: Sequence[str] = []) -> Checked:
    """
    Law, cams, solids and rules for each process ("fdm", "mill", ...; none: the profile's own), without files: the findings
    of `make` before it exports. Raises InvalidInput and IoError for a profile that cannot be read.
    """

def design(profile: Profile | str | os.PathLike[str], *, method: str | None = None, population: int | None = None, generations: int | None = None, seed: int | None = None, out: str | os.PathLike[str] | None = None, jobs: int = 0, resume: bool = False, force: bool = False, progress: Callable[..., object] | None = None) -> Search:
    """
    Searches springs for the joint of a profile, by "algorithm_1", "co_design" or "pareto"; None: as the profile says, like
    the other numbers. With `out`, a folder: the files of `fusee design` in out/NAME-design, with a checkpoint. `progress`
    is called with generation and best cost. Raises InvalidInput and IoError; springs that do not exist are findings.
    """

def fix(profile: Profile | str | os.PathLike[str], *, keep: Sequence[str] = [], reviews: bool = False, most: int = 1000, progress: Callable[..., object] | None = None) -> Fix:
    """
    Applies the changes that the findings suggest, best first, until the profile can be made with all its files
    (docs/guides/fix.md): drawn features before bought parts, the law last. No single change of the result can be left out.
    Facts (rig, machine, strength of a material) are never changed, nor the keys in `keep`; `reviews` mends warnings too; at
    most `most` candidates are judged. Nothing is written. `progress` is called with a text. Raises InvalidInput, also
    naming a key of `keep` that does not exist.
    """

def case_template(profile: Profile | str | os.PathLike[str]) -> CaseTemplate:
    """
    The empty gap case of the joint that a profile describes: radii, friction, inertias and springs as designed, and set
    points for each experiment (docs/gap.md). A case has no preload: springs that rest on stops continue below them to zero
    torque, and angles count from there. Raises InvalidInput naming a key that a case cannot hold: no parts, a preload of 0,
    friction that is not in proportion to the load.
    """

def diagnose(case: Case | Model | str | os.PathLike[str], *, against: Case | Model | str | os.PathLike[str] | None = None, jobs: int = 0, progress: Callable[..., object] | None = None) -> Diagnosis:
    """
    Finds where model and rig differ, which effect that the model lacks causes it, and how far the gap shrinks with that
    effect in the model (docs/gap.md). `case` is a Case or the folder of one; `jobs` threads, 0: one for each processor; the
    result does not depend on it. `progress` is called with the number of finished steps, that of all, and a text. Raises
    InvalidInput if the case has too few rows. `against`: another case of the same kind and model (another unit, gain, load
    or day), on which the causes are tried: `Diagnosis.against`.
    """

def predict(case: Case | CaseTemplate | str | os.PathLike[str], diagnosis: Diagnosis | None = None, inputs: dict[str, Any] | None = None) -> dict[str, dict[str, NDArray[Any]]]:
    """
    Predicts the measured columns of each experiment of a case, a folder or a template, at the inputs of the case or at
    `inputs`, columns by experiment and name as in Case.from_arrays, with the effects of a diagnosis or of the nominal rig.
    Raises InvalidInput.
    """

def budget(profile: Profile | str | os.PathLike[str], *, draws: int = 1000, wanted_percent: float = 5.0) -> Budget:
    """
    The errors of joints as a shop builds them, by source, and the tolerances for a torque error of +-`wanted_percent`.
    `draws` joints are sampled; a single spring is computed to first order. Raises InvalidInput, also if a cam cannot be
    designed.
    """

def springs(profile: Profile | str | os.PathLike[str], catalogue: str | os.PathLike[str] | None = None, *, within_percent: float = 2.0, most: int = 5, accept_reviews: bool = False) -> dict[str, PartSprings]:
    """
    Springs that can be wound or bought, by part ("k_se" and "k_pe"), each with the `values` that Profile.with_values puts
    into the profile. `catalogue` is a CSV file of springs on sale; a wound spring's rate differs by `within_percent` at
    most. Raises InvalidInput and IoError.
    """

def smallest_parts(profile: Profile | str | os.PathLike[str], *, catalogue: str | os.PathLike[str] | None = None, repair: bool = False, generations: int | None = None, jobs: int = 0, progress: Callable[..., object] | None = None) -> dict[str, SmallestPart]:
    """
    The smallest part of each family for a profile of one spring, by family, as `fusee design`. `catalogue` is a CSV file of
    springs on sale; with `repair` a law that cannot be made is changed. `progress` is called with the family's name. Raises
    InvalidInput and IoError; a family without a part has findings.
    """

def identify(csv: str | os.PathLike[str], *, columns: Sequence[str] = []) -> Identification:
    """
    Gear friction from break-away tests (docs/guides/identify-friction.md). The file has the columns side, direction,
    motor_torque_Nm and load_torque_Nm; `columns` names other headers, as "load_torque_Nm=Last in mNm". Raises InvalidInput
    naming file, line and column, and IoError.
    """

def query(study: str | os.PathLike[str], sql: str, *, seconds: int = 60) -> dict[str, NDArray[Any]]:
    """
    One SELECT on the index of a study (a folder of `fusee batch`): columns by name, numbers as an array of floats with NaN
    for empty cells, other columns as an array of texts; pandas.DataFrame takes it. Raises InvalidInput for a statement that
    is wrong, writes or runs longer than `seconds`; IoError if there is no index.
    """

def calibrate(sheet: str | os.PathLike[str], profile: Profile | str | os.PathLike[str] | None = None, *, write: str | os.PathLike[str] | None = None, force: bool = False) -> Calibration:
    """
    What measured coupons, or a filled inspection sheet, say, in SI. With `profile` the values are compared with the
    profile's; with `write` the calibrated profile becomes that file. Raises InvalidInput and IoError.
    """

def render(profile: Profile | str | os.PathLike[str], file: str | os.PathLike[str], view: str = "assembly", *, width_px: int = 1200, dark: bool = False, force: bool = False) -> None:
    """
    Draws one view of a design, such as "cams", "assembly" or "dead-band" (`fusee render --help` lists them), as *.svg or
    *.png of `width_px` pixels. Raises InvalidInput, also if the parts cannot be made, and IoError.
    """

def write_mjcf(profile: Profile | str | os.PathLike[str], folder: str | os.PathLike[str], *, force: bool = False) -> None:
    """
    Writes the joint as designed as a model for MuJoCo: joint.xml, and laws.json with companion programs that apply the
    exact laws. Raises InvalidInput for an arrangement other than "pnrvsa", and IoError.
    """

__version__: str
