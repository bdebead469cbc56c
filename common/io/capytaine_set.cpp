// Capytaine's NetCDF-4 (Capytaine manual, "Exporting outputs" and "Conventions"): dimensional SI,
// dimensions and degrees of freedom by name, directions in radians, e^{-i w t}.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "io/hdf5.hpp"
#include "io/hydro_reading.hpp"
#include "motion_names.hpp"

namespace hawser::io {

namespace {

/// A variable with the names of its dimensions. An index of a dimension that it does not have is of
/// no account.
class Variable {
 public:
    Variable() = default;
    Variable(const Hdf5File& file, const std::string& name)
        : values_(file.read(name)),
          shape_(file.dataset(name).shape()),
          dims_(file.dimensions(name)) {
        dims_.resize(shape_.size());
    }
    using Index = std::map<std::string, std::size_t>;
    [[nodiscard]] double at(const Index& index) const {
        std::size_t flat = 0;
        for (std::size_t d = 0; d < dims_.size(); ++d) {
            const auto i = index.find(dims_[d]);
            flat = flat * shape_[d] + (i == index.end() ? 0 : i->second);
        }
        return values_[flat];
    }
    [[nodiscard]] bool has(const std::string& dimension) const {
        return std::find(dims_.begin(), dims_.end(), dimension) != dims_.end();
    }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    [[nodiscard]] std::string dimension() const { return dims_.empty() ? "" : dims_[0]; }

 private:
    std::vector<double> values_;
    Extent shape_;
    std::vector<std::string> dims_;
};

class CapytaineSet {
 public:
    explicit CapytaineSet(Reading& reading)
        : r_(reading), path_(reading.database.path), file_(Hdf5File::open(path_)) {}

    HydroSet read() {
        set_.radiation_file = set_.excitation_file = set_.stiffness_file = path_;
        set_.data.source = "Capytaine " + path_.string();
        set_.files = {path_.string()};
        for (const char* name : {"omega", "radiating_dof", "influenced_dof", "added_mass",
                                 "radiation_damping", "rho", "g"})
            if (!file_.exists(name))
                r_.problems.add(path_, 0,
                                fmt::format("has no variable \"{}\"; expected a NetCDF-4 dataset "
                                            "of Capytaine",
                                            name));
        if (!r_.problems.empty()) return std::move(set_);
        HydroData& data = set_.data;
        data.density = file_.read("rho").at(0);
        data.gravity = file_.read("g").at(0);
        if (file_.exists("water_depth")) data.depth = file_.read("water_depth").at(0);
        omega_ = Variable(file_, "omega");
        along_ = omega_.dimension();
        influenced_ = modes("influenced_dof");
        radiating_ = modes("radiating_dof");
        if (!r_.problems.empty()) return std::move(set_);
        radiation();
        if (file_.exists("wave_direction")) excitation();
        hydrostatics();
        return std::move(set_);
    }

