#include "synthetic_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "io/result_fields.hpp"
#include "io/series_file.hpp"
#include "line_mesh.hpp"

namespace hawser::test {
namespace {

using io::Clock;
using std::numbers::pi;

Vec3 platform_at(const Case& input, double t) {
    if (!input.platform) return Vec3::Zero();
    if (input.lines.empty()) {
        return {0.0, 0.0, 5.0 * std::exp(-0.004 * t) * std::cos(2 * pi * t / 23.7)};
    }
    return {31.0 + 6.0 * std::sin(2 * pi * t / 135.0) + 1.5 * std::sin(2 * pi * t / 15.1),  //
            0.8 * std::sin(2 * pi * t / 128.0),                                             //
            -0.6 + 1.1 * std::sin(2 * pi * t / 14.8 + 0.4)};
}

Vec3 angles_at(const Case& input, double t) {  // [deg]
    if (input.lines.empty()) return Vec3::Zero();
    return {0.05 * std::sin(2 * pi * t / 43.0), 2.4 + 1.2 * std::sin(2 * pi * t / 50.0 + 1.0),
            0.3 * std::sin(2 * pi * t / 46.0)};
}

/// A line from end A to the seabed: a parabola down to a touchdown, flat from there.
Vec3 node_at(const Case& input, const Line& line, double fraction, double t) {
    const Vec3 a = line.end_a.position + platform_at(input, t);
    const double depth = input.environment.seabed.depth;
    if (line.end_b.kind == EndKind::free) return a - Vec3(0.0, 0.0, line.length() * fraction);
    const Vec3 b(line.end_b.position.x(), line.end_b.position.y(), -depth);
    const double touch = line.family == "scr" ? 0.62 : 0.93;
    const double q = std::min(fraction / touch, 1.0);
    const double power = line.family == "scr" ? 2.6 : 1.35;
    Vec3 r = a + fraction * (b - a);
    r.z() = -depth + (a.z() + depth) * std::pow(1.0 - q, power);
    if (line.family == "scr" && fraction < touch) {  // steep at the top
        const double s = std::pow(q, 1.8) * touch;
        r.head<2>() = (a + s * (b - a)).head<2>();
    }
    return r;
}

double tension_at(const Case& input, std::size_t line, double t) {
    const Line& l = input.lines[line];
    if (!input.platform) return 60e3 + 9e3 * std::sin(2 * pi * t / 10.0);
    const double pull = -std::cos(l.azimuth) * (platform_at(input, t).x() - 10.0);
    const double base = l.family == "scr" ? 2300e3 : 2600e3;
    return base + 45e3 * pull * (l.family == "scr" ? 0.1 : 1.0) +
           60e3 * std::sin(2 * pi * t / 15.1 + static_cast<double>(line));
}

LineType type_of(const std::string& name, double mass, double diameter, double area) {
    LineType type;
    type.name = name;
    type.category = "general";
    type.mass = mass;
    type.outer_diameter = diameter;
    type.displaced_area = area;
    return type;
}

Case hull_case(double duration) {
    Case c;
    c.name = "synthetic";
    c.environment.seabed.depth = 1500.0;
    Platform p;
    p.name = "spar";
    p.draft = 175.0;
    p.members.resize(3);
    p.members[0] = {.name = "hard tank", .from = {0, 0, 19}, .to = {0, 0, -70}, .diameter = 40.0};
    p.members[1] = {.name = "truss", .from = {0, 0, -70}, .to = {0, 0, -165}, .diameter = 12.0};
    p.members[2] = {
        .name = "soft tank", .from = {0, 0, -165}, .to = {0, 0, -175}, .diameter = 40.0};
    for (const double z : {-95.0, -115.0, -135.0}) {
        Plate plate;
        plate.name = "heave plates";
        plate.position = {0, 0, z};
        plate.area = 900.0;
        p.plates.push_back(plate);
    }
    c.platform = p;
    c.output.interval = 0.5;
    c.output.platform_loads = true;
    c.analysis.dynamics.duration = duration;
    c.analysis.dynamics.statistics_from = duration / 2;
    return c;
}

}  // namespace

Case synthetic_pair(double duration) {
    Case c = synthetic_spar(duration);
    Platform tender;
    tender.name = "tender";
    tender.position = {120.0, 60.0, 0.0};
    tender.members.resize(1);
    tender.members[0] = {.name = "hull", .from = {0, 0, 15}, .to = {0, 0, -20}, .diameter = 30.0};
    c.further_platforms = {tender};
    return c;
}

Case synthetic_decay(double duration) {
    Case c = hull_case(duration);
    c.title = "Heave decay of a truss spar";
    c.analysis.dynamics.statistics_from = 0.0;
    return c;
}

Case synthetic_spar(double duration) {
    Case c = hull_case(duration);
    c.title = "Truss spar, 100-year hurricane, 1500 m";
    WaveTrain wave;
    wave.type = WaveType::jonswap;
    wave.Hs = 15.2;
    wave.Tp = 15.6;
    c.environment.waves = {wave};
    c.environment.current = Current{.heading = 0.0, .profile = {{0.0, 1.9, {}}, {75.0, 0.0, {}}}};
    c.environment.wind = Wind{.spectrum = WindSpectrum::npd, .speed = 45.0};
    c.line_types = {type_of("chain", 589.0, 0.172, 0.075), type_of("polyester", 57.1, 0.29, 0.0414),
                    type_of("scr", 230.0, 0.324, 0.0824)};
    for (int i = 0; i < 12; ++i) {
        Line line;
        line.name = "ml" + std::to_string(i + 1);
        line.family = "mooring";
        line.azimuth = (120.0 * (i / 4) + 5.0 * (i % 4 - 1.5)) * pi / 180.0;
        const Vec3 out(std::cos(line.azimuth), std::sin(line.azimuth), 0.0);
        line.end_a.kind = EndKind::platform;
        line.end_a.position = 20.5 * out - 60.0 * Vec3::UnitZ();
        line.end_b.kind = EndKind::anchor;
        line.end_b.position = 2068.0 * out - 1500.0 * Vec3::UnitZ();
        line.sections = {{0, 91.0, 2}, {1, 2286.0, 14}, {0, 122.0, 4}};
        c.lines.push_back(line);
    }
    const std::array<const char*, 4> risers{"scr_oil", "scr_gas", "scr_prod1", "scr_prod2"};
    const std::array<double, 4> azimuths{60.0, 300.0, 170.0, 190.0};
    for (std::size_t i = 0; i < 4; ++i) {
        Line line;
        line.name = risers[i];
        line.family = "scr";
        line.azimuth = azimuths[i] * pi / 180.0;
        const Vec3 out(std::cos(line.azimuth), std::sin(line.azimuth), 0.0);
        line.end_a.kind = EndKind::platform;
        line.end_a.position = 20.0 * out - 172.0 * Vec3::UnitZ();
        line.end_b.kind = EndKind::anchor;
        line.end_b.position = 1517.0 * out - 1500.0 * Vec3::UnitZ();
        line.sections = {{2, 1250.0, 12}, {2, 750.0, 16}, {2, 400.0, 4}};
        if (i == 0) {  // what a top-tensioned riser would have
            line.constraints = {{.type = ConstraintType::tensioner, .name = "ram"},
                                {.type = ConstraintType::guide, .name = "keel"}};
        }
        c.lines.push_back(line);
    }
    for (LineType& type : c.line_types) type.breaking_load = 20e6;
    c.line_types[2].wall =
        PipeWall{.outer_diameter = 0.324, .inner_diameter = 0.284, .yield = 448e6};
    c.output.snapshots = 2.0;
    LineOutput all, more;
    more.select = "ml*";
    more.end_b = true;
    more.results = {"effective_tension", "declination", "azimuth", "force"};
    LineOutput risers_too;
    risers_too.select = "scr*";
    risers_too.results = {"von_mises_stress", "touchdown", "tensioner.tension", "tensioner.stroke",
                          "guide.force"};
    risers_too.at_arc = {1480.0, 1550.0};
    risers_too.range = {"effective_tension", "von_mises_stress"};
    c.output.lines = {all, more, risers_too};
    return c;
}

Case synthetic_chain(double duration) {
    Case c;
    c.name = "synthetic";
    c.title = "Hanging chain, top moved sideways";
    c.environment.seabed.depth = 100.0;
    c.line_types = {type_of("chain", 100.0, 0.08, 0.013)};
    Line line;
    line.name = line.family = "chain";
    line.end_a.kind = EndKind::fixed;
    line.end_a.position = Vec3(0, 0, -5.0);
    line.end_b.kind = EndKind::free;
    line.sections = {{0, 60.0, 20}};
    c.lines = {line};
    c.output.interval = 0.5;
    c.output.snapshots = 1.0;
    c.output.lines = {LineOutput{}};
    c.analysis.dynamics.duration = duration;
    c.analysis.dynamics.statistics_from = duration / 4;
    return c;
}

namespace {

/// Line that a channel of line_channels belongs to.
std::size_t line_of(const Case& input, const io::LineChannel& channel) {
    const std::size_t start = channel.path.find('/', 1) + 1;
    const std::string name = channel.path.substr(start, channel.path.find('/', start) - start);
    std::size_t i = 0;
    while (input.lines[i].name != name) ++i;
    return i;
}

void put_channel(const Case& input, const io::LineChannel& channel, double t,
                 std::vector<double>& values) {
    const std::string& path = channel.path;
    const std::size_t i = line_of(input, channel);
    const double wave = std::sin(2 * pi * t / 15.1 + static_cast<double>(i));
    const double T =
        tension_at(input, i, t) * (path.find("/end_b/") == std::string::npos ? 1 : 0.85);
    if (channel.width == 3) {
        values.insert(values.end(), {T, 0.5 * T, -T});
    } else if (path.ends_with("effective_tension")) {
        values.push_back(T);
    } else if (path.ends_with("declination")) {
        values.push_back(55.0);
    } else if (path.ends_with("azimuth")) {
        values.push_back(input.lines[i].azimuth * 180 / pi);
    } else if (path.ends_with("von_mises_stress")) {
        values.push_back(90e6 + 25e6 * wave);
    } else if (path.ends_with("touchdown/arc_length")) {
        values.push_back(0.62 * input.lines[i].length() + 18.0 * wave);
    } else if (path.ends_with("/stroke")) {
        values.push_back(1.2 * wave);
    } else if (path.ends_with("/tension")) {
        values.push_back(5338e3 + 176e3 * wave);
    } else if (path.ends_with("/force")) {
        values.push_back(std::max(0.0, 300e3 * (wave - 0.6)));
    } else {
        values.push_back(wave);
    }
}

/// A `latest` field: numbers per line, or per node.
void put_latest(const Case& input, const io::SeriesField& field, std::size_t i,
                const std::vector<double>& arc, double t, std::vector<double>& values) {
    const Line& line = input.lines[i];
    const double L = line.length();
    if (field.path.starts_with("/lines/range/") && !field.path.ends_with("time_of_maximum")) {
        const bool stress = field.path.find("stress") != std::string::npos;
        const double mean = stress ? 60e6 : tension_at(input, i, 0.0);
        for (const double s : arc) {
            const double bump = std::exp(-std::pow((s / L - 0.62) / 0.05, 2));
            const double x = mean * (1.0 - 0.4 * s / L + (stress ? bump : 0.0));
            double factor = 1.0;
            if (field.path.ends_with("/max") || field.path.ends_with("/at_maximum")) factor = 1.3;
            if (field.path.ends_with("/min")) factor = 0.8;
            if (field.path.ends_with("/std")) factor = 0.1;
            values.push_back(field.path.find("/t_m") != std::string::npos ? t : factor * x);
        }
    } else if (field.path.ends_with("grounded_length")) {
        values.push_back(line.sections.back().length);
    } else if (field.path.ends_with("touchdown")) {
        values.push_back(L - line.sections.back().length);
    } else if (field.path.ends_with("declination")) {
        values.push_back(55.0);
    } else if (field.path.ends_with("slack")) {
        values.insert(values.end(), {25e3, 0.0, std::nan("")});
    } else if (field.shape.size() == 2) {
        values.insert(values.end(), {0.9 * tension_at(input, i, t), 0.25 * L, t});
    } else {
        values.push_back(0.85 * tension_at(input, i, 0.0));
    }
}

}  // namespace

void record_synthetic(const std::filesystem::path& folder, const Case& input, io::Link& link,
                      int samples_per_segment, const std::function<void(int)>& after_segment) {
    std::vector<int> nodes;
    std::vector<LineMesh> meshes;
    for (const Line& line : input.lines) {
        meshes.push_back(mesh_of(line));
        nodes.push_back(static_cast<int>(meshes.back().arc_length.size()));
    }
    io::SeriesWriter writer(folder, io::result_fields(input, nodes), link);
    const std::vector<io::LineChannel> channels = io::line_channels(input, writer.fields());

    // Everything of the platform belongs to rank 0; of the lines, whole lines to their rank.
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        if (static_cast<int>(i * 7 % static_cast<std::size_t>(link.size())) == link.rank())
            mine.push_back(i);
    }
    const auto is_mine = [&](std::size_t i) {
        return std::find(mine.begin(), mine.end(), i) != mine.end();
    };
    const int all_nodes = std::accumulate(nodes.begin(), nodes.end(), 0);
    const auto of_nodes = [&](const io::SeriesField& field) {
        return field.shape == std::vector<int>{all_nodes} || field.path == "/lines/nodes/position";
    };
    const auto is_of_lines = [](const io::SeriesField& field) {
        return field.path.starts_with("/lines") || field.path.starts_with("/statics/lines") ||
               field.path.starts_with("/constraints");
    };
    const auto is_of_constraints = [](const io::SeriesField& field) {
        return field.path.starts_with("/constraints") && field.clock == Clock::latest;
    };
    for (std::size_t f = 0; f < writer.fields().size(); ++f) {
        const io::SeriesField& field = writer.fields()[f];
        std::vector<int> columns;
        if (!is_of_lines(field) || is_of_constraints(field)) {
            for (int k = 0; k < field.width() && link.rank() == 0; ++k) columns.push_back(k);
        } else if (of_nodes(field)) {
            const int inner = field.width() / all_nodes;
            for (const std::size_t i : mine) {
                const int first =
                    inner * std::accumulate(nodes.begin(), nodes.begin() + static_cast<int>(i), 0);
                for (int k = 0; k < inner * nodes[i]; ++k) columns.push_back(first + k);
            }
        } else if (field.clock == Clock::latest) {
            const int inner = field.width() / static_cast<int>(input.lines.size());
            for (const std::size_t i : mine)
                for (int k = 0; k < inner; ++k) columns.push_back(inner * static_cast<int>(i) + k);
        } else {
            for (const io::LineChannel& channel : channels)
                for (int k = 0; k < channel.width; ++k)
                    if (channel.field == &field && is_mine(line_of(input, channel)))
                        columns.push_back(channel.column + k);
        }
        writer.provide(static_cast<int>(f), columns);
    }

