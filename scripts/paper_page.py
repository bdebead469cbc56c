#!/usr/bin/env python3
"""The page of paper_figures: for each figure what the paper shows, what comes out, why they differ."""

import numpy as np

from paper_results import PAPER

HEAD = """# Figures 3 to 8 of OMAE2011-49553, and what comes out here

{what}

The paper's own axes are used: y up, z to starboard, so that its sway and pitch have the opposite sign of ours. It
does not say from where its weather comes. Two runs stand beside each other: the weather along x, and 15 degrees off
it towards the side on which the paper's sway is positive (heading -15 deg in the case). Numbers are of the window
drawn: mean ± standard deviation, least to greatest. Of the paper only the ranges of its axes can be read as numbers,
and nothing in the case is tuned towards them. Program: {version}.

"""

SYSTEM = """fairleads, hang-offs, azimuths of the SCRs and every depth inside the hull are not in the paper; the
README of the case lists what was assumed."""

MOTIONS = """the paper states neither heading, pretension, fairleads, line weights, drag of the hull, wind area nor
heave plates; all are assumed in the case.

- *Surge* is the mean load (wind {wind:.1f}, current {current:.1f}, mean drift {drift:.1f} MN, and viscous drift) over a
  stiffness of {stiffness:.2f} MN/m, all with the weather along x. {surge_would}
- *Sway* is {sway_along:.2f} m with the weather along x, so the paper's weather is not along its x. At 15 degrees the
  mooring is {across:.1f} times as stiff across x as along it (mean load over mean offset), which keeps the sway small.
- *Heave* goes to {heave_low:.1f} and {heave_high:.1f} m; the heave plates, their area and drag, are guessed, and its
  natural period of {heave_period:.0f} s lies in the tail of this sea.
- *Pitch* depends on the height and area of the deck in the wind and on the depth of the fairleads, all assumed.
- *Roll* and *yaw*: with the weather along x only the SCRs' sizes break the model's symmetry. The paper's axes show up
  to 2 degrees.
- *Coupled against quasi-static*, weather 15 degrees off: rms differences of {surge:.0f} % of the standard deviation in
  surge, {sway:.0f} in sway, {heave:.0f} in heave, {roll:.0f} in roll, {pitch:.0f} in pitch, {yaw:.0f} in yaw. Lines without
  drag of their own motion do not damp the hull: the ratios in the last column are what that is worth."""

KEEL = """the force is that of both contact points of the keel joint, 1 m above and below its middle, each a radial
magnitude, added; which of them, or what sum, the paper plots is not said. The lower one carries {lower:.0f} % of the
mean. The mean is the riser's tension times the angle between hull and riser, the swing that of the hull's lean.
Gap, stiffness of the guide and the strengthened joint are assumed."""

TENSION = """line 1 lies to leeward here. The dynamic line's range is {ratio:.1f} times that of the quasi-static one:
drag holds the middle of the line when its end moves with the waves, so that the end stretches the rope instead of
lifting the line. The paper's pretension, line weights and the drag of its rope are not known."""

STRESS = """the level follows from the angle at the top, assumed as 10 deg (a larger angle lowers it), and from the
bending at touch-down. At the end of the axis {on_bed:.0f} MPa are left, of tension and of the water's pressure. At
the moment of the maximum the peak is {now:.0f} MPa and its mean over the window {mean:.0f} MPa: that much is static."""


def spread(values):
    """mean ± std, least to greatest"""
    return f"{values.mean():.2f} ± {values.std():.2f}, {values.min() + 0.0:.2f} to {values.max() + 0.0:.2f}"


def rms(a, b):
    return float(np.sqrt(np.mean((a - b) ** 2)))


def share(a, b):
    """rms difference in % of the standard deviation of the first"""
    return 100 * rms(a, b) / a.std()


def differs_in_steps(worst):
    """What the figures of Figure 4 say of the paper's claim."""
    if worst < 1.0:  # a drawn line is some percent of the curve's height wide
        return (f"in the claim they do not: the two curves differ by {worst:.2g} % of the standard deviation at most, "
                "less than a line is wide. The levels are those of Figure 5.")
    return (f"**the two curves differ by {worst:.2g} % of the standard deviation**, which the paper says they do not. "
            "The levels are those of Figure 5.")


