#include "hull.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "status.hpp"
#include "user_damping.hpp"
#include "user_stiffness.hpp"

namespace hawser::master {

namespace {
constexpr double steepest_pitch = 80.0 * M_PI / 180.0;  // K:2: det E = cos(pitch)

Mat6 infinite_added_mass(const HydroData& data, const Platform& p) {
    const Hydrodynamics& h = p.hydrodynamics;
    if (data.added_mass_inf) return *data.added_mass_inf;
    if (h.database && h.database->estimate_infinite)
        return estimated_infinite_added_mass(data, h.memory->duration);
    throw RunError(ExitCode::input,
                   p.key_path +
                       ".hydrodynamics.added_mass.convolution: expected a database with the "
                       "added mass at infinite frequency (rows of period 0 in the .1); found none. "
                       "Compute it, or have it estimated: database.estimate_infinite: true");
}

/// Case key hydrodynamics.added_mass: a frequency, or the spectral peak.
Radiation radiation_of(const Platform& p, const HydroData* data, const Sea& sea) {
    const Hydrodynamics& h = p.hydrodynamics;
    Radiation r;
    if (data != nullptr && h.memory) {
        r.added_mass = infinite_added_mass(*data, p);
    } else if (data != nullptr) {
        if (!h.added_mass_frequency && !sea.has_waves())
            throw RunError(ExitCode::input,
                           p.key_path +
                               ".hydrodynamics.added_mass: expected a frequency, e.g. "
                               "{constant: 0.4 rad/s}: in still water there is no spectral peak to "
                               "take the constant added mass and damping at");
        r = radiation_at(*data, h.added_mass_frequency.value_or(sea.peak_frequency()));
    }
    if (h.matrix) {
        r.added_mass += h.matrix->added_mass;
        r.damping += h.matrix->damping;
    }
    return r;
}

Buoyancy buoyancy_of(const Hydrodynamics& h, const HydroData* data, const Water& water) {
    Buoyancy b{.density = water.density, .gravity = water.gravity};
    if (data != nullptr) {
        b.volume = data->displaced_volume;
        b.centre = data->centre_of_buoyancy;
        b.waterplane = data->waterplane_stiffness;
    }
    if (h.matrix) b.waterplane += h.matrix->stiffness.block<3, 3>(2, 2);
    return b;
}

/// A force and a moment, or a velocity and a rotation, on the axes of the body and of the world.
Vec6 to_body(const Mat3& R, const Vec6& v) {
    Vec6 out;
    out << R.transpose() * v.head<3>(), R.transpose() * v.tail<3>();
    return out;
}
Vec6 to_world(const Mat3& R, const Vec6& v) {
    Vec6 out;
    out << R * v.head<3>(), R * v.tail<3>();
    return out;
}

/// The pose alone.
PlatformMotion at_rest(const PlatformMotion& m) {
    return {.position = m.position, .angles = m.angles};
}

const Platform& platform_of(const Case& c, int which) {
    if (which >= c.platform_count())
        throw RunError(ExitCode::bug, "a hull was asked for in a case without one");
    return c.platform_at(which);
}
}  // namespace

Hull::Hull(const Case& c, const HydroData* data, int which)
    : Hull(c, platform_of(c, which), data) {}

Hull::Hull(const Case& c, const Platform& p, const HydroData* data)
    : name_(p.name),
      design_(p.position),
      statics_(c.analysis.statics),
      ramp_(c.analysis.dynamics.ramp),
      sea_(c.environment, ramp_, 0.0),
      buoyancy_(buoyancy_of(p.hydrodynamics, data, c.environment.water)),
      radiation_(radiation_of(p, data, sea_)),
      members_(p.members, c.environment.water),
      plates_(p.plates, c.environment.water),
      wind_(c.environment.wind, p.wind, ramp_),
      linear_damping_(p.linear_damping),
      quadratic_damping_(p.quadratic_damping),
      stiffness_(p.stiffness),
      stiffness_acts_(!stiffness_.isZero(0.0)),
      stiffness_turns_(p.stiffness_turns),
      current_load_(p.current_coefficients, c.environment.water.density),
      forces_(p.forces, ramp_),
      held_(p.held()),
      place_{.position = design_ + p.initial.position, .angles = p.initial.angles},
      wave_phases_(sea_.components()),
      phases_(sea_.components().size()),
      slow_phases_(sea_.components().size()) {
    const Hydrodynamics& h = p.hydrodynamics;
    if (h.memory && data != nullptr) {
        radiation_data_.frequencies = data->frequencies;
        radiation_data_.added_mass = data->added_mass;
        radiation_data_.damping = data->damping;
        infinite_ = infinite_added_mass(*data, p);
        const double D = c.analysis.dynamics.platform_step;
        if (h.memory->form == RadiationMemoryKeys::Form::discrete)
            discrete_.emplace(Retardation(*data), D, h.memory->duration);
        else
            fitted_ = FittedMemory(fit_memory(*data, infinite_, D, h.memory->order));
    }
    if (p.prescribed) path_.emplace(*p.prescribed, ramp_);
    body_.centre_of_gravity = p.centre_of_gravity;
    if (p.inertia)
        body_.inertia = *p.inertia;
    else
        radii_ = p.radii_of_gyration;
    mass_is_auto_ = !p.mass;
    set_mass(p.mass.value_or(acting_buoyancy() / c.environment.water.gravity));

    drift_ = h.drift;
    wave_phase_ = h.wave_phase.value_or(WavePhase::slow);
    cutoff_ = sea_.has_waves() ? h.slow_cutoff.value_or(sea_.peak_frequency() / 4) : 0.0;
    if (data != nullptr && sea_.has_waves()) {
        excitation_ = ComponentTable<CVec6>(data->excitation, sea_.components());
        if (drift_ == Drift::full_qtf) {
            if (data->difference.empty())
                throw RunError(
                    ExitCode::input,
                    p.key_path +
                        ".hydrodynamics.drift: full_qtf: expected a database with a "
                        "difference-frequency QTF (.10d, .11d or .12d); found none of them");
            using Of = QuadraticLoad::Of;
            differences_ = QuadraticLoad(data->difference, Of::differences, sea_.components());
            sums_ = QuadraticLoad(data->sum, Of::sums, sea_.components());
            mean_drift_ = ComponentTable<Vec6>(differences_.diagonal(), sea_.components());
        } else if (drift_ != Drift::none) {
            if (data->mean_drift.empty())
                throw RunError(ExitCode::input,
                               p.key_path +
                                   ".hydrodynamics.drift: expected a database with mean drift "
                                   "(.8, .9 or .7); found none of them");
            mean_drift_ = ComponentTable<Vec6>(data->mean_drift, sea_.components());
        }
    }
}

void Hull::set_mass(double mass) {
    body_.mass = mass;
    if (radii_) body_.inertia = mass * radii_->cwiseAbs2().asDiagonal();
}

double Hull::acting_buoyancy() const {
    return buoyancy_.density * buoyancy_.gravity * (buoyancy_.volume + members_.design_volume());
}

HullLoads Hull::loads(double t, const State& s) const {
    const PlatformMotion m = motion_of(s);
    const Mat3 R = rotation(m.angles);
    const Vec3 w = angular_velocity(m);
    const double r = ramp_factor(t, ramp_);
    HullLoads loads;

    loads[Load::weight] =
        weight_load(body_.mass, buoyancy_.gravity, R * body_.centre_of_gravity);  // K:6
    loads[Load::hydrostatic] = hydrostatic_load(buoyancy_, m, R);                 // K:6, K:7

    if (!excitation_.empty()) {  // K:8
        const WavePosition slow = slow_position(s);
        wave_phases_.set(t, slow, slow_phases_);
        if (wave_phase_ == WavePhase::slow) {
            loads[Load::wave1] =
                r * excitation_load(excitation_, sea_.components(), slow_phases_, slow.yaw);
        } else {
            const WavePosition here = instantaneous_position(s);
            wave_phases_.set(t, here, phases_);
            loads[Load::wave1] =
                r * excitation_load(excitation_, sea_.components(), phases_, here.yaw);
        }
        const DriftLoad drift = drift_load(mean_drift_, sea_.components(), slow_phases_, slow.yaw);
        loads[Load::drift] = mean_factor(statics_.drift_mean, r) * drift.mean;
        if (drift_ == Drift::newman) loads[Load::drift] += r * (drift.slow - drift.mean);
        if (drift_ == Drift::full_qtf) {  // K:11, K:12
            loads[Load::drift] += r * (differences_.load(slow_phases_, slow.yaw) - drift.mean);
            loads[Load::wave2] = r * sums_.load(slow_phases_, slow.yaw);
        }
    }

    const double current_factor = mean_factor(statics_.current, r);
    const MemberLoad members = members_.load(t, sea_, current_factor, m, R, w);
    const PlateLoad plates = plates_.load(t, sea_, current_factor, m, R, w);
    loads[Load::hydrostatic] += members.buoyancy;
    loads[Load::members] = members.rest;
    loads[Load::plates] = plates.rest;
    loads[Load::current] =
        members.current + plates.current + current_load_.load(sea_, current_factor, m, R, w);
    loads.member_added_mass = members.added_mass;
    loads.plate_added_mass = plates.added_mass;

    loads[Load::wind] =
        wind_.load(t, m, R, w) - (1.0 - mean_factor(statics_.wind_mean, r)) * wind_.mean_load(m, R);
    loads[Load::damping] = user_damping_load(linear_damping_, quadratic_damping_, m, w);
    if (stiffness_acts_)
        loads[Load::stiffness] = user_stiffness_load(stiffness_, stiffness_turns_, from_design(m));
    loads[Load::forces] = forces_.load(t, R);
    return loads;
}

State Hull::rate(double t, const State& s, HullLoads& loads, const Vec6& lines,
                 Vec6* acceleration) const {
    const PlatformMotion m = motion_of(s);
    const double pitch = m.angles.y();
    if (!(std::abs(pitch) <= steepest_pitch))
        throw RunError(ExitCode::diverged,
                       fmt::format("{}, t = {:.3f} s: pitch is {:.1f} deg; roll and yaw lose their "
                                   "meaning near 90 deg, the limit is 80 deg. Look at the loads "
                                   "and the stability of the platform, or take a shorter "
                                   "analysis.dynamics.steps.platform",
                                   name_, t, pitch * 180 / M_PI));
    const Mat3 R = rotation(m.angles);
    if (!(R(2, 2) >= std::cos(steepest_pitch)))
        throw RunError(ExitCode::diverged,
                       fmt::format("{}, t = {:.3f} s: the platform has capsized: its axis leans by "
                                   "{:.1f} deg, the limit is 80 deg. Look at its stability (weight "
                                   "and buoyancy, GM) and at the loads",
                                   name_, t, std::acos(R(2, 2)) * 180 / M_PI));
    const Vec3 w = angular_velocity(m);
    const TurnedBody body = turned(body_, R);
    const Mat6 A_w = turned(radiation_.added_mass, R), B_w = turned(radiation_.damping, R);
    Vec6 velocity;
    velocity << m.velocity, w;

    const double* memory = s.data() + memory_index;
    loads[Load::lines] = lines;
    loads[Load::radiation] = -B_w * velocity;
    if (fitted_.states() > 0) loads[Load::radiation] += to_world(R, fitted_.load(memory));
    if (discrete_) loads[Load::radiation] += to_world(R, discrete_->load(t, to_body(R, velocity)));
    const Vec6 force = loads.total() - gyroscopic_load(body, w);
    const Mat6 virtual_mass =
        mass_matrix(body) + A_w + loads.member_added_mass + loads.plate_added_mass;
    const bool holds = any(held_);
    HeldSolution solved;
    if (holds) {
        const PlatformAcceleration led = held_at(t).acceleration;
        Vec6 given;
        given << led.position, led.angles;
        solved = solve_held(virtual_mass, force, m, held_, given);  // K:20
        loads[Load::holding] = solved.holding;
    }
    const Vec6 a = holds ? solved.acceleration
                         : Vec6(virtual_mass.partialPivLu().solve(force));  // K:4: (x_O'', w')
    if (!a.allFinite())
        throw RunError(ExitCode::diverged,
                       fmt::format("{}, t = {:.3f} s: the platform's acceleration is not a finite "
                                   "number; take a shorter analysis.dynamics.steps.platform or "
                                   "look for a load without bound",
                                   name_, t));
    loads[Load::radiation] -= A_w * a;
    loads[Load::members] -= loads.member_added_mass * a;
    loads[Load::plates] -= loads.plate_added_mass * a;

    State rate = State::Zero();
    rate.segment<6>(0) = s.segment<6>(6);
    rate.segment<3>(6) = a.head<3>();
    rate.segment<3>(9) = angular_velocity_matrix(m.angles).partialPivLu().solve(
        Vec3(a.tail<3>() -
             angular_velocity_matrix_rate(m.angles, m.angle_rates) * m.angle_rates));  // K:3
    if (holds) rate.segment<6>(6) = solved.motions;
    add_slow_motion_to(rate, s, cutoff_);                                            // K:8
    fitted_.add_rates_to(rate.data() + memory_index, memory, to_body(R, velocity));  // K:10
    if (acceleration != nullptr) *acceleration = rate.segment<6>(6);
    return rate;
}

Vec6 Hull::static_load(const PlatformMotion& pose, const Statics& which) const {
    const Mat3 R = rotation(pose.angles);
    Vec6 load = weight_load(body_.mass, buoyancy_.gravity, R * body_.centre_of_gravity) +
                hydrostatic_load(buoyancy_, pose, R);
    const MemberLoad members = members_.static_load(sea_, 1.0, pose, R);
    load += members.buoyancy;
    if (which.current) load += members.current + plates_.current_load(sea_, 1.0, pose, R);
    if (which.current) load += current_load_.load(sea_, 1.0, at_rest(pose), R, Vec3::Zero());
    if (which.wind_mean) load += wind_.mean_load(pose, R);
    if (stiffness_acts_)
        load += user_stiffness_load(stiffness_, stiffness_turns_, from_design(pose));
    load += forces_.static_load(R);
    if (which.drift_mean && !mean_drift_.empty()) {
        const WavePosition at{pose.position.x(), pose.position.y(), pose.angles.z()};
        wave_phases_.set(0.0, at, slow_phases_);
        load += drift_load(mean_drift_, sea_.components(), slow_phases_, at.yaw).mean;
    }
    return load;
}

Mat6 Hull::static_stiffness(const PlatformMotion& pose, const Statics& which) const {
    Mat6 K;
    for (int j = 0; j < 6; ++j) {
        const double h = j < 3 ? 1e-2 : 1e-4;  // [m], [rad]: error h^2, rounding 1e-16 of 1 GN/h
        Vec6 step = Vec6::Zero();
        step[j] = h;
        K.col(j) = (static_load(displaced(pose, -step), which) -
                    static_load(displaced(pose, step), which)) /
                   (2.0 * h);
    }
    return K;
}

void Hull::remember(double t, const State& s, const Vec6& acceleration) {
    if (!discrete_) return;
    const PlatformMotion m = motion_of(s);
    const Mat3 R = rotation(m.angles);
    const Vec3 w = angular_velocity(m);
    Vec6 velocity, rate;
    velocity << m.velocity, w;
    // K:3, and d(R^T v)/dt = R^T (v' - w x v)
    rate << acceleration.head<3>() - w.cross(m.velocity),
        angular_velocity_matrix(m.angles) * acceleration.tail<3>() +
            angular_velocity_matrix_rate(m.angles, m.angle_rates) * m.angle_rates;
    discrete_->remember(t, to_body(R, velocity), to_body(R, rate));
}

Mat6 Hull::static_mass(const PlatformMotion& pose, double frequency) const {
    const Mat3 R = rotation(pose.angles);
    Mat6 added = radiation_.added_mass;
    if (!radiation_data_.frequencies.empty())
        added +=
            radiation_at(radiation_data_, std::clamp(frequency, radiation_data_.frequencies.front(),
                                                     radiation_data_.frequencies.back()))
                .added_mass -
            infinite_;
    const HullLoads wet = loads(0.0, start(pose, pose));
    return mass_matrix(turned(body_, R)) + turned(added, R) + wet.member_added_mass +
           wet.plate_added_mass;
}

LedMotion Hull::held_at(double t) const {
    if (!path_) return {.motion = place_, .acceleration = {}};
    LedMotion led = path_->at(t);
    led.motion.position += design_;
    return led;
}

State Hull::led(double t, State s) const {
    if (any(held_)) set_motion(s, with_held(motion_of(s), held_at(t).motion, held_));
    return s;
}

State Hull::start(const PlatformMotion& equilibrium, const PlatformMotion& with_initial) const {
    State s = State::Zero();
    set_motion(s, with_initial);
    s = led(0.0, s);
    rest_slow_motion_at(s, equilibrium);
    return s;
}

Vec6 Hull::momentum(const State& s) const {
    const PlatformMotion m = motion_of(s);
    return master::momentum(turned(body_, rotation(m.angles)), m.velocity, angular_velocity(m));
}

Vec6 Hull::momentum_transport(const State& s) const {
    const PlatformMotion m = motion_of(s);
    return master::momentum_transport(turned(body_, rotation(m.angles)), m.velocity,
                                      angular_velocity(m));
}

}  // namespace hawser::master
