#include "io/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "io/cylinder_options.hpp"

namespace hawser::io {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 2 wrong command line; 3 input not valid; 4 no static equilibrium;\n"
    "5 simulation diverged; 6 input or output failure; 7 stopped early; 1 anything else (a bug).";

/// What the options are read into before it is known that all is well.
struct Options {
    std::string case_file, out, output_file, duration, seed, offset, free;
    double heading = 0.0;
    std::vector<std::string> sets;
    CylinderOptions cylinder;
    HydroOptions hydro;
};

void add_case(CLI::App& command, Options& options) {
    command.add_option("case", options.case_file, "Case file (YAML)")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--set", options.sets,
                    "Change one key, repeatable: --set environment.waves[0].Hs=\"12 m\"")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_run(CLI::App& app, Options& options, CommandLine& line) {
    CLI::App& run = *app.add_subcommand(
        "run",
        "Simulate a case. Alone, one process does everything; under mpirun rank 0 is the platform "
        "and the other ranks are the lines. Stop it with Ctrl-C, or with a file named STOP in its "
        "folder.");
    add_case(run, options);
    run.add_option("--out", options.out, "Folder of the run (default: runs/<name of the case>)")
        ->type_name("DIR");
    run.add_flag("--force", line.force,
                 "Replace an earlier result in that folder; only files of a run are deleted");
    run.add_option("--duration", options.duration,
                   "Simulated time, e.g. \"600 s\": sets analysis.dynamics.duration")
        ->type_name("TIME");
    run.add_option("--seed", options.seed, "Seed of the waves: sets environment.waves[0].seed")
        ->type_name("N");
    run.add_flag(
        "--dry-run", line.dry_run,
        "Say which rank would do what, and how much memory and disk it takes; run nothing");
    static const std::map<std::string, ProgressStyle> styles{{"auto", ProgressStyle::automatic},
                                                             {"bar", ProgressStyle::bar},
                                                             {"lines", ProgressStyle::lines},
                                                             {"none", ProgressStyle::none}};
    run.add_option("--progress", line.progress,
                   "auto: a bar alone, lines under mpirun (default); bar; lines; none")
        ->type_name("STYLE")
        ->transform(CLI::CheckedTransformer(styles, CLI::ignore_case).description(""));
    run.add_flag("-q,--quiet", line.quiet, "Only errors, no progress and no summary");
    run.callback([&line] { line.command = CommandLine::Command::run; });
    run.footer(exit_codes);
}

void add_statics(CLI::App& app, Options& options, CommandLine& line) {
    CLI::App& statics = *app.add_subcommand(
        "statics",
        "Find the equilibrium that starts a run: where the platform rests, its stiffness and "
        "stability, tensions and angles of every line. With --offset also the restoring curve.");
    add_case(statics, options);
    CLI::Option* offset =
        statics
            .add_option("--offset", options.offset,
                        "Restoring curve: bring the platform to these offsets, FROM:TO:STEP or a "
                        "list of metres, in still water")
            ->type_name("0:60:5");
    statics
        .add_option(
            "--free", options.free,
            "What settles at each offset, the rest is held as designed: some of transverse, "
            "heave, roll, pitch, yaw; all; none (default heave; with --lines none)")
        ->type_name("LIST")
        ->needs(offset);
    statics
        .add_option("--heading", options.heading,
                    "Direction of the offsets, counter-clockwise from +x (default 0)")
        ->type_name("DEG")
        ->needs(offset);
    statics
        .add_option("--platform", line.statics.platform,
                    "Of several platforms the one that is moved (default the first)")
        ->type_name("NAME")
        ->needs(offset);
    statics
        .add_option("--lines", line.statics.lines,
                    "Lines that the curve sums, e.g. \"ml*\" (default all)")
        ->type_name("GLOB")
        ->needs(offset);
    statics
        .add_option("--without", line.without,
                    "Lines that are gone, e.g. ml3: the damaged condition. A mass of auto stays "
                    "that of all lines")
        ->type_name("GLOB");
    statics.add_flag("--json", line.json, "Print everything as JSON: SI, angles in degrees");
    statics
        .add_option("-o,--output", options.output_file,
                    "Write CSV to this file: the curve, or without --offset one row per line")
        ->type_name("FILE");
    statics.callback([&line] { line.command = CommandLine::Command::statics; });
    statics.footer(
        "Exit codes: 0 found; 3 not valid; 4 no static equilibrium; 2 wrong command "
        "line; 6 input or output failure.");
}

void add_modes(CLI::App& app, Options& options, CommandLine& line) {
    CLI::App& modes = *app.add_subcommand(
        "modes",
        "Natural periods and shapes about the equilibrium that starts a run, undamped: of every "
        "line with its ends held, and of the platform with its lines and their inertia.");
    add_case(modes, options);
    modes
        .add_option("--count", line.modes.count,
                    "Modes of each line, the lowest (default analysis.modes.count)")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    modes.add_option("--line", line.modes.lines, "Lines to look at, e.g. \"scr*\" (default all)")
        ->type_name("GLOB");
    modes.add_flag("--json", line.json, "Print everything as JSON, shapes too");
    modes.add_option("-o,--output", options.output_file, "Write periods and kinds as CSV")
        ->type_name("FILE");
    modes.callback([&line] { line.command = CommandLine::Command::modes; });
    modes.footer(
        "Exit codes: 0 found; 3 not valid; 4 no static equilibrium; 2 wrong command line; "
        "6 input or output failure.");
}

/// The files of a set, and what they do not tell.
void add_set(CLI::App& command, HydroOptions& o) {
    command
        .add_option(
            "files", o.files,
            "The files of a WAMIT or HAMS set or the name they share; a .nc of Capytaine; a "
            ".h5 of BEMIO; the folder of NEMOH")
        ->required()
        ->type_name("FILES");
    const auto add = [&](const char* name, std::string& value, const char* type, const char* text) {
        command.add_option(name, value, text)->type_name(type);
    };
    add("--format", o.format, "NAME",
        "wamit, hams, capytaine, nemoh or bemio (default: by the names)");
    add("--rho", o.rho, "KG/M3", "Density of the water (default: the files', else 1025)");
    add("--g", o.g, "M/S2", "Gravity (default: the files', else 9.80665)");
    add("--ulen", o.ulen, "M", "WAMIT's ULEN (default 1)");
    add("--depth", o.depth, "M", "Depth of the water, or infinite");
    add("--volume", o.volume, "M3", "Displaced volume, where the files do not tell");
    add("--centre-of-buoyancy", o.centre_of_buoyancy, "X,Y,Z", "Its centre, with --volume");
    add("--mass", o.mass, "KG", "Of the platform, for its metacentric height");
    add("--cog", o.cog, "Z", "Its centre of gravity, with --mass");
    command.add_flag("--includes-weight", o.includes_weight,
                     "The stiffness of the files contains -m g z_G of that mass");
    add("--period-column", o.period_column, "NAME",
        "First column: period, frequency, deep_wavenumber, wavenumber, auto");
    add("--limits", o.limits, "NAME", "Which end is which limit: wamit or reversed");
    add("--symmetry", o.symmetry, "PLANES",
        "Of the hull, which mirror the headings: xz, yz or xz,yz");
    add("--reference-point", o.reference_point, "X,Y,Z",
        "Origin of the files on the platform's axes");
    add("--phase-origin", o.phase_origin, "X,Y",
        "Where that point stood in the axes of the phases");
    add("--body", o.body, "N", "Which of several bodies");
}

void add_hydro_files(CLI::App& hydro, Options& options, CommandLine& line) {
    CLI::App& info = *hydro.add_subcommand(
        "info",
        "What a set of hydrodynamic data holds, and whether it can be right: symmetry, positive "
        "damping, Haskind's and Ogilvie's relations, long waves, drift, limits.");
    add_set(info, options.hydro);
    info.add_flag("--json", line.json, "Print everything as JSON, for scripts/plot_hydro");
    info.callback([&line] { line.command = CommandLine::Command::hydro_info; });
    info.footer(
        "Exit codes: 0 nothing is wrong; 3 cannot be read, or a check says wrong; 2 wrong command "
        "line.");

    CLI::App& convert = *hydro.add_subcommand(
        "convert",
        "Write a set as WAMIT files STEM.1 .3 .hst and so on with ULEN 1, and as BEMIO's STEM.h5, "
        "about the reference point and without weight.");
    add_set(convert, options.hydro);
    convert.add_option("-o,--output", options.out, "Where to write")->type_name("STEM")->required();
    convert.add_flag("-q,--quiet", line.quiet, "Only errors and warnings");
    convert.callback([&line] { line.command = CommandLine::Command::hydro_convert; });
    convert.footer(
        "Exit codes: 0 written; 3 cannot be read; 2 wrong command line; 6 output failure.");
}

/// `hydro` has commands of its own, for data that no case is needed for.
void add_hydro(CLI::App& app, Options& options, CommandLine& line) {
    CLI::App& hydro = *app.add_subcommand("hydro", "Hydrodynamic coefficients without a case.");
    hydro.require_subcommand(1);
    CLI::App& cylinder = *hydro.add_subcommand(
        "cylinder",
        "Radiation, excitation, mean drift and hydrostatics of vertical cylinders on one axis, by "
        "linear potential flow, as a set of WAMIT files STEM.1 .3 .8 .hst with ULEN 1 about the "
        "waterline, without weight.");
    CylinderOptions& o = options.cylinder;
    const auto add = [&](const char* name, std::string& value, const char* type, const char* text) {
        cylinder.add_option(name, value, text)->type_name(type);
    };
    add("--depth", o.depth, "M", "Water depth");
    cylinder.add_option("--part", o.parts, "Radius, top and bottom of a solid part; repeatable")
        ->type_name("R,TOP,BOTTOM")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add("--frequencies", o.frequencies, "FROM:TO:STEP", "Or a list with commas, rad/s");
    add("--headings", o.headings, "FROM:TO:STEP", "Or a list, degrees (default 0)");
    add("--out", o.out, "STEM", "Where to write");
    add("--rho", o.rho, "KG/M3", "Water density (default 1025)");
    add("--g", o.g, "M/S2", "Gravity (default 9.80665)");
    add("--mass", o.mass, "KG",
        "The drift is that of the free hull with this mass; else it is fixed");
    add("--cog", o.cog, "Z", "Centre of gravity, with --mass");
    add("--gyration", o.gyration, "M", "Radius of roll and pitch about it, with --mass");
    add("--heave-added-mass", o.heave_added_mass, "KG",
        "Of heave plates, in the free hull's heave");
    add("--heave-damping", o.heave_damping, "FRACTION", "Of critical, in the free hull's heave");
    add("--tolerance", o.tolerance, "PART", "Relative truncation error (default 2e-4)");
    cylinder.add_flag("-q,--quiet", line.quiet, "Only errors");
    cylinder.callback([&line] { line.command = CommandLine::Command::hydro_cylinder; });
    cylinder.footer("Exit codes: 0 written; 2 wrong command line; 6 output failure.");
    add_hydro_files(hydro, options, line);
}

/// "from:to:step" or "a,b,c"; false if it is neither.
bool read_offsets(const std::string& text, std::vector<double>& out) {
    std::vector<double> numbers;
    const char separator = text.find(':') != std::string::npos ? ':' : ',';
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, separator);) {
        std::size_t used = 0;
        try {
            numbers.push_back(std::stod(word, &used));
        } catch (const std::exception&) {
            return false;
        }
        if (used != word.size() || !std::isfinite(numbers.back())) return false;
    }
    if (separator == ',') {
        out = numbers;
        return !numbers.empty();
    }
    if (numbers.size() != 3 || numbers[2] == 0.0) return false;
    const double n = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-9);
    if (!(n >= 0.0 && n <= 1000.0)) return false;
    for (int i = 0; i <= static_cast<int>(n); ++i) out.push_back(numbers[0] + i * numbers[2]);
    return true;
}

