// Up to four rods of equal layout, one per vector lane, advanced side by side: time steps (R:27 to
// R:29), passes of the paper's scheme (P:3), statics. Every lane has its own step, Newton count and
// status; a lane that is done or has failed is frozen, so that a rod's bits do not depend on its
// neighbours. No MPI, no files, no allocation in a step.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "constraint/along_rod.hpp"
#include "constraint/point_laws.hpp"
#include "constraint/slope_laws.hpp"
#include "environment/sea.hpp"
#include "lines.hpp"
#include "packing.hpp"
#include "rod/catenary.hpp"
#include "rod/element.hpp"
#include "rod/elimination.hpp"
#include "rod/small_motion.hpp"
#include "rod/state.hpp"
#include "rod/time_scheme.hpp"
#include "spline.hpp"

namespace hawser::worker {

/// A mass, clump or buoy at a node, per lane.
template <class V>
struct PointMass {
    int node = 0;
    V mass, displaced, added, drag, height;  ///< [kg], rho V [kg], Ca rho V [kg], 1/2 rho Cd A, [m]
};

/// Motion of a rod's end and the axis of its joint on world axes, per lane.
template <class V>
struct EndValues {
    Vector<V> position, velocity, acceleration, axis;
};

/// The platform before and after a step, per lane.
template <class V>
struct HullMotion {
    struct Pose {
        Vec3 position = Vec3::Zero();
        Mat3 turned = Mat3::Identity();
    };
    std::array<Pose, static_cast<std::size_t>(LaneTraits<V>::count)> before, now;
    Vector<V> origin, velocity, spin;  ///< of the reference point after the step
};

/// A contact point of a constraint along the rods of a pack: its laws, its places (one per lane)
/// and what a step knows of it. A pull tube has several, every other constraint one.
template <class V>
struct PlacedConstraint {
    Law<V> law;
    SlopeLaw<V> joint;    ///< of a flex joint or a clamp
    int declared = 0;     ///< index into Line::constraints; -1: mirror of another rod's
    bool tied = false;    ///< to a point of another rod
    bool mirror = false;  ///< the other rod's side of a tie: takes what the tie gives
    int of_line = -1, of_constraint = -1;  ///< mirror: line and constraint (of lane 0) it mirrors
    bool is_end_a = false, is_end_b = false;  ///< tied end of the line
    std::vector<LineConstraint> at;  ///< one per lane; of a pull tube its point and tangent there
    V on_platform{};                 ///< 1: moves with the platform, 0: stands on the earth
    int hull = 0;                    ///< which of the rod's platforms
    typename LaneTraits<V>::Mask axis_is_static = LaneTraits<V>::none();  ///< of the joint
    V element{}, xi{};                  ///< where it touches during the step
    Vector<V> place, axis, joint_axis;  ///< on world axes at the end of the step
    std::vector<Vector<V>> cylinders;   ///< of a tensioner: their points less the place
    /// The failing node is where it holds the rod: it lets go with it
    typename LaneTraits<V>::Mask lets_go = LaneTraits<V>::none();
    V holds = V(1.0);            ///< part of the load of a guide: 0 beyond the rod's ends
    V slide_start{};             ///< g.k of the material point before the step [m]
    V friction{}, stroke{};      ///< friction spring and stroke before the step [m]
    ConstraintMotion<V> motion;  ///< at the last trial values
    ConstraintReading<V> reading;
    ConstraintLoad<V> joint_load;
    Vector<V> point, rate, slope;  ///< of the rod there: r, r_t, r'
    Vector<V> place_rate;          ///< of a place on another rod [m/s]
    Vector<V> moved;               ///< correction of the point, sum A_i d_i [m]
    /// Carried to the solution of the linear system: force, force on the slope, moment of the joint
    Vector<V> force, slope_force, moment;
    ConstraintState<V> settled;     ///< of each lane's own last iteration
    Vector<V> fitted;               ///< force as the pass returns it (P:5, R:48)
    std::array<Vector<V>, 3> used;  ///< the same of the passes before the kept one, R:40
};

/// What the passes of a platform step hand over of one line's load on the platform, R:48.
struct LaneHandedOver {
    std::array<Vec6, 3> used;  ///< as the passes before the kept one returned it [N, N.m]
    Vec6 load, given;  ///< after the last step of the kept pass; its impulse so far [N.s, N.m.s]
};

/// The first section of a line that a winch pays out or takes in.
struct WoundLine {
    Curve paid_out;
    double section = 0.0;  ///< its length without the winch [m]
    int elements = 0;      ///< of it, at end A; 0: no winch
};

template <class V>
struct SectionForces;  // section_forces.hpp

/// Work done, for tests and the benchmark.
struct WorkCount {
    std::int64_t passes = 0, steps = 0, solves = 0, water_samples = 0;
    double rod_time = 0.0;  ///< simulated time of all passes [s]
};

/// Tolerances of the Newton iterations (README.md of worker, "Time"); tests tighten them.
struct NewtonControl {
    double tolerance =
        0.005;  ///< largest nodal position correction that needs no further iteration [m]
    /// The same of an undamped rule, which keeps what an iteration leaves
    static constexpr double undamped_tolerance = 1e-4;
    int max_iterations = 8;
    int max_halvings = 6;
    /// The same of a quasi-static pass, and parts into which the platform's way is cut at most
    double still_tolerance = 1e-6;
    int still_iterations = 30;
    int still_parts = 64;
    /// A contact is settled when its law's force at the solution differs from the force that the
    /// solution holds by less than this part of it and `constraint_force` [N].
    double constraint_part = 0.01, constraint_force = 1e3;
    int constraint_iterations = 5;  ///< beyond which only positions count
};

template <class V>
class RodGroup;
template <class V>
struct TieSide;
template <class V>
struct TieBorder;

template <class V>
class RodPack {
 public:
    using Mask = typename LaneTraits<V>::Mask;
    static constexpr int lanes = LaneTraits<V>::count;

