#!/usr/bin/python3
"""Writes tests/common/hydro/ball.nc: a hemisphere of 2 m in the layout of Capytaine's NetCDF-4.

usage: capytaine_sample.py FILE.nc

The numbers are those of tests/common/test_hydro_formats.cpp. Capytaine's conventions: SI, dimensions
as scales, directions in radians, e^{-i w t}, so the imaginary parts are minus those of WAMIT; a
complex value is a pair along the dimension "complex"; dofs in any order.
"""

import math
import sys

import h5py
import numpy as np

RHO, G, RADIUS = 1025.0, 9.80665, 2.0
MODES = ["Heave", "Surge", "Sway", "Roll", "Pitch", "Yaw"]  # not in the usual order
ORDER = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
OMEGA = [math.inf, 1.5, 0.0, 1.0]
VOLUME = 2 / 3 * math.pi * RADIUS**3


def added_mass(w):
    scale = {math.inf: 0.7, 0.0: 0.8, 1.0: 1.1, 1.5: 1.0}[w]
    A = np.zeros((6, 6))
    A[0, 0] = A[1, 1] = 9e3 * scale
    A[2, 2] = 1.1e4 * scale
    A[0, 4] = A[4, 0] = -300 * scale
    A[1, 3] = A[3, 1] = 300 * scale
    return A


def damping(w):
    B = np.zeros((6, 6))
    if 0 < w < math.inf:
        to_B = w**3 / (4 * math.pi * RHO * G**3)  # Haskind's relation in deep water
        B[0, 0] = B[1, 1] = to_B * math.pi * 1e8 * w**2
        B[2, 2] = to_B * 2 * math.pi * (6.4e9 + 1e6 * w**2)
    return B


def excitation(w, b):
    """As WAMIT has it, e^{+i w t}."""
    return np.array([1e4 * 1j * w * math.cos(b), 1e4 * 1j * w * math.sin(b), 8e4 + 1e3j * w,
                     -500 * w * math.sin(b), 500 * w * math.cos(b), 0])


def main():
    with h5py.File(sys.argv[1], "w") as f:
        text = h5py.string_dtype()
        f.create_dataset("omega", data=np.array(OMEGA))
        f.create_dataset("wave_direction", data=np.radians([0, 90, 180, 270]))
        for name in ("radiating_dof", "influenced_dof"):
            f.create_dataset(name, data=MODES, dtype=text)
        f.create_dataset("complex", data=["re", "im"], dtype=text)
        for name in ("omega", "wave_direction", "radiating_dof", "influenced_dof", "complex"):
            f[name].make_scale(name)
        place = [ORDER.index(m) for m in MODES]

        def put(name, dims, values):
            data = f.create_dataset(name, data=np.array(values))
            for i, dim in enumerate(dims):
                data.dims[i].attach_scale(f[dim])

        square = np.ix_(place, place)
        # Rows are the motion that radiates, columns the force: the matrices are transposed.
        put("added_mass", ["omega", "radiating_dof", "influenced_dof"],
            [added_mass(w).T[square] for w in OMEGA])
        put("radiation_damping", ["omega", "radiating_dof", "influenced_dof"],
            [damping(w).T[square] for w in OMEGA])
        force = np.array([[np.conj(excitation(w if w < math.inf else 0, b))[place]
                           for b in f["wave_direction"][()]] for w in OMEGA])
        for name, share in (("Froude_Krylov_force", 0.75), ("diffraction_force", 0.25)):
            put(name, ["complex", "omega", "wave_direction", "influenced_dof"],
                [share * force.real, share * force.imag])
        C = np.zeros((6, 6))
        C[2, 2] = RHO * G * math.pi * RADIUS**2
        put("hydrostatic_stiffness", ["influenced_dof", "radiating_dof"], C[square])
        for name, value in (("rho", RHO), ("g", G), ("water_depth", math.inf),
                            ("displaced_volume", VOLUME)):
            f.create_dataset(name, data=value)
        f.create_dataset("center_of_buoyancy", data=[0, 0, -3 / 8 * RADIUS])


if __name__ == "__main__":
    main()
