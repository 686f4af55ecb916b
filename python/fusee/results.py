"""Results that are tables of figures: the unit stands at the end of a name or in its text; NaN is a figure that is not known."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import Any

from fusee import _fusee
from fusee.fields import as_field

Range = tuple[float, float]
"""Low and high end."""


@dataclass(frozen=True)
class Tolerance:
    """The limit of one source of error for the wanted band; each with its unit, "0.3 mm"."""

    source: str
    stated: str
    alone: str
    """If every other source were perfect."""
    shared: str
    """If all sources that matter take an equal part."""


@dataclass(frozen=True)
class TorqueError:
    """How far a spring's torque is from the design at one travel of the capstan since the law's lowest load; of a single spring as a share
    of its largest torque. One standard deviation by each source alone; 5 to 95 % of joints to first order, and as sampled."""

    travel_deg: float
    torque_Nm: float
    sigma_percent: dict[str, float]
    band_percent: Range
    sampled_percent: Range


@dataclass(frozen=True)
class PartBudget:
    """The errors of one spring's torque, from the lowest to the greatest travel."""

    part: str
    """ "k_se", "k_pe", or "cam" of a single spring."""
    limits: dict[str, str | None]
    """The tolerance of each source with its unit; None where the source does not reach this part."""
    worst_place: int
    """Index of the place with the widest band."""
    places: list[TorqueError]
    tolerances: list[Tolerance]

    @property
    def worst(self) -> TorqueError:
        """The place with the widest band."""
        return self.places[self.worst_place]


@dataclass(frozen=True)
class DeadBandError:
    """The dead-band at one co-contraction, full width at the joint, and its errors as of TorqueError; NaN where the springs do not cover it."""

    tau_Nm: float
    nominal_deg: float
    sigma_deg: dict[str, float]
    band_deg: Range
    sampled_deg: Range


@dataclass(frozen=True)
class Budget:
    """The errors of joints as a shop builds them (docs/guides/budget.md)."""

    name: str
    process: str
    wanted_percent: float
    """Torque error, to both sides, for which the tolerances are."""
    draws: int
    """Joints sampled; 0: none."""
    percentile: float
    """Half of a band of 5 to 95 %, in standard deviations."""
    parts: list[PartBudget]
    dead_bands: list[DeadBandError]


@dataclass(frozen=True)
class FoundSpring:
    """A spring that passes every rule on the profile's cam."""

    name: str
    """Wire x coil x turns [mm], or the name in the catalogue."""
    values: dict[str, Any]
    """For Profile.with_values: each in the unit of its key."""


@dataclass(frozen=True)
class PartSprings:
    """The springs for one part."""

    wound: list[FoundSpring]
    """The smallest first."""
    bought: list[FoundSpring]
    """Of the catalogue, the nearest rate first."""
    tried: int
    """Springs judged."""
    broken: dict[str, int]
    """Rules that tried springs broke, and how many did."""


@dataclass(frozen=True)
class SmallestPart:
    """The smallest part of one family for a single spring."""

    profile: _fusee.Profile | None
    """With its spring and sizes, for fusee.make; None: the findings say why not."""
    figures: dict[str, Any]
    """As `fusee design --json` has them."""
    findings: list[_fusee.Finding]


@dataclass(frozen=True)
class FrictionLaw:
    """What a profile takes: friction = gear_friction load + gear_friction_constant_Nm."""

    gear_friction: float
    gear_friction_constant_Nm: float


@dataclass(frozen=True)
class FrictionRemark:
    """A sentence about the rows, and the probability of such rows by chance."""

    id: str
    text: str
    p: float


@dataclass(frozen=True)
class FrictionLine:
    """Friction = constant + mu load, fitted to a group of rows; ranges are 95 % intervals."""

    group: str
    """ "all", "backdrive", "agonist", "agonist backdrive", ..."""
    rows: int
    mu: float
    mu_95: Range
    constant_Nm: float
    constant_95_Nm: Range
    scatter_Nm: float
    """One standard deviation of the rows about the line."""
    r_squared: float
    through_zero_mu: float
    """Of the line without a constant, as in the paper."""
    through_zero_mu_95: Range
    robust_mu: float
    robust_constant_Nm: float
    outlier_rows: list[int]


@dataclass(frozen=True)
class MotorFriction:
    """One motor with rows of both directions: they tell its friction from its torque constant."""

    side: str
    rows: int
    torque_scale: float
    """True torque over the stated one."""
    torque_scale_95: Range
    mu: float
    mu_95: Range
    constant_Nm: float
    constant_95_Nm: Range
    p: float
    """Chance of a scale as far from 1 if it is 1."""
    differs: bool


@dataclass(frozen=True)
class FrictionReading:
    """Friction, if the stated torque is right."""

    mu: float
    mu_95: Range


@dataclass(frozen=True)
class TorqueReading:
    """True torque over the stated one, if there is no friction."""

    torque_scale: float
    torque_scale_95: Range


