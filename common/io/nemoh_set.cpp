// A folder of NEMOH (manual, "Input/Output"): Nemoh.cal, Results/RadiationCoefficients.tec,
// Results/ExcitationForce.tec, Mesh/KH.dat, Mesh/Hydrostatics.dat. Dimensional SI; forces as
// magnitude and phase of e^{-i w t}.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "io/hydro_reading.hpp"

namespace hawser::io {

namespace {

struct Line {
    int number = 0;
    std::string text;
};

/// Numbers at the beginning of a line, up to the first word.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> all;
    std::istringstream in(text);
    for (double x = 0.0; in >> x;) all.push_back(x);
    return all;
}

class NemohSet {
 public:
    explicit NemohSet(Reading& reading) : r_(reading), folder_(reading.database.path) {}

    HydroSet read() {
        set_.data.source = "NEMOH " + folder_.string();
        set_.radiation_file = file("RadiationCoefficients.tec", {"results", "Results"});
        set_.excitation_file = file("ExcitationForce.tec", {"results", "Results"});
        set_.stiffness_file = file("KH.dat", {"mesh", "Mesh"}, true);
        calculation();
        radiation();
        excitation();
        hydrostatics();
        for (const Path& path : {set_.radiation_file, set_.excitation_file, set_.stiffness_file})
            if (std::filesystem::exists(path)) set_.files.push_back(path.string());
        return std::move(set_);
    }

 private:
    /// The file in the folder itself or in one of these; of several bodies NAME_0, NAME_1 ...
    [[nodiscard]] Path file(const std::string& name, std::initializer_list<const char*> folders,
                            bool per_body = false) const {
        std::vector<std::string> names{name};
        if (per_body)
            names.push_back(fmt::format("{}_{}{}", Path(name).stem().string(),
                                        r_.database.body.value_or(1) - 1,
                                        Path(name).extension().string()));
        for (const std::string& n : names) {
            if (std::filesystem::exists(folder_ / n)) return folder_ / n;
            for (const char* f : folders)
                if (std::filesystem::exists(folder_ / f / n)) return folder_ / f / n;
        }
        return folder_ / name;
    }

    std::vector<Line> lines(const Path& path, const char* what) {
        std::vector<Line> all;
        std::ifstream in(path);
        if (!in) r_.problems.add(path, 0, fmt::format("cannot be read; expected {}", what));
        std::string text;
        for (int n = 1; std::getline(in, text); ++n) all.push_back({n, text});
        return all;
    }

    /// Nemoh.cal: a value and what it is, a line each, in the order of the manual.
    void calculation() {
        const Path path = file("Nemoh.cal", {});
        if (!std::filesystem::exists(path)) {
            if (!r_.database.rho)
                r_.problems.add(path, 0, "is not there; expected it, or the key rho");
            return;
        }
        std::vector<double> environment;  // rho, g, depth
        for (const Line& line : lines(path, "NEMOH's calculation file")) {
            const std::vector<double> x = numbers_of(line.text);
            if (x.empty() || line.text.find("---") == 0) continue;
            environment.push_back(x[0]);
            if (environment.size() == 5) bodies_ = static_cast<int>(x[0]);
            if (environment.size() == 5) break;  // after XEFF YEFF the number of bodies
        }
        if (environment.size() < 3) {
            r_.problems.add(path, 0, "expected density, gravity and depth in its first lines");
            return;
        }
        set_.data.density = environment[0];
        set_.data.gravity = environment[1];
        set_.data.depth =
            environment[2] > 0.0 ? environment[2] : std::numeric_limits<double>::infinity();
        if (bodies_ > 1 && !r_.database.body)
            r_.problems.add(path, 0,
                            fmt::format("there are {} bodies; the key `body` says which one to "
                                        "read",
                                        bodies_));
    }

    /// What the first column of a .tec is, from its VARIABLES line: w, f or T.
    static char column_of(const std::string& variables) {
        if (variables.find("Hz") != std::string::npos) return 'f';
        if (variables.find("T (s)") != std::string::npos ||
            variables.find("T(s)") != std::string::npos)
            return 'T';
        return 'w';
    }
    static double frequency(char column, double x) {
        return column == 'f' ? 2 * M_PI * x : column == 'T' ? 2 * M_PI / x : x;
    }

