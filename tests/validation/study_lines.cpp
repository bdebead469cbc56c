// How end tension and stress depend on mesh and time step: a mooring line, windward and leeward,
// and a steel catenary riser (the cases of rod-numerics' tables 14.2 and 14.3; tests/README.md
// keeps the figures). Run by scripts/validate --studies.
//
//     build/tests/study_lines
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "line_mesh.hpp"
#include "worker/rod_runs.hpp"

namespace {

using namespace hawser;
using namespace hawser::worker;
using namespace hawser::worker::testing;

/// What a run leaves: tension at the top after the ramp, at rest before, and the largest curvature.
struct Run {
    double rest = 0.0, rest_curvature = 0.0, curvature = 0.0;
    Record top;
    bool ok = false;
};

/// Largest |r''| of a rod [1/m] at the two Gauss points of each element where a cubic gives it
/// best.
double curvature(const RodPack<Single>& rod, const Line& line) {
    const LineMesh mesh = mesh_of(line);
    const NodeState<Single>* node = rod.kept().nodes();
    double largest = 0.0;
    for (int e = 0; e < rod.elements(); ++e) {  // from end B
        const auto far = static_cast<std::size_t>(rod.elements() - e);
        const double L = mesh.arc_length[far] - mesh.arc_length[far - 1];
        for (const double x : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
            const auto c = reduced_curvature(x);
            const Vec3 q0 = vec(node[e + 1].r) - vec(node[e].r);
            const Vec3 bend =
                (c[0] * q0 + c[1] * L * vec(node[e].d) + c[2] * L * vec(node[e + 1].d)) / (L * L);
            largest = std::max(largest, bend.norm());
        }
    }
    return largest;
}

/// @param every  pass and sample [s]; the leeward line's tension has spikes of some 0.1 s
Run simulate(Case input, double step, double duration, double every) {
    input.analysis.dynamics.line_step = step;
    input.analysis.dynamics.ramp = 24.0;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    Run out;
    if (!rod.equilibrium({}, false).ok()) return out;
    out.rest = rod.tension_a(0);
    out.rest_curvature = curvature(rod, input.lines[0]);
    out.ok = run(rod, duration, every, [&](double t) {
                 if (t < 24.0) return;
                 out.top.add(t, rod.tension_a(0));
                 out.curvature = std::max(out.curvature, curvature(rod, input.lines[0]));
             }).ok();
    return out;
}

/// Chain 91, polyester 2286, chain 122 m from a fairlead at -100 m to an anchor at -1500 m.
/// @param span  2062 at rest, 2.06 MN; 35 m more: the windward line, 7 MN; 35 m less: the leeward
/// one
Case mooring_line(double span, const Vec3& amplitude, double period, int refine) {
    Case input = standing_line(moving(fixed_at({0, 0, -100}), amplitude, period), span, 1);
    input.environment.seabed.depth = 1500;
    input.lines[0].end_b = anchored_at({span, 0, -1500});
    input.lines[0].sections[0].elements = 2 * refine;
    input.lines[0].sections[1].elements = 16 * refine;
    input.lines[0].sections[2].elements = 2 * refine;
    for (LineType& type : input.line_types) type.damping_ratio = 0.01;
    return input;
}

/// 324 x 20 mm, 2600 m, hang-off 1335 m above the bed, fine about touchdown; pinned at the top.
Case riser(const Vec3& amplitude, double period, int refine) {
    LineType pipe = plain_type(229.2, 2.07e11 * 0.019101, 4.58729e7);
    pipe.displaced_area = M_PI / 4 * 0.324 * 0.324;
    pipe.outer_diameter = pipe.drag_diameter = 0.324;
    pipe.drag_normal = 1.2, pipe.added_mass_normal = 1.0, pipe.damping_ratio = 0.01;
    Case input = one_line(pipe, 2600, 1, moving(fixed_at({0, 0, -165}), amplitude, period),
                          anchored_at({1760, 0, -1500}), 1500);
    input.lines[0].sections = {{.type = 0, .length = 1400, .elements = 5 * refine},
                               {.type = 0, .length = 500, .elements = 15 * refine},
                               {.type = 0, .length = 700, .elements = 5 * refine}};
    return input;
}

struct Subject {
    const char* name;
    Case (*make)(int refine);
    double duration;
};
const Subject subjects[] = {
    {"windward line, 3 m / 15.6 s, heave 0.5 m",
     [](int refine) {
         return mooring_line(2097, {-3, 0, 0.5}, 15.6, refine);
     },
     86.4},
    {"windward line, 5 m / 3 m / 10 s",
     [](int refine) {
         return mooring_line(2097, {-5, 0, 3}, 10, refine);
     },
     84},
    {"leeward line, 6 m / 3 m / 12 s",
     [](int refine) {
         return mooring_line(2027, {-6, 0, 3}, 12, refine);
     },
     84},
    {"riser, 3 m / 15.6 s, heave 0.5 m",
     [](int refine) {
         return riser({-3, 0, 0.5}, 15.6, refine);
     },
     86.4},
    {"riser, 5 m / 4 m / 12 s",
     [](int refine) {
         return riser({-5, 0, 4}, 12, refine);
     },
     84},
};

void mesh_study() {
    fmt::print(
        "Mesh, step 0.02 s: elements; tension at the top at rest, std and max in motion [kN]; "
        "largest bending stress at rest and in motion [MPa]\n");
    for (const Subject& subject : subjects) {
        const bool is_riser = subject.name[0] == 'r';
        fmt::print("| {} |\n", subject.name);
        for (const int refine : {1, 2, 4, 8}) {
            const Case input = subject.make(refine);
            const Run r = simulate(input, 0.02, subject.duration, 0.02);
            if (!r.ok) {
                fmt::print("|   {} | fails |\n", mesh_of(input.lines[0]).elements());
                continue;
            }
            fmt::print("|   {} | {:.3f} | {:.2f} | {:.1f} |", mesh_of(input.lines[0]).elements(),
                       r.rest / 1e3, r.top.deviation() / 1e3, r.top.largest() / 1e3);
            const double stress = 2.07e11 * 0.162 / 1e6;
            if (is_riser)
                fmt::print(" {:.2f} | {:.2f} |", stress * r.rest_curvature, stress * r.curvature);
            fmt::print("\n");
        }
    }
}

void step_study() {
    fmt::print(
        "Time step, against 0.0025 s: error of std [%] / of max [% of max less mean] / rms "
        "difference [% of std]; largest curvature [%]; samples every 0.4 s\n");
    for (const Subject& subject : subjects) {
        const Case input = subject.make(2);
        const Run exact = simulate(input, 0.0025, subject.duration, 0.4);
        fmt::print("| {} |", subject.name);
        for (const double h : {0.02, 0.05, 0.1, 0.2, 0.4}) {
            const Run r = simulate(input, h, subject.duration, 0.4);
            if (!r.ok || !exact.ok) {
                fmt::print(" fails |");
                continue;
            }
            const double std = exact.top.deviation();
            fmt::print(" {:.2f} / {:.2f} / {:.2f}; {:.2f} |", 100 * (r.top.deviation() / std - 1),
                       100 * (r.top.largest() - exact.top.largest()) /
                           (exact.top.largest() - exact.top.mean()),
                       100 * rms_difference(r.top, exact.top) / std,
                       100 * (r.curvature / exact.curvature - 1));
        }
        fmt::print("\n");
    }
}

}  // namespace

int main() {
    mesh_study();
    step_study();
    return 0;
}
