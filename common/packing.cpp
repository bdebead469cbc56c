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
    bool operator==(const ConstraintLayout&) const = default;
};

struct Layout {
    LineModel model;
    int elements;
    EndKind end_a, end_b;
    Joint joint_a, joint_b;
    std::vector<int> attachment_nodes;
    std::vector<ConstraintLayout> constraints;
    bool operator==(const Layout&) const = default;
};

Layout layout_of(const Line& line, LineModel usual) {
    const LineMesh mesh = mesh_of(line);
    std::vector<ConstraintLayout> constraints;
    for (const LineConstraint& c : line.constraints)
        constraints.push_back({c.type, c.type == ConstraintType::slider && c.gap > 0.0,
                               c.path.size(), c.cylinders.size()});
    return {.model = line.model.value_or(usual),
            .elements = mesh.elements(),
            .end_a = line.end_a.kind,
            .end_b = line.end_b.kind,
            .joint_a = line.end_a.joint,
            .joint_b = line.end_b.joint,
            .attachment_nodes = mesh.attachment_node,
            .constraints = std::move(constraints)};
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

std::vector<Pack> packs_of(const Case& input) {
    std::vector<Pack> packs;
    std::vector<Layout> layouts;
    for (int i = 0; i < static_cast<int>(input.lines.size()); ++i) {
        const Line& line = input.lines[static_cast<std::size_t>(i)];
        const Layout layout = layout_of(line, input.analysis.dynamics.line_model);
        std::size_t p = 0;
        while (p < packs.size() &&
               !(layouts[p] == layout && packs[p].lines.size() < lanes_per_pack))
            ++p;
        if (p == packs.size()) {
            packs.push_back({});
            layouts.push_back(layout);
        }
        packs[p].lines.push_back(i);
        const double step = std::min(line.time_step.value_or(input.analysis.dynamics.line_step),
                                     input.analysis.dynamics.line_step);
        packs[p].cost =
            std::max(packs[p].cost, cost_of(layout, step, input.analysis.dynamics.platform_step));
    }
    return packs;
}

std::vector<int> assign(const std::vector<Pack>& packs, int workers) {
    std::vector<std::size_t> order(packs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return packs[a].cost > packs[b].cost; });
    std::vector<double> load(static_cast<std::size_t>(workers), 0.0);
    std::vector<int> worker(packs.size(), 0);
    for (const std::size_t p : order) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += packs[p].cost;
        worker[p] = static_cast<int>(least - load.begin());
    }
    return worker;
}

}  // namespace hawser
