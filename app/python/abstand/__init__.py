"""Distances and contact between people and robots, with stated error bounds.

SI units; world z up, right-handed. Poses are arrays (4, 4): X_WB takes points of B into W. A signed distance is positive apart and
negative inside, between the bare surfaces; the true distance is never below `distance - bound`. Forces act on the first of two
bodies. Errors are abstand.Error: ParseError for files, UsageError (a ValueError too) for arguments. docs/python.md has more.
"""
from ._errors import Error, ParseError, UsageError, WriteError
from ._engine import (
    JOINTS,
    PARTS,
    Contact,
    Contacts,
    Distance,
    Distances,
    Human,
    HumanPart,
    HumanPoses,
    Mechanism,
    Memory,
    Mesh,
    Shape,
    Structure,
    box,
    capsule,
    contact,
    contacts,
    cuboid,
    cylinder,
    distance,
    distances,
    ellipsoid,
    load_mesh,
    sphere,
)

__version__ = "@PROJECT_VERSION@"

# Names of the second extension, which is loaded on first use of one of them, as loading its readers is slow.
_LATER = ("Recording", "Result", "Scene", "SceneRun", "StepResult", "read_recording", "read_result")

__all__ = [name for name in globals() if not name.startswith("_")] + list(_LATER)


def __getattr__(name):
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import _scene

    for later in _LATER:
        globals()[later] = getattr(_scene, later)
    return globals()[name]


def __dir__():
    return sorted(set(globals()) | set(_LATER))
