// Time series while a run lasts: every rank collects samples of the columns it owns; from time to
// time all write them together into a segment file that is closed, synced and renamed, so that
// whatever was reported as saved can be read after any crash.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "status.hpp"

namespace hawser::io {

class Hdf5File;
class Link;

/// Which clock a field ticks on: `/time` or `/snapshot_time`; or none: of `latest` each segment
/// holds what was put last, and the joined result what the last segment has.
enum class Clock { sample, snapshot, latest };

/// A result that is recorded over time. All ranks declare the same fields in the same order.
struct SeriesField {
    std::string path;  ///< in the result file, e.g. /lines/end_a/effective_tension
    std::string units, description;
    std::vector<int> shape;  ///< of one sample; empty: a number
    Clock clock = Clock::sample;
    bool single_precision = false;

    /// Numbers in one sample.
    [[nodiscard]] int width() const {
        int n = 1;
        for (const int k : shape) n *= k;
        return n;
    }
};

/// A segment holds at most so many samples and snapshots.
inline constexpr int segment_samples = 256;

class SeriesWriter {
 public:
    /// Removes unfinished segments (*.h5.part) of an earlier run from `folder`.
    SeriesWriter(std::filesystem::path folder, std::vector<SeriesField> fields, Link& link);

    /// Index of a field, -1 if it is not recorded.
    [[nodiscard]] int find(const std::string& path) const;
    [[nodiscard]] const std::vector<SeriesField>& fields() const { return fields_; }

    /// Declares that this rank provides these columns of a field (indices into the flattened
    /// sample, in the order `put` will give them). Columns that no rank provides read as NaN.
    void provide(int field, std::vector<int> columns);
    /// Memory for so many samples between segments; after it no sample allocates.
    void reserve(int samples, int snapshots);

    /// Opens the next sample of a clock; every rank calls it, with the same t [s].
    void add_time(Clock clock, double t);
    /// This rank's columns of a field at the time just added, or its latest. Columns not put are
    /// NaN.
    void put(int field, std::span<const double> values);

    /// Collective: writes all pending samples as one segment. When it returns they are on disk
    /// under their final name. Without pending samples it does nothing. A failure is a RunError
    /// alone; among several ranks it leaves its message in status.json and ends them all.
    void write_segment();

    /// Samples and snapshots not yet written.
    [[nodiscard]] int pending() const;
    /// Time up to which everything can be read back [s]; 0 before the first segment.
    [[nodiscard]] double saved_to() const { return saved_to_; }
    [[nodiscard]] int segments() const { return segments_; }
    /// Bytes that one sample, one snapshot of all ranks take in a segment.
    [[nodiscard]] std::uint64_t bytes_per(Clock clock) const;

 private:
    void write_pending(Hdf5File& file);
    /// status.json says that the run failed: with several ranks nobody else can any more.
    void leave_status(const RunError& error) const;
    [[nodiscard]] double last_time() const;
    struct Buffer {
        std::vector<int> order;    // where value k of a put goes among the ascending columns
        std::vector<int> columns;  // ascending
        std::vector<double> values;
        std::vector<float> singles;  // instead of values in single precision
    };
    [[nodiscard]] std::vector<double>& times(Clock clock) {
        return clock == Clock::sample ? sample_times_ : snapshot_times_;
    }

    std::filesystem::path folder_;
    std::vector<SeriesField> fields_;
    std::unordered_map<std::string, int> index_;
    Link& link_;
    std::vector<Buffer> buffers_;
    std::vector<double> sample_times_, snapshot_times_;
    int segments_ = 0;
    double saved_to_ = 0.0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// Segment files of a run's folder, in order of time.
std::vector<std::filesystem::path> segment_files(const std::filesystem::path& folder);

}  // namespace hawser::io
