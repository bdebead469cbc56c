#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "io/result_parts.hpp"

namespace hawser::io {
namespace {

/// Members and plates of one hull, under `root`.
void write_hull(Hdf5File& file, const Platform& platform, const std::string& root) {
    std::vector<double> ends, diameters, plates, areas;
    for (const Member& m : platform.members) {
        ends.insert(ends.end(), m.from.data(), m.from.data() + 3);
        ends.insert(ends.end(), m.to.data(), m.to.data() + 3);
        diameters.push_back(m.diameter);
    }
    for (const Plate& p : platform.plates) {
        plates.insert(plates.end(), p.position.data(), p.position.data() + 3);
        areas.push_back(p.area);
    }
    write_numbers(file, root + "member_ends", ends, {diameters.size(), 2, 3}, "m",
                  "Ends of the hull's members, platform axes");
    write_numbers(file, root + "member_diameter", diameters, {diameters.size()}, "m",
                  "Diameters of the hull's members");
    write_numbers(file, root + "plate_position", plates, {areas.size(), 3}, "m",
                  "Centres of the heave plates, platform axes");
    write_numbers(file, root + "plate_area", areas, {areas.size()}, "m2",
                  "Areas of the heave plates");
}

/// Where hull and seabed are, for pictures.
void write_geometry(Hdf5File& file, const Case& input) {
    const std::string root = "/input/geometry/";
    write_numbers(file, root + "seabed_depth", {&input.environment.seabed.depth, 1}, {}, "m",
                  "Still-water depth at the origin");
    const double slope = input.environment.seabed.slope_angle * 180.0 / M_PI;
    const double towards = input.environment.seabed.slope_direction * 180.0 / M_PI;
    write_numbers(file, root + "seabed_slope", {&slope, 1}, {}, "deg", "Slope of the seabed");
    write_numbers(file, root + "seabed_rises_towards", {&towards, 1}, {}, "deg",
                  "Heading in which the seabed rises");
    for (int k = 0; k < input.platform_count(); ++k) {
        const Platform& p = input.platform_at(k);
        write_hull(file, p, input.platform_count() > 1 ? root + p.name + "/" : root);
    }
}

}  // namespace

void write_input(Hdf5File& file, const RunRecord& record) {
    file.write_text("/input/case", record.resolved);
    describe(file, "/input/case", "", "The case as run, every default filled in");
    for (const auto& [name, text] : record.sources) {
        std::string key = name;
        std::replace(key.begin(), key.end(), '/', '_');
        const std::string path = "/input/files/" + key;
        if (file.exists(path)) continue;
        file.write_text(path, text);
        describe(file, path, "", "Source " + name);
    }
    write_geometry(file, record.input);
}

void write_root(Hdf5File& file, const RunRecord& record) {
    for (const Adjustment& a : record.adjustments)
        file.attribute("/", "adjusted_" + record.input.lines[static_cast<std::size_t>(a.line)].name,
                       note_of(a, record.input));
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    file.attribute("/", "program", std::string("hawser"));
    file.attribute("/", "version", record.version);
    file.attribute("/", "build", record.build);
    file.attribute("/", "build_host", std::string(host.data()));
    file.attribute("/", "format", std::int64_t{1});
    file.attribute("/", "title", record.input.title);
    file.attribute("/", "created",
                   fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
    file.attribute("/", "command", record.command);
    file.attribute("/", "ranks", std::int64_t{record.ranks});
    file.attribute("/", "complete", record.complete);
}

}  // namespace hawser::io
