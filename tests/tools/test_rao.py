#!/usr/bin/python3
"""scripts/rao.py against series whose operators are known.

Usage: test_rao.py FOLDER-OF-SCRIPTS
"""

import math
import os
import sys
import tempfile
import unittest

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
import rao  # noqa: E402


def operator(w):
    """A lightly damped oscillator, 15 s, as heave; a pure delay as surge; pitch a tenth of both."""
    w0, z = 2 * math.pi / 15, 0.06
    heave = w0 ** 2 / (w0 ** 2 - w ** 2 + 2j * z * w0 * w)
    surge = np.exp(-1j * w * 1.7)
    nothing = np.zeros_like(heave)
    return np.array([surge, nothing, heave, nothing, 0.1 * (heave + surge), nothing]).T


def random_sea(seconds, step=0.5, components=800, noise=0.0):
    """Elevation of a white band and the motions that the operator makes of it, component by component."""
    draw = np.random.default_rng(7)
    t = np.arange(0, seconds, step)
    w = np.sort(draw.uniform(0.2, 1.2, components))
    A = math.sqrt(2.0 / components) * np.exp(2j * math.pi * draw.uniform(size=components))
    H = operator(w)
    x, y = np.zeros(len(t)), np.zeros((len(t), 6))
    for k in range(components):
        turn = np.exp(1j * w[k] * t)
        x += (A[k] * turn).real
        y += ((A[k] * H[k])[None, :] * turn[:, None]).real
    return t, x, y + noise * draw.standard_normal(y.shape)


class RegularWaves(unittest.TestCase):
    def test_operator_and_frequency_are_exact(self):
        t = np.arange(0, 400, 0.25)
        w, A = 0.6137, 1.3 * np.exp(0.4j)
        turn = np.exp(1j * w * t)
        H = operator(np.array([w]))[0]
        drift = 5.0 + 0.001 * t  # a mean and a slow drift do not count
        motion = ((A * H)[None, :] * turn[:, None]).real + drift[:, None]
        found = rao.regular(t, (A * turn).real, motion)
        self.assertAlmostEqual(found.frequency[0], w, delta=1e-6)
        self.assertLess(np.abs(found.operator[0] - H).max(), 1e-4)
        self.assertTrue(rao.is_regular((A * turn).real, t))

    def test_tells_that_a_motion_still_grows(self):
        t = np.arange(0, 400, 0.25)
        wave = np.cos(0.6 * t)
        motion = np.repeat(((1 - np.exp(-t / 300)) * wave)[:, None], 6, axis=1)
        self.assertGreater(rao.regular(t, wave, motion).error.max(), 0.05)


class RandomWaves(unittest.TestCase):
    def test_operator_lies_within_its_stated_error(self):
        t, x, y = random_sea(12000)
        found = rao.random(t, x, y)
        self.assertFalse(rao.is_regular(x, t))
        middle = (found.frequency > 0.25) & (found.frequency < 1.15)
        H = operator(found.frequency[middle])
        off = np.abs(found.operator[middle] - H)[:, [0, 2, 4]] / np.abs(H[:, [0, 2, 4]])
        # without noise only what a window smears is left: at the peak (0.006/0.025 rad/s)^2
        self.assertLess(np.median(off), 0.005)
        self.assertLess(off.max(), 0.1)
        self.assertGreater(found.coherence[middle][:, [0, 2, 4]].min(), 0.98)

    def test_noise_lowers_coherence_and_the_error_says_so(self):
        t, x, y = random_sea(12000, noise=1.0)
        found = rao.random(t, x, y)
        middle = (found.frequency > 0.25) & (found.frequency < 1.15)
        H = operator(found.frequency[middle])[:, 0]
        off = np.abs(np.abs(found.operator[middle, 0]) - np.abs(H)) / np.abs(H)
        stated = found.error[middle, 0]
        self.assertLess(found.coherence[middle, 0].mean(), 0.97)
        # two thirds lie within one standard error; by chance some more or fewer
        self.assertGreater(np.mean(off < stated), 0.5)
        self.assertLess(np.mean(off < stated), 0.85)


def narrow(seconds, damping, noise=0.0, seed=5):
    """White elevation and the heave of an oscillator of 15 s, by the exact step of its impulse response."""
    draw, step, w0 = np.random.default_rng(seed), 0.5, 2 * math.pi / 15
    n = int(seconds / step)
    before = int(5 / (damping * w0 * step))  # until it is steady
    x = draw.standard_normal(n + before)
    s = np.arange(int(8 / (damping * w0 * step))) * step
    wd = w0 * math.sqrt(1 - damping ** 2)
    response = w0 ** 2 / wd * np.exp(-damping * w0 * s) * np.sin(wd * s) * step
    size = 1 << int(len(x) + len(s)).bit_length()
    y = np.fft.irfft(np.fft.rfft(x, size) * np.fft.rfft(response, size), size)[before:before + n]
    motion = np.zeros((n, 6))
    motion[:, 2] = y + noise * draw.standard_normal(n)
    return np.arange(n) * step, x[before:], motion


