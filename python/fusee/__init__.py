"""Springs of antagonistic variable-stiffness joints as cams, and the diagnosis of built joints, on NumPy arrays (docs/guides/python.md)."""

from fusee import _fusee
from fusee._fusee import (
    Alternative,
    Case,
    CaseTemplate,
    Change,
    Checked,
    CheckedPart,
    CheckedProcess,
    ComparedFigure,
    Conflict,
    Design,
    Diagnosis,
    Equilibrium,
    Finding,
    Fix,
    FoundEffect,
    Law,
    LawCurve,
    Made,
    Model,
    NextExperiment,
    OverriddenLimit,
    ParetoPoint,
    Part,
    Place,
    Potential,
    Profile,
    Search,
    Simulation,
    Trace,
    __version__,
    budget,
    calibrate,
    case_template,
    check,
    design,
    diagnose,
    fix,
    identify,
    keys,
    make,
    predict,
    query,
    render,
    resolve,
    simulate,
    springs,
    tabulated,
    write_mjcf,
)
from fusee.errors import InvalidInput, IoError, Refusal
from fusee.functions import FunctionLaw, law_from_functions
from fusee.words import speak as _speak

__all__ = [name for name in dir() if not name.startswith("_") and name not in ("errors", "functions", "words")] + ["__version__"]
globals().update(_speak(_fusee, [name for name in __all__ if hasattr(_fusee, name)]))
