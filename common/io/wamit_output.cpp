#include "io/wamit_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/files.hpp"

namespace hawser::io {
namespace {

using Text = fmt::memory_buffer;

template <class... Values>
void put(Text& text, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

void put_complex(Text& text, Complex x) {
    x += 0.0;  // no negative zeros
    put(text, " {:16.9e} {:16.9e} {:16.9e} {:16.9e}\n", std::abs(x), std::arg(x) * 180.0 / M_PI,
        x.real(), x.imag());
}

std::string radiation(const HydroData& data) {
    Text text;
    const auto limit = [&](double period, const Mat6& A) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (A(i, j) != 0.0)
                    put(text, " {:16.9e} {:5} {:5} {:16.9e}\n", period, i + 1, j + 1,
                        A(i, j) / data.density);
    };
    if (data.added_mass_0) limit(-1.0, *data.added_mass_0);
    if (data.added_mass_inf) limit(0.0, *data.added_mass_inf);
    for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
        const double w = data.frequencies[f];
        const Mat6 &A = data.added_mass[f], &B = data.damping[f];
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (A(i, j) != 0.0 || B(i, j) != 0.0)
                    put(text, " {:16.9e} {:5} {:5} {:16.9e} {:16.9e}\n", 2.0 * M_PI / w, i + 1,
                        j + 1, A(i, j) / data.density, B(i, j) / (data.density * w));
    }
    return fmt::to_string(text);
}

/// PER BETA I mod phase Re Im, the numbers over `scale`.
std::string waves(const WaveTable<CVec6>& table, double scale) {
    Text text;
    for (std::size_t f = 0; f < table.frequencies.size(); ++f)
        for (const auto& h : table.headings)
            for (int i = 0; i < 6; ++i) {
                put(text, " {:16.9e} {:16.9e} {:5}", 2.0 * M_PI / table.frequencies[f],
                    h.heading * 180.0 / M_PI, i + 1);
                put_complex(text, h.values[f][i] / scale);
            }
    return fmt::to_string(text);
}

/// PER BETA BETA I mod phase Re Im; momentum gives surge, sway and yaw alone.
std::string drift(const WaveTable<Vec6>& table, bool horizontal, double rho_g) {
    Text text;
    for (std::size_t f = 0; f < table.frequencies.size(); ++f)
        for (const auto& h : table.headings)
            for (int i = 0; i < 6; ++i) {
                if (horizontal && i >= 2 && i <= 4) continue;
                const double degrees = h.heading * 180.0 / M_PI;
                put(text, " {:16.9e} {:16.9e} {:16.9e} {:5}", 2.0 * M_PI / table.frequencies[f],
                    degrees, degrees, i + 1);
                put_complex(text, h.values[f][i] / rho_g);
            }
    return fmt::to_string(text);
}

/// PER1 PER2 BETA1 BETA2 I mod phase Re Im, where there are values.
std::string second_order(const Qtf& qtf, double rho_g) {
    Text text;
    const std::size_t N = qtf.frequencies.size();
    for (const QtfPair& p : qtf.pairs)
        for (std::size_t m = 0; m < N; ++m)
            for (std::size_t n = 0; n < N; ++n) {
                if (p.given[m * N + n] == 0) continue;
                for (int i = 0; i < 6; ++i) {
                    put(text, " {:16.9e} {:16.9e} {:16.9e} {:16.9e} {:5}",
                        2.0 * M_PI / qtf.frequencies[m], 2.0 * M_PI / qtf.frequencies[n],
                        p.heading_1 * 180.0 / M_PI, p.heading_2 * 180.0 / M_PI, i + 1);
                    put_complex(text, p.values[m * N + n][i] / rho_g);
                }
            }
    return fmt::to_string(text);
}

std::string hydrostatics(const HydroData& data, double rho_g) {
    Mat6 C = Mat6::Zero();
    if (data.buoyancy_stiffness) {
        C = *data.buoyancy_stiffness / rho_g;
    } else {
        C.block<3, 3>(2, 2) = data.waterplane_stiffness / rho_g;
        const double upright = data.displaced_volume * data.centre_of_buoyancy.z();
        C(3, 3) += upright;
        C(4, 4) += upright;
    }
    Text text;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) put(text, " {:5} {:5} {:16.9e}\n", i + 1, j + 1, C(i, j) + 0.0);
    return fmt::to_string(text);
}

}  // namespace

std::vector<std::filesystem::path> write_wamit(const HydroData& data, double gravity,
                                               const std::string& stem) {
    const double rho_g = data.density * gravity;
    std::vector<std::filesystem::path> files;
    const auto write = [&](const char* extension, const std::string& text) {
        files.emplace_back(stem + extension);
        write_atomically(files.back(), text);
    };
    const auto write_waves = [&](const char* extension, const WaveTable<CVec6>& table,
                                 double scale) {
        if (!table.empty()) write(extension, waves(table, scale));
    };
    const auto write_drift = [&](DriftMethod method, const WaveTable<Vec6>& table) {
        const char* extension = method == DriftMethod::momentum   ? ".8"
                                : method == DriftMethod::pressure ? ".9"
                                                                  : ".7";
        if (!table.empty()) write(extension, drift(table, method == DriftMethod::momentum, rho_g));
    };
    write(".1", radiation(data));
    write_waves(".2", data.haskind, rho_g);
    write_waves(".3", data.excitation, rho_g);
    write_waves(".3fk", data.froude_krylov, rho_g);
    write_waves(".3sc", data.scattering, rho_g);
    write_waves(".4", data.motion, 1.0);
    write_drift(data.drift_method, data.mean_drift);
    for (const MeanDrift& other : data.other_drift) write_drift(other.method, other.table);
    if (!data.difference.empty()) write(".12d", second_order(data.difference, rho_g));
    if (!data.sum.empty()) write(".12s", second_order(data.sum, rho_g));
    write(".hst", hydrostatics(data, rho_g));
    return files;
}

}  // namespace hawser::io