/// "heave,pitch", "all", "none"; false if a word is none of the motions.
bool read_free(const std::string& text, std::optional<FreeMotions>& to) {
    FreeMotions& out = to.emplace(FreeMotions{.heave = false});
    if (text == "none") return true;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const bool all = word == "all";
        bool known = all;
        for (auto& [name, motion] : {std::pair("transverse", &out.transverse),
                                     {"heave", &out.heave},
                                     {"roll", &out.roll},
                                     {"pitch", &out.pitch},
                                     {"yaw", &out.yaw}})
            if (all || word == name) *motion = known = true;
        if (!known) return false;
    }
    return out.any();
}

void add_others(CLI::App& app, Options& options, CommandLine& line) {
    CLI::App& check = *app.add_subcommand(
        "check",
        "Check a case without running it: every key, unit and name, geometry, data files and "
        "physical sense. All problems in one go, each with file, line and column.");
    add_case(check, options);
    check.add_flag("--echo", line.echo,
                   "Print the resolved case: one file with every default filled in");
    check.add_flag("--json", line.json, "Print the problems as JSON");
    check.add_flag("--statics", line.with_statics,
                   "Solve the statics of every line and the platform too, and print a summary");
    check.callback([&line] { line.command = CommandLine::Command::check; });
    check.footer(
        "Exit codes: 0 valid; 3 not valid; 4 no static equilibrium; 2 wrong command line; 6 no "
        "such file.");

    CLI::App& schema = *app.add_subcommand(
        "schema", "Print the JSON Schema of case files, for editors that complete and check keys.");
    schema.add_flag("--reference", line.reference,
                    "Print the reference case instead: every key with its meaning and default");
    schema.add_option("-o,--output", options.output_file, "Write to this file")->type_name("FILE");
    schema.callback([&line] { line.command = CommandLine::Command::schema; });

    CLI::App& version = *app.add_subcommand("version", "Print program, build and libraries.");
    version.callback([&line] { line.command = CommandLine::Command::version; });
}

