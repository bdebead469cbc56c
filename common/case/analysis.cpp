#include "case/analysis.hpp"

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;

const Table& statics_keys() {
    static const Table table = [] {
        Keys<Statics> k("statics");
        k.words("loads",
                {{"current", &Statics::current},
                 {"wind_mean", &Statics::wind_mean},
                 {"drift_mean", &Statics::drift_mean}},
                "Mean loads in the static solution, on in full from the start; one left out is "
                "ramped")
            .def("[current, wind_mean, drift_mean]");
        k.number(
             "tolerance", &Statics::tolerance, dimension::number,
             "Relative tolerance of the platform's equilibrium; lines are always solved to 1e-9 m")
            .def("1.0e-6")
            .above(0)
            .at_most(0.01);
        k.integer("max_iterations", &Statics::max_iterations,
                  "Limit of Newton iterations for the platform")
            .def("200")
            .at_least(1);
        k.only("start", "catenary", {"file"}, "First guess of the lines' shapes");
        return k.done();
    }();
    return table;
}

const Table& steps_keys() {
    static const Table table = [] {
        Keys<Dynamics> k("steps");
        k.number("platform", &Dynamics::platform_step, dimension::time, "Platform step")
            .def("0.5 s")
            .above(0);
        k.number("lines", &Dynamics::line_step, dimension::time,
                 "Upper bound of the rods' step; each pass of length H is run in "
                 "ceil(H / bound) equal steps")
            .def("0.02 s")
            .above(0);
        k.number("waves", &Dynamics::wave_step, dimension::time,
                 "Interval at which wave kinematics on lines are renewed")
            .def("0.25 s")
            .above(0);
        return k.done();
    }();
    return table;
}

const Table& rod_scheme_keys() {
    static const Table table = [] {
        Keys<RodScheme> k("rod_scheme");
        k.choice("type", &RodScheme::type,
                 std::vector<std::pair<std::string, RodSchemeType>>{
                     {"generalised_alpha", RodSchemeType::generalised_alpha},
                     {"adams_moulton", RodSchemeType::adams_moulton}},
                 "Time integration of the rods; adams_moulton is the paper's, undamped")
            .def("generalised_alpha");
        k.number("spectral_radius", &RodScheme::spectral_radius, dimension::number,
                 "Damping of generalised_alpha at high frequency: 1 none, 0 full")
            .def("0.8")
            .at_least(0)
            .at_most(1);
        return k.done();
    }();
    return table;
}

const Table& coupling_keys() {
    static const Table table = [] {
        Keys<Dynamics> k("coupling");
        k.only("scheme", "paper", {"synchronous", "one_pass"},
               "How platform and rods advance together");
        k.choice(
             "force", &Dynamics::force,
             std::vector<std::pair<std::string, ForceFit>>{
                 {"instantaneous", ForceFit::instantaneous},
                 {"linear_fit", ForceFit::linear_fit},
                 {"quadratic_fit", ForceFit::quadratic_fit},
                 {"impulse_matched", ForceFit::impulse_matched}},
             "Force of a line at the end of a pass: its last value (the paper), a fit over the "
             "pass, or its last value and, spread over the next platform step, what the four "
             "values of a step missed of the line's impulse, so that knocks in guides lose none "
             "(dynamic lines; others return the last value)")
            .def("impulse_matched");
        return k.done();
    }();
    return table;
}

const Table& modes_keys() {
    static const Table table = [] {
        Keys<Analysis> k("modes");
        k.integer("count", &Analysis::modes, "Number of natural periods that `hawser modes` shows")
            .def("20")
            .at_least(1)
            .at_most(1000);
        return k.done();
    }();
    return table;
}

const Table& dynamics_keys() {
    static const Table table = [] {
        Keys<Dynamics> k("dynamics");
        k.number("duration", &Dynamics::duration, dimension::time,
                 "Simulated time, the ramp included")
            .required()
            .above(0)
            .eg("1 h");
        k.number("ramp", &Dynamics::ramp, dimension::time,
                 "Time over which waves, gusts and slow drift grow from nothing")
            .def("100 s")
            .at_least(0);
        k.number("statistics_from", &Dynamics::statistics_from, dimension::time,
                 "Statistics and ledger cover the time from here")
            .follows("max(ramp, min(600 s, duration/2)); half of a run shorter than that")
            .at_least(0)
            .eg("600 s");
        k.group("steps", steps_keys, "Time steps");
        k.number("depth_filter", &Dynamics::depth_filter, dimension::number,
                 "A point on a line sees a wave component down to this many wavelengths; 0: all")
            .def("1")
            .at_least(0);
        k.map("rod_scheme", &Dynamics::rod_scheme, rod_scheme_keys, "Time integration of the rods");
        k.choice("line_model", &Dynamics::line_model, line_model_words(),
                 "How lines respond: rods in motion, the same rods at rest at every stage, or an "
                 "elastic catenary between the ends")
            .def("dynamic")
            .later_words({"linear_spring"});
        k.group("coupling", coupling_keys, "How platform and rods advance together");
        k.later("checkpoint", "Checkpoints");
        return k.done();
    }();
    return table;
}

}  // namespace

const std::vector<std::pair<std::string, LineModel>>& line_model_words() {
    static const std::vector<std::pair<std::string, LineModel>> words{
        {"dynamic", LineModel::dynamic},
        {"quasi_static", LineModel::quasi_static},
        {"catenary", LineModel::catenary}};
    return words;
}

const Table& analysis_keys() {
    static const Table table = [] {
        Keys<Analysis> k("analysis");
        k.map("statics", &Analysis::statics, statics_keys, "The static solution");
        k.map("dynamics", &Analysis::dynamics, dynamics_keys, "The simulation").required();
        k.group("modes", modes_keys, "Natural periods and shapes");
        return k.done();
    }();
    return table;
}

}  // namespace hawser