def row(*cells):
    return "| " + " | ".join(str(c) for c in cells) + " |\n"


def table(*rows):
    head, *rest = rows
    return row(*head) + row(*["---"] * len(head)) + "".join(row(*r) for r in rest) + "\n"


def axis_of(channel):
    low, high = PAPER[channel].axis
    return f"{low:g} to {high:g}"


def common_samples(a, b, channel, window):
    """The two series at the times that both have, inside the window."""
    in_a = np.isin(np.round(a.time, 6), np.round(b.time, 6)) & a.inside(window)
    in_b = np.isin(np.round(b.time, 6), np.round(a.time, 6)) & b.inside(window)
    return a.series(channel)[in_a], b.series(channel)[in_b]


def text(everything, window, quick):
    first = next(iter(everything.values()))["coupled"]
    what = (f"An hour of the storm, of which {window[0]:g} to {window[1]:g} s are drawn, by `scripts/paper_figures`."
            if not quick else "**A quick run, 45 s of storm and not an hour: its numbers mean nothing.**")
    version = f"{first.file.attrs['program']} {first.file.attrs['version']}, {first.file.attrs['build']}"
    figures = (figure_3, figure_4, figure_5, figure_6, figure_7, figure_8)
    return HEAD.format(what=what, version=version) + "\n".join(draw(everything, window) for draw in figures)


def section(number, title, shows, here, differs):
    return (f"## Figure {number}: {title}\n\n![Figure {number}](figure_{number}.png)\n\n"
            f"**The paper shows** {shows}\n\n**Here:**\n\n{here}**Why they differ:** {differs}\n")


def figure_3(everything, window):
    return section(3, "the system",
                   "the spar with 12 mooring lines in three groups, 4 TTRs and 4 SCRs, diameters exaggerated.",
                   "the same lines at rest under the mean wind, current and drift.\n\n", SYSTEM)


def figure_4(everything, window):
    rows = [("weather", "channel", "paper's axis", "step 0.5 s", "rms of the difference to 1.0 s", "% of std")]
    for heading, hours in everything.items():
        if "step_1s" not in hours:
            continue
        for channel in ("surge", "heave", "pitch"):
            a, b = common_samples(hours["coupled"], hours["step_1s"], channel, window)
            rows.append((f"{heading}°", f"{channel}, {PAPER[channel].unit}", axis_of(channel), spread(a),
                         f"{rms(a, b):.2g}", f"{share(a, b):.2g}"))
    worst = max(float(cells[-1]) for cells in rows[1:])
    return section(4, "platform steps of 0.5 and 1.0 s",
                   "surge, heave and pitch with both steps, and says that there is no difference between them.",
                   table(*rows), differs_in_steps(worst))


def motions_facts(everything, window):
    """The numbers in MOTIONS, of the runs themselves."""
    along, off = (everything[heading]["coupled"] for heading in ("0", "15"))
    surge, sway = (along.series(channel)[along.inside(window)].mean() for channel in ("surge", "sway"))
    loads = {name: 1e-6 * along.load(name, 0)[along.inside(window)].mean()
             for name in ("wind", "current", "drift", "lines")}
    stiffness = -loads["lines"] / surge
    inside = off.inside(window)
    secant = [abs(off.load("lines", axis)[inside].mean() / off.motions[inside, axis].mean()) for axis in (0, 1)]
    middle = sum(PAPER["surge"].axis) / 2
    lacks = stiffness * (middle - surge)
    would = (f"The middle of the paper's axis, {middle:g} m, is {abs(lacks):.1f} MN {'more' if lacks > 0 else 'less'}: "
             f"{100 * abs(lacks) / loads['wind']:.0f} % of the wind load or {100 * abs(lacks) / loads['current']:.0f} % of "
             "the current's.")
    heave = along.series("heave")[along.inside(window)]
    facts = {"wind": loads["wind"], "current": loads["current"], "drift": loads["drift"], "stiffness": stiffness,
             "surge_would": would, "sway_along": sway, "across": secant[1] / secant[0],
             "heave_low": heave.min(), "heave_high": heave.max(), "heave_period": along.fact("period_heave")}
    hours = everything["15"]
    for channel in ("surge", "sway", "heave", "roll", "pitch", "yaw"):
        facts[channel] = share(*common_samples(hours["coupled"], hours["quasi_static"], channel, window))
    return facts


