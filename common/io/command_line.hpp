// The command line. The only user of CLI11.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hydro/cylinder_data.hpp"
#include "io/hydro_options.hpp"
#include "modes_report.hpp"
#include "roles.hpp"
#include "statics_report.hpp"
#include "status.hpp"

namespace hawser::io {

struct CommandLine {
    enum class Command {
        none,
        run,
        check,
        statics,
        modes,
        hydro_cylinder,
        hydro_info,
        hydro_convert,
        schema,
        version
    };
    Command command = Command::none;

    std::filesystem::path case_file;  ///< run, check, statics, modes
    std::vector<std::pair<std::string, std::string>>
        overrides;  ///< --set, --duration, --seed: key path and value, in this order

    std::filesystem::path out;  ///< run: empty, so the default folder
    bool force = false;
    bool dry_run = false;
    ProgressStyle progress = ProgressStyle::automatic;
    bool quiet = false;

    bool echo = false;                  ///< check
    bool with_statics = false;          ///< check
    bool json = false;                  ///< check, statics, modes
    StaticsRequest statics;             ///< statics: the restoring curve
    std::string without;                ///< statics: lines that are gone; empty: none
    ModesRequest modes;                 ///< modes
    bool reference = false;             ///< schema
    std::filesystem::path output_file;  ///< schema: empty, so standard output; statics, modes: CSV

    hydro::CylinderRequest cylinder;  ///< hydro cylinder; `out` is the stem of its files
    HydroRequest hydro;               ///< hydro info, convert; `out` likewise

    std::string text;  ///< the whole command, for the result's attributes

    /// Set if there is nothing to run: help was asked for, or the command line is wrong. `message`
    /// then goes to standard output (ExitCode::done) or standard error.
    std::optional<ExitCode> finished;
    std::string message;
};

CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace hawser::io
