// BEMIO's .h5 (WEC-Sim manual, "BEMIO"): one group per body; with scaled = 0 the numbers are over
// rho, rho w and rho g. The time factor is e^{+i w t} whatever program they come from.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/hdf5.hpp"
#include "io/hydro_reading.hpp"
#include "status.hpp"

namespace hawser::io {

namespace {

class BemioSet {
 public:
    explicit BemioSet(Reading& reading)
        : r_(reading), path_(reading.database.path), file_(Hdf5File::open(path_)) {}

    HydroSet read() {
        set_.radiation_file = set_.excitation_file = set_.stiffness_file = path_;
        set_.data.source = "BEMIO " + path_.string();
        set_.files = {path_.string()};
        int bodies = 0;
        while (file_.exists(fmt::format("body{}", bodies + 1))) ++bodies;
        const int wanted = r_.database.body.value_or(1);
        if (wanted > bodies || (bodies > 1 && !r_.database.body))
            r_.problems.add(
                path_, 0,
                fmt::format("holds {} bodies; the key `body` says which one to read", bodies));
        body_ = fmt::format("body{}/", wanted);
        for (const std::string& name :
             {std::string("simulation_parameters/w"), std::string("simulation_parameters/rho"),
              std::string("simulation_parameters/g"), body_ + "hydro_coeffs/added_mass/all",
              body_ + "hydro_coeffs/radiation_damping/all",
              body_ + "hydro_coeffs/linear_restoring_stiffness"})
            if (r_.problems.empty() && !file_.exists(name))
                r_.problems.add(
                    path_, 0, fmt::format("has no dataset \"{}\"; expected a file of BEMIO", name));
        if (!r_.problems.empty()) return std::move(set_);
        if (bodies > 1)
            r_.notes.push_back(
                fmt::format("{}: body {} of {} is read; forces on it from the motion of the others "
                            "are left out",
                            path_.string(), wanted, bodies));
        parameters();
        radiation();
        excitation();
        drift();
        hydrostatics();
        return std::move(set_);
    }

 private:
    [[nodiscard]] double number(const std::string& name, double otherwise) const {
        return file_.exists(name) ? file_.read(name).at(0) : otherwise;
    }

    void parameters() {
        HydroData& data = set_.data;
        const std::string all = "simulation_parameters/";
        w_ = file_.read(all + "w");
        data.density = file_.read(all + "rho").at(0);
        data.gravity = file_.read(all + "g").at(0);
        scaled_ = number(all + "scaled", 0.0) != 0.0;
        if (file_.exists(all + "wave_dir")) headings_ = file_.read(all + "wave_dir");
        if (file_.exists(all + "water_depth")) {
            try {
                data.depth = file_.read(all + "water_depth").at(0);
            } catch (const RunError&) {  // the word "infinite"
                data.depth = std::numeric_limits<double>::infinity();
            }
        }
        data.displaced_volume = number(body_ + "properties/disp_vol", 0.0);
        if (file_.exists(body_ + "properties/cb"))
            if (const auto r = file_.read(body_ + "properties/cb"); r.size() == 3)
                data.centre_of_buoyancy = r_.database.reference_point + Vec3(r[0], r[1], r[2]);
        first_ = static_cast<std::size_t>(number(body_ + "properties/dof_start",
                                                 6.0 * (r_.database.body.value_or(1) - 1) + 1)) -
                 1;
        for (std::size_t i = 0; i < w_.size(); ++i)
            if (w_[i] > 0.0 && std::isfinite(w_[i])) order_.push_back(i);
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t a, std::size_t b) { return w_[a] < w_[b]; });
    }

    /// The body's own 6 x 6 of (dof, all dofs, frequencies).
    [[nodiscard]] Mat6 matrix(const std::vector<double>& values, const Extent& shape,
                              std::size_t f) const {
        Mat6 M = Mat6::Zero();
        const std::size_t columns = shape.at(1), n = shape.size() > 2 ? shape[2] : 1;
        for (std::size_t i = 0; i < 6 && i < shape[0]; ++i)
            for (std::size_t j = 0; j < 6 && first_ + j < columns; ++j)
                M(static_cast<int>(i), static_cast<int>(j)) =
                    values[(i * columns + first_ + j) * n + f];
        return M;
    }