    /// Rows that follow each line beginning with Zone.
    struct Zone {
        Line head;
        std::vector<std::pair<int, std::vector<double>>> rows;
    };
    std::vector<Zone> zones(const Path& path, const char* what, char& column) {
        std::vector<Zone> all;
        for (Line& line : lines(path, what)) {
            std::string start = line.text.substr(0, 4);
            std::transform(start.begin(), start.end(), start.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            if (start == "vari") column = column_of(line.text);
            if (start == "zone") {
                all.push_back({std::move(line), {}});
                continue;
            }
            const std::vector<double> x = numbers_of(line.text);
            if (!x.empty() && !all.empty()) all.back().rows.emplace_back(line.number, x);
        }
        return all;
    }

    /// One zone per motion j: frequency, then A_ji and B_ji for every force i.
    void radiation() {
        char column = 'w';
        const Path& path = set_.radiation_file;
        const std::vector<Zone> all = zones(path, "NEMOH's radiation coefficients", column);
        if (all.empty() || all.size() % 6 != 0) {
            if (std::filesystem::exists(path))
                r_.problems.add(path, 0,
                                fmt::format("has {} zones; expected one for each of six motions of "
                                            "every body",
                                            all.size()));
            return;
        }
        const auto first = static_cast<std::size_t>(6 * (r_.database.body.value_or(1) - 1));
        if (all.size() > 6 && !r_.database.body) {
            r_.problems.add(path, 0,
                            fmt::format("there are {} bodies; the key `body` says which one to "
                                        "read",
                                        all.size() / 6));
            return;
        }
        if (first + 6 > all.size()) {
            r_.problems.add(path, 0, fmt::format("has {} bodies", all.size() / 6));
            return;
        }
        if (all.size() > 6)
            r_.notes.push_back(
                fmt::format("{}: body {} of {} is read; forces on it from the motion of the others "
                            "are left out",
                            path.string(), first / 6 + 1, all.size() / 6));
        HydroData& data = set_.data;
        for (const auto& [line, x] : all[first].rows)
            data.frequencies.push_back(frequency(column, x[0]));
        data.frequencies = distinct_frequencies(std::move(data.frequencies));
        data.added_mass.assign(data.frequencies.size(), Mat6::Zero());
        data.damping = data.added_mass;
        for (std::size_t j = 0; j < 6; ++j)
            for (const auto& [line, x] : all[first + j].rows) {
                if (x.size() < 2 * all.size() + 1) {
                    r_.problems.add(
                        path, line,
                        fmt::format("expected {} numbers; got {}", 2 * all.size() + 1, x.size()));
                    continue;
                }
                const std::size_t f = place_of_frequency(data.frequencies, frequency(column, x[0]));
                if (f >= data.frequencies.size()) continue;
                set_.radiation_rows.push_back({data.frequencies[f], static_cast<int>(j), line});
                for (std::size_t i = 0; i < 6; ++i) {
                    const std::size_t at = 1 + 2 * (first + i);
                    data.added_mass[f](static_cast<int>(i), static_cast<int>(j)) = x[at];
                    data.damping[f](static_cast<int>(i), static_cast<int>(j)) = x[at + 1];
                }
            }
    }

    /// One zone per heading, named in its head: frequency, then magnitude and phase of every force.
    void excitation() {
        const Path& path = set_.excitation_file;
        if (!std::filesystem::exists(path)) return;
        char column = 'w';
        const auto first = static_cast<std::size_t>(6 * (r_.database.body.value_or(1) - 1));
        std::vector<WaveRow> rows;
        for (const Zone& zone : zones(path, "NEMOH's excitation", column)) {
            const std::size_t at = zone.head.text.find("beta =");
            const std::vector<double> beta = at == std::string::npos
                                                 ? std::vector<double>{}
                                                 : numbers_of(zone.head.text.substr(at + 6));
            if (beta.empty()) {
                r_.problems.add(path, zone.head.number,
                                "expected a zone whose title says \"beta = ... deg\"");
                continue;
            }
            for (const auto& [line, x] : zone.rows) {
                if (x.size() < 1 + 2 * (first + 6)) {
                    r_.problems.add(
                        path, line,
                        fmt::format("expected {} numbers; got {}", 1 + 2 * (first + 6), x.size()));
                    continue;
                }
                for (std::size_t i = 0; i < 6; ++i) {
                    const double size = x[1 + 2 * (first + i)], phase = x[2 + 2 * (first + i)];
                    rows.push_back({line, frequency(column, x[0]), beta[0], static_cast<int>(i),
                                    std::polar(size, -phase)});
                    set_.excitation_rows.push_back(
                        {rows.back().frequency, static_cast<int>(i), line});
                }
            }
        }
        set_.data.excitation = table_of(rows, path, r_.problems);
    }

    /// KH.dat: 6 x 6. Hydrostatics.dat: "XF = x - XG = y", three of them, then the volume.
    void hydrostatics() {
        const Path& path = set_.stiffness_file;
        Mat6 C = Mat6::Zero();
        int row = 0;
        for (const Line& line : lines(path, "NEMOH's hydrostatic stiffness")) {
            const std::vector<double> x = numbers_of(line.text);
            if (x.size() < 6 || row >= 6) continue;
            for (int j = 0; j < 6; ++j) C(row, j) = x[static_cast<std::size_t>(j)];
            ++row;
        }
        if (row == 6)
            set_.stiffness = C;
        else if (std::filesystem::exists(path))
            r_.problems.add(path, 0, fmt::format("expected 6 rows of 6 numbers; got {}", row));

        const Path about = file("Hydrostatics.dat", {"mesh", "Mesh"}, true);
        if (!std::filesystem::exists(about)) {
            if (!r_.database.displaced_volume)
                r_.problems.add(about, 0,
                                "is not there; expected it, or the keys displaced_volume and "
                                "centre_of_buoyancy");
            return;
        }
        Vec3 r_B = Vec3::Zero();
        int axis = 0;
        for (const Line& line : lines(about, "NEMOH's hydrostatics")) {
            const std::size_t at = line.text.find('=');
            if (at == std::string::npos) continue;
            const std::vector<double> x = numbers_of(line.text.substr(at + 1));
            if (x.empty()) continue;
            if (axis < 3)
                r_B[axis] = x[0];
            else if (axis == 3)
                set_.data.displaced_volume = x[0];
            ++axis;
        }
        if (axis < 4) r_.problems.add(about, 0, "expected XF, YF, ZF and the displacement");
        set_.data.centre_of_buoyancy = r_.database.reference_point + r_B;
    }

    Reading& r_;
    Path folder_;
    HydroSet set_;
    int bodies_ = 1;
};

}  // namespace

HydroSet read_nemoh_set(Reading& reading) { return NemohSet(reading).read(); }

}  // namespace hawser::io