 private:
    /// Place of each mode along a dimension of degrees of freedom. They are called "Heave", or
    /// "buoy__Heave" where there are several bodies.
    std::vector<std::optional<std::size_t>> modes(const std::string& dimension) {
        std::vector<std::optional<std::size_t>> places(6);
        const std::vector<std::string> names = file_.read_texts(dimension);
        std::vector<std::string> bodies;
        const auto split = [](const std::string& name) {
            const std::size_t cut = name.rfind("__");
            return cut == std::string::npos ? std::pair(std::string(), name)
                                            : std::pair(name.substr(0, cut), name.substr(cut + 2));
        };
        for (const std::string& name : names)
            if (const std::string body = split(name).first;
                std::find(bodies.begin(), bodies.end(), body) == bodies.end())
                bodies.push_back(body);
        const auto wanted = static_cast<std::size_t>(r_.database.body.value_or(1));
        if (wanted > bodies.size() || (bodies.size() > 1 && !r_.database.body)) {
            r_.problems.add(path_, 0,
                            fmt::format("holds {} {} ({}); the key `body` says which one to read",
                                        bodies.size(), bodies.size() == 1 ? "body" : "bodies",
                                        fmt::join(bodies, ", ")));
            return places;
        }
        if (bodies.size() > 1 && dimension == "influenced_dof")
            r_.notes.push_back(
                fmt::format("{}: body {} ({}) of {} is read; forces on it from the motion of the "
                            "others are left out",
                            path_.string(), wanted, bodies[wanted - 1], bodies.size()));
        for (std::size_t i = 0; i < names.size(); ++i) {
            auto [body, mode] = split(names[i]);
            if (body != bodies[wanted - 1]) continue;
            std::transform(mode.begin(), mode.end(), mode.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            const auto known = std::find(motion_names.begin(), motion_names.end(), mode);
            if (known == motion_names.end())
                r_.notes.push_back(
                    fmt::format("{}: degree of freedom \"{}\" is none of the six "
                                "motions and left out",
                                path_.string(), names[i]));
            else
                places[static_cast<std::size_t>(known - motion_names.begin())] = i;
        }
        return places;
    }

    /// Frequencies with their place along omega, ascending; the limits 0 and infinity apart.
    std::vector<std::pair<double, std::size_t>> frequencies() const {
        std::vector<std::pair<double, std::size_t>> all;
        for (std::size_t i = 0; i < omega_.values().size(); ++i)
            if (const double w = omega_.values()[i]; w > 0.0 && std::isfinite(w))
                all.emplace_back(w, i);
        std::sort(all.begin(), all.end());
        return all;
    }

    [[nodiscard]] Mat6 matrix(const Variable& v, std::size_t at) const {
        Mat6 M = Mat6::Zero();
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                if (influenced_[i] && radiating_[j])
                    M(static_cast<int>(i), static_cast<int>(j)) =
                        v.at({{along_, at},
                              {"influenced_dof", *influenced_[i]},
                              {"radiating_dof", *radiating_[j]}});
        return M;
    }

    void radiation() {
        const Variable A(file_, "added_mass"), B(file_, "radiation_damping");
        if (!A.has("influenced_dof") || !A.has("radiating_dof")) {
            r_.problems.add(path_, 0,
                            "added_mass has no named dimensions; expected a NetCDF-4 dataset of "
                            "Capytaine");
            return;
        }
        for (const auto& [w, at] : frequencies()) {
            set_.data.frequencies.push_back(w);
            set_.data.added_mass.push_back(matrix(A, at));
            set_.data.damping.push_back(matrix(B, at));
        }
        for (std::size_t i = 0; i < omega_.values().size(); ++i) {
            if (omega_.values()[i] == 0.0) set_.data.added_mass_0 = matrix(A, i);
            if (std::isinf(omega_.values()[i])) set_.data.added_mass_inf = matrix(A, i);
        }
        if (set_.data.frequencies.empty()) r_.problems.add(path_, 0, "holds no finite frequency");
    }

    /// A table of forces; the imaginary part changes its sign with the convention of time.
    WaveTable<CVec6> table(const std::string& name) {
        const Variable X(file_, name);
        if (!X.has("complex")) {
            r_.problems.add(path_, 0,
                            name +
                                " has no dimension \"complex\"; expected real and imaginary "
                                "parts apart, as separate_complex_values leaves them");
            return {};
        }
        const std::vector<std::string> part = file_.read_texts("complex");
        const std::size_t re = part.at(0) == "re" ? 0 : 1, im = 1 - re;
        const std::vector<double> directions = file_.read("wave_direction");
        std::vector<WaveRow> rows;
        for (const auto& [w, at] : frequencies())
            for (std::size_t b = 0; b < directions.size(); ++b)
                for (std::size_t i = 0; i < 6; ++i) {
                    Variable::Index index{{along_, at}, {"wave_direction", b}};
                    Complex value = 0.0;
                    if (influenced_[i]) {
                        index["influenced_dof"] = *influenced_[i];
                        index["complex"] = re;
                        const double real = X.at(index);
                        index["complex"] = im;
                        value = {real, -X.at(index)};
                    }
                    rows.push_back({0, w, directions[b] * 180 / M_PI, static_cast<int>(i), value});
                }
        return table_of(rows, path_, r_.problems);
    }

    void excitation() {
        HydroData& data = set_.data;
        const bool parts = file_.exists("diffraction_force") && file_.exists("Froude_Krylov_force");
        if (parts) {
            data.scattering = table("diffraction_force");
            data.froude_krylov = table("Froude_Krylov_force");
        }
        if (file_.exists("excitation_force")) {
            data.excitation = table("excitation_force");
        } else if (parts) {
            data.excitation = data.froude_krylov;
            for (std::size_t h = 0; h < data.excitation.headings.size(); ++h)
                for (std::size_t f = 0; f < data.excitation.frequencies.size(); ++f)
                    data.excitation.headings[h].values[f] += data.scattering.headings[h].values[f];
        }
    }

    void hydrostatics() {
        HydroData& data = set_.data;
        if (file_.exists("hydrostatic_stiffness"))
            set_.stiffness = matrix(Variable(file_, "hydrostatic_stiffness"), 0);
        else
            r_.problems.add(path_, 0,
                            "has no hydrostatic_stiffness; expected a dataset made with "
                            "hydrostatics");
        for (const char* name : {"displaced_volume", "disp_volume"})
            if (file_.exists(name)) data.displaced_volume = file_.read(name).at(0);
        if (file_.exists("center_of_buoyancy"))
            if (const std::vector<double> r = file_.read("center_of_buoyancy"); r.size() == 3)
                data.centre_of_buoyancy = r_.database.reference_point + Vec3(r[0], r[1], r[2]);
        if (data.displaced_volume == 0.0 && !r_.database.displaced_volume)
            r_.problems.add(path_, 0,
                            "does not tell the displaced volume; expected the keys "
                            "displaced_volume and centre_of_buoyancy");
    }

    Reading& r_;
    Path path_;
    Hdf5File file_;
    HydroSet set_;
    Variable omega_;
    std::string along_;  ///< the dimension of omega: omega, or period
    std::vector<std::optional<std::size_t>> influenced_, radiating_;
};

}  // namespace

HydroSet read_capytaine_set(Reading& reading) { return CapytaineSet(reading).read(); }

}  // namespace hawser::io
