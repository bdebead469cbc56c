#include <fmt/format.h>

#include <array>
#include <numbers>

#include "io/result_fields.hpp"
#include "io/result_parts.hpp"

namespace hawser::io {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

}  // namespace

std::vector<ChannelStatistics> result_statistics(const Hdf5File& result, const Case& input,
                                                 const std::vector<SeriesField>& fields,
                                                 double from) {
    std::vector<ChannelStatistics> rows;
    const std::vector<double> time = result.read("/time");
    const auto add = [&](const std::string& channel, const std::string& units,
                         const std::string& path, std::uint64_t column) {
        const std::vector<double> x = result.dataset(path).read_column(column);
        rows.push_back({channel, units, statistics_of(time, x, from)});
    };
    for (int p = 0; p < input.platform_count(); ++p) {
        const std::string root = platform_path(input.platform_at(p));
        if (!result.exists(root + "position")) continue;
        const std::array<const char*, 6> motions{"surge", "sway", "heave", "roll", "pitch", "yaw"};
        for (std::size_t k = 0; k < 6; ++k) {
            add(root.substr(1) + motions[k], k < 3 ? "m" : "deg", root + "position", k);
        }
    }
    for (int p = 0; p < input.platform_count(); ++p)
        if (const std::string path = platform_path(input.platform_at(p)) + "elevation";
            result.exists(path))
            add(path.substr(1), "m", path, 0);
    for (const auto& [name, units] :
         {std::pair{"elevation", "m"}, std::pair{"wind_speed", "m/s"}}) {
        const std::string path = std::string("environment/") + name;
        if (result.exists("/" + path)) add(path, units, "/" + path, 0);
    }
    if (const std::string path = "/environment/elevation_of_trains"; result.exists(path))
        for (std::size_t i = 0; i < input.environment.waves.size(); ++i)
            add("environment/elevation_of_train_" + std::to_string(i + 1), "m", path, i);
    for (const LineChannel& channel : line_channels(input, fields))
        if (channel.in_statistics)
            add(channel.path.substr(1), channel.field->units, channel.field->path,
                static_cast<std::uint64_t>(channel.column));
    return rows;
}

void write_statics(Hdf5File& file, const Case& input, const StaticState& statics) {
    for (std::size_t k = 0; k < statics.platforms.size(); ++k) {
        const Platform& p = input.platform_at(static_cast<int>(k));
        const PlatformMotion& found = statics.platforms[k];
        const Vec3 x = found.position - p.position, q = degrees * found.angles;
        const std::array<double, 6> six{x[0], x[1], x[2], q[0], q[1], q[2]};
        write_numbers(file, "/statics" + platform_path(p) + "position", six, {6},
                      "m, m, m, deg, deg, deg",
                      "Equilibrium under the mean loads: surge, sway, heave, roll, pitch, yaw");
    }
    if (!statics.end_a_tension.empty()) {
        write_numbers(file, "/statics/lines/end_a/effective_tension", statics.end_a_tension,
                      {statics.end_a_tension.size()}, "N",
                      "Effective tension at end A in the equilibrium");
    }
}

void write_design_position(Hdf5File& file, const Case& input) {
    for (int k = 0; k < input.platform_count(); ++k) {
        const Platform& p = input.platform_at(k);
        const std::string group = "/platform/" + p.name;
        if (!file.exists(group) || (input.platform_count() == 1 && p.position == Vec3::Zero()))
            continue;
        file.attribute(group, "design_position", std::span(p.position.data(), 3));
    }
}

void write_platform_facts(Hdf5File& file, const Platform& platform,
                          const std::vector<Fact>& facts) {
    for (const Fact& fact : facts)
        write_numbers(file, "/statics" + platform_path(platform) + fact.name, {&fact.value, 1}, {},
                      fact.units, fact.description);
}

void write_statistics(Hdf5File& file, const std::vector<ChannelStatistics>& rows, double from) {
    std::vector<std::string> channel, unit;
    std::vector<std::int64_t> n;
    std::array<std::vector<double>, 9> v;
    for (const ChannelStatistics& row : rows) {
        const Statistics& s = row.values;
        channel.push_back(row.channel);
        unit.push_back(row.units);
        n.push_back(s.n);
        const std::array<double, 9> values{s.mean,  s.std,      s.min,      s.t_min, s.max,
                                           s.t_max, s.skewness, s.kurtosis, s.tz};
        for (std::size_t k = 0; k < values.size(); ++k) v[k].push_back(values[k]);
    }
    file.write_table("/statistics/table", {{"channel", channel},
                                           {"unit", unit},
                                           {"n", n},
                                           {"mean", v[0]},
                                           {"std", v[1]},
                                           {"min", v[2]},
                                           {"t_min", v[3]},
                                           {"max", v[4]},
                                           {"t_max", v[5]},
                                           {"skewness", v[6]},
                                           {"kurtosis", v[7]},
                                           {"tz", v[8]}});
    describe(file, "/statistics/table", "see column unit; times in s",
             fmt::format("Statistics of the samples from t = {} s on; tz: mean period of "
                         "up-crossings of the mean",
                         from));
    write_numbers(file, "/statistics/from", {&from, 1}, {}, "s", "Start of the statistics");
}

void write_ledger(Hdf5File& file, const Platform& platform, const LedgerTable& ledger) {
    const std::string root = "/ledger/" + platform.name + "/";
    const std::string units = "N, N, N, N.m, N.m, N.m";
    const std::string span =
        fmt::format(" from {} to {} s, about O, world axes", ledger.from, ledger.to);
    file.write_texts(root + "components", ledger.components);
    describe(file, root + "components", "", "Names of the rows of mean");
    std::vector<double> mean;
    for (const Vec6& row : ledger.mean) mean.insert(mean.end(), row.data(), row.data() + 6);
    write_numbers(file, root + "mean", mean, {ledger.mean.size(), 6}, units,
                  "Mean of each load component" + span);
    const auto six = [&](const char* name, const Vec6& v, const char* what) {
        write_numbers(file, root + name, {v.data(), 6}, {6}, units, what + span);
    };
    six("sum", ledger.sum, "Sum of the components");
    six("momentum", ledger.momentum, "Mean of mass x acceleration, from the change of momentum");
    six("residual", ledger.residual, "Sum of the components - mass x acceleration");
}

}  // namespace hawser::io