    /// @param lines  indices into Case::lines, one per lane; fewer than `lanes` leave idle copies
    /// of the first
    RodPack(const Case& input, const Sea& sea, std::vector<int> lines);

    /// Static solution with the platform at `pose`, in the kept state: a = v = 0, current if asked,
    /// no waves.
    Status equilibrium(const PlatformMotion& pose, bool current);
    /// Shape from which the first static solution starts, instead of a catenary: nodes from end B
    /// to end A.
    void set_guess(int lane, const std::vector<CatenaryNode>& nodes);
    /// One pass from the kept state at t0 to t1 along the spline; the result is the working state.
    /// Quasi-static lines and catenaries are found at rest at t1 (README.md, "Line models").
    /// A line that fails stays where it failed, the others finish; the first failed line, in line
    /// order, is told. Rods that are tied to rods of other packs pass with them (RodGroup).
    Status pass(double t0, double t1, const MotionSpline& platform);
    /// The pass that ended last becomes the kept state.
    void keep();

    /// The platforms that these rods touch. Poses and splines that are given are those of the
    /// first; a second one is told beforehand and stays until it is told anew.
    [[nodiscard]] const Touched& touched() const { return touched_; }
    void follow_second(const MotionSpline& platform) { second_ = platform; }
    /// Design position of the first platform.
    [[nodiscard]] const PlatformMotion& design() const { return design_; }

