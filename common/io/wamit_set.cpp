// WAMIT numeric files (WAMIT manual, ch. 4 "Output files" and ch. 11 for second order): .1 .2 .3
// .3fk .3sc .4 .7 .8 .9 .10-.12 d/s .hst; .gdf and .frc for checks. HAMS writes the first-order
// ones of them with e^{-i w t}, the limits the other way round, and a first column that its control
// file chooses.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "environment/dispersion.hpp"
#include "io/hydro_reading.hpp"
#include "io/qtf_rows.hpp"

namespace hawser::io {

namespace {

/// The files of one set being read.
class WamitSet {
 public:
    explicit WamitSet(Reading& reading) : r_(reading), hams_(is_hams(reading)) {}

    HydroSet read() {
        radiation();
        excitation();
        set_.data.froude_krylov = waves(".3fk", exciting_force);
        set_.data.scattering = waves(".3sc", exciting_force);
        set_.data.motion = waves(".4", motion);
        drift();
        set_.data.difference = second_order({".12d", ".11d", ".10d"}, true);
        set_.data.sum = second_order({".12s", ".11s", ".10s"}, false);
        hydrostatics();
        if (!hams_ && !r_.database.body) {
            set_.geometry = read_wamit_geometry(r_.file(".gdf"));
            set_.control = read_wamit_control(r_.file(".frc"));
        }
        for (const char* ending : {".1", ".2", ".3", ".3fk", ".3sc", ".4", ".7", ".8", ".9", ".12d",
                                   ".11d", ".10d", ".12s", ".11s", ".10s", ".hst"})
            if (std::filesystem::exists(r_.file(ending)))
                set_.files.push_back(r_.file(ending).string());
        if (set_.geometry) set_.files.push_back(set_.geometry->file.string());
        if (set_.control) set_.files.push_back(set_.control->file.string());
        if (others_)
            r_.notes.push_back(
                fmt::format("{}: body {} of several is read; forces on it from the motion of the "
                            "others are left out",
                            r_.database.path, *r_.database.body));
        return std::move(set_);
    }

 private:
    /// What makes the number of a file dimensional, by mode 0 .. 5.
    using Scale = std::function<double(const WamitSet&, int)>;

    static bool is_hams(const Reading& r) { return r.database.format == HydroFormat::hams; }
    [[nodiscard]] double density() const { return r_.database.rho.value_or(0.0); }
    static double exciting_force(const WamitSet& s, int i) {
        return s.density() * s.r_.gravity * s.r_.power_of_length(2 + rotation_of(i));
    }
    static double second_order_force(const WamitSet& s, int i) {
        return s.density() * s.r_.gravity * s.r_.power_of_length(1 + rotation_of(i));
    }
    static double motion(const WamitSet& s, int i) { return s.r_.power_of_length(-rotation_of(i)); }

    [[nodiscard]] Complex turned(Complex x) const { return hams_ ? std::conj(x) : x; }

    [[nodiscard]] PeriodColumn column() const {
        return r_.database.period_column.value_or(PeriodColumn::period);
    }

    /// w of a positive first column.
    [[nodiscard]] double frequency(double per) const {
        const double g = r_.gravity, K = per / r_.database.ulen;
        switch (column()) {
            case PeriodColumn::frequency:
                return per;
            case PeriodColumn::deep_wavenumber:
                return std::sqrt(g * K);
            case PeriodColumn::wavenumber:
                return std::sqrt(g * K * (std::isfinite(r_.depth) ? std::tanh(K * r_.depth) : 1.0));
            default:
                return 2.0 * M_PI / per;
        }
    }

    double frequency_of(double per, const Path& file, int line) {
        if (per > 0.0) return frequency(per);
        r_.problems.add(file, line, fmt::format("expected a period above zero; got {:g}", per));
        return 0.0;
    }

    // A mode number of the file as 0 .. 5 of the body that is read; -1 for another body, and with a
    // problem for anything else.
    int mode_of(double number, const Path& file, int line) {
        const int mode = static_cast<int>(number);
        if (mode == number && mode >= 1) {
            const int body = (mode - 1) / 6 + 1;
            if (body == r_.database.body.value_or(1)) return (mode - 1) % 6;
            others_ = r_.database.body.has_value();
            if (!others_)
                r_.problems.add(file, line,
                                fmt::format("mode {} belongs to a second body; the key `body` says "
                                            "which one to read",
                                            mode));
            return -1;
        }
        r_.problems.add(file, line, fmt::format("expected a mode 1 to 6; got {:g}", number));
        return -1;
    }

