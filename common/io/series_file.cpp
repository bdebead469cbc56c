#include "io/series_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "io/files.hpp"
#include "io/hdf5.hpp"
#include "io/link.hpp"
#include "io/run_folder.hpp"
#include "status.hpp"

namespace hawser::io {
namespace fs = std::filesystem;
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool is_segment(const fs::path& path, const char* ending) {
    const std::string name = path.filename().string();
    return name.starts_with("segment_") && name.ends_with(ending);
}

}  // namespace

SeriesWriter::SeriesWriter(fs::path folder, std::vector<SeriesField> fields, Link& link)
    : folder_(std::move(folder)),
      fields_(std::move(fields)),
      link_(link),
      buffers_(fields_.size()) {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        index_[fields_[i].path] = static_cast<int>(i);
    }
    if (link_.rank() != 0) return;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        if (is_segment(entry.path(), ".h5.part")) fs::remove(entry.path());
    }
    if (error) {
        throw RunError(ExitCode::io, fmt::format("{}: {}", folder_.string(), error.message()));
    }
}

int SeriesWriter::find(const std::string& path) const {
    const auto it = index_.find(path);
    return it == index_.end() ? -1 : it->second;
}

void SeriesWriter::provide(int field, std::vector<int> columns) {
    Buffer& buffer = buffers_.at(static_cast<std::size_t>(field));
    std::vector<int> by_column(columns.size());
    std::iota(by_column.begin(), by_column.end(), 0);
    std::sort(by_column.begin(), by_column.end(), [&](int a, int b) {
        return columns[static_cast<std::size_t>(a)] < columns[static_cast<std::size_t>(b)];
    });
    buffer.order.resize(columns.size());
    for (std::size_t k = 0; k < by_column.size(); ++k) {
        buffer.order[static_cast<std::size_t>(by_column[k])] = static_cast<int>(k);
    }
    std::sort(columns.begin(), columns.end());
    assert(std::adjacent_find(columns.begin(), columns.end()) == columns.end());
    assert(columns.empty() || columns.back() < fields_[static_cast<std::size_t>(field)].width());
    buffer.columns = std::move(columns);
    if (fields_[static_cast<std::size_t>(field)].clock == Clock::latest)
        buffer.values.assign(buffer.columns.size(), not_a_number);
}

void SeriesWriter::reserve(int samples, int snapshots) {
    sample_times_.reserve(static_cast<std::size_t>(samples));
    snapshot_times_.reserve(static_cast<std::size_t>(snapshots));
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (fields_[i].clock == Clock::latest) continue;
        const int rows = fields_[i].clock == Clock::sample ? samples : snapshots;
        const std::size_t n = static_cast<std::size_t>(rows) * buffers_[i].columns.size();
        if (fields_[i].single_precision) {
            buffers_[i].singles.reserve(n);
        } else {
            buffers_[i].values.reserve(n);
        }
    }
}

void SeriesWriter::add_time(Clock clock, double t) {
    times(clock).push_back(t);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (fields_[i].clock != clock) continue;
        Buffer& b = buffers_[i];
        if (fields_[i].single_precision) {
            b.singles.resize(b.singles.size() + b.columns.size(),
                             std::numeric_limits<float>::quiet_NaN());
        } else {
            b.values.resize(b.values.size() + b.columns.size(), not_a_number);
        }
    }
}

void SeriesWriter::put(int field, std::span<const double> values) {
    Buffer& b = buffers_[static_cast<std::size_t>(field)];
    const std::size_t n = b.columns.size();
    assert(values.size() == n);
    if (fields_[static_cast<std::size_t>(field)].single_precision) {
        float* row = b.singles.data() + (b.singles.size() - n);
        for (std::size_t k = 0; k < n; ++k) row[b.order[k]] = static_cast<float>(values[k]);
    } else {
        double* row = b.values.data() + (b.values.size() - n);
        for (std::size_t k = 0; k < n; ++k) row[b.order[k]] = values[k];
    }
}

int SeriesWriter::pending() const {
    return static_cast<int>(sample_times_.size() + snapshot_times_.size());
}

std::uint64_t SeriesWriter::bytes_per(Clock clock) const {
    std::uint64_t bytes = sizeof(double);  // the time itself
    for (const SeriesField& field : fields_) {
        if (field.clock != clock) continue;
        bytes += static_cast<std::uint64_t>(field.width()) *
                 (field.single_precision ? sizeof(float) : sizeof(double));
    }
    return bytes;
}

void SeriesWriter::write_segment() {
    if (pending() == 0) return;
    const fs::path path = folder_ / fmt::format("segment_{:05d}.h5", segments_ + 1);
    Hdf5File file;  // outlives the failure: closing it would wait for ranks that are elsewhere
    try {
        file = Hdf5File::create(part_of(path), &link_);
        write_pending(file);
        file.close();
        link_.barrier();
        if (link_.rank() == 0) publish(path);
        link_.barrier();
    } catch (const RunError& error) {
        if (!link_.alone()) leave_status(error);
        link_.fail(error.code(), error.what());  // alone: throws on; else ends all ranks
    }
    ++segments_;
    saved_to_ = last_time();
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (fields_[i].clock == Clock::latest) continue;
        buffers_[i].values.clear();
        buffers_[i].singles.clear();
    }
    sample_times_.clear();
    snapshot_times_.clear();
}

double SeriesWriter::last_time() const {
    double t = saved_to_;
    if (!sample_times_.empty()) t = std::max(t, sample_times_.back());
    if (!snapshot_times_.empty()) t = std::max(t, snapshot_times_.back());
    return t;
}

void SeriesWriter::leave_status(const RunError& error) const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began_;
    try {
        write_status(folder_, {.state = RunState::State::failed,
                               .exit_code = error.code(),
                               .message = error.what(),
                               .t = last_time(),
                               .saved_to = saved_to_,
                               .wall_s = wall.count()});
    } catch (const RunError&) {
        // A full disk may not even take this; the message on the screen remains.
    }
}

void SeriesWriter::write_pending(Hdf5File& file) {
    for (const Clock clock : {Clock::sample, Clock::snapshot}) {
        const std::vector<double>& t = times(clock);
        if (t.empty()) continue;
        const char* name = clock == Clock::sample ? "/time" : "/snapshot_time";
        Hdf5Dataset data = file.create_dataset(name, {.shape = {t.size()}, .nan_fill = false});
        data.attribute("units", "s");
        // All ranks know the time: rank 0 writes it.
        data.write_columns(link_.rank() == 0 ? std::vector<int>{0} : std::vector<int>{}, t.data());
    }
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const SeriesField& field = fields_[i];
        const std::size_t rows = field.clock == Clock::latest ? 1 : times(field.clock).size();
        if (rows == 0) continue;
        Extent shape{rows};
        for (const int k : field.shape) shape.push_back(static_cast<std::uint64_t>(k));
        Hdf5Dataset data = file.create_dataset(
            field.path, {.shape = shape, .single_precision = field.single_precision});
        data.attribute("units", field.units);
        data.attribute("description", field.description);
        if (field.single_precision) {
            data.write_columns(buffers_[i].columns, buffers_[i].singles.data());
        } else {
            data.write_columns(buffers_[i].columns, buffers_[i].values.data());
        }
    }
}

std::vector<fs::path> segment_files(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (is_segment(entry.path(), ".h5")) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace hawser::io
