#!/usr/bin/python3
"""Response amplitude operators from series of elevation and motion.

Regular waves: elevation and motion are fitted with one frequency over whole periods at the end of the
run. Random waves: cross spectra, with coherence (Welch's method: overlapping Hann windows). The
operator is complex with the time factor e^{+i w t}: its phase is by how much the motion is ahead of
the crest at the platform's design position. Needs numpy only.

A window of length T blurs what is narrower than 2 pi/T. A resonance of half-power bandwidth 2 a [rad/s] answers with
h(s) = a e^{-a s} times its peak; in cross spectra it is weighted with the window's own correlation r(s/T), so that of
the peak is left

    R(a T) = int_0^T a e^{-a s} r(s/T) ds

and the coherence there is that very R, for the same blur takes R of the cross spectrum and R of the response's
spectrum: R^2/R. So in waves that are even over the bandwidth the peak is that found over the coherence.
"""

import csv
import math
from dataclasses import dataclass

import numpy as np

LEAST_KEPT = 0.2  # of a peak: below it the coherence of some twelve windows tells no more
MOTIONS = ["surge", "sway", "heave", "roll", "pitch", "yaw"]


@dataclass
class Response:
    """Operators over frequency, in the units of the motions per metre (rotations in degrees)."""

    frequency: np.ndarray  # [rad/s]
    operator: np.ndarray  # (frequencies, 6), complex
    coherence: np.ndarray  # (frequencies, 6); 1 in regular waves
    error: np.ndarray  # (frequencies, 6): standard error relative to |operator|; in regular waves how
    # much it still changed between the halves of the time that was used
    window: float = 0.0  # length of a window [s]; 0: regular waves
    windows: float = 1.0  # independent ones


def fit(t, x, w):
    """Complex amplitude X of x = Re(X e^{i w t}) + a + b t, by least squares."""
    s = t - t.mean()
    columns = np.column_stack([np.cos(w * t), -np.sin(w * t), np.ones_like(t), s])
    c = np.linalg.lstsq(columns, x, rcond=None)[0]
    return c[0] + 1j * c[1]


def wave_frequency(t, elevation):
    """Frequency of a regular wave: that of the sine which leaves least of the elevation."""
    step, n = t[1] - t[0], len(t)
    power = np.abs(np.fft.rfft((elevation - elevation.mean()) * np.hanning(n)))
    middle, width = 2 * math.pi * np.argmax(power) / (n * step), 2 * math.pi / (n * step)

    def left(w):
        columns = np.column_stack([np.cos(w * t), np.sin(w * t), np.ones_like(t)])
        return float(np.sum((elevation - columns @ np.linalg.lstsq(columns, elevation, rcond=None)[0]) ** 2))

    low, high = max(middle - width, 0.1 * width), middle + width
    golden = (math.sqrt(5) - 1) / 2
    for _ in range(60):
        a, b = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, b) if left(a) < left(b) else (a, high)
    return 0.5 * (low + high)


def regular(t, elevation, motion, periods=10):
    """Operators of a run in regular waves, from the last `periods` whole periods (or half the run)."""
    w = wave_frequency(t, elevation)
    T = 2 * math.pi / w
    count = min(periods, int(0.5 * (t[-1] - t[0]) / T))
    if count < 2:
        raise ValueError(f"the run is too short for a wave of {T:.1f} s: at least 4 periods are needed")

    def over(t0, t1):
        use = (t > t0 - 1e-9) & (t < t1 + 1e-9)
        A = fit(t[use], elevation[use], w)
        return np.array([fit(t[use], motion[use, i], w) / A for i in range(6)])

    end = t[-1]
    X = over(end - count * T, end)
    before, after = over(end - count * T, end - count / 2 * T), over(end - count / 2 * T, end)
    change = np.abs(after - before) / np.maximum(np.abs(X), 1e-12)
    return Response(np.array([w]), X[None, :], np.ones((1, 6)), change[None, :])