def figure_5(everything, window):
    rows = [("weather", "channel", "paper's axis", "coupled", "quasi-static lines", "rms difference, % of std",
             "std, quasi-static over coupled")]
    for heading, hours in everything.items():
        for channel in ("surge", "sway", "heave", "roll", "pitch", "yaw"):
            a, b = common_samples(hours["coupled"], hours["quasi_static"], channel, window)
            moves = a.std() > 0.005  # of a motion that nothing drives no ratio is told
            rows.append((f"{heading}°", f"{channel}, {PAPER[channel].unit}", axis_of(channel), spread(a), spread(b),
                         f"{share(a, b):.0f}" if moves else "-",
                         f"{b.std() / a.std():.2f}" if moves else "-"))
    return section(5, "coupled against quasi-static lines",
                   "six motions; heave differs little between the two, all others plainly.", table(*rows),
                   MOTIONS.format(**motions_facts(everything, window)))


def figure_6(everything, window):
    rows = [("weather", "paper's axis, kN", "both points, kN", "upper point, kN", "lower point, kN",
             "time in contact, %")]
    for heading, hours in everything.items():
        inside = hours["coupled"].inside(window)
        upper, lower = (force[inside] for force in hours["coupled"].keel_forces())
        rows.append((f"{heading}°", axis_of("keel"), spread(upper + lower), spread(upper), spread(lower),
                     f"{100 * np.mean(upper + lower > 0):.0f}"))
    carried = 100 * lower.mean() / (upper + lower).mean()
    return section(6, "contact force at the keel joint, TTR 1",
                   "one curve that is never negative, so a magnitude, on an axis of 0 to 600 kN.", table(*rows),
                   KEEL.format(lower=carried))


def figure_7(everything, window):
    rows = [("weather", "paper's axis, kN", "coupled, kN", "quasi-static lines, kN", "range, kN",
             "range, quasi-static, kN")]
    for heading, hours in everything.items():
        a, b = common_samples(hours["coupled"], hours["quasi_static"], "top_tension", window)
        rows.append((f"{heading}°", axis_of("top_tension"), spread(a), spread(b), f"{np.ptp(a):.0f}",
                     f"{np.ptp(b):.0f}"))
    a, b = common_samples(*(everything["0"][run] for run in ("coupled", "quasi_static")), "top_tension", window)
    return section(7, "top tension of mooring line 1", "the dynamic line beside the quasi-static one.", table(*rows),
                   TENSION.format(ratio=np.ptp(a) / np.ptp(b)))


def figure_8(everything, window):
    rows = [("weather", "paper's axis, MPa", "greatest, MPa", "at arc length, m", "at time, s",
             "greatest of the mean, MPa", "at arc length, m")]
    for heading, hours in everything.items():
        stress = hours["coupled"].stress(window)
        greatest, arc = stress.greatest
        rows.append((f"{heading}°", axis_of("stress"), f"{greatest:.1f}", f"{arc:.0f}", f"{stress.t_max:g}",
                     f"{stress.mean.max():.1f}", f"{stress.arc[int(stress.mean.argmax())]:.0f}"))
    stress = everything["0"]["coupled"].stress(window)
    at = int(stress.highest.argmax())
    facts = {"on_bed": stress.mean[-1], "now": stress.moment[at], "mean": stress.mean[at]}
    return section(8, "von Mises stress around the touch-down zone, oil export SCR",
                   "one curve over 1000 to 1900 m of arc length on an axis of 0 to 150 MPa; whether it is of one "
                   "moment or an envelope is not said.", table(*rows),
                   STRESS.format(**facts))