    /// Load of a lane on the platform about `reference` [N, N.m] in the working state.
    /// @param hull  0: the first platform of the rods, 1: the second
    [[nodiscard]] Vec6 wrench(int lane, const Vec3& reference, int hull = 0) const;
    /// The same as the pass returns it: instantaneous, the fit of the force over the pass (P:5), or
    /// with what the platform is still owed (R:48).
    [[nodiscard]] const Vec6& pass_wrench(int lane, int hull = 0) const {
        return fitted_[static_cast<std::size_t>(hull)][static_cast<std::size_t>(lane)];
    }
    /// Effective tension at end A (platform) and at end B in the working state [N]. After keep()
    /// the working state is the kept one; so it is after equilibrium().
    [[nodiscard]] double tension_a(int lane) const;
    [[nodiscard]] double tension_b(int lane) const;
    /// Unit direction in which the line leaves end A or arrives at end B (increasing arc length).
    [[nodiscard]] Vec3 direction_a(int lane) const;
    [[nodiscard]] Vec3 direction_b(int lane) const;
    [[nodiscard]] Vec3 force_on_support_a(int lane) const;
    [[nodiscard]] Vec3 force_on_support_b(int lane) const;
    /// Moments of the joints at the ends on what holds them [N.m].
    [[nodiscard]] Vec3 moment_on_support_a(int lane) const;
    [[nodiscard]] Vec3 moment_on_support_b(int lane) const;
    /// Position of node n counted from end A [m].
    [[nodiscard]] Vec3 node_position(int lane, int n) const;
    /// Nodes of a lane from end B to end A with tangents and tensions: a guess for another pack.
    [[nodiscard]] std::vector<CatenaryNode> found_shape(int lane) const;
    /// Static stiffness about `reference`: -d(wrench)/d(position, rotation vector) [6 x 6], R:25.
    /// After swing() the dynamic stiffness.
    /// Of a rod that is tied to others its own part; `ties` gets what joins them (RodGroup).
    [[nodiscard]] Mat6 stiffness(int lane, const Vec3& reference, TieBorder<V>* ties = nullptr) {
        return stiffness_about<6>(lane, {reference, Vec3::Zero()}, ties);
    }
    /// The same of rods that touch two platforms, each about its own reference: rows and columns of
    /// the first, then of the second.
    [[nodiscard]] Mat12 stiffness_between(int lane, const Vec3& first, const Vec3& second,
                                          TieBorder<V>* ties = nullptr) {
        return stiffness_about<12>(lane, {first, second}, ties);
    }

    /// Linear undamped motion of angular frequency omega about the last static solution, R:44: what
    /// stiffness() then gives is K(omega) - omega^2 M, exact for the mesh. Lines that a run
    /// computes at rest have no inertia. The state stays.
    void swing(double omega);
    /// The matrices of that motion for one lane, ends held.
    [[nodiscard]] SmallMotion small_motion(int lane);

    /// Constraint c of a lane (index into Line::constraints) in the working state: force [N] and
    /// moment about its point [N.m] on the rod - its support feels the opposite ones - and that
    /// point [m].
    [[nodiscard]] Vec3 constraint_force(int lane, int c) const;
    [[nodiscard]] Vec3 constraint_moment(int lane, int c) const;
    [[nodiscard]] Vec3 constraint_point(int lane, int c) const;
    /// Largest normal force of a guide or pull tube, tension of a tensioner, force otherwise [N].
    [[nodiscard]] double constraint_magnitude(int lane, int c) const;
    /// Least gap left, stroke of a tensioner, distance from the place otherwise [m].
    [[nodiscard]] double constraint_opening(int lane, int c) const;
    /// Slide of the rod along the axis since the start [m].
    [[nodiscard]] double constraint_slip(int lane, int c) const;
    /// Energy stored, and taken by dampers and friction since the start [J].
    [[nodiscard]] double constraint_energy(int lane, int c) const;
    [[nodiscard]] double constraint_dissipated(int lane, int c) const;
    /// |I_rod - I_hull| / sum h |f| of R:40 from the start to the kept state; 0 where the platform
    /// made no steps of four passes.
    [[nodiscard]] double impulse_mismatch(int lane, int c) const;
    /// How many constraints a line of this pack declares.
    [[nodiscard]] int constraint_count() const {
        int count = 0;
        for (const PlacedConstraint<V>& c : constraints_) count = std::max(count, c.declared + 1);
        return count;
    }

    /// Force inside the rods in the working state from the balance of what acts on them, R:47.
    void section_forces(SectionForces<V>& out) const;

    [[nodiscard]] const std::vector<int>& lines() const { return lines_; }
    /// Elements, counted from end B; arc lengths of the nodes from end B, ascending [m]; the bed.
    [[nodiscard]] const std::vector<ElementProperties<V>>& properties() const {
        return properties_;
    }
    [[nodiscard]] const std::vector<double>& arc_length(int lane) const {
        return arc_length_[static_cast<std::size_t>(lane)];
    }
    [[nodiscard]] const Bed& bed() const { return bed_; }
    [[nodiscard]] LineModel model() const { return model_; }
    /// Is an end held by a support?
    [[nodiscard]] bool held_a() const { return place_a_.held(); }
    [[nodiscard]] bool held_b() const { return place_b_.held(); }
    [[nodiscard]] int elements() const { return static_cast<int>(properties_.size()); }
    [[nodiscard]] const RodState<V>& kept() const { return kept_; }
    RodState<V>& kept() { return kept_; }
    [[nodiscard]] const RodState<V>& state() const { return working_; }
    [[nodiscard]] const WorkCount& work() const { return work_; }
    NewtonControl newton;

