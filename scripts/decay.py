#!/usr/bin/python3
"""Period and damping of a free decay, by the p-q method.

    x'' + b1 x' + b2 |x'| x' + w^2 x = 0

loses per period the part p + q a of its amplitude a (in the logarithm):

    p = 2 pi b1/(2 w)        q = (8/3) b2

to first order in p and q. Half the heights from turning point to turning point are the amplitudes, so
that the place of rest, which may not be known, drops out. The line p + q a is a robust one (Tukey's biweight): swings
that another motion disturbs, usually the first and largest, do not bend it. Beside it stands what the smallest swings
lose, which needs no line. scripts/plot draws both, and tests/validation/validate_platforms.py uses it. Needs numpy only.
"""

import math
from dataclasses import dataclass

import numpy as np

LEAST = 0.02  # heights below this part of the greatest are left out


@dataclass
class Decay:
    """What a free decay tells. Amplitudes and q in the units of the series."""

    when: np.ndarray  # times of the turning points that were used [s]
    what: np.ndarray  # values there
    amplitude: np.ndarray  # of each pair of neighbouring heights, their geometric mean
    loss: np.ndarray  # of each pair: logarithm of their ratio, for a whole period
    period: float  # damped, mean over the turning points [s]
    p: float  # loss per period as the amplitude goes to zero
    q: float  # what it grows by with the amplitude [1/unit]
    p_error: float = 0.0  # standard errors of the two, from the scatter about the line
    q_error: float = 0.0
    scatter: float = 0.0  # root mean square of loss - (p + q a), all pairs alike
    small: tuple = (0.0, 0.0, 0.0)  # smallest third of the amplitudes: least, greatest, median loss

    @property
    def linear_damping(self):
        """Part of critical as the amplitude goes to zero."""
        return damping_of(self.p)

    @property
    def quadratic_damping(self):
        """What the part of critical grows by with the amplitude [1/unit]."""
        return self.q / (2 * math.pi)

    @property
    def natural_period(self):
        """Undamped [s]: the period times sqrt(1 - damping^2), at the mean amplitude."""
        return self.period * math.sqrt(1 - damping_of(float(np.mean(self.loss))) ** 2)

    @property
    def coefficients(self):
        """b1 [1/s] and b2 [1/unit] of the equation above."""
        return 2 * self.p / self.period, 3 * self.q / 8


def damping_of(loss):
    """Part of critical damping of a logarithmic loss per period."""
    return loss / np.hypot(2 * math.pi, loss)


def robust_line(a, y, w):
    """p, q of y = p + q a, their standard errors: Tukey's biweight on residuals times w (an error of y is in
    inverse proportion to w), begun at the weighted median of the slopes of all pairs of points (Theil and Sen)."""
    i, j = np.triu_indices(len(a), 1)
    run = a[j] - a[i]
    apart = np.abs(run) > 1e-9 * np.abs(a).max()
    slope, weight = ((y[j] - y[i])[apart] / run[apart]), np.abs(run[apart])
    order = np.argsort(slope)
    q = slope[order][np.searchsorted(np.cumsum(weight[order]), 0.5 * weight.sum())]
    p = float(np.median(y - q * a))
    X = np.column_stack([np.ones_like(a), a])
    for _ in range(50):
        off = w * (y - p - q * a)
        scale = max(1.4826 * float(np.median(np.abs(off))), 1e-4 * float(np.median(w * np.abs(y))), 1e-300)
        kept = w * np.clip(1 - (off / (4.685 * scale)) ** 2, 0, None)  # root of the weight
        before = p, q
        p, q = np.linalg.lstsq(X * kept[:, None], kept * y, rcond=None)[0]
        if abs(p - before[0]) + abs(q - before[1]) * a.max() < 1e-9 * abs(p):
            break
    left = kept * (y - p - q * a)
    free = max(float(np.sum((kept / w) ** 2)) - 2, 1.0)
    spread = np.linalg.pinv((X * kept[:, None]).T @ (X * kept[:, None])) * float(left @ left) / free
    return p, q, math.sqrt(spread[0, 0]), math.sqrt(spread[1, 1])


def turning_points(t, x):
    """Times and values of the extremes between crossings of the mean, each from the parabola
    through three samples. Ripples beside the decaying motion do not count as turns. The first and the
    last piece of the series are left out."""
    above = x > x.mean()
    edges = np.flatnonzero(above[1:] != above[:-1]) + 1  # first sample after each crossing
    when, what = [], []
    for first, end in zip(edges[:-1], edges[1:]):
        piece = x[first:end]
        i = first + int(piece.argmax() if above[first] else piece.argmin())
        i = min(max(i, 1), len(x) - 2)
        before, after = x[i] - x[i - 1], x[i + 1] - x[i]
        shift = 0.5 * (before + after) / (before - after) if before != after else 0.0  # in steps, from sample i
        when.append(t[i] + shift * (t[i + 1] - t[i]))
        what.append(x[i] + 0.25 * (before + after) * shift)
    return np.array(when), np.array(what)


def free_decay(t, x, least=LEAST):
    """The decay of a series sampled at equal intervals, or None if it has fewer than four turns that
    are higher than `least` of the highest, or does not decay."""
    when, what = turning_points(np.asarray(t, float), np.asarray(x, float))
    height = np.abs(np.diff(what))
    small = np.flatnonzero(height <= least * height.max(initial=0.0))
    if len(small):
        height = height[: small[0]]
    if len(height) < 3:
        return None
    when, what = when[: len(height) + 1], what[: len(height) + 1]
    loss = 2 * np.log(height[:-1] / height[1:])
    amplitude = 0.5 * np.sqrt(height[:-1] * height[1:])
    period = 2 * np.polyfit(np.arange(len(when)), when, 1)[0]
    if len(loss) > 2:  # an error of a turn is an error of the loss in inverse proportion to the height
        p, q, p_error, q_error = robust_line(amplitude, loss, amplitude)
    else:
        p, q, p_error, q_error = float(np.mean(loss)), 0.0, 0.0, 0.0
    smallest = np.argsort(amplitude)[: -(-len(loss) // 3)]
    small = (float(amplitude[smallest].min()), float(amplitude[smallest].max()), float(np.median(loss[smallest])))
    scatter = float(np.sqrt(np.mean((loss - p - q * amplitude) ** 2)))
    return Decay(when, what, amplitude, loss, float(period), float(p), float(q), p_error, q_error, scatter, small)