    void radiation() {
        HydroData& data = set_.data;
        const std::string at = body_ + "hydro_coeffs/";
        const auto A = file_.read(at + "added_mass/all"),
                   B = file_.read(at + "radiation_damping/all");
        const Extent shape = file_.dataset(at + "added_mass/all").shape();
        if (shape.size() != 3 || shape[2] != w_.size() ||
            file_.dataset(at + "radiation_damping/all").shape() != shape) {
            r_.problems.add(path_, 0,
                            "added_mass/all and radiation_damping/all are not (6, 6 N, number of "
                            "frequencies)");
            return;
        }
        const double rho = scaled_ ? 1.0 : data.density;
        for (const std::size_t f : order_) {
            if (std::isnan(A[f])) continue;  // a frequency of the drift alone
            data.frequencies.push_back(w_[f]);
            data.added_mass.push_back(rho * matrix(A, shape, f));
            data.damping.push_back((scaled_ ? 1.0 : rho * w_[f]) * matrix(B, shape, f));
        }
        for (const auto& [name, to] :
             {std::pair{"inf_freq", &data.added_mass_inf}, {"zero_freq", &data.added_mass_0}}) {
            const std::string limit = at + "added_mass/" + name;
            if (!file_.exists(limit)) continue;
            const Mat6 M = rho * matrix(file_.read(limit), file_.dataset(limit).shape(), 0);
            if (M.allFinite()) *to = M;
        }
    }

    WaveTable<CVec6> table(const std::string& group) {
        const std::string re = group + "re", im = group + "im";
        if (!file_.exists(re) || !file_.exists(im)) return {};
        const auto x = file_.read(re), y = file_.read(im);
        const Extent shape = file_.dataset(re).shape();
        if (shape.size() != 3 || shape[1] != headings_.size() || shape[2] != w_.size() ||
            y.size() != x.size()) {
            r_.problems.add(path_, 0, group + "re and im are not (6, headings, frequencies)");
            return {};
        }
        const double scale = scaled_ ? 1.0 : set_.data.density * set_.data.gravity;
        std::vector<WaveRow> rows;
        for (const std::size_t f : order_)
            for (std::size_t h = 0; h < shape[1]; ++h)
                for (std::size_t i = 0; i < 6 && i < shape[0]; ++i) {
                    const std::size_t at = (i * shape[1] + h) * shape[2] + f;
                    if (!std::isfinite(x[at]) || !std::isfinite(y[at])) continue;  // not there
                    rows.push_back({0, w_[f], headings_[h], static_cast<int>(i),
                                    scale * Complex(x[at], y[at])});
                }
        return table_of(rows, path_, r_.problems);
    }

    void excitation() {
        const std::string at = body_ + "hydro_coeffs/excitation/";
        set_.data.excitation = table(at);
        set_.data.froude_krylov = table(at + "froude-krylov/");
        set_.data.scattering = table(at + "scattering/");
    }

    void drift() {
        HydroData& data = set_.data;
        for (const auto& [way, method] : {std::pair{"momentum_conservation", DriftMethod::momentum},
                                          {"pressure_integration", DriftMethod::pressure},
                                          {"control_surface", DriftMethod::control_surface}}) {
            const std::string name = fmt::format("{}hydro_coeffs/mean_drift/{}/val", body_, way);
            if (!file_.exists(name)) continue;
            const auto x = file_.read(name);
            const Extent shape = file_.dataset(name).shape();
            if (shape.size() != 3 || shape[1] != headings_.size() || shape[2] != w_.size()) {
                r_.problems.add(path_, 0, name + " is not (6, headings, frequencies)");
                return;
            }
            const double scale = scaled_ ? 1.0 : data.density * data.gravity;
            std::vector<WaveRow> rows;
            for (const std::size_t f : order_)
                for (std::size_t h = 0; h < shape[1]; ++h)
                    for (std::size_t i = 0; i < 6 && i < shape[0]; ++i)
                        if (const double D = x[(i * shape[1] + h) * shape[2] + f]; std::isfinite(D))
                            rows.push_back(
                                {0, w_[f], headings_[h], static_cast<int>(i), scale * D});
            WaveTable<Vec6> table = real_part(table_of(rows, path_, r_.problems));
            if (table.empty()) continue;
            if (!data.mean_drift.empty()) {
                data.other_drift.push_back({method, std::move(table)});
                continue;
            }
            data.mean_drift = std::move(table);
            data.drift_method = method;
            data.drift_is_horizontal = method == DriftMethod::momentum;
        }
    }

    void hydrostatics() {
        const std::vector<double> C = file_.read(body_ + "hydro_coeffs/linear_restoring_stiffness");
        if (C.size() < 36) {
            r_.problems.add(path_, 0, "linear_restoring_stiffness is not 6 x 6");
            return;
        }
        const double scale = scaled_ ? 1.0 : set_.data.density * set_.data.gravity;
        set_.stiffness =
            scale * Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(C.data());
    }

    Reading& r_;
    Path path_;
    Hdf5File file_;
    HydroSet set_;
    std::string body_;
    std::vector<double> w_, headings_;
    std::vector<std::size_t> order_;  ///< places of the finite frequencies, ascending
    std::size_t first_ = 0;           ///< the body's first column in coupled matrices
    bool scaled_ = false;
};

}  // namespace

HydroSet read_bemio_set(Reading& reading) { return BemioSet(reading).read(); }

}  // namespace hawser::io
