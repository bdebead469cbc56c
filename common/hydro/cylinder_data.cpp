#include "hydro/cylinder_data.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace hawser::hydro {
namespace {

struct Coefficients {
    double surge, heave, surge_pitch, pitch;
};

Mat6 matrix_of(const Coefficients& c) {
    Mat6 M = Mat6::Zero();
    M(0, 0) = M(1, 1) = c.surge;
    M(2, 2) = c.heave;
    M(0, 4) = M(4, 0) = c.surge_pitch;
    M(1, 3) = M(3, 1) = -c.surge_pitch;
    M(3, 3) = M(4, 4) = c.pitch;
    return M;
}

Mat6 added_mass_of(const WaveResponse& r) {
    return matrix_of(
        {r.surge_added_mass, r.heave_added_mass, r.surge_pitch_added_mass, r.pitch_added_mass});
}
Mat6 damping_of(const WaveResponse& r) {
    return matrix_of({r.surge_damping, r.heave_damping, r.surge_pitch_damping, r.pitch_damping});
}

/// Forces of a wave that travels towards `heading`: the hull is a body of revolution.
CVec6 turned(Complex along, Complex heave, Complex pitch, double heading) {
    const double c = std::cos(heading), s = std::sin(heading);
    CVec6 X;
    X << along * c, along * s, heave, -pitch * s, pitch * c, 0.0;
    return X;
}

Mat6 infinite_added_mass(CylinderFlow& flow, double rho) {
    const AzimuthFlow heave = flow.solve(0, infinite_frequency),
                      pitch = flow.solve(1, infinite_frequency);
    return matrix_of({-rho * pitch.force(0, 0).real(), -rho * heave.force(0, 0).real(),
                      -rho * pitch.force(0, 1).real(), -rho * pitch.force(1, 1).real()});
}

/// Largest relative change of radiation coefficients at one frequency.
double change(CylinderFlow& coarse, CylinderFlow& fine, double K) {
    const AzimuthFlow c0 = coarse.solve(0, K), f0 = fine.solve(0, K);
    const AzimuthFlow c1 = coarse.solve(1, K), f1 = fine.solve(1, K);
    const auto part = [](Complex a, Complex b, double size) {
        return size > 0.0 ? std::abs(a - b) / size : 0.0;
    };
    const double surge = std::abs(f1.force(0, 0)), pitch = std::abs(f1.force(1, 1));
    return std::max({part(c0.force(0, 0), f0.force(0, 0), std::abs(f0.force(0, 0))),
                     part(c1.force(0, 0), f1.force(0, 0), surge),
                     part(c1.force(1, 1), f1.force(1, 1), pitch),
                     part(c1.force(0, 1), f1.force(0, 1), std::sqrt(surge * pitch))});
}

}  // namespace

CylinderData cylinder_data(const CylinderRequest& request,
                           const std::function<void(double)>& progress) {
    const Water& water = request.water;
    const auto K_of = [&](double w) { return w * w / water.gravity; };
    CylinderData out;
    out.buoyancy = buoyancy_of(request.hull);

    // H:13: double all sums until that changes less than the tolerance.
    Resolution resolution{1.0, K_of(request.frequencies.back())};
    const double probes[] = {request.frequencies.front(),
                             request.frequencies[request.frequencies.size() / 2],
                             request.frequencies.back()};
    auto flow = std::make_unique<CylinderFlow>(request.hull, resolution);
    for (;;) {
        resolution.level *= 2.0;
        auto finer = std::make_unique<CylinderFlow>(request.hull, resolution);
        out.truncation_error = 0.0;
        for (const double w : probes)
            out.truncation_error = std::max(out.truncation_error, change(*flow, *finer, K_of(w)));
        flow = std::move(finer);
        if (out.truncation_error <= request.tolerance) break;
        out.within_tolerance = resolution.level < 8.0;
        if (!out.within_tolerance) break;
    }
    out.functions = flow->functions();
    out.outer_modes = flow->outer_modes();

    std::optional<FreeHull> free = request.free;
    if (free && request.heave_damping_fraction > 0.0) {
        free->heave_damping =
            heave_damping_of(request.heave_damping_fraction, *flow, request.hull, water, *free);
        out.heave_damping = free->heave_damping;
    }

    HydroData& data = out.data;
    data.density = water.density;
    data.displaced_volume = out.buoyancy.volume;
    data.centre_of_buoyancy = {0.0, 0.0, out.buoyancy.centre};
    data.drift_is_horizontal = true;
    data.frequencies = data.excitation.frequencies = data.mean_drift.frequencies =
        request.frequencies;
    for (const double heading : request.headings) {
        data.excitation.headings.push_back({heading, {}});
        data.mean_drift.headings.push_back({heading, {}});
    }
    out.zero_frequency = std::min(0.001, 0.5 * request.frequencies.front());
    data.added_mass_0 =
        added_mass_of(wave_response(*flow, request.hull, out.zero_frequency, water, nullptr));
    data.added_mass_inf = infinite_added_mass(*flow, water.density);
    const double rho_g = water.density * water.gravity;
    data.waterplane_stiffness.diagonal() << rho_g * out.buoyancy.waterplane,
        rho_g * out.buoyancy.waterplane_moment, rho_g * out.buoyancy.waterplane_moment;

    for (std::size_t i = 0; i < request.frequencies.size(); ++i) {
        const WaveResponse r = wave_response(*flow, request.hull, request.frequencies[i], water,
                                             free ? &*free : nullptr);
        data.added_mass.push_back(added_mass_of(r));
        data.damping.push_back(damping_of(r));
        for (std::size_t h = 0; h < request.headings.size(); ++h) {
            const double heading = request.headings[h];
            data.excitation.headings[h].values.push_back(
                turned(r.surge_force, r.heave_force, r.pitch_moment, heading));
            data.mean_drift.headings[h].values.push_back(turned(r.drift, 0.0, 0.0, heading).real());
        }
        out.haskind_gap = std::max(out.haskind_gap, r.haskind_gap);
        out.energy_gap = std::max(out.energy_gap, r.energy_gap);
        if (progress)
            progress(static_cast<double>(i + 1) / static_cast<double>(request.frequencies.size()));
    }
    return out;
}

}  // namespace hawser::hydro