 private:
    friend class RodGroup<V>;
    struct EndPlace {
        EndKind kind = EndKind::free;
        int hull = 0;              ///< which of the rod's platforms, of that kind
        std::vector<LineEnd> end;  ///< one per lane
        [[nodiscard]] bool held() const { return kind != EndKind::free; }
        [[nodiscard]] bool sprung() const { return held() && end.front().joint == Joint::spring; }
        [[nodiscard]] bool on_line() const { return kind == EndKind::line; }
        /// Is the position of the rod's node that of the support?
        [[nodiscard]] bool prescribed() const { return held() && !sprung() && !on_line(); }
    };
    /// Rows of a prescribed end's position, kept for its reaction.
    struct ReactionRows {
        V own[3][3], D[3][4], E[3][7], R[3];  ///< of `own` the lower triangle
    };

    // rod_pack.cpp: set-up and read-out
    [[nodiscard]] std::size_t hulls() const { return touched_.two() ? 2 : 1; }
    /// Motion of the first (0) or second platform, `first` that of the first.
    [[nodiscard]] const MotionSpline& motion_of(int hull, const MotionSpline& first) const {
        return hull == 0 ? first : second_;
    }
    /// Effective tension in the rod just inside a free end, e.g. below a tensioner's ring [N].
    [[nodiscard]] double end_tension(std::size_t node, int lane) const;
    void set_properties(const Case& input);
    void set_spring();
    void set_slope_law(const EndPlace& place, SlopeLaw<V>& law,
                       const ElementProperties<V>& element);
    EndValues<V> end_values(const EndPlace& place, const Vector<V>& axis, V t,
                            const MotionSpline& platform) const;

    // time_step.cpp
    void begin_pass(double t0, double t1, const MotionSpline& platform, V h);
    void begin_step(Mask active, V h, V t_new, const MotionSpline& platform);
    /// The trial values corrected by what solve() found, and the forces of the supports.
    void correct(Mask iterating, V a0, V a1);
    /// Takes away from `sound` the lanes that have lost their way, from `converged` those that want
    /// another iteration.
    void judge(int iteration, V h, Mask iterating, Mask& sound, Mask& converged);
    void end_step(Mask accepted, V h, V t_new);
    void restart_rates(int lane);
    void predict(const RodState<V>& s, V h);
    void prepare_material(const RodState<V>& s, V h);
    void accept(Mask accepted, V h, V t_new);
    void drag_grips(Mask accepted);
    /// Friction of the bed acts in passes of every line model, not in static solutions.
    [[nodiscard]] GripBefore<V> grip_before(std::size_t e) const {
        if (!friction_on_ || working_.grips() == nullptr) return {};
        return {&working_.nodes()[e], &working_.nodes()[e + 1],
                working_.grips() + e * gauss_points};
    }

    // hull_impulse.cpp
    [[nodiscard]] bool matches_impulse() const;
    void begin_handing_over(double t0, double t1, const MotionSpline& platform);
    void add_to_fit(int lane, int i, int n, const MotionSpline& platform);
    void add_to_given(int lane, double h, const MotionSpline& platform);
    void end_handing_over();
    void take_static_load(const PlatformMotion& pose);
    /// Load on the first (0) or second platform about its O at t. @param platform  the first
    [[nodiscard]] Vec6 wrench_at(int lane, std::size_t hull, const MotionSpline& platform,
                                 double t) const;
    /// The load at time t is what the pass returns. @param platform  the first
    void take_wrench(int lane, const MotionSpline& platform, double t);

    // quasi_static.cpp
    void begin_still_pass(double t0, double t1, const MotionSpline& platform);
    void end_still_pass(Mask solved, double t0, double t1, const MotionSpline& platform);
    void begin_still_attempt(V t, const MotionSpline& platform);
    void reach(Mask good);
    void start_still(Mask from_prediction, V ahead);
    /// The platform that a rod in guides goes along with.
    [[nodiscard]] int leading_hull() const {
        for (const PlacedConstraint<V>& c : constraints_)
            if (!c.mirror && !c.tied && c.at.front().on_platform) return c.hull;
        return 0;
    }
    void carry_with_hull(int lane, const PlatformMotion& from, const PlatformMotion& to);
    void current_at(double t, const MotionSpline& platform);

