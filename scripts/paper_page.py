"""The page of paper_figures: for each figure what the paper shows, what comes out, why they differ."""

import numpy as np

from paper_results import PAPER

KEEL = ""
TENSION = ""
STRESS = ""
MOTIONS = ""
HEAD = """# Figures 3 to 8 of OMAE2011-49553, and what comes out here

{what}
All of it is in the paper's own axes: y up, z to starboard, so that the paper's sway and pitch have the opposite
sign of ours. The paper does not say from where the weather comes. Two runs stand beside each other: the weather
along x, and 15 degrees off it towards the side on which the paper's sway is positive (-15 deg in the axes of the
case). Numbers are of the window drawn, mean and standard deviation, then least to greatest. Of the paper only the
ranges of its axes can be read as numbers; nothing in the case is tuned towards them. Program: {version}.

"""


def spread(values):
    """mean ± std, least to greatest"""
    return f"{values.mean():.2f} ± {values.std():.2f}, {values.min():.2f} to {values.max():.2f}"


def rms(a, b):
    return float(np.sqrt(np.mean((a - b) ** 2)))


def row(*cells):
    return "| " + " | ".join(str(c) for c in cells) + " |\n"


def table(*rows):
    head, *rest = rows
    return row(*head) + row(*["---"] * len(head)) + "".join(row(*r) for r in rest) + "\n"


def common_samples(a, b, channel, window):
    """The two series at the times both have, inside the window; None if one is missing."""
    if a is None or b is None or a.series(channel) is None or b.series(channel) is None:
        return None
    in_a = np.isin(np.round(a.time, 6), np.round(b.time, 6)) & a.inside(window)
    in_b = np.isin(np.round(b.time, 6), np.round(a.time, 6)) & b.inside(window)
    return a.series(channel)[in_a], b.series(channel)[in_b]


def text(everything, window, quick):
    first = next(iter(everything.values()))["coupled"]
    what = (f"One hour of the storm, {window[0]:g} to {window[1]:g} s drawn, by `scripts/paper_figures`."
            if not quick else "**A quick run: 45 s of storm and not an hour, the numbers mean nothing.**")
    version = f"{first.file.attrs['program']} {first.file.attrs['version']}, {first.file.attrs['build']}"
    parts = [HEAD.format(what=what, version=version), figure_3(), figure_4(everything, window),
             figure_5(everything, window), figure_6(everything, window), figure_7(everything, window),
             figure_8(everything, window)]
    return "".join(parts)


def section(number, title, shows, table_text, differs):
    return (f"## Figure {number}: {title}\n\n![Figure {number}](figure_{number}.png)\n\n"
            f"**The paper shows** {shows}\n\n**Here:**\n\n{table_text}**Why they differ:** {differs}\n\n")


def figure_3():
    return section(3, "the system",
                   "the spar with 12 mooring lines in three groups, 4 TTRs and 4 SCRs, diameters exaggerated.",
                   "the same lines at rest under the mean wind, current and drift.\n\n",
                   "fairleads, hang-offs, azimuths of the SCRs and all depths inside the hull are not in the paper; "
                   "the README of the case lists what was assumed.")


def figure_4(everything, window):
    rows = [("weather", "channel", "paper's axis", "step 0.5 s", "rms of the difference to 1.0 s", "% of std")]
    for heading, hours in everything.items():
        for channel in ("surge", "heave", "pitch"):
            both = common_samples(hours.get("coupled"), hours.get("step_1s"), channel, window)
            if both is None:
                continue
            q, difference = PAPER[channel], rms(*both)
            rows.append((f"{heading}°", f"{q.name}, {q.unit}", f"{q.axis[0]:g} to {q.axis[1]:g}", spread(both[0]),
                         f"{difference:.2g}", f"{100 * difference / both[0].std():.2g}"))
    return section(4, "platform steps of 0.5 and 1.0 s",
                   "two curves in each of surge, heave and pitch, and says that there is no difference between them.",
                   table(*rows),
                   "in the claim they do not: the curves cannot be told apart. The levels are those of Figure 5.")


def figure_5(everything, window):
    rows = [("weather", "channel", "paper's axis", "coupled", "quasi-static lines", "rms difference, % of std")]
    for heading, hours in everything.items():
        for channel in ("surge", "sway", "heave", "roll", "pitch", "yaw"):
            q = PAPER[channel]
            both = common_samples(hours.get("coupled"), hours.get("quasi_static"), channel, window)
            if both is None:
                inside = hours["coupled"].inside(window)
                cells = (spread(hours["coupled"].series(channel)[inside]), "-", "-")
            else:
                share = f"{100 * rms(*both) / both[0].std():.0f}" if both[0].std() > 0.005 else "-"
                cells = (spread(both[0]), spread(both[1]), share)
            rows.append((f"{heading}°", f"{q.name}, {q.unit}", f"{q.axis[0]:g} to {q.axis[1]:g}", *cells))
    return section(5, "coupled against quasi-static lines",
                   "six motions; heave differs little between the two, all others plainly.", table(*rows), MOTIONS)


def figure_6(everything, window):
    rows = [("weather", "paper's axis, kN", "both points together, kN", "upper point, kN", "lower point, kN",
             "time in contact, %")]
    for heading, hours in everything.items():
        hour = hours["coupled"]
        forces = hour.keel_forces()
        inside = hour.inside(window)
        upper, lower = (force[inside] for force in forces)
        rows.append((f"{heading}°", "0 to 600", spread(upper + lower), spread(upper), spread(lower),
                     f"{100 * np.mean(upper + lower > 0):.0f}"))
    return section(6, "contact force at the keel joint, TTR 1",
                   "one curve that is never negative, so a magnitude, on an axis of 0 to 600 kN.", table(*rows), KEEL)


def figure_7(everything, window):
    rows = [("weather", "paper's axis, kN", "coupled, kN", "quasi-static lines, kN", "range, kN", "range, quasi-static, kN")]
    for heading, hours in everything.items():
        a, b = common_samples(hours["coupled"], hours["quasi_static"], "top_tension", window)
        rows.append((f"{heading}°", "600 to 1800", spread(a), spread(b), f"{np.ptp(a):.0f}", f"{np.ptp(b):.0f}"))
    return section(7, "top tension of mooring line 1",
                   "the dynamic line beside the quasi-static one.", table(*rows), TENSION)


def figure_8(everything, window):
    rows = [("weather", "paper's axis, MPa", "greatest, MPa", "at arc length, m", "at time, s",
             "greatest of the mean, MPa", "at arc length, m")]
    for heading, hours in everything.items():
        stress = hours["coupled"].stress(window)
        greatest, arc = stress.greatest
        rows.append((f"{heading}°", "0 to 150", f"{greatest:.1f}", f"{arc:.0f}", f"{stress.t_max:g}",
                     f"{stress.mean.max():.1f}", f"{stress.arc[int(stress.mean.argmax())]:.0f}"))
    return section(8, "von Mises stress around the touch-down zone, oil export SCR",
                   "one curve over 1000 to 1900 m of arc length on an axis of 0 to 150 MPa; whether it is of one "
                   "moment or an envelope is not said.", table(*rows), STRESS)
