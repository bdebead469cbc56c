#include "io/hydro_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "io/bemio_output.hpp"
#include "io/hydro_info.hpp"
#include "io/wamit_output.hpp"

namespace hawser::io {

namespace {
namespace fs = std::filesystem;

CheckedHydro read(const HydroRequest& request) {
    return read_checked_hydro(request.database, request.water, request.depth);
}

bool any_wrong(const CheckedHydro& found) {
    return std::any_of(found.checks.begin(), found.checks.end(), [](const PlacedCheck& c) {
        return c.check.verdict == HydroCheck::Verdict::wrong;
    });
}
}  // namespace

int hydro_info_command(const HydroRequest& request, bool json) {
    const CheckedHydro found = read(request);
    std::fputs(
        (json ? hydro_json(request, found).text() + "\n" : hydro_text(request, found)).c_str(),
        stdout);
    return static_cast<int>(any_wrong(found) ? ExitCode::input : ExitCode::done);
}

int hydro_convert_command(const HydroRequest& request, const std::string& stem, bool quiet) {
    const fs::path folder = fs::path(stem).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw RunError(ExitCode::io, fmt::format("{}: there is no such folder", folder.string()));
    const CheckedHydro found = read(request);
    for (const std::string& file : found.files) {
        fs::path own = file;
        const fs::path same = fs::weakly_canonical(own.replace_extension(), ignored);
        if (same == fs::weakly_canonical(stem, ignored))
            throw RunError(ExitCode::command_line,
                           fmt::format("{}: is one of the files to read; expected another name "
                                       "after -o",
                                       file));
    }
    const HydroData& data = found.data;
    std::vector<fs::path> files = write_wamit(data, data.gravity, stem);
    files.emplace_back(stem + ".h5");
    write_bemio(data, fs::path(stem).filename().string(), request.cog, files.back());
    for (const auto& [check, file, line] : found.checks)
        if (check.verdict == HydroCheck::Verdict::doubtful ||
            check.verdict == HydroCheck::Verdict::wrong)
            fmt::print(stderr, "{}: {}: {}\n",
                       check.verdict == HydroCheck::Verdict::wrong ? "error" : "warning",
                       line > 0 ? fmt::format("{}:{}", file, line) : file, check.sentence);
    if (quiet) return static_cast<int>(ExitCode::done);
    std::string names;
    for (const fs::path& file : files) names.append(" ").append(file.string());
    fmt::print("from {}:{}\n", data.source, names);
    fmt::print("rho {:g} kg/m3, ULEN 1 m, about the reference point, without weight\n",
               data.density);
    if (!data.motion.empty() || !data.difference.empty() || !data.sum.empty())
        fmt::print("free motions and quadratic transfer functions are in the WAMIT files alone\n");
    if (data.depth == 0.0)
        fmt::print("the depth of the water is not known (--depth): {}.h5 says infinite\n", stem);
    return static_cast<int>(ExitCode::done);
}

}  // namespace hawser::io