    // catenary_lines.cpp
    std::vector<CatenaryElement> catenary_elements(int lane) const;
    Status hang(double t1, const MotionSpline& platform);
    Status hang_at(const PlatformMotion& pose);
    Mat6 hanging_stiffness(int lane, const Vec3& reference) const;
    bool hang_lane(int lane, double t, const MotionSpline& platform);

    // solve.cpp
    /// Assembles and eliminates every node but that at end A, which is left factorised.
    void reduce(V a0, V a1);
    /// The corrections, and the reactions of the supports at the linear system's solution.
    void back_substitute();
    void update_trial(Mask iterating, V a0, V a1, V part, V limit, V& correction, V& finite);
    /// Inertia of a point mass less the loads on it, and the Jacobian.
    PointLoad<V> point_mass_load(const PointMass<V>& mass, const Vector<V>& r, const Vector<V>& v,
                                 const Vector<V>& a, const Water<V>& water, V a0, V a1) const;
    void add_point_mass(const PointMass<V>& mass, V a0, V a1, V (&D)[7][7], V (&R)[7]) const;
    void add_slope_law(const SlopeLaw<V>& law, const TrialNode<V>& node, const Vector<V>& axis,
                       V (&D)[7][7], V (&R)[7], ConstraintLoad<V>& load, Mask on) const;

    // constraints.cpp
    void set_constraints(const Case& input);
    void set_laws(PlacedConstraint<V>& to) const;
    /// Springs of a joint's point and of a clamp, after the element that they hold.
    void hold_by_element(PlacedConstraint<V>& to, int lane, int element) const;
    /// Takes away what a joint that looks for its point would exert along its axis.
    void let_slide(PlacedConstraint<V>& c) const;
    /// Takes away the loads of what has let go and of guides beyond the rod's ends.
    void let_go(PlacedConstraint<V>& c) const;
    /// Element from end B, and place in it, of an arc length from end A.
    [[nodiscard]] std::pair<int, double> element_at(int lane, double arc_length) const;
    void place_constraints(const RodState<V>& before, V t_before, V t, const MotionSpline& platform,
                           bool search);
    void locate(PlacedConstraint<V>& c, int lane, bool search) const;
    Vec3 trial_point(int lane, int element, double xi, Vec3* slope) const;
    HullMotion<V> hull_motion(V t_before, V t, const MotionSpline& platform) const;
    /// Loads of all constraints at the trial values.
    void find_points();
    void apply_laws(V a1);
    void add_constraints(std::size_t e, ElementSystem<V>& element) const;
    void carry_constraints();
    /// How far the laws are from the forces that the solution of the linear system holds, as a part
    /// of what `newton` allows.
    [[nodiscard]] V constraint_misfit() const;

    // ties.cpp
    [[nodiscard]] Vec3 kept_point(int lane, double arc_length) const;
    /// The point of the rod that is nearest to `to`: from the whole rod, or from where it was.
    void locate_nearest(PlacedConstraint<V>& c, int lane, const Vec3& to, bool search) const;
    void reduce_side(TieSide<V>& side) const;
    void last_rows(const V* column, int stride, V (&z)[7]) const;