@dataclass(frozen=True)
class BreakAwayToMeasure:
    """The row that tells the two readings apart, and the load that each of them expects there."""

    direction: str
    motor_torque_Nm: float
    load_if_torque_right_Nm: float
    load_if_no_friction_Nm: float


@dataclass(frozen=True)
class OneWayFriction:
    """One motor with rows of one direction: two readings fit them."""

    side: str
    direction: str
    rows: int
    if_torque_right: FrictionReading
    if_no_friction: TorqueReading
    to_measure: BreakAwayToMeasure


@dataclass(frozen=True)
class FrictionCurve:
    """The trusted line over the load with its 95 % band."""

    load_Nm: list[float]
    line_Nm: list[float]
    low_Nm: list[float]
    high_Nm: list[float]


@dataclass(frozen=True)
class BreakAwayRepeat:
    """The rows of one set point."""

    side: str
    direction: str
    motor_torque_Nm: float
    rows: int
    mean_load_Nm: float
    mean_friction_Nm: float
    deviation_Nm: float
    """One standard deviation of the friction; NaN for a single row."""


@dataclass(frozen=True)
class Identification:
    """Gear friction from break-away tests (docs/guides/identify-friction.md)."""

    name: str
    file_sha256: str
    law: FrictionLaw | None
    """None: the rows are no gear friction, or no motor has both directions."""
    profile_lines: str
    remarks: list[FrictionRemark]
    motors: list[MotorFriction]
    one_way: list[OneWayFriction]
    scatter_growth: float
    """Share of the scatter's variance that grows with the friction squared: 0 none, near 1 in proportion to friction."""
    lines: list[FrictionLine]
    trusted: FrictionLine
    line_curve: FrictionCurve
    repeats: list[BreakAwayRepeat]


@dataclass(frozen=True)
class MeasuredFigure:
    """One result of a sheet, and the key of a profile that it concerns."""

    id: str
    what: str
    value: float
    """SI: m, Nm/rad, N/m, or a share."""
    range: Range
    """SI; what it is stands in `range_is`."""
    range_is: str
    """ "95 %", or "ladder": the two neighbouring rungs."""
    rows: int
    key: str | None
    present: float
    """The profile's own value, SI."""
    changes: bool
    """Do the rows contradict the profile's value?"""


@dataclass(frozen=True)
class UnknownFigure:
    """A value that the sheet does not determine, and the missing rows."""

    id: str
    why: str


@dataclass(frozen=True)
class Calibration:
    """What measured coupons, or a filled inspection sheet, say (docs/guides/calibrate.md)."""

    name: str
    file_sha256: str
    figures: list[MeasuredFigure]
    unknown: list[UnknownFigure]
    findings: list[_fusee.Finding]
    """Of an inspected part, passes too."""
    remarks: list[str]


@dataclass(frozen=True)
class Gap:
    """Root mean square of (measured - predicted)/sigma, in sigma."""

    before: float
    """Of the nominal model."""
    after: float
    """With the effects found."""
    noise_floor: float
    """Of a model without any error."""
    heldout_before: float
    """The same on rows that the fit has not seen."""
    heldout_after: float
    heldout_after_95: Range
    """95 % interval, over the parts held out in turn."""


@dataclass(frozen=True)
class AbsorbedParameter:
    """A build parameter of a fit without any effect."""

    value: float
    """In `unit`, as `with_cause`."""
    tolerances: float
    """How far it moved, in standard deviations of its tolerance; NaN: nobody states one."""
    with_cause: float
    """Its value in the fit with the cause."""
    unit: str


@dataclass(frozen=True)
class Absorption:
    """What a fit of all parameters would have claimed, without any effect."""

    parameters: dict[str, AbsorbedParameter]
    """By name, most tolerances first."""
    after: float
    """The gap of this fit, in sigma."""
    heldout_after: float
    """The same on rows that it has not seen, in sigma."""
    sentence: str


@dataclass(frozen=True)
class CarriedCause:
    """A cause on another case."""

    id: str
    side: str
    here: float
    """Its size on the case of the diagnosis, in `unit`."""
    there: float
    """Fitted again on the other case, in `unit`; NaN: no experiment there sees it."""
    there_ci95: Range
    unit: str
    survival: str
    """ "agrees", "differs", "gone" or "open"."""


@dataclass(frozen=True)
class AgainstGap:
    """The gap on the other case, in sigma."""

    before: float
    """Of the nominal model."""
    carried: float
    """With the causes as they are."""
    refitted: float
    """With their sizes fitted there."""
    own: float
    """Of its own diagnosis."""


@dataclass(frozen=True)
class Against:
    """The causes of a diagnosis on another case of the same model."""

    case: str
    causes: list[CarriedCause]
    gap: AgainstGap
    verdict: str
    """Of its own diagnosis, as are the effects."""
    effects: list[_fusee.FoundEffect]


def result_of(name: str, value: dict[str, Any]) -> Any:
    """The dataclass `name` from the dictionary of a result; members without a field are left out."""
    return as_field(getattr(sys.modules[__name__], name), value)
