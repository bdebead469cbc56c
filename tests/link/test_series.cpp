// Series written by 1, 2, 3 ranks together: the same data whatever the rank count, and every
// segment that was reported as written is readable.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "io/hdf5.hpp"
#include "io/series_file.hpp"
#include "ranks.hpp"

namespace {

std::atomic<std::size_t> allocations = 0;

}  // namespace

void* operator new(std::size_t n) {
    ++allocations;
    if (void* p = std::malloc(n > 0 ? n : 1)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace {

using namespace hawser::io;
namespace fs = std::filesystem;

// An empty folder, the same on all ranks of this job; removed with the object. Collective.
class SharedFolder {
 public:
    explicit SharedFolder(const std::string& name) {
        const Link& link = hawser::test::ranks();
        std::string text =
            (fs::temp_directory_path() / ("hawser_" + name + "_" + std::to_string(::getpid())))
                .string();
        link.broadcast(text);
        path = text;
        if (link.rank() == 0) fs::create_directories(path);
        link.barrier();
    }
    SharedFolder(const SharedFolder&) = delete;
    SharedFolder& operator=(const SharedFolder&) = delete;
    ~SharedFolder() {
        hawser::test::ranks().barrier();
        if (hawser::test::ranks().rank() == 0) fs::remove_all(path);
    }
    fs::path path;
};

// A value that tells field, time and column, with all 53 bits in use.
[[gnu::noinline]] double value_of(int field, double t, int column) {
    return std::sin(1.0 + field + 0.37 * t) / (column + 3.0);
}

std::vector<SeriesField> some_fields() {
    return {{"/platform/spar/position", "m", "six motions", {6}},
            {"/lines/end_a/effective_tension", "N", "tension", {16}},
            {"/lines/end_a/force", "N", "force", {16, 3}},
            {"/lines/nodes/position", "m", "nodes", {101, 3}, Clock::snapshot, true},
            {"/environment/elevation", "m", "elevation", {}}};
}

// Columns of a field that a rank owns: whole lines dealt out like cards, so scattered, and handed
// over in descending order.
std::vector<int> columns_of(const SeriesField& field, int rank, int size) {
    std::vector<int> columns;
    if (field.path.starts_with("/lines")) {
        const int inner = field.shape.size() > 1 ? field.shape[1] : 1;
        for (int line = field.shape[0]; line-- > 0;) {
            if ((line * 7) % size != rank || line == 5) continue;  // line 5 belongs to nobody
            for (int k = 0; k < inner; ++k) columns.push_back(line * inner + k);
        }
    } else if (rank == 0) {
        for (int k = field.width(); k-- > 0;) columns.push_back(k);
    }
    return columns;
}

void write_some(const fs::path& folder, int segments) {
    Link& link = hawser::test::ranks();
    SeriesWriter writer(folder, some_fields(), link);
    std::vector<std::vector<int>> columns;
    for (std::size_t f = 0; f < writer.fields().size(); ++f) {
        columns.push_back(columns_of(writer.fields()[f], link.rank(), link.size()));
        writer.provide(static_cast<int>(f), columns.back());
    }
    std::vector<double> values;
    for (int s = 0; s < segments; ++s) {
        for (int i = 0; i < 10; ++i) {
            const double t = 0.5 * (10 * s + i);
            writer.add_time(Clock::sample, t);
            if (i % 4 == 0) writer.add_time(Clock::snapshot, t);
            for (std::size_t f = 0; f < columns.size(); ++f) {
                if (writer.fields()[f].clock == Clock::snapshot && i % 4 != 0) continue;
                values.clear();
                for (const int c : columns[f])
                    values.push_back(value_of(static_cast<int>(f), t, c));
                writer.put(static_cast<int>(f), values);
            }
        }
        writer.write_segment();
        EXPECT_EQ(writer.saved_to(), 0.5 * (10 * s + 9));
        EXPECT_EQ(writer.pending(), 0);
    }
}

// Every value is the one that was put, so the data do not depend on the number of ranks.
TEST(Series, HoldsEveryValueOfScatteredColumnsForAnyRankCount) {
    const SharedFolder shared("series");
    const fs::path& folder = shared.path;
    write_some(folder, 3);
    hawser::test::ranks().barrier();
    const std::vector<fs::path> files = segment_files(folder);
    ASSERT_EQ(files.size(), 3u);
    for (std::size_t s = 0; s < files.size(); ++s) {
        const Hdf5File file = Hdf5File::open(files[s]);
        const std::vector<double> time = file.read("/time"), snaps = file.read("/snapshot_time");
        ASSERT_EQ(time.size(), 10u);
        ASSERT_EQ(snaps.size(), 3u);
        const std::vector<SeriesField> fields = some_fields();
        for (std::size_t f = 0; f < fields.size(); ++f) {
            const std::vector<double>& clock = fields[f].clock == Clock::sample ? time : snaps;
            const std::vector<double> data = file.read(fields[f].path);
            const int width = fields[f].width();
            ASSERT_EQ(data.size(), clock.size() * static_cast<std::size_t>(width));
            const int inner = fields[f].shape.size() > 1 ? fields[f].shape[1] : 1;
            for (std::size_t i = 0; i < clock.size(); ++i) {
                for (int c = 0; c < width; ++c) {
                    const double got =
                        data[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)];
                    double put = value_of(static_cast<int>(f), clock[i], c);
                    if (fields[f].single_precision) put = static_cast<float>(put);
                    if (fields[f].path.starts_with("/lines") && c / inner == 5) {
                        ASSERT_TRUE(std::isnan(got)) << fields[f].path << " column " << c;
                    } else {
                        ASSERT_EQ(got, put) << fields[f].path << " sample " << i << " column " << c;
                    }
                }
            }
        }
    }
}

TEST(Series, IsNotAllocatedAgainOnceReserved) {
    Link& link = hawser::test::ranks();
    const SharedFolder shared("reserved");
    const fs::path& folder = shared.path;
    SeriesWriter writer(folder, some_fields(), link);
    writer.provide(0, columns_of(writer.fields()[0], link.rank(), link.size()));
    writer.reserve(100, 10);
    const std::vector<double> six(link.rank() == 0 ? 6 : 0, 1.0);
    const std::size_t before = allocations.load();
    for (int i = 0; i < 100; ++i) {
        writer.add_time(Clock::sample, i);
        writer.put(0, six);
    }
    EXPECT_EQ(allocations.load(), before);
}

// A finished segment survives; a half-written one of an earlier run is removed at the start.
TEST(Series, RemovesUnfinishedSegmentsOfAnEarlierRun) {
    Link& link = hawser::test::ranks();
    const SharedFolder shared("leftover");
    const fs::path& folder = shared.path;
    if (link.rank() == 0) std::ofstream(folder / "segment_00007.h5.part") << "half";
    link.barrier();
    SeriesWriter writer(folder, some_fields(), link);
    link.barrier();
    EXPECT_FALSE(fs::exists(folder / "segment_00007.h5.part"));
}

}  // namespace
