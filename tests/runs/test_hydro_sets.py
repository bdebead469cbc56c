"""Sets of hydrodynamic data from outside: one body in five formats moves alike, `hydro convert` loses
nothing, wrong sets are found with file and line, a regular wave gives back the .4 and the drift.

usage: test_hydro_sets.py HAWSER SOURCE_DIR [unittest arguments]

The body is a truncated cylinder of `hawser hydro cylinder`. The formats are written here by their
own conventions, from the manuals, without the program's writers or readers.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE = sys.argv[1:3]
RHO, G = 1025.0, 9.80665
MODES = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
ROTATES = numpy.array([0, 0, 0, 1, 1, 1])

# The hull: radius, draft, depth [m]; mass in the middle of what it displaces.
R, DRAFT, DEPTH = 10.0, 20.0, 100.0
VOLUME = math.pi * R**2 * DRAFT
Z_G, GYRATION = -13.0, 9.0


def hawser(*arguments, code=0):
    done = subprocess.run([HAWSER, *map(str, arguments)], capture_output=True, text=True, timeout=100)
    assert done.returncode == code, f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr


def cylinder(stem, frequencies, headings, radius=R, draft=DRAFT, depth=DEPTH, free=()):
    hawser("hydro", "cylinder", "--depth", depth, "--part", f"{radius},0,-{draft}", "--frequencies", frequencies,
           "--headings", headings, "--tolerance", "2e-3", "--out", stem, *free, "-q")


def read_rows(path):
    return [[float(x) for x in line.split()] for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines()]


class Body:
    """Dimensional coefficients, e^{+i w t}, of a WAMIT set with ULEN 1."""

    def __init__(self, stem):
        rows = {end: read_rows(f"{stem}{end}") for end in (".1", ".3", ".hst")}
        self.w = sorted({2 * math.pi / row[0] for row in rows[".1"] if row[0] > 0})
        self.headings = sorted({row[1] for row in rows[".3"]})
        self.A, self.B = numpy.zeros((2, len(self.w), 6, 6))
        self.limits = {-1: numpy.zeros((6, 6)), 0: numpy.zeros((6, 6))}
        self.X = numpy.zeros((len(self.w), len(self.headings), 6), complex)
        self.C = numpy.zeros((6, 6))
        for row in rows[".1"]:
            i, j = int(row[1]) - 1, int(row[2]) - 1
            if row[0] > 0:
                f = self.place(2 * math.pi / row[0])
                self.A[f, i, j], self.B[f, i, j] = RHO * row[3], RHO * self.w[f] * row[4]
            else:
                self.limits[int(row[0])][i, j] = RHO * row[3]
        for row in rows[".3"]:
            f, h = self.place(2 * math.pi / row[0]), self.headings.index(row[1])
            self.X[f, h, int(row[2]) - 1] = RHO * G * complex(row[5], row[6])
        for i, j, value in rows[".hst"]:
            self.C[int(i) - 1, int(j) - 1] = RHO * G * value

    def place(self, w):
        return int(numpy.argmin(numpy.abs(numpy.array(self.w) - w)))


def text(rows):
    return "".join(" ".join(f"{x:.15g}" for x in row) + "\n" for row in rows)


def write_wamit(body, stem, ulen=1.0, header=True, turned=False, by_frequency=False):
    """WAMIT manual, chapter 4: A over rho L^k, B over rho w L^k, X over rho g L^m. HAMS (`turned`):
    e^{-i w t}, zero frequency as 0 and infinite as -1."""
    zero, infinite = (0, -1) if turned else (-1, 0)
    first = (lambda w: w) if by_frequency else (lambda w: 2 * math.pi / w)
    one, three, hst = [], [], []
    for i in range(6):
        for j in range(6):
            scale = RHO * ulen ** (3 + ROTATES[i] + ROTATES[j])
            hst.append((i + 1, j + 1, body.C[i, j] / (RHO * G * ulen ** (2 + ROTATES[i] + ROTATES[j]))))
            if not body.A[:, i, j].any():
                continue
            one += [(zero, i + 1, j + 1, body.limits[-1][i, j] / scale),
                    (infinite, i + 1, j + 1, body.limits[0][i, j] / scale)]
            one += [(first(w), i + 1, j + 1, body.A[f, i, j] / scale, body.B[f, i, j] / (scale * w))
                    for f, w in enumerate(body.w)]
    for f, w in enumerate(body.w):
        for h, b in enumerate(body.headings):
            for i in range(6):
                x = body.X[f, h, i] / (RHO * G * ulen ** (2 + ROTATES[i]))
                x = x.conjugate() if turned else x
                three.append((first(w), b, i + 1, abs(x), math.degrees(math.atan2(x.imag, x.real)), x.real, x.imag))
    for end, rows in ((".1", one), (".3", three), (".hst", hst)):
        pathlib.Path(f"{stem}{end}").write_text(("WAMIT Numeric Output\n" if header else "") + text(rows),
                                                encoding="utf-8")


def write_capytaine(body, path):
    """Dimensions by name, radians, e^{-i w t}, limits as omega 0 and infinity; other order of motions."""
    order = [2, 0, 1, 3, 5, 4]
    omega = [math.inf, *reversed(body.w), 0.0]
    zeros = numpy.zeros((6, 6))
    A = [body.limits[0], *reversed(body.A), body.limits[-1]]
    B = [zeros, *reversed(body.B), zeros]
    nothing = numpy.zeros((len(body.headings), 6))
    X = numpy.conj(numpy.array([nothing, *reversed(body.X), nothing]))[:, :, order]
    square = numpy.ix_(order, order)
    with h5py.File(path, "w") as f:
        words = h5py.string_dtype()
        f["omega"] = numpy.array(omega)
        f["wave_direction"] = numpy.radians(body.headings)
        for name in ("radiating_dof", "influenced_dof"):
            f.create_dataset(name, data=[MODES[i] for i in order], dtype=words)
        f.create_dataset("complex", data=["re", "im"], dtype=words)
        for name in ("omega", "wave_direction", "radiating_dof", "influenced_dof", "complex"):
            f[name].make_scale(name)

        def put(name, dims, values):
            data = f.create_dataset(name, data=numpy.array(values))
            for i, dim in enumerate(dims):
                data.dims[i].attach_scale(f[dim])

        for name, all_of in (("added_mass", A), ("radiation_damping", B)):
            put(name, ["omega", "influenced_dof", "radiating_dof"], [M[square] for M in all_of])
        for name, share in (("Froude_Krylov_force", 0.4 + 0.3j), ("diffraction_force", 0.6 - 0.3j)):
            put(name, ["complex", "omega", "wave_direction", "influenced_dof"],
                [(share * X).real, (share * X).imag])
        put("hydrostatic_stiffness", ["influenced_dof", "radiating_dof"], body.C[square])
        for name, value in (("rho", RHO), ("g", G), ("water_depth", DEPTH), ("displaced_volume", VOLUME)):
            f[name] = value
        f["center_of_buoyancy"] = [0.0, 0.0, -DRAFT / 2]


def write_bemio(body, path):
    """(mode, mode, frequency) and (mode, heading, frequency), over rho, rho w and rho g; degrees."""
    w = numpy.array(body.w)
    with h5py.File(path, "w") as f:
        parameters = f.create_group("simulation_parameters")
        for name, value in (("rho", RHO), ("g", G), ("scaled", 0.0), ("water_depth", DEPTH)):
            parameters[name] = [[value]]
        parameters["w"], parameters["wave_dir"] = w[:, None], numpy.array(body.headings)[:, None]
        f["body1/properties/disp_vol"] = [[VOLUME]]
        f["body1/properties/cb"] = [[0.0], [0.0], [-DRAFT / 2]]
        f["body1/properties/cg"] = [[0.0], [0.0], [0.0]]
        at = f.create_group("body1/hydro_coeffs")
        at["added_mass/all"] = numpy.moveaxis(body.A, 0, 2) / RHO
        at["added_mass/inf_freq"] = body.limits[0] / RHO
        at["radiation_damping/all"] = numpy.moveaxis(body.B, 0, 2) / (RHO * w)
        X = numpy.transpose(body.X, (2, 1, 0)) / (RHO * G)
        at["excitation/re"], at["excitation/im"] = X.real, X.imag
        at["linear_restoring_stiffness"] = body.C / (RHO * G)


def write_nemoh(body, folder):
    """A zone per motion with A and B of the six forces, a zone per heading with size and phase (radians)
    of e^{-i w t}."""
    for name in ("Mesh", "Results"):
        (folder / name).mkdir(parents=True)
    (folder / "Nemoh.cal").write_text(
        f"--- Environment ---\n{RHO} ! RHO\n{G} ! G\n{DEPTH} ! DEPTH\n0. 0. ! XEFF YEFF\n--- Bodies ---\n1 ! bodies\n",
        encoding="utf-8")
    zones = "VARIABLES=\"w (rad/s)\"\n"
    for j in range(6):
        zones += f"Zone t=\"Motion of body   1 in DoF   {j + 1}\",I= {len(body.w)},F=POINT\n"
        zones += text([w, *numpy.ravel([body.A[f, :, j], body.B[f, :, j]], "F")] for f, w in enumerate(body.w))
    (folder / "Results/RadiationCoefficients.tec").write_text(zones, encoding="utf-8")
    zones = "VARIABLES=\"w (rad/s)\"\n"
    for h, b in enumerate(body.headings):
        zones += f"Zone t=\"Diffraction force - beta = {b:.10g} deg\",I= {len(body.w)},F=POINT\n"
        x = numpy.conj(body.X[:, h])
        zones += text([w, *numpy.ravel([abs(x[f]), numpy.angle(x[f])], "F")] for f, w in enumerate(body.w))
    (folder / "Results/ExcitationForce.tec").write_text(zones, encoding="utf-8")
    (folder / "Mesh/KH.dat").write_text(text(body.C), encoding="utf-8")
    (folder / "Mesh/Hydrostatics.dat").write_text(
        f" XF =   0.000 - XG =   0.000\n YF =   0.000 - YG =   0.000\n ZF = {-DRAFT / 2:.3f} - ZG =   0.000\n"
        f" Displacement =  {VOLUME:.12g}\n", encoding="utf-8")


STATED = f"rho: {RHO}, displaced_volume: {VOLUME!r}, centre_of_buoyancy: [0, 0, {-DRAFT / 2}], includes_weight: false"


def case(path, database, wave="{type: airy, H: 2 m, T: 9 s, heading: 30 deg}", platform="", duration=40, w=0.7,
         depth=DEPTH):
    path.write_text(f"""format: 1
