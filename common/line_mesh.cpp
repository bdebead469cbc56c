#include "line_mesh.hpp"

#include <cmath>
#include <cstddef>

namespace hawser {

LineMesh mesh_of(const Line& line) {
    LineMesh mesh;
    mesh.arc_length.push_back(0.0);
    double start = 0.0;
    for (std::size_t j = 0; j < line.sections.size(); ++j) {
        const Section& section = line.sections[j];
        double weight_sum = 0.0;
        for (int e = 0; e < section.elements; ++e) weight_sum += std::pow(section.growth, e);
        double before = 0.0;
        for (int e = 0; e < section.elements; ++e) {
            before += std::pow(section.growth, e);
            mesh.arc_length.push_back(start + section.length * before / weight_sum);
            mesh.section.push_back(static_cast<int>(j));
        }
        start += section.length;
        mesh.arc_length.back() = start;  // the joint lies exactly where the sections meet
    }
    for (const Attachment& attachment : line.attachments) {
        int nearest = 0;
        for (std::size_t n = 0; n < mesh.arc_length.size(); ++n) {
            if (std::abs(mesh.arc_length[n] - attachment.arc_length) <
                std::abs(mesh.arc_length[static_cast<std::size_t>(nearest)] -
                         attachment.arc_length))
                nearest = static_cast<int>(n);
        }
        mesh.attachment_node.push_back(nearest);
    }
    return mesh;
}

}  // namespace hawser
