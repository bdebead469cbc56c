#include "packing.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "line_mesh.hpp"

namespace hawser {

namespace {

/// What makes the work of one constraint.
struct ConstraintLayout {
    ConstraintType type;
    bool gap;  ///< of a slider: contact instead of a spring
    std::size_t path, cylinders;
    int other;  ///< of a tie: which line of the bundle; -1: none
    int hull;   ///< which of the line's platforms
    bool operator==(const ConstraintLayout&) const = default;
};

struct Layout {
    LineModel model;
    int elements;
    EndKind end_a, end_b;
    Joint joint_a, joint_b;
    std::vector<int> attachment_nodes;
    std::vector<ConstraintLayout> constraints;
    int first, second, hull_a, hull_b;  ///< platforms of the line, and which of them the ends have
    bool operator==(const Layout&) const = default;
};

Layout layout_of(const Line& line, const std::vector<int>& bundle, LineModel usual,
                 const Touched& touched) {
    const LineMesh mesh = mesh_of(line);
    std::vector<ConstraintLayout> constraints;
    for (const LineConstraint& c : line.constraints)
        constraints.push_back(
            {c.type, c.type == ConstraintType::slider && c.gap > 0.0, c.path.size(),
             c.cylinders.size(),
             c.other_line < 0
                 ? -1
                 : static_cast<int>(std::lower_bound(bundle.begin(), bundle.end(), c.other_line) -
                                    bundle.begin()),
             touched.place_of(c.platform)});
    return {.model = line.model.value_or(usual),
            .elements = mesh.elements(),
            .end_a = line.end_a.kind,
            .end_b = line.end_b.kind,
            .joint_a = line.end_a.joint,
            .joint_b = line.end_b.joint,
            .attachment_nodes = mesh.attachment_node,
            .constraints = std::move(constraints),
            .first = touched.first,
            .second = touched.second,
            .hull_a = touched.place_of(line.end_a.platform),
            .hull_b = touched.place_of(line.end_b.platform)};
}

/// Work of a line in element steps per simulated second; a pack steps at its slowest. Four passes
/// per platform step D run dynamic lines over 3 D; quasi-static ones take some five solves each.
double cost_of(const Layout& layout, double step, double D) {
    constexpr double passes = 4.0, solves = 5.0, run = 3.0;
    const double dynamic = layout.elements / step;
    if (layout.model == LineModel::dynamic) return dynamic;
    const double still = layout.elements * passes * solves / (run * D);
    return layout.model == LineModel::quasi_static ? still : still / 10.0;
}

}  // namespace

std::vector<std::vector<int>> bundles_of(const Case& input) {
    const int count = static_cast<int>(input.lines.size());
    std::vector<int> first(input.lines.size());  // lowest line of each line's bundle
    std::iota(first.begin(), first.end(), 0);
    for (int i = 0; i < count; ++i) {
        for (const LineConstraint& c : input.lines[static_cast<std::size_t>(i)].constraints) {
            if (c.other_line < 0) continue;
            const int a = first[static_cast<std::size_t>(i)],
                      b = first[static_cast<std::size_t>(c.other_line)];
            std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
        }
    }
    std::vector<std::vector<int>> bundles;
    for (int i = 0; i < count; ++i) {
        if (first[static_cast<std::size_t>(i)] != i) continue;
        bundles.emplace_back();
        for (int k = i; k < count; ++k)
            if (first[static_cast<std::size_t>(k)] == i) bundles.back().push_back(k);
    }
    return bundles;
}

std::vector<Touched> touched_platforms(const Case& input) {
    std::vector<Touched> out(input.lines.size());
    for (const std::vector<int>& bundle : bundles_of(input)) {
        Touched its;
        bool any = false;
        const auto touch = [&](int platform) {
            if (!any)
                its.first = platform;
            else if (platform != its.first && !its.two())
                its.second = platform;
            any = true;
        };
        for (const int i : bundle) {
            const Line& line = input.lines[static_cast<std::size_t>(i)];
            if (line.end_a.kind == EndKind::platform) touch(line.end_a.platform);
            if (line.end_b.kind == EndKind::platform) touch(line.end_b.platform);
            for (const LineConstraint& c : line.constraints)
                if (c.on_platform && c.other_line < 0) touch(c.platform);
        }
        for (const int i : bundle) out[static_cast<std::size_t>(i)] = its;
    }
    return out;
}

bool joins_platforms(const Case& input) {
    const std::vector<Touched> all = touched_platforms(input);
    return std::any_of(all.begin(), all.end(), [](const Touched& t) { return t.two(); });
}

std::vector<Pack> packs_of(const Case& input) {
    struct Group {
        std::vector<Layout> layouts;  ///< of the bundle's lines
        std::vector<std::vector<int>> bundles;
    };
    std::vector<Group> groups;
    const std::vector<Touched> touched = touched_platforms(input);
    for (const std::vector<int>& bundle : bundles_of(input)) {
        std::vector<Layout> layouts;
        layouts.reserve(bundle.size());
        for (const int i : bundle)
            layouts.push_back(layout_of(input.lines[static_cast<std::size_t>(i)], bundle,
                                        input.analysis.dynamics.line_model,
                                        touched[static_cast<std::size_t>(i)]));
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return g.layouts == layouts && g.bundles.size() < lanes_per_pack;
        });
        if (group == groups.end())
            groups.push_back({std::move(layouts), {bundle}});
        else
            group->bundles.push_back(bundle);
    }
    const Dynamics& dynamics = input.analysis.dynamics;
    std::vector<Pack> packs;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        double step = dynamics.line_step;  // of the group: the shortest of its lines'
        for (const std::vector<int>& bundle : groups[g].bundles)
            for (const int i : bundle)
                step = std::min(step,
                                input.lines[static_cast<std::size_t>(i)].time_step.value_or(step));
        for (std::size_t k = 0; k < groups[g].layouts.size(); ++k) {
            Pack pack{.lines = {},
                      .cost = cost_of(groups[g].layouts[k], step, dynamics.platform_step),
                      .group = static_cast<int>(g)};
            for (const std::vector<int>& bundle : groups[g].bundles)
                pack.lines.push_back(bundle[k]);
            packs.push_back(std::move(pack));
        }
    }
    return packs;
}

std::vector<int> assign(const std::vector<Pack>& packs, int workers) {
    std::vector<double> cost;  // of the groups
    for (const Pack& pack : packs) {
        cost.resize(static_cast<std::size_t>(pack.group) + 1, 0.0);
        cost.back() += pack.cost;
    }
    std::vector<std::size_t> order(cost.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
    std::vector<double> load(static_cast<std::size_t>(workers), 0.0);
    std::vector<int> of_group(cost.size(), 0);
    for (const std::size_t g : order) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += cost[g];
        of_group[g] = static_cast<int>(least - load.begin());
    }
    std::vector<int> worker;
    worker.reserve(packs.size());
    for (const Pack& pack : packs) worker.push_back(of_group[static_cast<std::size_t>(pack.group)]);
    return worker;
}

}  // namespace hawser
