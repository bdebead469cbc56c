#!/usr/bin/env python3
"""What the paper's figures need from a result file, in the paper's axes and units (paper_figures)."""

from dataclasses import dataclass
from functools import cached_property

import h5py
import numpy as np


@dataclass(frozen=True)
class Quantity:
    """A channel of the paper: its axis there, and where it stands in ours."""

    name: str
    unit: str
    axis: tuple  # range of the paper's axis
    column: int = -1  # of platform/<name>/position
    sign: float = 1.0  # the paper has y up, so its z is our -y and its pitch turns the other way


PAPER = {
    "surge": Quantity("surge", "m", (25, 50), 0),
    "sway": Quantity("sway", "m", (6, 16), 1, -1.0),
    "heave": Quantity("heave", "m", (-2, 1), 2),
    "roll": Quantity("roll", "deg", (-2, 2), 3),
    "pitch": Quantity("pitch", "deg", (-10, 2), 4, -1.0),
    "yaw": Quantity("yaw", "deg", (-2, 2), 5),
    "keel": Quantity("force", "kN", (0, 600)),
    "top_tension": Quantity("tension", "kN", (600, 1800)),
    "stress": Quantity("von Mises stress", "MPa", (0, 150)),
}
MOORING, RISER, KEEL, EXPORT = "ml1", "ttr1", ("keel.upper", "keel.lower"), "scr_oil"


@dataclass
class Stress:
    """Von Mises stress along the oil riser over a window [m, MPa, s]."""

    arc: np.ndarray
    lowest: np.ndarray
    mean: np.ndarray
    highest: np.ndarray
    moment: np.ndarray  # at t_max, when the greatest of all occurs
    t_max: float

    @property
    def greatest(self):
        """The greatest stress and where."""
        return self.highest.max(), self.arc[int(self.highest.argmax())]


class Hour:
    """One run."""

    def __init__(self, path):
        self.file = h5py.File(path, "r")
        self.time = self.file["time"][:]
        platforms = list(self.file["platform"])
        if len(platforms) != 1:
            raise SystemExit(f"paper_figures: {path} holds {len(platforms)} platforms ({', '.join(platforms)}); the "
                             "paper's figures are of a case with one")
        self.platform = platforms[0]
        self.depth = float(self.file["input/geometry/seabed_depth"][()])
        self.names = [t.decode() for t in self.file["lines/names"][:]]

    def inside(self, window):
        return (self.time >= window[0] - 1e-9) & (self.time <= window[1] + 1e-9)

    @cached_property
    def motions(self):
        return self.file[f"platform/{self.platform}/position"][:]

    def load(self, name, motion):
        """A component of the load on the platform against time, the program's axes [N, N.m]."""
        return self.file[f"platform/{self.platform}/loads/{name}"][:, motion]

    def fact(self, name):
        """A number that the run tells of the platform, e.g. a natural period [s]."""
        return float(self.file[f"statics/platform/{self.platform}/{name}"][()])

    def series(self, channel):
        """A channel of PAPER against time, in the paper's axes."""
        quantity = PAPER[channel]
        if quantity.column >= 0:
            return quantity.sign * self.motions[:, quantity.column]
        if channel == "top_tension":
            return self.end_tension(MOORING)
        if channel == "keel":
            return sum(self.keel_forces())
        raise KeyError(channel)

    def end_tension(self, line):
        """Effective tension at end A [kN]."""
        return 1e-3 * self.file["lines/end_a/effective_tension"][:, self.names.index(line)]

    def keel_forces(self):
        """Radial contact forces at the keel's upper and lower point on TTR 1, magnitudes [kN]."""
        return [1e-3 * self.file[f"constraint/{RISER}/{name}/force"][:] for name in KEEL]

    def stress(self, window):
        mine = self.file["lines/at/line"][:] == EXPORT.encode()
        arc = self.file["lines/at/arc_length"][:][mine]
        inside = self.inside(window)
        values = 1e-6 * self.file["lines/at/von_mises_stress"][:][np.ix_(inside, mine)]
        when = int(values.max(axis=1).argmax())
        return Stress(arc, values.min(axis=0), values.mean(axis=0), values.max(axis=0), values[when],
                      float(self.time[inside][when]))

    def shapes_at_start(self):
        """(name, family, nodes) of every line in the first snapshot."""
        first = self.file["lines/nodes/first"][:]
        nodes = self.file["lines/nodes/position"][0]
        family = [t.decode() for t in self.file["lines/family"][:]]
        return [(n, f, nodes[a:b]) for n, f, a, b in zip(self.names, family, first[:-1], first[1:])]

    def members(self):
        """(end, end, diameter) of the hull's members at the first sample, world axes."""
        ends = self.file["input/geometry/member_ends"][:]
        return [(self.at_start(a), self.at_start(b), d)
                for (a, b), d in zip(ends, self.file["input/geometry/member_diameter"][:])]

    def plates(self):
        """(centre, half the side of a square of its area), turned with the hull but drawn level."""
        return [(self.at_start(p), 0.5 * np.sqrt(area))
                for p, area in zip(self.file["input/geometry/plate_position"][:],
                                   self.file["input/geometry/plate_area"][:])]

    def at_start(self, point):
        """A point of the platform on world axes at the first sample."""
        a, b, c = np.radians(self.motions[0, 3:])
        rx = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
        ry = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
        rz = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
        return self.motions[0, :3] + rz @ ry @ rx @ point