    /// Which limit a row of a .1 is: -1 zero, +1 infinite frequency, 0 none. Adds a problem if
    /// nothing says how to tell.
    int limit_of(double per, const Path& file, int line) {
        if (per > 0.0) return 0;
        std::optional<HydroLimits> limits = r_.database.limits;
        if (!limits && hams_) limits = HydroLimits::reversed;
        if (!limits && column() == PeriodColumn::period) limits = HydroLimits::wamit;
        if (!limits) {
            if (!limits_told_)
                r_.problems.add(
                    file, line,
                    fmt::format("{:g} is a limit, but with frequencies or wavenumbers in this "
                                "column programs differ in which; expected the key `limits`: wamit "
                                "(negative is zero frequency) or reversed; or, if the column holds "
                                "periods, period_column: period",
                                per));
            limits_told_ = true;
            return -1;
        }
        const int of_wamit = per < 0.0 ? -1 : 1;
        return *limits == HydroLimits::wamit ? of_wamit : -of_wamit;
    }

    /// .1: PER I J A B; the limits without B. A: rho L^k, B: rho w L^k.
    void radiation() {
        const Path file = r_.file(".1");
        HydroData& data = set_.data;
        set_.radiation_file = file;
        const std::vector<Record> records = read_records(file, 4, r_.problems);
        for (const Record& record : records)
            if (record.numbers[0] > 0.0) data.frequencies.push_back(frequency(record.numbers[0]));
        data.frequencies = distinct_frequencies(std::move(data.frequencies));
        std::vector<GatheredMatrix> A(data.frequencies.size()), B(data.frequencies.size());
        std::optional<GatheredMatrix> zero, infinite;
        for (const Record& record : records) {
            const int i = mode_of(record.numbers[1], file, record.line);
            const int j = mode_of(record.numbers[2], file, record.line);
            if (i < 0 || j < 0) continue;
            const double scale =
                density() * r_.power_of_length(3 + rotation_of(i) + rotation_of(j));
            const double per = record.numbers[0], added = scale * record.numbers[3];
            if (const int limit = limit_of(per, file, record.line); limit != 0) {
                std::optional<GatheredMatrix>& to = limit < 0 ? zero : infinite;
                if (!to) to.emplace();
                to->set(i, j, added);
            } else if (record.numbers.size() < 5) {
                r_.problems.add(file, record.line, "expected 5 numbers, PER I J A B; got 4");
            } else {
                const double w = frequency(per);
                const std::size_t at = place_of_frequency(data.frequencies, w);
                if (i == j) set_.radiation_rows.push_back({w, i, record.line});
                A[at].set(i, j, added);
                B[at].set(i, j, scale * w * record.numbers[4]);
            }
        }
        if (!records.empty() && data.frequencies.empty())
            r_.problems.add(file, 0, "holds no finite period");
        for (std::size_t f = 0; f < A.size(); ++f) {
            data.added_mass.push_back(A[f].filled());
            data.damping.push_back(B[f].filled());
        }
        if (zero) data.added_mass_0 = zero->filled();
        if (infinite) data.added_mass_inf = infinite->filled();
    }

    /// A file of PER BETA I mod phase Re Im; empty if there is none.
    WaveTable<CVec6> waves(const char* extension, const Scale& scale) {
        const Path file = r_.file(extension);
        if (!std::filesystem::exists(file)) return {};
        std::vector<WaveRow> rows;
        for (const Record& record : read_records(file, 7, r_.problems)) {
            const auto& x = record.numbers;
            const int i = mode_of(x[2], file, record.line);
            const double w = frequency_of(x[0], file, record.line);
            if (i < 0 || w <= 0.0) continue;
            rows.push_back({record.line, w, x[1], i, scale(*this, i) * turned({x[5], x[6]})});
        }
        if (std::string(extension) == ".3" || std::string(extension) == ".2") {
            periods(rows, file);
            set_.excitation_rows.clear();
            for (const WaveRow& row : rows)
                set_.excitation_rows.push_back({row.frequency, row.mode, row.line});
        }
        return table_of(rows, file, r_.problems);
    }

    /// Every period of the excitation must be one of the .1.
    void periods(const std::vector<WaveRow>& rows, const Path& file) {
        std::vector<double> strange;
        for (const WaveRow& row : rows) {
            const auto same = [&](double w) { return same_frequency(w, row.frequency); };
            const auto& known = set_.data.frequencies;
            if (std::any_of(known.begin(), known.end(), same) ||
                std::any_of(strange.begin(), strange.end(), same))
                continue;
            strange.push_back(row.frequency);
            r_.problems.add(
                file, row.line,
                fmt::format("period {:.6g} s has excitation but no added mass and "
                            "damping in {}",
                            2 * M_PI / row.frequency, set_.radiation_file.filename().string()));
        }
    }

