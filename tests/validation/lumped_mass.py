#!/usr/bin/python3
"""A second opinion on lines in motion: point masses and springs in a plane, explicit in time.

Shares nothing with the rods: no finite elements, no implicit step, no multipliers. Nodes carry half of
the mass, weight, buoyancy, added mass and Morison drag of the segments beside them;
segments are springs of stiffness EA/l with a small damper; the bed pushes up on nodes that are in it.
Used where two sources disagree (validate_lines.py), and for what lines add to a platform's inertia
(validate_platforms.py).

Units: SI. x horizontal, z up; node 0 is the fairlead.
"""

from dataclasses import dataclass

import numpy as np

RHO, G = 1025.0, 9.80665


@dataclass
class Part:
    """A stretch of uniform line. Drag coefficients act on diameter x length, both of them."""
    length: float
    segments: int
    mass: float
    diameter: float
    EA: float
    Cd: float = 0.0
    Cd_axial: float = 0.0
    Ca: float = 1.0
    Ca_axial: float = 0.0


@dataclass
class Bed:
    z: float
    stiffness: float  # per length of line [N/m2]
    damping: float  # per length of line [N.s/m2]


class Line:
    def __init__(self, parts, damping=0.05):
        """`damping`: of critical in a segment by itself."""
        def spread(get):
            return np.concatenate([np.full(p.segments, get(p)) for p in parts])
        self.l = spread(lambda p: p.length / p.segments)
        self.EA = spread(lambda p: p.EA)
        mass, area = spread(lambda p: p.mass), spread(lambda p: np.pi / 4 * p.diameter**2)
        self.c = damping * self.l * np.sqrt(self.EA * mass)

        def to_nodes(per_length):
            half = per_length * self.l / 2
            return np.append(half, 0) + np.insert(half, 0, 0)
        self.m = to_nodes(mass)
        self.w = to_nodes((mass - RHO * area) * G)
        self.added = to_nodes(RHO * area * spread(lambda p: p.Ca))
        self.along = to_nodes(mass + RHO * area * spread(lambda p: p.Ca_axial))
        self.cn = to_nodes(0.5 * RHO * spread(lambda p: p.Cd * p.diameter))
        self.ct = to_nodes(0.5 * RHO * spread(lambda p: p.Cd_axial * p.diameter))
        self.part = to_nodes(np.ones_like(self.l))

    def at_rest(self, dx, dz, bed=False):
        """Nodes with the fairlead at 0 and the other end at (dx, -dz), by Newton on the force (H, V) at
        the fairlead; with a bed what would hang below the anchor lies there instead."""
        def march(H, V):
            x = [np.zeros(2)]
            for i in range(len(self.l)):
                v = V - self.w[1:i + 1].sum()
                if bed and v < 0:
                    v = 0.0
                T = np.hypot(H, v)
                x.append(x[-1] + self.l[i] * (1 + T / self.EA[i]) / T * np.array([H, -v]))
            return np.array(x)
        F = np.array([0.5 * self.w.sum(), 0.7 * self.w.sum()])
        for _ in range(200):
            miss = march(*F)[-1] - (dx, -dz)
            if np.abs(miss).max() < 1e-9:
                break
            J = np.array([(march(*(F + d))[-1] - march(*F)[-1]) / 1.0 for d in np.eye(2)]).T
            step = np.linalg.solve(J, miss)
            F = F - step * min(1.0, 0.3 * np.abs(F).min() / np.abs(step).max())
        return march(*F)

    def tensions_in_motion(self, x, motion, duration, dt, bed=None, every=50):
        """Tension of the segment at the fairlead [N] against time. `motion(t)` gives the fairlead's
        displacement and velocity."""
        times, tensions, _ = self.in_motion(x, motion, duration, dt, bed, every)
        return times, tensions

    def in_motion(self, x, motion, duration, dt, bed=None, every=50):
        """Also the force of the line on what moves its fairlead, the inertia of the end's half segment included."""
        x, v = x.copy(), np.zeros_like(x)
        start = x[0].copy()
        times, tensions, forces = [], [], []
        up = np.array([0.0, 1.0])
        for n in range(int(round(duration / dt)) + 1):
            t = n * dt
            shift, speed = motion(t)
            x[0], v[0] = start + shift, speed
            d = x[1:] - x[:-1]
            L = np.sqrt((d * d).sum(1))
            e = d / L[:, None]
            rate = ((v[1:] - v[:-1]) * e).sum(1) / self.l
            T = self.EA * (L / self.l - 1) + self.c * rate
            pull = T[:, None] * e
            F = np.zeros_like(x)
            F[:-1] += pull
            F[1:] -= pull
            F[:, 1] -= self.w
            q = np.zeros_like(x)  # direction of the line at nodes
            q[:-1] += e
            q[1:] += e
            q /= np.sqrt((q * q).sum(1))[:, None]
            vt = (v * q).sum(1)
            vn = v - vt[:, None] * q
            F -= (self.cn * np.sqrt((vn * vn).sum(1)))[:, None] * vn + (self.ct * np.abs(vt) * vt)[:, None] * q
            if bed:
                inside = x[:, 1] < bed.z
                push = self.part * (bed.stiffness * (bed.z - x[:, 1]) - bed.damping * v[:, 1])
                F += np.where(inside, np.maximum(push, 0), 0)[:, None] * up
            # (m + added (I - q q)) a = F
            Fq = (F * q).sum(1)
            a = (F - Fq[:, None] * q) / (self.m + self.added)[:, None] + (Fq / self.along)[:, None] * q
            if n % every == 0:
                times.append(t)
                tensions.append(T[0])
                a0 = (motion(t + dt)[1] - motion(max(t - dt, 0.0))[1]) / (t + dt - max(t - dt, 0.0))
                along = (a0 @ q[0]) * q[0]
                forces.append(F[0] - self.along[0] * along - (self.m[0] + self.added[0]) * (a0 - along))
            a[0] = a[-1] = 0
            v += dt * a
            v[-1] = 0
            x += dt * v
        return np.array(times), np.array(tensions), np.array(forces)

    def impedance(self, x, direction, w, amplitude=0.05, dt=2e-3, bed=None, settle=4):
        """Complex force of the line on its fairlead per displacement of that in `direction`, both in the plane,
        Re(Z x e^{iwt}), from a harmonic motion of small amplitude."""
        period = 2 * np.pi / w
        direction = np.asarray(direction, float)
        t, _, F = self.in_motion(x, harmonic(amplitude * direction, period, settle * period),
                                 (settle + 4) * period, dt, bed, every=10)
        late = t >= (settle + 1) * period
        t, F = t[late], F[late]
        # x = a sin wt = Re(-i a e^{iwt})
        basis = np.column_stack([np.cos(w * t), -np.sin(w * t), np.ones_like(t), t])
        found = np.linalg.lstsq(basis, F, rcond=None)[0]
        return (found[0] + 1j * found[1]) / (-1j * amplitude)


def harmonic(amplitude, period, ramp, phase=(0.0, 0.0)):
    """Displacement and velocity of a fairlead that starts gently."""
    amplitude, phase, w = np.array(amplitude), np.array(phase), 2 * np.pi / period

    def motion(t):
        r = min(t / ramp, 1.0)
        f, df = r**3 * (10 - 15 * r + 6 * r * r), 30 * r * r * (1 - r)**2 / ramp
        s, c = np.sin(w * t + phase), np.cos(w * t + phase)
        return amplitude * f * s, amplitude * (df * s + f * w * c)
    return motion
