#include "io/bemio_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro_relations.hpp"
#include "io/files.hpp"
#include "io/hdf5.hpp"
#include "io/wave_rows.hpp"

namespace hawser::io {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = M_PI / 180.0;
constexpr double same_heading = 1e-6;  // [rad]

/// The grid of all tables: frequencies ascending, headings in the order they come.
struct Grid {
    std::vector<double> frequencies, headings;

    template <class Value>
    void add(const WaveTable<Value>& table) {
        frequencies.insert(frequencies.end(), table.frequencies.begin(), table.frequencies.end());
        for (const auto& h : table.headings)
            if (std::none_of(headings.begin(), headings.end(), [&](double b) {
                    return std::abs(std::remainder(b - h.heading, 2 * M_PI)) < same_heading;
                }))
                headings.push_back(h.heading);
    }
};

class BemioFile {
 public:
    BemioFile(const HydroData& data, const std::filesystem::path& path)
        : d_(data), file_(Hdf5File::create(part_of(path))) {
        grid_.frequencies = data.frequencies;
        for (const auto* table : {&data.excitation, &data.froude_krylov, &data.scattering})
            grid_.add(*table);
        grid_.add(data.mean_drift);
        for (const MeanDrift& other : data.other_drift) grid_.add(other.table);
        grid_.frequencies = distinct_frequencies(grid_.frequencies);
        std::sort(grid_.headings.begin(), grid_.headings.end());
    }

    void write(const std::string& name, double cog) {
        parameters();
        body(name, cog);
        radiation();
        forces("excitation/", d_.excitation);
        forces("excitation/froude-krylov/", d_.froude_krylov);
        forces("excitation/scattering/", d_.scattering);
        drift(d_.drift_method, d_.mean_drift);
        for (const MeanDrift& other : d_.other_drift) drift(other.method, other.table);
        file_.close();
    }

 private:
    void scalar(const std::string& name, double x) {
        file_.write(name, std::vector<double>{x}, {1, 1});
    }

    void parameters() {
        const std::string at = "simulation_parameters/";
        scalar(at + "rho", d_.density);
        scalar(at + "g", d_.gravity);
        scalar(at + "scaled", 0.0);
        if (d_.depth > 0.0 && std::isfinite(d_.depth))
            scalar(at + "water_depth", d_.depth);
        else
            file_.write_text(at + "water_depth", "infinite");
        std::vector<double> periods, headings;
        for (const double w : grid_.frequencies) periods.push_back(2 * M_PI / w);
        for (const double b : grid_.headings) headings.push_back(b / degree);
        file_.write(at + "w", grid_.frequencies, {periods.size(), 1});
        file_.write(at + "T", periods, {periods.size(), 1});
        file_.write(at + "wave_dir", headings, {headings.size(), 1});
    }

    void body(const std::string& name, double cog) {
        const std::string at = "body1/properties/";
        file_.write_text(at + "name", name);
        scalar(at + "body_number", 1);
        scalar(at + "dof", 6);
        scalar(at + "dof_start", 1);
        scalar(at + "dof_end", 6);
        scalar(at + "disp_vol", d_.displaced_volume);
        const Vec3& r = d_.centre_of_buoyancy;
        file_.write(at + "cb", std::vector<double>{r.x(), r.y(), r.z()}, {3, 1});
        file_.write(at + "cg", std::vector<double>{0.0, 0.0, cog}, {3, 1});
        const Mat6 C = d_.buoyancy_stiffness.value_or(Mat6::Zero()) / (d_.density * d_.gravity);
        matrix("linear_restoring_stiffness", C);
    }

    void matrix(const std::string& name, const Mat6& M) {
        std::vector<double> rows;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) rows.push_back(M(i, j));
        file_.write(coefficients_ + name, rows, {6, 6});
    }

    void radiation() {
        std::vector<double> A, B;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                for (const double w : grid_.frequencies) {
                    const auto at = place_of(d_.frequencies, w);
                    A.push_back(at ? d_.added_mass[*at](i, j) / d_.density : nan);
                    B.push_back(at ? d_.damping[*at](i, j) / (d_.density * w) : nan);
                }
        const std::size_t n = grid_.frequencies.size();
        file_.write(coefficients_ + "added_mass/all", A, {6, 6, n});
        file_.write(coefficients_ + "radiation_damping/all", B, {6, 6, n});
        if (d_.added_mass_inf) matrix("added_mass/inf_freq", *d_.added_mass_inf / d_.density);
        if (d_.added_mass_0) matrix("added_mass/zero_freq", *d_.added_mass_0 / d_.density);
    }

    /// Value of a table on the grid, mode by mode: (6, headings, frequencies).
    template <class Value, class Part>
    std::vector<double> spread(const WaveTable<Value>& table, const Part& part) const {
        std::vector<double> all;
        for (int i = 0; i < 6; ++i)
            for (const double b : grid_.headings) {
                const auto h =
                    std::find_if(table.headings.begin(), table.headings.end(), [&](const auto& x) {
                        return std::abs(std::remainder(b - x.heading, 2 * M_PI)) < same_heading;
                    });
                for (const double w : grid_.frequencies) {
                    const auto f = place_of(table.frequencies, w);
                    all.push_back(h != table.headings.end() && f ? part(h->values[*f][i]) : nan);
                }
            }
        return all;
    }
    [[nodiscard]] Extent extent() const {
        return {6, grid_.headings.size(), grid_.frequencies.size()};
    }

    void forces(const std::string& group, const WaveTable<CVec6>& table) {
        if (table.empty()) return;
        const double scale = d_.density * d_.gravity;
        const std::string at = coefficients_ + group;
        file_.write(at + "re", spread(table, [&](Complex x) { return x.real() / scale; }),
                    extent());
        file_.write(at + "im", spread(table, [&](Complex x) { return x.imag() / scale; }),
                    extent());
        file_.write(at + "mag", spread(table, [&](Complex x) { return std::abs(x) / scale; }),
                    extent());
        file_.write(at + "phase", spread(table, [](Complex x) { return std::arg(x); }), extent());
    }

    void drift(DriftMethod method, const WaveTable<Vec6>& table) {
        if (table.empty()) return;
        const char* way = method == DriftMethod::momentum   ? "momentum_conservation"
                          : method == DriftMethod::pressure ? "pressure_integration"
                                                            : "control_surface";
        const double scale = d_.density * d_.gravity;
        file_.write(coefficients_ + "mean_drift/" + way + "/val",
                    spread(table, [&](double x) { return x / scale; }), extent());
    }

    const HydroData& d_;
    Hdf5File file_;
    Grid grid_;
    const std::string coefficients_ = "body1/hydro_coeffs/";
};
}  // namespace

void write_bemio(const HydroData& data, const std::string& name, double cog,
                 const std::filesystem::path& path) {
    BemioFile(data, path).write(name, cog);
    publish(path);
}

}  // namespace hawser::io