environment:
  seabed: {{depth: {depth} m}}
  waves: [{wave}]
platform:
  name: buoy
  mass: auto
  centre_of_gravity: [0, 0, {Z_G}]
  radii_of_gyration: {{roll: {GYRATION}, pitch: {GYRATION}, yaw: 7}}
  hydrodynamics:
    database: {{{database}}}
    added_mass: {{constant: {w} rad/s}}
    {platform}
analysis:
  statics: {{loads: []}}
  dynamics: {{duration: {duration} s, ramp: 20 s, steps: {{platform: 0.5 s}}}}
output: {{channels: [platform.motions, platform.loads]}}
""", encoding="utf-8")
    return path


def run(path):
    out = path.with_suffix("")
    hawser("run", path, "--out", out, "--force", "-q")
    with h5py.File(out / "result.h5") as f:
        at = f["platform/buoy"]
        loads = {name: values[()] for name, values in at["loads"].items()}
        return f["time"][()], at["position"][()], loads


class Folder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cylinder(cls.folder / "set", "0.2:2.6:0.1", "0:315:45")
        cls.body = Body(cls.folder / "set")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()


class FiveFormats(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        write_wamit(cls.body, cls.folder / "wamit", ulen=3.0)
        write_wamit(cls.body, cls.folder / "hams", header=False, turned=True, by_frequency=True)
        write_capytaine(cls.body, cls.folder / "capytaine.nc")
        write_bemio(cls.body, cls.folder / "bemio.h5")
        write_nemoh(cls.body, cls.folder / "nemoh")
        cls.databases = {
            "wamit": f"format: wamit, path: wamit, ulen: 3 m, {STATED}",
            "hams": f"format: hams, path: hams, period_column: frequency, {STATED}",
            "capytaine": "format: capytaine, path: capytaine.nc, includes_weight: false",
            "bemio": "format: bemio, path: bemio.h5, includes_weight: false",
            "nemoh": "format: nemoh, path: nemoh, includes_weight: false"}
        cls.options = ["--rho", RHO, "--volume", VOLUME, "--centre-of-buoyancy", f"0,0,{-DRAFT / 2}", "--depth", DEPTH]

    def test_the_same_body_moves_alike(self):
        motions = {name: run(case(self.folder / f"case_{name}.yml", database))[1]
                   for name, database in self.databases.items()}
        amplitude = numpy.ptp(motions["wamit"], axis=0)
        self.assertGreater(min(amplitude[[0, 1, 2, 3, 4]]), 0.1)  # it does move: m and degrees
        for name, motion in motions.items():
            # 15 digits in the files; yaw of a round hull is rounding.
            off = numpy.abs(motion - motions["wamit"])[:, :5].max(axis=0) / amplitude[:5]
            self.assertLess(off.max(), 1e-9, name)

    def test_convert_keeps_every_number(self):
        sources = {"wamit": ["wamit.1", "wamit.3", "--ulen", 3, *self.options],
                   "hams": ["hams", "--format", "hams", "--period-column", "frequency", *self.options],
                   "capytaine": ["capytaine.nc"], "bemio": ["bemio.h5"], "nemoh": ["nemoh"]}
        for name, (first, *rest) in sources.items():
            files = [self.folder / first] + [self.folder / x if str(x).startswith("wamit.") else x for x in rest]
            hawser("hydro", "convert", *files, "-o", self.folder / f"to_{name}")
            # WAMIT -> BEMIO -> WAMIT, each by the program.
            hawser("hydro", "convert", self.folder / f"to_{name}.h5", "-o", self.folder / f"back_{name}")
            for stem in (f"to_{name}", f"back_{name}"):
                other = Body(self.folder / stem)
                # Nine decimals are printed.
                numpy.testing.assert_allclose(other.w, self.body.w, rtol=2e-9)
                for key in ("A", "B", "X", "C"):
                    own, new = getattr(self.body, key), getattr(other, key)
                    if key == "X":  # headings -180 to 180 may stand for 0 to 360
                        places = [[round(b) % 360 for b in other.headings].index(round(b) % 360)
                                  for b in self.body.headings]
                        new = new[:, places]
                    numpy.testing.assert_allclose(new, own, rtol=4e-9, atol=4e-9 * abs(own).max(), err_msg=stem)
                if name != "nemoh":  # it has no limits
                    numpy.testing.assert_allclose(other.limits[0], self.body.limits[0], rtol=4e-9, err_msg=stem)

    def test_info_guesses_the_format_and_finds_nothing_wrong(self):
        for name, arguments in {"wamit": ["wamit", "--ulen", 3, *self.options],
                                "hams": ["hams", "--format", "hams", *self.options],
                                "capytaine": ["capytaine.nc"], "bemio": ["bemio.h5"], "nemoh": ["nemoh"]}.items():
            data = json.loads(hawser("hydro", "info", self.folder / arguments[0], *arguments[1:], "--json"))
            self.assertEqual({c["verdict"] for c in data["checks"]} - {"fine", "remark"}, set(), name)
            self.assertEqual(data["symmetry"], "round")
            sizes = {c["what"]: c["size"] for c in data["checks"] if "size" in c}
            # What the truncation of the eigenfunctions leaves, and B linear between frequencies.
            self.assertLess(sizes["Haskind, surge"], 1e-4, name)
            self.assertLess(sizes["Haskind, surge and pitch"], 1e-4, name)
            self.assertLess(sizes["Ogilvie, heave"], 0.02, name)
        words = hawser("hydro", "info", self.folder / "nemoh", "--mass", RHO * VOLUME, "--cog", Z_G)
        # z_B + I/V - z_G of a cylinder
        self.assertIn(f"GM {-DRAFT / 2 + R**2 / (4 * DRAFT) - Z_G:.5g} m in roll", words)

    def test_pictures_are_drawn(self):
        (self.folder / "info.json").write_text(hawser("hydro", "info", self.folder / "capytaine.nc", "--json"),
                                               encoding="utf-8")
        done = subprocess.run([str(pathlib.Path(SOURCE) / "scripts/plot_hydro"), str(self.folder / "info.json"), "-o",
                               str(self.folder / "picture")], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("radiation", "excitation"):
            self.assertGreater((self.folder / f"picture_{name}.png").stat().st_size, 20000)


class WrongSets(Folder):
    def complaint(self, name, database=None, code=3, **keys):
        path = case(self.folder / f"{name}.yml", database or f"path: {name}, {STATED}", **keys)
        return hawser("check", path, code=code)

    def changed(self, name, change):
        """The set with its rows of .1 and .3 changed: row -> row."""
        for end in (".1", ".3", ".hst"):
            rows = read_rows(self.folder / f"set{end}")
            (self.folder / f"{name}{end}").write_text(text(change(end, row) for row in rows), encoding="utf-8")

    def line_of(self, name, end, is_it):
        return 1 + [is_it(row) for row in read_rows(self.folder / f"{name}{end}")].index(True)

    def test_the_right_one_is_valid(self):
        self.assertIn("0 errors, 0 warnings", self.complaint("right", f"path: set, {STATED}", code=0))

    def test_negative_damping(self):
        self.changed("negative", lambda end, r: [*r[:4], -r[4]] if end == ".1" and len(r) == 5 and r[1] == r[2] == 3
                     and abs(2 * math.pi / r[0] - 0.7) < 1e-6 else r)
        at = self.line_of("negative", ".1", lambda r: len(r) == 5 and r[4] < -1e-3 and r[1] == r[2])
        self.assertIn(f"negative.1:{at}:1: error: damping of mode 3 is negative at 0.7 rad/s", self.complaint("negative"))

    def test_periods_read_as_frequencies(self):
        words = self.complaint("column", f"path: set, period_column: frequency, limits: wamit, {STATED}",
                               wave="{type: airy, H: 0.1 m, T: 1 s, heading: 0 deg}")
        self.assertRegex(words, r"set\.3:\d+:1: error: .*check period_column")

    def test_excitation_of_another_run(self):
        cylinder(self.folder / "other", "0.2:2.6:0.1", "0:315:45", radius=6.0)
        self.changed("mixed", lambda end, r: r)
        (self.folder / "mixed.3").write_text((self.folder / "other.3").read_text(encoding="utf-8"), encoding="utf-8")
        self.assertRegex(self.complaint("mixed"), r"mixed\.3:\d+:1: error: .*not of one run")

    def test_phase_that_haskind_forbids(self):
        self.changed("phase", lambda end, r: [*r[:3], r[3], r[4] + 180, -r[5], -r[6]]
                     if end == ".3" and r[2] in (4, 5) else r)
        self.assertRegex(self.complaint("phase"), r"phase\.3:\d+:1: error: B15 and the phases of surge and pitch "
                         r"excitation .* do not belong to this damping")

    def test_time_the_other_way_round(self):
        self.changed("turned", lambda end, r: [*r[:4], -r[4], r[5], -r[6]] if end == ".3" else r)
        self.assertRegex(self.complaint("turned"), r"turned\.3:\d+:1: error: .*the phases follow e\^\(-i w t\)")

    def test_exchanged_limits(self):
        self.assertRegex(self.complaint("limits", f"path: set, limits: reversed, {STATED}"),
                         r"set\.1.* error: .*limits of zero and infinite frequency are exchanged")

    def test_length_unit(self):
        self.assertIn("Check ulen", self.complaint("ulen", f"path: set, ulen: 1.5 m, {STATED}"))

    def test_density(self):
        self.assertIn("900 to 1100 kg/m3; got 1.025",
                      self.complaint("thin", f"path: set, {STATED.replace('1025.0', '1.025')}"))
        self.assertIn("warning: platform.hydrodynamics.database.rho: 1000 kg/m3, but the water has 1025 kg/m3",
                      self.complaint("fresh", f"path: set, {STATED.replace('1025.0', '1000')}", code=0))

    def test_heading_that_is_not_covered(self):
        cylinder(self.folder / "quarter", "0.2:2.6:0.1", "0:90:45")
        words = self.complaint("quarter", wave="{type: airy, H: 2 m, T: 9 s, heading: 120 deg}")
        self.assertIn("quarter.yml:4:40: error: environment.waves[0].heading: waves meet the platform at a heading of "
                      "120 deg, outside the 0 to 90 deg", words)
        self.complaint("quarter", f"path: quarter, symmetry: [xz, yz], {STATED}", code=0,
                       wave="{type: airy, H: 2 m, T: 9 s, heading: 120 deg}")

    def test_waves_outside_the_frequencies(self):
        self.assertIn("100.0 % of the waves' energy lies outside the frequencies",
                      self.complaint("short", f"path: set, {STATED}", wave="{type: airy, H: 0.1 m, T: 2 s, heading: 0 deg}"))

    def test_another_depth(self):
        words = self.complaint("shallow", f"path: set, {STATED}", code=0, depth=30)
        self.assertRegex(words, r"belong together in water of \w+ .*depth .*, not of 30 m")

    def test_volume_that_only_the_file_tells(self):
        write_bemio(self.body, self.folder / "volume.h5")
        path = case(self.folder / "volume.yml", "format: bemio, path: volume.h5, includes_weight: false",
                    platform=f"\n  displacement: {1.02 * RHO * VOLUME} kg")
        self.assertIn("volume.yml:14:3: error: platform.displacement", hawser("check", path, code=3))


class FreeHull(unittest.TestCase):
    """The cylinder of radius 20 m, draft 70 m in 300 m of water, whose free motions and drift are published with
    the reference data (truncated_cylinder/rao_free_floating.csv at 0.425 rad/s)."""

    MASS, Z_G, GYRATION = 9.016371e7, -42.0, 25.0
    W, WAVE = 0.425, 0.6  # of the reference, of the run: there the drift is a fair part of the force

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cylinder(cls.folder / "hull", "0.4,0.425,0.5,0.6,0.65", "0:180:90", 20, 70, 300,
                 ("--mass", cls.MASS, "--cog", cls.Z_G, "--gyration", cls.GYRATION))
        cls.body = Body(cls.folder / "hull")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def motion(self, f, h, damping):
        """Of the free hull per metre: (-w2 (M + A) + i w (B + damping) + C) x = X about the waterline."""
        M = self.MASS * numpy.diag([1, 1, 1, *[self.GYRATION**2 + self.Z_G**2] * 2, 14.0**2])
        M[0, 4] = M[4, 0] = self.MASS * self.Z_G
        M[1, 3] = M[3, 1] = -self.MASS * self.Z_G
        C = self.body.C.copy()
        C[3, 3] -= self.MASS * G * self.Z_G
        C[4, 4] -= self.MASS * G * self.Z_G
        w = self.body.w[f]
        return numpy.linalg.solve(-w**2 * (M + self.body.A[f]) + 1j * w * (self.body.B[f] + numpy.diag(damping)) + C,
                                  self.body.X[f, h])

    def test_linear_solution_is_that_of_the_reference(self):
        x = self.motion(1, self.body.headings.index(0.0), numpy.zeros(6))
        for mode, value in ((0, 3.676944e-02 - 1.388608j), (2, -4.038060e-01 - 4.741302e-02j),
                            (4, 6.064328e-04 - 2.290210e-02j)):
            self.assertLess(abs(x[mode] - value), 0.005 * abs(value), MODES[mode])

    def test_regular_wave_gives_back_the_4_and_the_drift(self):
        damping = numpy.array([1e7, 0, 1e7, 4e9, 4e9, 0])  # forgets how it began, drifts evenly
        rows = []
        for f, w in enumerate(self.body.w):
            for h, b in enumerate(self.body.headings):
                for i, x in enumerate(self.motion(f, h, damping)):
                    rows.append((2 * math.pi / w, b, i + 1, abs(x), math.degrees(numpy.angle(x)), x.real, x.imag))
        (self.folder / "hull.4").write_text(text(rows), encoding="utf-8")
        stated = (f"rho: {RHO}, displaced_volume: {math.pi * 400 * 70!r}, centre_of_buoyancy: [0, 0, -35], "
                  "includes_weight: false")
        info = json.loads(hawser("hydro", "info", self.folder / "hull", "--volume", math.pi * 400 * 70,
                                 "--centre-of-buoyancy", "0,0,-35", "--depth", 300, "--json"))
        heading = [round(b) for b in info["motion"]["headings"]].index(0)
        of_reference, f = (int(numpy.argmin(abs(numpy.array(info["motion"]["frequencies"]) - w)))
                           for w in (self.W, self.WAVE))
        rao = numpy.array(info["motion"]["re"])[heading, f] + 1j * numpy.array(info["motion"]["im"])[heading, f]
        drift = numpy.array(info["mean_drift"][0]["re"])[heading, :, 0]
        self.assertLess(abs(drift[of_reference] - 4882.017), 0.005 * 4882)
        D = drift[f]

        amplitude, T = 1.0, 2 * math.pi / self.WAVE
        path = case(self.folder / "wave.yml", f"path: hull, {stated}",
                    wave=f"{{type: airy, H: {2 * amplitude} m, T: {T!r} s, heading: 0 deg}}", depth=300, w=self.WAVE,
                    duration=500, platform="drift: mean\n    wave_phase: slow\n  damping: {linear: {"
                    f"surge: {damping[0]} N.s/m, heave: {damping[2]} N.s/m, roll: {damping[3]} N.m.s/rad, pitch: {damping[4]} N.m.s/rad}}}}")
        words = path.read_text(encoding="utf-8").replace(f"[0, 0, {Z_G}]", f"[0, 0, {self.Z_G}]")
        words = words.replace(f"roll: {GYRATION}, pitch: {GYRATION}, yaw: 7",
                              f"roll: {self.GYRATION}, pitch: {self.GYRATION}, yaw: 14")
        path.write_text(words, encoding="utf-8")
        t, position, loads = run(path)
        last = t > t[-1] - 8 * T
        x = position[last]
        x[:, 3:] = numpy.radians(x[:, 3:])
        # The drift moves the hull evenly: the phase is that of the wave where it is.
        s = t[last] - t[-1]
        k = wave_number(self.WAVE, 300.0)
        phase = self.WAVE * t[last] - k * numpy.polyval(numpy.polyfit(s, x[:, 0], 1), s)
        design = numpy.column_stack([numpy.ones_like(s), s, numpy.cos(phase), -numpy.sin(phase)])
        fit = numpy.linalg.lstsq(design, x, rcond=None)[0]
        for mode in (0, 2, 4):
            found = complex(*fit[2:4, mode]) / amplitude
            self.assertLess(abs(found - rao[mode]), 0.01 * abs(rao[mode]), MODES[mode])
        # The first-order force at the slow position leaves no mean.
        force = loads["wave1"][last, 0] + loads["drift"][last, 0]
        mean = numpy.linalg.lstsq(design[:, [0, 2, 3]], force, rcond=None)[0][0]
        self.assertLess(abs(mean - D * amplitude**2), 0.03 * D * amplitude**2)


def wave_number(w, depth):
    k = w * w / G
    for _ in range(100):
        k = w * w / (G * math.tanh(k * depth))
    return k


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