    const double D = input.output.interval;
    const int steps = static_cast<int>(std::lround(input.analysis.dynamics.duration / D));
    const int every =
        input.output.snapshots ? static_cast<int>(std::lround(*input.output.snapshots / D)) : 0;
    std::vector<double> values;
    for (int step = 0; step <= steps; ++step) {
        const double t = step * D;
        writer.add_time(Clock::sample, t);
        const bool snapshot = every > 0 && step % every == 0;
        if (snapshot) writer.add_time(Clock::snapshot, t);
        for (std::size_t f = 0; f < writer.fields().size(); ++f) {
            const io::SeriesField& field = writer.fields()[f];
            if (field.clock == Clock::snapshot && !snapshot) continue;
            values.clear();
            if (field.path == "/lines/nodes/position") {
                for (const std::size_t i : mine) {
                    for (const double s : meshes[i].arc_length) {
                        const Vec3 r =
                            node_at(input, input.lines[i], s / input.lines[i].length(), t);
                        values.insert(values.end(), r.data(), r.data() + 3);
                    }
                }
            } else if (is_of_lines(field) && !is_of_constraints(field)) {
                if (field.clock == Clock::latest) {
                    for (const std::size_t i : mine)
                        put_latest(input, field, i, meshes[i].arc_length, t, values);
                } else {
                    for (const io::LineChannel& channel : channels)
                        if (channel.field == &field && is_mine(line_of(input, channel)))
                            put_channel(input, channel, t, values);
                }
            } else if (link.rank() == 0) {
                const Vec3 x = platform_at(input, t), q = angles_at(input, t);
                if (field.path.ends_with("/position")) {
                    values = {x[0], x[1], x[2], q[0], q[1], q[2]};
                } else if (field.path == "/environment/elevation") {
                    values = {5.0 * std::sin(2 * pi * t / 15.6) +
                              2.0 * std::sin(2 * pi * t / 11.3)};
                } else if (field.path == "/environment/wind_speed") {
                    values = {55.8 + 6.0 * std::sin(2 * pi * t / 71.0) +
                              2.0 * std::sin(2 * pi * t / 13.0)};
                } else if (field.clock == Clock::latest) {
                    values.assign(static_cast<std::size_t>(field.width()), 0.004);
                } else {
                    for (int k = 0; k < field.width(); ++k) values.push_back(std::sin(0.1 * t + k));
                }
            }
            writer.put(static_cast<int>(f), values);
        }
        if ((step + 1) % samples_per_segment == 0 || step == steps) {
            writer.write_segment();
            if (after_segment) after_segment(writer.segments());
        }
    }
}