    /// .3, else .2 (Haskind); in still water neither is needed.
    void excitation() {
        set_.data.haskind = waves(".2", exciting_force);
        const std::vector<RowPlace> of_haskind = set_.excitation_rows;
        set_.data.excitation = waves(".3", exciting_force);
        set_.excitation_file = r_.file(".3");
        if (std::filesystem::exists(set_.excitation_file) || set_.data.haskind.empty()) return;
        set_.excitation_file = r_.file(".2");
        set_.excitation_rows = of_haskind;
        std::swap(set_.data.excitation, set_.data.haskind);
        r_.notes.push_back(fmt::format("{}: excitation is taken from it, there is no .3",
                                       set_.excitation_file.string()));
    }

    /// .8, .9, .7: PER BETA1 BETA2 I mod phase Re Im, rows with BETA1 = BETA2. The first of them
    /// that is there acts, the others are for comparison.
    void drift() {
        HydroData& data = set_.data;
        for (const auto& [extension, method] : {std::pair{".8", DriftMethod::momentum},
                                                {".9", DriftMethod::pressure},
                                                {".7", DriftMethod::control_surface}}) {
            const Path file = r_.file(extension);
            if (!std::filesystem::exists(file)) continue;
            std::vector<WaveRow> rows;
            for (const Record& record : read_records(file, 8, r_.problems)) {
                const auto& x = record.numbers;
                if (x[3] < 0.0 || std::remainder(x[1] - x[2], 360.0) != 0.0) continue;
                const int i = mode_of(x[3], file, record.line);
                const double w = frequency_of(x[0], file, record.line);
                if (i < 0 || w <= 0.0) continue;
                rows.push_back({record.line, w, x[1], i, second_order_force(*this, i) * x[6]});
            }
            WaveTable<Vec6> table = real_part(table_of(rows, file, r_.problems));
            if (!data.mean_drift.empty()) {
                data.other_drift.push_back({method, std::move(table)});
                continue;
            }
            data.mean_drift = std::move(table);
            set_.drift_file = file;
            data.drift_method = method;
            data.drift_is_horizontal = method == DriftMethod::momentum;
            if (data.drift_is_horizontal)
                r_.notes.push_back(
                    fmt::format("{}: from momentum, so the mean drift of heave, roll and pitch is "
                                "zero",
                                file.string()));
        }
    }

    /// The first of the files that is there: PER1 PER2 BETA1 BETA2 I mod phase Re Im.
    Qtf second_order(std::initializer_list<const char*> extensions, bool difference) {
        for (const char* extension : extensions) {
            const Path file = r_.file(extension);
            if (!std::filesystem::exists(file)) continue;
            if (set_.second_order_file.empty()) set_.second_order_file = file;
            std::vector<QtfRow> rows;
            for (const Record& record : read_records(file, 9, r_.problems)) {
                const auto& x = record.numbers;
                const int i = mode_of(x[4], file, record.line);
                const double w1 = frequency_of(x[0], file, record.line);
                const double w2 = frequency_of(x[1], file, record.line);
                if (i < 0 || w1 <= 0.0 || w2 <= 0.0) continue;
                rows.push_back(
                    {w1, w2, x[2], x[3], i, second_order_force(*this, i) * turned({x[7], x[8]})});
            }
            return qtf_of(rows, difference);
        }
        return {};
    }

    /// .hst: I J C.
    void hydrostatics() {
        const Path file = r_.file(".hst");
        set_.stiffness_file = file;
        GatheredMatrix C;
        const std::vector<Record> records = read_records(file, 3, r_.problems);
        for (const Record& record : records) {
            const int i = mode_of(record.numbers[0], file, record.line);
            const int j = mode_of(record.numbers[1], file, record.line);
            if (i < 0 || j < 0) continue;
            C.set(i, j,
                  density() * r_.gravity * r_.power_of_length(2 + rotation_of(i) + rotation_of(j)) *
                      record.numbers[2]);
        }
        if (!records.empty()) set_.stiffness = C.filled();
    }

    Reading& r_;
    bool hams_;
    bool limits_told_ = false;
    bool others_ = false;  ///< other bodies were met and may be left out
    HydroSet set_;
};

}  // namespace

HydroSet read_wamit_set(Reading& reading) {
    HydroSet set = WamitSet(reading).read();
    set.data.source =
        fmt::format("{} {}", reading.database.format == HydroFormat::hams ? "HAMS" : "WAMIT",
                    reading.database.path);
    return set;
}

}  // namespace hawser::io