    // constraint_border.cpp, constraint_results.cpp
    template <int columns>
    using Border = Eigen::Matrix<double, 7, columns>;
    using References = std::array<Vec3, 2>;
    /// @tparam n  6: one platform; 12: the first and the second
    template <int n>
    Eigen::Matrix<double, n, n> stiffness_about(int lane, const References& reference,
                                                TieBorder<V>* ties);
    /// Border columns of the constraints along the rod after the elimination of all nodes before
    /// end A; their block of R:22 and R:24 is added to M.
    template <int columns>
    Border<columns> border_of_constraints(int lane, const References& reference,
                                          Eigen::Matrix<double, columns, columns>& M,
                                          TieBorder<V>* ties) const;
    /// The border of an end B that moves with a platform: its columns in K, its block in M.
    template <int columns>
    void add_border_at_end_b(int lane, const References& reference, std::vector<Border<columns>>& K,
                             Eigen::Matrix<double, columns, columns>& M, TieBorder<V>* ties) const;
    /// C and G of the ties: the part of the nodes before end A, R:46.
    void begin_border(int lane, TieBorder<V>& ties, Eigen::Index columns) const;
    /// Border of the node at end A: K^T D^-1 K, and its part of the ties. Z's own rows of a
    /// prescribed position are folded with B.
    template <int n, int columns>
    Eigen::Matrix<double, columns, columns> border_at_end_a(
        int lane, const Eigen::Matrix<double, n, n>& D, const Eigen::Matrix<double, n, columns>& K,
        TieBorder<V>* ties, const Eigen::Matrix<double, 3, columns>* B = nullptr) const;
    void settle_constraints(Mask iterating);
    /// What a step of length h (0: statics) found becomes the constraints' state; their sums over
    /// time go on from `before`.
    void keep_constraints(Mask accepted, V h, const RodState<V>& before, RodState<V>& s);
    void take_joint_axes(RodState<V>& s);
    /// Lanes with a joint along the rod whose axis is the static tangent.
    [[nodiscard]] Mask static_joint_axes() const;
    template <class Combine>
    void for_points_of(int c, Combine&& combine) const;

    // curves.cpp
    void set_curves(const Case& input);
    /// Linearises tension tables about the trial tension; lanes whose last linearisation fits.
    /// @param before  state before a step of length h; null in statics
    Mask follow_curves(Mask which, const RodState<V>* before, V h);

    // changes.cpp
    void set_changes(const Case& input);
    void pay_out(V t);
    void part(V t);
    void part_element(std::size_t e, V a0, V a1);

    // water.cpp
    void refresh_water(double until, const PlatformMotion& hull);
    void sample_slab(double T, std::size_t slab, const PlatformMotion& hull);
    template <class Where, class Needed>
    int gather_points(Where&& where, Needed&& needed);
    template <class Node>
    void shelter_water(V t, const MotionSpline& platform, bool moves, const Node* nodes,
                       std::vector<Water<V>>& to) const;
    void interpolate_water(V t, std::vector<Water<V>>& to) const;
    void water_of_state(SectionForces<V>& out) const;
    /// Current alone, where the trial values put the rods; sheltered water stands still.
    void current_only(bool current, V t, const MotionSpline& platform);
    void scatter_water(Water<V>* to);

    // small_motion.cpp
    void prepare_tangent(double omega);

    // statics.cpp
    void start_from(int lane, const std::vector<CatenaryNode>& nodes);
    void copy_idle_lanes();
    /// @param a, b  where the ends are; without b it hangs free
    Mask guess_lane(int lane, const PlatformMotion& pose, const Vec3& a,
                    const std::optional<Vec3>& b);
    /// Is it a rod with a free end B, so stiff that it keeps the direction of its clamp at end A?
    [[nodiscard]] bool stands_out(int lane, const std::vector<CatenaryElement>& elements) const;
    void guess_straight(int lane, const Vec3& a, const Vec3& axis,
                        const std::vector<CatenaryElement>& elements);
    Mask guess_under_tension(int lane, const LineConstraint& tensioner, const PlatformMotion& pose,
                             const Vec3& foot, const std::vector<CatenaryElement>& elements);
    void begin_statics(const MotionSpline& still, Mask wanted);
    void end_statics(Mask solved);
    /// Lanes whose trial values are an equilibrium that nobody wants.
    Mask false_equilibria() const;
    Status status_of(Mask bad, Status::Code code, double t) const;
    void take_axes();
    void finish_statics(Mask good);
    void set_pose(const PlatformMotion& pose);
    [[nodiscard]] PlatformMotion last_pose() const;