class CutPeaks(unittest.TestCase):
    def test_what_a_window_leaves_of_a_peak(self):
        """R against the blur itself: the window's spectrum times the resonance, over frequency; and far off its
        limit 1 - (4/3) (pi/aT)^2."""
        n, T = 1 << 20, 100.0
        window = np.zeros(n)
        window[:1000] = np.hanning(1001)[:1000]
        weight = np.abs(np.fft.fft(window)) ** 2
        u = 2 * math.pi * np.fft.fftfreq(n, T / 1000)
        for aT in (0.5, 2.0, 8.0):
            a = aT / T
            left = np.sum(weight / (1 + 1j * u / a)).real / weight.sum()
            self.assertAlmostEqual(rao.kept_of_peak(aT), left, delta=2e-3)
            self.assertAlmostEqual(rao.bandwidth_kept(rao.kept_of_peak(aT)) / aT, 1, delta=1e-6)
        self.assertAlmostEqual(rao.kept_of_peak(60.0), 1 - 4 / 3 * (math.pi / 60) ** 2, delta=3e-4)

    def test_a_cut_peak_is_told_with_its_height(self):
        """1.2 % of critical peaks at 1/(2 z) = 41.7; 15 windows of 3000 s leave under half. That the rest is told
        rests on a coherence of twelve independent windows: by chance a third off, over twenty draws a tenth."""
        z, truth, told = 0.012, [], []
        for seed in range(20):
            t, x, y = narrow(3000, z, seed=seed)
            response = rao.random(t, x, y)
            cut = rao.cut_peaks(response, t[-1])
            self.assertEqual([c.motion for c in cut], [2])
            self.assertLess(cut[0].found, 0.6 / (2 * z))
            told.append(cut[0].found / cut[0].kept)
            truth.append(cut[0].run)
        self.assertAlmostEqual(np.median(told) * 2 * z, 1, delta=0.3)
        # and a run of the length that is told shows it: 95 % asked for, told within the scatter of the estimate
        t, x, y = narrow(float(np.median(truth)), z)
        shown = rao.random(t, x, y)
        self.assertGreater(np.abs(shown.operator[:, 2]).max() * 2 * z, 0.85)

    def test_a_wide_peak_in_noise_is_not_cut(self):
        """15 % of critical is seven resolutions wide; noise alone lowers its coherence."""
        t, x, y = narrow(3000, 0.15, noise=1.0)
        response = rao.random(t, x, y)
        peak = int(np.abs(response.operator[:, 2]).argmax())
        self.assertLess(response.coherence[peak, 2], 0.95)
        self.assertEqual(rao.cut_peaks(response, t[-1]), [])

    def test_low_coherence_is_told_by_range(self):
        w = np.linspace(0.1, 1.0, 10)
        H, c = np.ones((10, 6), complex), np.ones((10, 6))
        c[[2, 3, 7], 2] = 0.4
        H[7, 2] = 0.01  # too small to matter
        response = rao.Response(w, H, c, np.zeros((10, 6)))
        self.assertEqual(rao.low_coherence(response, 2), [(w[2], w[3])])
        self.assertEqual(rao.low_coherence(response, 0), [])


class Spectrum(unittest.TestCase):
    def test_holds_the_variance(self):
        t, x, _ = random_sea(12000)
        w, S = rao.spectrum(t, x)
        self.assertAlmostEqual(np.sum(S) * (w[1] - w[0]) / np.var(x), 1, delta=0.03)
        band = (w > 0.3) & (w < 1.1)
        self.assertAlmostEqual(S[band].mean(), 1.0, delta=0.1)  # variance 1 over 1 rad/s


class Tables(unittest.TestCase):
    def test_what_is_written_is_read(self):
        w = np.array([0.3, 0.5])
        X = operator(w)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rao.csv")
            rao.write(path, rao.Response(w, X, np.ones(X.shape), np.zeros(X.shape)), ["heave: a remark, of two parts"])
            back = rao.read(path)
        self.assertLess(np.abs(back.operator - X).max(), 1e-5)

    def test_reads_wamit_and_radians(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hull.4")
            with open(path, "w") as file:
                file.write(" 10.0 0.0 3 0.5 -90.0 0.0 -0.5\n 10.0 0.0 5 0.02 0.0 0.02 0.0\n"
                           " 10.0 90.0 3 9.0 0.0 9.0 0.0\n")
            found = rao.read(path, heading=0.0, ulen=2.0)
            table = os.path.join(folder, "other.csv")
            with open(table, "w") as file:
                file.write("omega_rad_s,heave_re,heave_im,pitch_re,pitch_im\n0.5,1,2,0.1,0\n")
            other = rao.read(table)
            with self.assertRaises(ValueError):
                rao.read(path, heading=45.0)
        self.assertAlmostEqual(found.frequency[0], 0.2 * math.pi)
        self.assertAlmostEqual(found.operator[0, 2], -0.5j)
        self.assertAlmostEqual(found.operator[0, 4], 0.01 * 180 / math.pi)
        self.assertAlmostEqual(other.operator[0, 4], 0.1 * 180 / math.pi)
        self.assertAlmostEqual(other.operator[0, 2], 1 + 2j)


if __name__ == "__main__":
    unittest.main()
