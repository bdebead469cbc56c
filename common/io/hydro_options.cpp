#include "io/hydro_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include "io/option_numbers.hpp"

namespace hawser::io {

namespace {
namespace fs = std::filesystem;
using Problems = std::vector<std::string>;

template <class Value>
using Words = std::vector<std::pair<const char*, Value>>;
const Words<HydroFormat> formats{{"wamit", HydroFormat::wamit},
                                 {"hams", HydroFormat::hams},
                                 {"capytaine", HydroFormat::capytaine},
                                 {"nemoh", HydroFormat::nemoh},
                                 {"bemio", HydroFormat::bemio}};
const Words<PeriodColumn> columns{{"period", PeriodColumn::period},
                                  {"frequency", PeriodColumn::frequency},
                                  {"deep_wavenumber", PeriodColumn::deep_wavenumber},
                                  {"wavenumber", PeriodColumn::wavenumber},
                                  {"auto", PeriodColumn::automatic}};
const Words<HydroLimits> limit_words{{"wamit", HydroLimits::wamit},
                                     {"reversed", HydroLimits::reversed}};

template <class Value>
std::optional<Value> chosen(const char* name, const std::string& text, const Words<Value>& words,
                            Problems& problems) {
    if (text.empty()) return std::nullopt;
    std::string all;
    for (const auto& [word, value] : words) {
        if (text == word) return value;
        all += (all.empty() ? "" : ", ") + std::string(word);
    }
    problems.push_back(fmt::format("{} {}: expected one of {}", name, text, all));
    return std::nullopt;
}

std::optional<double> read(const char* name, const std::string& text, double above,
                           Problems& problems) {
    if (text.empty()) return std::nullopt;
    const std::optional<double> x = number_of(text);
    if (x && *x > above) return x;
    problems.push_back(
        above > -1e300
            ? fmt::format("{}: expected a number above {:g}; got \"{}\"", name, above, text)
            : fmt::format("{}: expected a number; got \"{}\"", name, text));
    return std::nullopt;
}

std::vector<double> read_vector(const char* name, const std::string& text, std::size_t n,
                                Problems& problems) {
    if (text.empty()) return {};
    const auto x = numbers_of(text, ',');
    if (x && x->size() == n) return *x;
    problems.push_back(
        fmt::format("{}: expected {} numbers with commas; got \"{}\"", name, n, text));
    return {};
}

bool is_ending_of_wamit(const fs::path& file) {
    static const std::vector<std::string> endings{
        ".1",   ".2",   ".3",   ".3fk", ".3sc", ".4",   ".7",   ".8",   ".9",   ".10d", ".11d",
        ".12d", ".10s", ".11s", ".12s", ".hst", ".gdf", ".out", ".frc", ".pot", ".cfg"};
    const std::string ending = file.extension().string();
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// A folder of HAMS or NEMOH as the file, stem or folder that its reader takes.
void look_into_folder(const fs::path& folder, HydroRequest& request,
                      std::optional<HydroFormat>& format, Problems& problems) {
    for (const char* at : {"", "Output/Wamit_format", "Wamit_format"}) {
        const fs::path place = folder / at;
        if (!fs::is_directory(place) || format == HydroFormat::nemoh) continue;
        for (const auto& entry : fs::directory_iterator(place))
            if (entry.path().extension() == ".1") {
                request.database.path = (place / entry.path().stem()).string();
                if (!format)
                    format =
                        place.filename() == "Wamit_format" ? HydroFormat::hams : HydroFormat::wamit;
                return;
            }
    }
    for (const char* name : {"RadiationCoefficients.tec", "results/RadiationCoefficients.tec",
                             "Results/RadiationCoefficients.tec"})
        if (fs::exists(folder / name)) {
            request.database.path = folder.string();
            if (!format) format = HydroFormat::nemoh;
            return;
        }
    problems.push_back(
        fmt::format("{}: holds neither a .1 nor RadiationCoefficients.tec", folder.string()));
}

void find_files(const HydroOptions& o, HydroRequest& request, std::optional<HydroFormat>& format,
                Problems& problems) {
    const fs::path first = o.files.front();
    if (fs::is_directory(first) && o.files.size() == 1) {
        look_into_folder(first, request, format, problems);
        return;
    }
    request.database.path = first.string();
    if (is_ending_of_wamit(first)) {
        fs::path stem = first;
        request.database.path = stem.replace_extension().string();
        if (first.extension() == ".out" && !fs::exists(stem.string() + ".1"))
            problems.push_back(
                fmt::format("{}: WAMIT's listing is not read; expected the numeric files of the "
                            "run, {}.1, .3, .hst",
                            first.string(), stem.filename().string()));
        for (const std::string& other : o.files)
            if (fs::path(other).replace_extension() != stem && is_ending_of_wamit(other))
                problems.push_back(
                    fmt::format("{} and {}: expected the files of one set, with one "
                                "name before their endings",
                                first.string(), other));
    } else if (o.files.size() > 1) {
        problems.push_back(fmt::format(
            "{}: expected one file, folder or stem, or the files of one WAMIT set", o.files[1]));
    } else if (!fs::exists(first) && !fs::exists(first.string() + ".1")) {
        problems.push_back(
            fmt::format("{}: there is no such file, nor {}.1", first.string(), first.string()));
    }
    if (format) return;
    const std::string ending = first.extension().string();
    const bool of_hams = first.parent_path().filename() == "Wamit_format";
    format = ending == ".nc"                        ? HydroFormat::capytaine
             : ending == ".h5" || ending == ".hdf5" ? HydroFormat::bemio
             : of_hams                              ? HydroFormat::hams
                                                    : HydroFormat::wamit;
}
}  // namespace

HydroRequest hydro_request(const HydroOptions& o, Problems& problems) {
    HydroRequest request;
    HydroDatabase& d = request.database;
    std::optional<HydroFormat> format = chosen("--format", o.format, formats, problems);
    if (o.files.empty()) {
        problems.emplace_back("expected the files of a set, or the name they share");
        return request;
    }
    find_files(o, request, format, problems);
    d.format = format.value_or(HydroFormat::wamit);
    const bool by_stem = d.format == HydroFormat::wamit || d.format == HydroFormat::hams;

    constexpr double any = -std::numeric_limits<double>::infinity();
    request.water.gravity = read("--g", o.g, 0.0, problems).value_or(request.water.gravity);
    d.rho = read("--rho", o.rho, 0.0, problems);
    if (!d.rho && by_stem) {
        d.rho = request.water.density;
        request.assumed.push_back(fmt::format("--rho {:g} kg/m3", *d.rho));
    }
    request.water.density = d.rho.value_or(request.water.density);
    d.ulen = read("--ulen", o.ulen, 0.0, problems).value_or(1.0);
    if (by_stem && o.ulen.empty()) request.assumed.emplace_back("--ulen 1 m");
    d.displaced_volume = read("--volume", o.volume, 0.0, problems);
    if (const auto r = read_vector("--centre-of-buoyancy", o.centre_of_buoyancy, 3, problems);
        !r.empty())
        d.centre_of_buoyancy = Vec3(r[0], r[1], r[2]);
    if (by_stem && d.displaced_volume && !d.centre_of_buoyancy)
        problems.emplace_back("--centre-of-buoyancy: expected with --volume, X,Y,Z in m");
    if (o.depth == "infinite")
        request.depth = std::numeric_limits<double>::infinity();
    else
        request.depth = read("--depth", o.depth, 0.0, problems).value_or(0.0);
    if (const auto body = read("--body", o.body, 0.5, problems)) d.body = static_cast<int>(*body);
    d.period_column = chosen("--period-column", o.period_column, columns, problems);
    if (d.format == HydroFormat::hams && !d.period_column) {
        d.period_column = PeriodColumn::automatic;
        request.assumed.emplace_back("--period-column auto");
    }
    d.limits = chosen("--limits", o.limits, limit_words, problems);
    std::istringstream planes(o.symmetry);
    for (std::string plane; std::getline(planes, plane, ',');) {
        if (plane != "xz" && plane != "yz")
            problems.push_back(fmt::format("--symmetry {}: expected xz, yz or xz,yz", o.symmetry));
        d.symmetry.push_back(plane);
    }
    if (const auto r = read_vector("--reference-point", o.reference_point, 3, problems); !r.empty())
        d.reference_point = Vec3(r[0], r[1], r[2]);
    d.phase_origin = read_vector("--phase-origin", o.phase_origin, 2, problems);

    request.mass = read("--mass", o.mass, 0.0, problems);
    const auto cog = read("--cog", o.cog, any, problems);
    if (request.mass.has_value() != cog.has_value())
        problems.emplace_back("--mass and --cog: expected both or none");
    request.cog = cog.value_or(0.0);
    d.includes_weight = o.includes_weight;
    if (o.includes_weight && !request.mass)
        problems.emplace_back("--includes-weight: expected --mass and --cog of the weight");
    if (o.includes_weight) {
        d.included_mass = request.mass.value_or(0.0);
        d.included_z = request.cog - d.reference_point.z();
    }
    return request;
}

}  // namespace hawser::io
