#!/usr/bin/python3
"""scripts/decay.py against series whose damping is known.

Usage: test_decay.py FOLDER-OF-SCRIPTS
"""

import math
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
from decay import free_decay  # noqa: E402

W, STEP = 2 * math.pi / 24.0, 0.5


def oscillator(b1, b2, amplitude, periods=15, fine=20):
    """x'' + b1 x' + b2 |x'| x' + W^2 x = 0 from rest, by Runge-Kutta with a twentieth of the step."""

    def rate(y):
        return np.array([y[1], -b1 * y[1] - b2 * abs(y[1]) * y[1] - W * W * y[0]])

    n, h = int(periods * 24.0 / STEP), STEP / fine
    y, x = np.array([amplitude, 0.0]), [amplitude]
    for _ in range(n):
        for _ in range(fine):
            k1 = rate(y)
            k2 = rate(y + h / 2 * k1)
            k3 = rate(y + h / 2 * k2)
            k4 = rate(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        x.append(y[0])
    return np.arange(n + 1) * STEP, np.array(x)


class FreeDecay(unittest.TestCase):
    def test_linear_damping_is_exact(self):
        """Only the parabola through three samples, a 48th of a period apart, is in error: 1e-4."""
        z = 0.04
        found = free_decay(*oscillator(2 * z * W, 0, 2.0))
        self.assertAlmostEqual(found.linear_damping / z, 1, delta=2e-3)
        self.assertLess(abs(found.quadratic_damping) * 2.0, 2e-3 * z)
        self.assertAlmostEqual(found.period * math.sqrt(1 - z * z) / 24.0, 1, delta=2e-4)
        self.assertAlmostEqual(found.natural_period / 24.0, 1, delta=2e-4)

    def test_tells_linear_from_quadratic_damping(self):
        """The method is of first order in the loss of a period, here 0.2: its square is some per cent."""
        b1, b2 = 2 * 0.01 * W, 0.02
        found = free_decay(*oscillator(b1, b2, 3.0))
        self.assertAlmostEqual(found.p / (2 * math.pi * 0.01), 1, delta=0.02)
        self.assertAlmostEqual(found.q / (8 / 3 * b2), 1, delta=0.02)
        self.assertAlmostEqual(found.coefficients[0] / b1, 1, delta=0.02)
        self.assertAlmostEqual(found.coefficients[1] / b2, 1, delta=0.02)

    def test_place_of_rest_need_not_be_known(self):
        t, x = oscillator(2 * 0.03 * W, 0, 1.0)
        about_zero, moved = free_decay(t, x), free_decay(t, x + 17.3)
        self.assertAlmostEqual(moved.p, about_zero.p, delta=1e-6)
        self.assertAlmostEqual(moved.period, about_zero.period, delta=1e-6)

    def test_ripples_are_not_turns(self):
        """A tenth of the last height at five times the frequency: extremes are moved, none is added."""
        t, x = oscillator(2 * 0.03 * W, 0, 1.0, periods=10)
        ripple = 0.05 * np.abs(x[-40:]).max() * np.sin(5 * W * t)
        clean, dirty = free_decay(t, x), free_decay(t, x + ripple)
        self.assertEqual(len(dirty.when), len(clean.when))
        self.assertAlmostEqual(dirty.period / clean.period, 1, delta=5e-3)
        self.assertAlmostEqual(dirty.p / clean.p, 1, delta=0.03)  # late turns, which it moves most, weigh least

    def test_a_motion_beside_it_does_not_bend_the_line(self):
        """A linear oscillator, 1.27 % of critical, and another of 11.3 s that dies four times as fast and moves the
        first turns: the early losses scatter, a plain weighted line has a slope, the robust one tells the 1.27 %."""
        z = 0.0127
        t, x = oscillator(2 * z * W, 0, 2.0, periods=30)
        beside = 0.09 * np.exp(-4 * z * W * t) * np.cos(2 * math.pi / 11.3 * t + 1.0)
        found = free_decay(t, x + beside)
        self.assertGreater(found.scatter, 0.05 * found.p)  # and it is told
        plain = np.polyfit(found.amplitude, found.loss, 1, w=found.amplitude)
        self.assertGreater(abs(plain[1] / (2 * math.pi * z) - 1), 0.02)  # p: what this is a remedy for
        self.assertAlmostEqual(found.linear_damping / z, 1, delta=0.01)
        self.assertLess(abs(found.q), 0.7 * abs(plain[0]))
        self.assertAlmostEqual(found.small[2] / (2 * math.pi * z), 1, delta=0.007)

    def test_standard_errors_hold_the_truth(self):
        """Turns with errors of 0.5 % of the greatest: of 40 draws some nineteen in twenty lie within two errors."""
        z, draw, inside = 0.03, np.random.default_rng(3), 0
        t, x = oscillator(2 * z * W, 0, 1.0, periods=10)
        for _ in range(40):
            noise = np.interp(t, t[::24], draw.normal(0, 0.005, len(t[::24])))
            found = free_decay(t, x + noise)
            inside += abs(found.p - 2 * math.pi * z) < 2 * found.p_error
        self.assertGreater(inside, 30)

    def test_needs_four_turns(self):
        t, x = oscillator(2 * 0.03 * W, 0, 1.0, periods=2)
        self.assertIsNone(free_decay(t, x))
        self.assertIsNone(free_decay(t, np.zeros_like(t)))


if __name__ == "__main__":
    unittest.main()
