// The finite-element mesh of a line: where its nodes lie along the unstretched arc, from end A.
#pragma once

#include <vector>

#include "case/lines.hpp"

namespace hawser {

struct LineMesh {
    std::vector<double> arc_length;    ///< of the nodes, from end A; elements + 1 values [m]
    std::vector<int> section;          ///< of each element, index into Line::sections
    std::vector<int> attachment_node;  ///< node of each attachment
    [[nodiscard]] int elements() const { return static_cast<int>(section.size()); }
};

/// Nodes of all sections. Elements of a section form a geometric row with ratio `growth` from end
/// A. An attachment is moved to the nearest node.
LineMesh mesh_of(const Line& line);

}  // namespace hawser
