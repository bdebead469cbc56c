#include <algorithm>

#include "io/result_parts.hpp"

namespace hawser::io {
namespace {

constexpr std::uint64_t chunk_bytes = 256 * 1024;

/// A chunk is whole samples, about 256 kB of them: full width, written once.
Hdf5Layout joined_layout(const SeriesField& field, std::uint64_t rows) {
    Hdf5Layout layout{
        .shape = {rows}, .single_precision = field.single_precision, .nan_fill = false};
    for (const int k : field.shape) layout.shape.push_back(static_cast<std::uint64_t>(k));
    const std::uint64_t row = static_cast<std::uint64_t>(std::max(field.width(), 1)) *
                              (field.single_precision ? sizeof(float) : sizeof(double));
    layout.chunk = layout.shape;
    layout.chunk[0] =
        std::clamp<std::uint64_t>(chunk_bytes / row, 1, std::max<std::uint64_t>(rows, 1));
    layout.deflate = true;
    return layout;
}

/// A field of the result that grows segment by segment; holds samples back until they fill a chunk.
class GrowingField {
 public:
    GrowingField(Hdf5File& file, const SeriesField& field, std::uint64_t rows)
        : path_(field.path), width_(static_cast<std::uint64_t>(field.width())) {
        const Hdf5Layout layout = joined_layout(field, rows);
        chunk_rows_ = layout.chunk.at(0);
        target_ = file.create_dataset(field.path, layout);
        target_.attribute("units", field.units);
        target_.attribute("description", field.description);
    }

    void append(const Hdf5File& segment) {
        if (!segment.exists(path_)) return;  // no tick of this clock in the segment
        const Hdf5Dataset source = segment.dataset(path_);
        const std::uint64_t rows = source.shape().at(0);
        const std::size_t before = held_.size();
        held_.resize(before + rows * width_);
        source.read_rows(0, rows, held_.data() + before);
        write(held_.size() / width_ / chunk_rows_ * chunk_rows_);
    }
    void finish() { write(held_.size() / width_); }

 private:
    void write(std::uint64_t rows) {
        if (rows == 0) return;
        target_.write_rows(written_, rows, held_.data());
        written_ += rows;
        held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(rows * width_));
    }

    std::string path_;
    std::uint64_t width_, chunk_rows_ = 1, written_ = 0;
    Hdf5Dataset target_;
    std::vector<double> held_;
};

}  // namespace

JoinedTimes joined_times(const std::vector<std::filesystem::path>& segments) {
    JoinedTimes times;
    for (const std::filesystem::path& path : segments) {
        const Hdf5File segment = Hdf5File::open(path);
        for (const auto& [name, all] :
             {std::pair{"/time", &times.sample}, std::pair{"/snapshot_time", &times.snapshot}}) {
            if (!segment.exists(name)) continue;
            const std::vector<double> more = segment.read(name);
            all->insert(all->end(), more.begin(), more.end());
        }
    }
    return times;
}

void join_fields(Hdf5File& file, const std::vector<std::filesystem::path>& segments,
                 const std::vector<SeriesField>& fields, const JoinedTimes& times) {
    std::vector<GrowingField> growing;
    growing.reserve(fields.size());
    for (const SeriesField& field : fields) {
        if (field.clock == Clock::latest) continue;
        growing.emplace_back(
            file, field,
            field.clock == Clock::sample ? times.sample.size() : times.snapshot.size());
    }
    for (const std::filesystem::path& path : segments) {
        const Hdf5File segment = Hdf5File::open(path);
        for (GrowingField& field : growing) field.append(segment);
    }
    for (GrowingField& field : growing) field.finish();
    if (segments.empty()) return;
    const Hdf5File last = Hdf5File::open(segments.back());
    for (const SeriesField& field : fields) {
        if (field.clock != Clock::latest) continue;
        std::vector<double> row(static_cast<std::size_t>(field.width()));
        last.dataset(field.path).read_rows(0, 1, row.data());
        Extent shape;
        for (const int k : field.shape) shape.push_back(static_cast<std::uint64_t>(k));
        write_numbers(file, field.path, row, shape, field.units, field.description);
    }
}

}  // namespace hawser::io