/// "path=value", cut at the first "=".
bool add_override(const std::string& text, CommandLine& line) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return false;
    line.overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    return true;
}

std::string whole_text(int argc, const char* const* argv) {
    std::string text = "hawser";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool quote = word.empty() || word.find_first_of(" \"'*[]${}") != std::string::npos;
        text += quote ? fmt::format(" '{}'", word) : " " + word;
    }
    return text;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
    CommandLine line;
    Options options;
    line.text = whole_text(argc, argv);
    CLI::App app{
        "Hawser: coupled time-domain simulation of a moored floating platform with its mooring "
        "lines and risers.",
        "hawser"};
    app.require_subcommand(1);
    app.footer(std::string("hawser COMMAND --help tells the options of each.\n") + exit_codes);
    add_run(app, options, line);
    add_statics(app, options, line);
    add_modes(app, options, line);
    add_hydro(app, options, line);
    add_others(app, options, line);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, err;
        const int code = app.exit(error, out, err);
        line.finished = code == 0 ? ExitCode::done : ExitCode::command_line;
        line.message = code == 0 ? out.str() : err.str();
        const std::string first = argc > 1 ? argv[1] : "";
        if (code != 0 && !first.empty() && first[0] != '-' && app.get_subcommands().empty()) {
            line.message = fmt::format(
                "unknown command \"{}\"; the commands are run, check, statics, modes, hydro, "
                "schema, "
                "version\n",
                first);
        }
        return line;
    }
    if (line.command == CommandLine::Command::hydro_cylinder) {
        std::vector<std::string> problems;
        line.cylinder = cylinder_request(options.cylinder, problems);
        line.out = options.cylinder.out;
        for (const std::string& problem : problems) line.message.append(problem).append("\n");
        if (!problems.empty()) line.finished = ExitCode::command_line;
        return line;
    }
    if (line.command == CommandLine::Command::hydro_info ||
        line.command == CommandLine::Command::hydro_convert) {
        std::vector<std::string> problems;
        line.hydro = hydro_request(options.hydro, problems);
        line.out = options.out;
        for (const std::string& problem : problems) line.message.append(problem).append("\n");
        if (!problems.empty()) line.finished = ExitCode::command_line;
        return line;
    }
    line.case_file = options.case_file;
    line.out = options.out;
    line.output_file = options.output_file;
    for (const std::string& set : options.sets) {
        if (add_override(set, line)) continue;
        line.finished = ExitCode::command_line;
        line.message = fmt::format(
            "--set {}: expected path=value, e.g. --set "
            "environment.waves[0].Hs=\"12 m\"\n",
            set);
        return line;
    }
    line.statics.heading = options.heading * M_PI / 180.0;
    if (!options.offset.empty() && !read_offsets(options.offset, line.statics.offsets)) {
        line.finished = ExitCode::command_line;
        line.message = fmt::format(
            "--offset {}: expected FROM:TO:STEP or a list in metres, e.g. --offset 0:60:5\n",
            options.offset);
        return line;
    }
    if (!options.free.empty() && !read_free(options.free, line.statics.free)) {
        line.finished = ExitCode::command_line;
        line.message = fmt::format(
            "--free {}: expected all, none, or some of transverse, heave, roll, pitch, yaw with "
            "commas between, e.g. --free heave,pitch\n",
            options.free);
        return line;
    }
    if (!options.duration.empty()) {
        line.overrides.emplace_back("analysis.dynamics.duration", options.duration);
    }
    if (!options.seed.empty())
        line.overrides.emplace_back("environment.waves[0].seed", options.seed);
    return line;
}

}  // namespace hawser::io
