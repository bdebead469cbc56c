// The door to HDF5: files, datasets, attributes as values. The only code that calls the library;
// every call is checked, and a failure is a RunError(ExitCode::io) with the call, the path and the
// library's own words. A file opened through a link of several ranks is written collectively.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::io {

class Link;

using Extent = std::vector<std::uint64_t>;

/// An open object of the library, closed with its owner.
class Hdf5Handle {
 public:
    using Close = int (*)(std::int64_t);
    Hdf5Handle() = default;
    Hdf5Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    ~Hdf5Handle() { reset(); }

    [[nodiscard]] std::int64_t id() const { return id_; }
    /// Closes now; returns false if the library could not.
    bool reset();

 private:
    std::int64_t id_ = -1;
    Close close_ = nullptr;
};

/// How a dataset of numbers is stored.
struct Hdf5Layout {
    Extent shape;
    bool single_precision = false;
    Extent chunk = {};     ///< empty: contiguous
    bool deflate = false;  ///< level 1 with shuffle; needs a chunk
    bool nan_fill = true;  ///< values never written read as NaN
};

/// A dataset of float or double whose first dimension is the sample. Values go in and out as the
/// type named; the library converts.
class Hdf5Dataset {
 public:
    [[nodiscard]] const Extent& shape() const { return shape_; }
    [[nodiscard]] bool single_precision() const { return single_precision_; }

    /// Writes samples [first, first + count), each with the product of the other dimensions.
    void write_rows(std::uint64_t first, std::uint64_t count, const double* values);
    void write_rows(std::uint64_t first, std::uint64_t count, const float* values);
    void read_rows(std::uint64_t first, std::uint64_t count, double* values) const;
    void read_rows(std::uint64_t first, std::uint64_t count, float* values) const;

    /// Collective: every sample of the given columns, which are ascending indices into the
    /// flattened sample. `values` (samples, columns). A rank without columns calls with none.
    void write_columns(const std::vector<int>& columns, const double* values);
    void write_columns(const std::vector<int>& columns, const float* values);

    /// One column of the flattened sample, all samples.
    [[nodiscard]] std::vector<double> read_column(std::uint64_t column) const;

    void attribute(const std::string& name, const std::string& value);

 private:
    friend class Hdf5File;
    void transfer_rows(bool write, std::uint64_t first, std::uint64_t count, bool single,
                       void* values) const;
    void transfer_columns(const std::vector<int>& columns, bool single, const void* values) const;

    Hdf5Handle id_;
    Extent shape_;
    bool single_precision_ = false;
    bool collective_ = false;
    std::string place_;  // "file: /path", for messages
};

/// One column of a compound table: text of fixed length, doubles or integers.
struct Hdf5Column {
    std::string name;
    std::variant<std::vector<std::string>, std::vector<double>, std::vector<std::int64_t>> values;
};

/// Equal boxes of a source and of a virtual dataset: start and count along each dimension.
struct Hdf5Box {
    Extent start, count;
};

class Hdf5File {
 public:
    Hdf5File() = default;  ///< none open
    /// Creates or truncates. With a link of more than one rank the call is collective, on all of
    /// them, and so are all calls that create or write through it.
    static Hdf5File create(const std::filesystem::path& path, const Link* link = nullptr);
    /// Opens for reading, this rank alone.
    static Hdf5File open(const std::filesystem::path& path);

    /// Flushes to disk and closes; a destructor alone cannot report what then goes wrong.
    void close();

    [[nodiscard]] bool exists(const std::string& path) const;
    [[nodiscard]] std::vector<std::string> children(const std::string& path) const;

    Hdf5Dataset create_dataset(const std::string& path, const Hdf5Layout& layout);
    [[nodiscard]] Hdf5Dataset dataset(const std::string& path) const;

    /// Whole small datasets. `shape` empty: scalar.
    void write(const std::string& path, std::span<const double> values, const Extent& shape);
    void write(const std::string& path, std::span<const std::int64_t> values, const Extent& shape);
    void write_text(const std::string& path, const std::string& text);
    void write_texts(const std::string& path, const std::vector<std::string>& texts);
    void write_table(const std::string& path, const std::vector<Hdf5Column>& columns);
    [[nodiscard]] std::vector<double> read(const std::string& path) const;
    [[nodiscard]] std::string read_text(const std::string& path) const;
    /// Texts of variable or fixed length; characters along the last dimension make one text.
    [[nodiscard]] std::vector<std::string> read_texts(const std::string& path) const;
    /// Names of the dimensions of a dataset, from its dimension scales (NetCDF-4); none without.
    [[nodiscard]] std::vector<std::string> dimensions(const std::string& path) const;

    /// A dataset of the same file that shows a box of `source`; `shape` has as many values as it.
    void write_virtual(const std::string& path, const Extent& shape, const std::string& source,
                       const Hdf5Box& box);

    /// Attributes of a group or dataset; "/" is the file's own.
    void attribute(const std::string& path, const std::string& name, const std::string& value);
    void attribute(const std::string& path, const std::string& name, std::int64_t value);
    void attribute(const std::string& path, const std::string& name, bool value);
    void attribute(const std::string& path, const std::string& name,
                   std::span<const double> values);
    [[nodiscard]] std::string text_attribute(const std::string& path,
                                             const std::string& name) const;

 private:
    Hdf5Handle create_raw(const std::string& path, std::int64_t type, std::int64_t space,
                          std::int64_t properties);
    [[nodiscard]] std::string place(const std::string& path) const;

    Hdf5Handle id_;
    std::filesystem::path path_;
    bool collective_ = false;
};

/// Version of the library, "1.10.8".
std::string hdf5_version();

}  // namespace hawser::io