io::RunRecord synthetic_record(const Case& input, int ranks) {
    io::RunRecord record;
    record.input = input;
    record.resolved = "format: 1\ntitle: " + input.title + "\n";
    record.sources = {{"synthetic.yml", "format: 1\n"}};
    record.version = "0";
    record.build = "test";
    record.command = "synthetic";
    record.ranks = ranks;
    record.complete = true;
    record.outcome = "done";
    record.statics = io::StaticState{};
    if (input.platform) {
        record.statics->platforms = {PlatformMotion{.position = platform_at(input, 0.0)}};
        record.platforms = {
            {{"mass", "t", "mass", 98434.0}, {"buoyancy", "kN", "acting buoyancy", 1017940.0}}};
        LedgerTable ledger;
        const std::vector<std::pair<std::string, Vec6>> rows{
            {"wave1", (Vec6() << 1e4, 2e3, 5e4, 1e6, 3e6, 0).finished()},
            {"drift", (Vec6() << 6.2e5, 0, 0, 0, -1e6, 2e5).finished()},
            {"radiation", (Vec6() << 0, 0, 100, 0, 0, 0).finished()},
            {"hydrostatic", (Vec6() << 0, 0, 1.0179e9, 0, -3e9, 0).finished()},
            {"weight", (Vec6() << 0, 0, -9.653e8, 0, 3.2e9, 0).finished()},
            {"members", (Vec6() << 1.2e6, 3e3, 1e4, 2e6, -8e7, 0).finished()},
            {"plates", (Vec6() << 0, 0, -2e4, 0, 5e5, 0).finished()},
            {"current", (Vec6() << 3.3e6, 0, 0, 0, -9e7, 0).finished()},
            {"wind", (Vec6() << 4.8e6, 0, 0, 0, 2.16e8, 0).finished()},
            {"damping", (Vec6() << 0, 0, 0, 0, 0, 1e3).finished()}};
        for (const auto& [name, mean] : rows)
            ledger.components.push_back(name), ledger.mean.push_back(mean);
        Vec6 lines = Vec6::Zero();
        for (const Vec6& row : ledger.mean) lines -= row;
        if (!input.lines.empty()) {
            for (const auto& [name, share] : {std::pair{"mooring", 0.9}, std::pair{"scr", 0.1}}) {
                ledger.components.emplace_back(name);
                ledger.mean.emplace_back(share * lines);
            }
        }
        for (const Vec6& row : ledger.mean) ledger.sum += row;
        ledger.residual = ledger.sum;
        ledger.from = input.analysis.dynamics.statistics_from;
        ledger.to = input.analysis.dynamics.duration;
        record.ledgers.assign(static_cast<std::size_t>(input.platform_count()), ledger);
        for (const Platform& p : input.further_platforms) {
            record.statics->platforms.push_back({.position = p.position + platform_at(input, 0.0)});
            record.platforms.push_back({{"mass", "t", "mass", 14500.0}});
        }
    }
    record.performance = {{"wall", "s", "wall time of the time loop", 12.3},
                          {"cpu_per_second", "s/s", "user CPU time per simulated second", 0.06}};
    return record;
}

}  // namespace hawser::test