    std::vector<int> lines_;
    Touched touched_;
    PlatformMotion design_;
    MotionSpline second_;  ///< of the second platform, where there is one
    const Sea* sea_;
    TimeScheme scheme_;
    Bed bed_;
    double gravity_ = 9.80665, water_density_ = 1025.0;
    ForceFit force_ = ForceFit::impulse_matched;
    LineModel model_ = LineModel::dynamic;
    template <class T>
    using PerHullAndLane = std::array<std::array<T, static_cast<std::size_t>(lanes)>, 2>;
    PerHullAndLane<Vec6> fitted_{};
    PerHullAndLane<LaneHandedOver> handed_{};
    double ramp_ = 0.0, platform_step_ = 0.5, wave_step_ = 0.25;
    V line_step_{};
    std::vector<Curve> curves_;  ///< tension tables, and which one an element of a lane has; or -1
    std::vector<std::array<int, static_cast<std::size_t>(lanes)>> curve_of_;
    std::vector<Mask> curved_;
    bool parts_ = false, winds_ = false, shelters_ = false;
    V parting_time_{}, parting_element_{}, dead_{};  ///< elements from end B; -1: none
    Mask parted_, lets_go_a_, released_;             ///< has failed; fails at end A; has done so
    std::vector<WoundLine> winch_;                   ///< per lane
    std::vector<V> full_length_;                     ///< of the elements, without winch [m]
    V sheltered_above_{};                            ///< height on the platform [m]
    Mask used_;
    std::vector<std::vector<double>> arc_length_;  ///< per lane, of the nodes from end B to A

    std::vector<ElementProperties<V>> properties_;
    std::vector<PointMass<V>> masses_;
    EndPlace place_a_, place_b_;
    SlopeLaw<V> law_a_, law_b_;
    PointLaw<V> spring_a_;
    std::vector<PlacedConstraint<V>> constraints_;
    int passes_since_keep_ = 0;
    double pass_length_ = 0.0;    ///< of the pass that ended last [s]
    MotionSpline platform_;       ///< of the pass or static solution that ended last
    double current_share_ = 0.0;  ///< of the current in it, where it was one at rest
    std::array<HullMotion<V>, 2> hull_;
    std::vector<TrialNode<V>> reached_;  ///< quasi-static: last good shape on the platform's way
    std::vector<V> reached_lambda_;
    std::vector<std::vector<CatenaryElement>> hanging_;  ///< catenary: what each lane is made of
    Catenary hung_;                                      ///< catenary: workspace
    std::vector<Mat3> hanging_stiffness_;                ///< catenary: of end A, per lane [N/m]
    bool friction_on_ = true;
    Mask law_on_;             ///< lanes whose laws of slopes act
    double hold_part_ = 1.0;  ///< of the stiffness of held points, on the way to a static solution
    /// Of a static solution that is looked for: joints without an arc length take the point of the
    /// rod that comes to lie in their plane, and exert nothing along their axis.
    bool finds_points_ = false;
    /// Of small motion: guides with a gap hold the rod as if it were closed, R:49.
    bool guides_closed_ = false;
    Mask guessed_;  ///< lanes with a guess of their own
    bool has_strain_ = false, started_ = false, static_ = false;
    Mask axis_is_static_a_, axis_is_static_b_;

    RodState<V> kept_, working_;

    // Workspace of a step
    std::vector<TrialNode<V>> trial_;
    std::vector<V> lambda_;
    std::vector<Compliance<V>> material_;
    std::vector<Water<V>> water_;
    std::vector<NodeFactor<V>> factors_;
    struct Middle {
        V column[14], inverse_pivot, R;
    };
    std::vector<Middle> middles_;
    struct Correction {
        V x[7];
    };
    std::vector<Correction> correction_;
    std::vector<V> lambda_correction_;
    ElementSystem<V> element_;
    EndValues<V> end_a_, end_b_;
    Vector<V> reaction_a_, reaction_b_, moment_a_, moment_b_;
    Vector<V> found_force_a_, found_force_b_, found_moment_a_, found_moment_b_;  ///< in each lane's
                                                                                 ///< last iteration
    V correction_size_{}, correction_finite_{};  ///< largest [m]; 0, or NaN
    V last_D_[7][7], last_R_[7];                 ///< node at end A before its elimination
    NodeFactor<V> last_;  ///< its factors; of a prescribed end rows 3 to 6, from index 0
    ReactionRows rows_b_;
    ConstraintLoad<V> slope_load_a_, slope_load_b_, spring_load_a_;
    std::vector<int> slot_;  ///< place of a lane's Gauss point among the samples; -1: none
    std::vector<double> xs_, ys_, zs_, ux_, uy_, uz_, ax_, ay_, az_, eta_;
    WorkCount work_;
};

/// The value type of a pack, and one rod by itself (for tests).
using Quad = Lanes<lanes_per_pack>;
using Single = Lanes<1>;

}  // namespace hawser::worker
