"""Small motions of a moored body from WAMIT files, in the frequency domain: an independent calculation beside the
time domain, with nothing of the program in it.

    [ -w^2 (M + A(w)) + i w (B(w) + b) + C + K ] X = F(w),   Re(X e^{iwt}), rotations in radians
"""

import math

import numpy as np

RHO, G = 1025.0, 9.80665


def rows_of(file):
    """Numbers of a file, line by line; lines that do not start with a number are headings."""
    with open(file) as lines:
        for line in lines:
            try:
                yield [float(word) for word in line.split()]
            except ValueError:
                continue


class WamitFiles:
    """.1, .3 and .hst of one body, SI, at their own frequencies; heading 0."""

    def __init__(self, stem):
        added, force = {}, {}
        for period, i, j, *values in rows_of(f"{stem}.1"):
            w = 0.0 if period < 0 else math.inf if period == 0 else 2 * math.pi / period
            A, B = added.setdefault(w, (np.zeros((6, 6)), np.zeros((6, 6))))
            A[int(i) - 1, int(j) - 1] = RHO * values[0]
            if len(values) > 1:
                B[int(i) - 1, int(j) - 1] = RHO * w * values[1]
        for period, heading, i, _, _, real, imaginary in rows_of(f"{stem}.3"):
            if heading == 0:
                force.setdefault(2 * math.pi / period, np.zeros(6, complex))[int(i) - 1] = RHO * G * (real + 1j * imaginary)
        finite = sorted(w for w in added if 0 < w < math.inf)
        self.frequencies = np.array(finite)
        self.A, self.B = (np.array([added[w][k] for w in finite]) for k in (0, 1))
        self.wave_frequencies = np.array(sorted(force))
        self.F = np.array([force[w] for w in self.wave_frequencies])
        self.C = np.zeros((6, 6))
        for i, j, value in rows_of(f"{stem}.hst"):
            self.C[int(i) - 1, int(j) - 1] = RHO * G * value

    @staticmethod
    def at(w, frequencies, values):
        """Linear between two frequencies."""
        k = min(max(int(np.searchsorted(frequencies, w)), 1), len(frequencies) - 1)
        s = (w - frequencies[k - 1]) / (frequencies[k] - frequencies[k - 1])
        return (1 - s) * values[k - 1] + s * values[k]

    def response(self, w, mass, centre, inertia, mooring, damping=0.0):
        """Six complex amplitudes per metre of wave. `inertia` about the centre of gravity, all else about the origin;
        the buoyancy moment stands in C, the weight's is added here."""
        c = np.asarray(centre, float)
        cross = np.array([[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]])
        M = np.block([[mass * np.eye(3), -mass * cross], [mass * cross, np.asarray(inertia) - mass * cross @ cross]])
        C = self.C.copy()
        C[3, 3] -= mass * G * c[2]
        C[4, 4] -= mass * G * c[2]
        A = self.at(w, self.frequencies, self.A)
        B = self.at(w, self.frequencies, self.B)
        Z = -w * w * (M + A) + 1j * w * (B + damping) + C + mooring
        return np.linalg.solve(Z, self.at(w, self.wave_frequencies, self.F))