def random(t, elevation, motion, windows=15, least=0.01):
    """Operators of a run in random waves, where the sea has at least the part `least` of the energy
    density at its peak. The run is cut into `windows` windows that overlap by half."""
    step = t[1] - t[0]
    n = int(2 * len(t) / (windows + 1))
    window = np.hanning(n + 1)[:n]
    Sxx, Sxy = 0.0, np.zeros((n // 2 + 1, 6), complex)
    Syy = np.zeros((n // 2 + 1, 6))
    count = 0
    for first in range(0, len(t) - n + 1, max(n // 2, 1)):
        part = slice(first, first + n)
        x = np.fft.rfft((elevation[part] - elevation[part].mean()) * window)
        y = np.fft.rfft((motion[part] - motion[part].mean(axis=0)) * window[:, None], axis=0)
        Sxx = Sxx + np.abs(x) ** 2
        Sxy += np.conj(x)[:, None] * y
        Syy += np.abs(y) ** 2
        count += 1
    w = 2 * math.pi * np.arange(n // 2 + 1) / (n * step)
    use = Sxx > least * Sxx[1:].max()
    use[:2] = False  # the mean and what the window spreads of it
    H = Sxy[use] / Sxx[use, None]
    floor = 1e-300
    coherence = np.abs(Sxy[use]) ** 2 / np.maximum(Sxx[use, None] * Syy[use], floor)
    # Bendat and Piersol: variance of |H|; windows that overlap by half count nine elevenths each
    independent = max(count * 9 / 11, 1.0)
    error = np.sqrt(np.maximum(1 - coherence, 0) / np.maximum(2 * coherence * independent, floor))
    return Response(w[use], H, coherence, error, n * step, independent)


def kept_of_peak(aT):
    """R: what a Hann window of length T leaves of the peak of a resonance with half-power bandwidth 2 a."""
    x = (np.arange(4000) + 0.5) / 4000
    r = (2 / 3) * (1 - x) * (1 + 0.5 * np.cos(2 * math.pi * x)) + np.sin(2 * math.pi * x) / (2 * math.pi)
    # a e^{-a s} over each of the small steps exactly, so that a quick decay is no trouble
    weight = np.exp(-aT * (x - 0.5 / 4000)) - np.exp(-aT * (x + 0.5 / 4000))
    return float(np.sum(weight * r))


def bandwidth_kept(R):
    """a T of which R is left, by bisection."""
    low, high = 1e-6, 1e6
    for _ in range(80):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if kept_of_peak(middle) < R else (low, middle)
    return math.sqrt(low * high)


@dataclass
class CutPeak:
    """A peak that the spectral resolution cuts."""

    motion: int
    at: int  # place in the frequencies
    found: float  # its size there
    kept: float  # part of the true peak that this is, estimated; LEAST_KEPT: that or less
    bandwidth: float  # of the resonance at half power [rad/s]
    damping: float  # part of critical
    run: float  # length of run of which 95 % would be seen, with the same number of windows [s]


def half_power_width(w, size, k):
    """Width of the peak at size[k] where it falls to 1/sqrt(2) [rad/s]; twice one side where the other does not."""
    level, sides = size[k] / math.sqrt(2), []
    for step in (-1, 1):
        i = k
        while 0 <= i + step < len(w) and size[i] > level:
            i += step
        if size[i] <= level:
            part = (size[i - step] - level) / (size[i - step] - size[i])
            sides.append(abs(w[i - step] + part * (w[i] - w[i - step]) - w[k]))
    return sum(sides) * (1 if len(sides) == 2 else 2) if sides else math.inf


def cut_peaks(response, length, seen=0.95, least=1.5):
    """Peaks of operators from random waves of a run of `length` of which less than `seen` is left. A peak is
    the greatest value inside the frequencies, `least` times the median or more and no wider than the resolution would
    make a resonance of the bandwidth that the coherence tells: else it is noise that lowers the coherence."""
    cut = []
    w, T = response.frequency, response.window
    if T == 0.0:
        return cut
    for i in range(response.operator.shape[1]):
        size = np.abs(response.operator[:, i])
        k = int(size.argmax())
        if k in (0, len(w) - 1) or size[k] < least * np.median(size) or size[k] <= 1e-6:
            continue
        c = float(response.coherence[k, i])
        R = min(max(c - (1 - c) ** 2 / response.windows, LEAST_KEPT), 1.0)  # less what chance gives
        if R >= seen:
            continue
        a = bandwidth_kept(R) / T
        if half_power_width(w, size, k) > 2 * (2 * a + 1.44 * 2 * math.pi / T):  # 1.44: Hann's own, in steps
            continue
        cut.append(CutPeak(i, k, float(size[k]), R, 2 * a, a / w[k], length * bandwidth_kept(seen) / (a * T)))
    return cut


def low_coherence(response, i, least=0.8, matters=0.05):
    """Ranges [rad/s] in which less than `least` of motion i comes from the waves, where it is at least the part
    `matters` of its greatest."""
    size = np.abs(response.operator[:, i])
    low = (response.coherence[:, i] < least) & (size > matters * size.max())
    edges = np.flatnonzero(np.diff(np.concatenate([[0], low.astype(int), [0]])))
    return [(response.frequency[a], response.frequency[b - 1]) for a, b in zip(edges[::2], edges[1::2])]


def spectrum(t, x, windows=7):
    """One-sided variance density over frequency [rad/s] by Welch's method: w, S."""
    step = t[1] - t[0]
    n = int(2 * len(t) / (windows + 1))
    window = np.hanning(n + 1)[:n]
    S, count = 0.0, 0
    for first in range(0, len(t) - n + 1, max(n // 2, 1)):
        part = x[first:first + n]
        S = S + np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
        count += 1
    w = 2 * math.pi * np.arange(n // 2 + 1) / (n * step)
    return w, S * step / (math.pi * count * np.sum(window ** 2))


def is_regular(elevation, t):
    """Does one sine hold (nearly) all of the elevation?"""
    if np.ptp(elevation) == 0.0:
        raise ValueError("there are no waves in this run")
    w = wave_frequency(t, elevation)
    A = fit(t, elevation, w)
    return float(np.std(elevation - (A * np.exp(1j * w * t)).real)) < 0.02 * float(np.std(elevation))


def write(path, response, remarks=()):
    """As a table with a header: frequency, then real and imaginary part, coherence and error of each; before it the
    remarks, as lines that begin with #."""
    head = ["omega_rad_s"]
    for m in MOTIONS:
        unit = "m_per_m" if m in MOTIONS[:3] else "deg_per_m"
        head += [f"{m}_re_{unit}", f"{m}_im_{unit}", f"{m}_coherence", f"{m}_error"]
    with open(path, "w", newline="") as file:
        file.writelines(f"# {line}\n" for line in remarks)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(head)
        for w, X, c, e in zip(response.frequency, response.operator, response.coherence, response.error):
            row = [f"{w:.6g}"]
            for i in range(6):
                row += [f"{X[i].real:.6g}", f"{X[i].imag:.6g}", f"{c[i]:.4f}", f"{e[i]:.3g}"]
            table.writerow(row)


def read(path, heading=0.0, ulen=1.0):
    """A reference: this program's own table, any table with columns like `heave_re` and `heave_im`
    beside `omega_rad_s` (rotations in rad unless the column says deg), or WAMIT's .4 (column 1 the
    period; rotations in rad/m times ulen)."""
    if path.endswith(".4"):
        return read_wamit(path, heading, ulen)
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if not rows or "omega_rad_s" not in rows[0]:
        raise ValueError(f"{path}: no column omega_rad_s in the first line")
    w = np.array([float(r["omega_rad_s"]) for r in rows])
    X = np.full((len(w), 6), np.nan, complex)
    for i, m in enumerate(MOTIONS):
        names = [n for n in rows[0] if n.split("_")[0] == m]
        part = {p: next((n for n in names if p in n.split("_")), None) for p in ("re", "im")}
        if part["re"] is None or part["im"] is None:
            continue
        scale = 180 / math.pi if i > 2 and "deg" not in part["re"].split("_") else 1.0
        X[:, i] = scale * np.array([float(r[part["re"]]) + 1j * float(r[part["im"]]) for r in rows])
    return Response(w, X, np.ones((len(w), 6)), np.zeros((len(w), 6)))


def read_wamit(path, heading, ulen):
    found = {}
    with open(path) as file:
        for line in file:
            cells = line.split()
            try:
                period, beta, mode, re, im = (float(cells[k]) for k in (0, 1, 2, 5, 6))
            except (IndexError, ValueError):
                continue  # the header
            if abs((beta - heading + 180) % 360 - 180) < 0.01 and 1 <= mode <= 6 and period > 0:
                scale = 180 / math.pi / ulen if mode > 3 else 1.0
                found.setdefault(2 * math.pi / period, np.zeros(6, complex))[int(mode) - 1] = \
                    scale * (re + 1j * im)
    if not found:
        raise ValueError(f"{path}: no motions for waves that travel towards {heading:g} deg")
    w = np.array(sorted(found))
    X = np.array([found[k] for k in w])
    return Response(w, X, np.ones(X.shape), np.zeros(X.shape))


def joined(responses):
    """Several runs in regular waves as one response."""
    order = np.argsort([r.frequency[0] for r in responses])
    rows = [responses[k] for k in order]
    return Response(*(np.concatenate([getattr(r, name) for r in rows])
                      for name in ("frequency", "operator", "coherence", "error")))
