#include "io/hdf5.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "io/link.hpp"
#include "io/link_mpi.hpp"
#include "status.hpp"

namespace hawser::io {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// What the library says: the innermost description of its error stack and the call it stood in.
std::string library_words() {
    std::string words;
    const auto take = [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
        if (depth == 0 && error->desc != nullptr) {
            *static_cast<std::string*>(out) = fmt::format("{} ({})", error->desc, error->func_name);
        }
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &words);
    H5Eclear2(H5E_DEFAULT);
    std::erase(words, '\n');
    if (const std::size_t addresses = words.find(", buf = "); addresses != std::string::npos) {
        words.erase(addresses, words.rfind(" (") - addresses);
    }
    return words.empty() ? "no further words from HDF5" : words;
}

[[noreturn]] void fail(const char* call, const std::string& place) {
    throw RunError(ExitCode::io, fmt::format("{}: {}: {}", place, call, library_words()));
}

/// The result of a call, checked: HDF5 says failure with a negative number.
template <class T>
T checked(T result, const char* call, const std::string& place) {
    if (result < 0) fail(call, place);
    return result;
}

// Closers of the library as functions of one type.
int close_file(std::int64_t id) { return H5Fclose(id); }
int close_group(std::int64_t id) { return H5Gclose(id); }
int close_dataset(std::int64_t id) { return H5Dclose(id); }
int close_space(std::int64_t id) { return H5Sclose(id); }
int close_type(std::int64_t id) { return H5Tclose(id); }
int close_properties(std::int64_t id) { return H5Pclose(id); }
int close_attribute(std::int64_t id) { return H5Aclose(id); }
int close_object(std::int64_t id) { return H5Oclose(id); }

/// Before the first call: errors are reported by RunError alone, not printed by the library as
/// well, and the library does not tidy up when the program ends: everything is closed by its owner,
/// and what could not be closed because the disk is full would crash it there (seen with 1.10.8).
void prepare_library() {
    static const bool prepared = [] {
        H5dont_atexit();
        return true;
    }();
    (void)prepared;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Handle properties(hid_t cls, const std::string& place) {
    return {checked(H5Pcreate(cls), "H5Pcreate", place), close_properties};
}

Hdf5Handle space_of(const Extent& shape, const std::string& place) {
    if (shape.empty()) return {checked(H5Screate(H5S_SCALAR), "H5Screate", place), close_space};
    const std::vector<hsize_t> dims(shape.begin(), shape.end());
    return {checked(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr),
                    "H5Screate_simple", place),
            close_space};
}

Hdf5Handle file_space(const Hdf5Handle& dataset, const std::string& place) {
    return {checked(H5Dget_space(dataset.id()), "H5Dget_space", place), close_space};
}

Extent extent_of(const Hdf5Handle& space, const std::string& place) {
    const int rank =
        checked(H5Sget_simple_extent_ndims(space.id()), "H5Sget_simple_extent_ndims", place);
    std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
    checked(H5Sget_simple_extent_dims(space.id(), dims.data(), nullptr),
            "H5Sget_simple_extent_dims", place);
    return {dims.begin(), dims.end()};
}

/// Text of variable length, UTF-8; of fixed length where `length` > 0.
Hdf5Handle text_type(std::size_t length, const std::string& place) {
    Hdf5Handle type(checked(H5Tcopy(H5T_C_S1), "H5Tcopy", place), close_type);
    checked(H5Tset_size(type.id(), length > 0 ? length : H5T_VARIABLE), "H5Tset_size", place);
    checked(H5Tset_cset(type.id(), H5T_CSET_UTF8), "H5Tset_cset", place);
    if (length > 0) checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "H5Tset_strpad", place);
    return type;
}

void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value,
                     const std::string& place) {
    const Hdf5Handle space = space_of({}, place);
    const Hdf5Handle attribute(
        checked(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                "H5Acreate2", place),
        close_attribute);
    checked(H5Awrite(attribute.id(), type, value), "H5Awrite", place);
}

/// Of variable length, which readers take as text; of fixed length in a file that several ranks
/// write, where HDF5 does not promise variable ones.
void write_text_attribute(hid_t object, const std::string& name, const std::string& value,
                          bool collective, const std::string& place) {
    if (!collective) {
        const char* text = value.c_str();
        write_attribute(object, name, text_type(0, place).id(), &text, place);
        return;
    }
    std::string padded = value;
    padded.resize(std::max<std::size_t>(value.size(), 1), '\0');
    write_attribute(object, name, text_type(padded.size(), place).id(), padded.data(), place);
}

Hdf5Handle transfer_properties(bool collective, const std::string& place) {
    Hdf5Handle p = properties(H5P_DATASET_XFER, place);
    if (collective) {
        checked(H5Pset_dxpl_mpio(p.id(), H5FD_MPIO_COLLECTIVE), "H5Pset_dxpl_mpio", place);
    }
    return p;
}

hid_t memory_type(bool single) { return single ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE; }

void select_box(const Hdf5Handle& space, H5S_seloper_t how, const Extent& start,
                const Extent& count, const std::string& place) {
    const std::vector<hsize_t> s(start.begin(), start.end()), c(count.begin(), count.end());
    checked(H5Sselect_hyperslab(space.id(), how, s.data(), nullptr, c.data(), nullptr),
            "H5Sselect_hyperslab", place);
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
    if (this != &other) {
        reset();
        id_ = std::exchange(other.id_, -1);
        close_ = other.close_;
    }
    return *this;
}

bool Hdf5Handle::reset() {
    const std::int64_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
}

// --- datasets --------------------------------------------------------------------------------

void Hdf5Dataset::transfer_rows(bool write, std::uint64_t first, std::uint64_t count, bool single,
                                void* values) const {
    Extent start(shape_.size(), 0), box = shape_;
    start.at(0) = first;
    box.at(0) = count;
    const Hdf5Handle file = file_space(id_, place_), memory = space_of(box, place_);
    select_box(file, H5S_SELECT_SET, start, box, place_);
    const Hdf5Handle how = transfer_properties(write && collective_, place_);
    if (write) {
        checked(H5Dwrite(id_.id(), memory_type(single), memory.id(), file.id(), how.id(), values),
                "H5Dwrite", place_);
    } else {
        checked(H5Dread(id_.id(), memory_type(single), memory.id(), file.id(), how.id(), values),
                "H5Dread", place_);
    }
}

void Hdf5Dataset::write_rows(std::uint64_t first, std::uint64_t count, const double* values) {
    transfer_rows(true, first, count, false, const_cast<double*>(values));
}
void Hdf5Dataset::write_rows(std::uint64_t first, std::uint64_t count, const float* values) {
    transfer_rows(true, first, count, true, const_cast<float*>(values));
}
void Hdf5Dataset::read_rows(std::uint64_t first, std::uint64_t count, double* values) const {
    transfer_rows(false, first, count, false, values);
}
void Hdf5Dataset::read_rows(std::uint64_t first, std::uint64_t count, float* values) const {
    transfer_rows(false, first, count, true, values);
}

void Hdf5Dataset::write_columns(const std::vector<int>& columns, const double* values) {
    transfer_columns(columns, false, values);
}
void Hdf5Dataset::write_columns(const std::vector<int>& columns, const float* values) {
    transfer_columns(columns, true, values);
}

void Hdf5Dataset::transfer_columns(const std::vector<int>& columns, bool single,
                                   const void* values) const {
    const Hdf5Handle file = file_space(id_, place_);
    checked(H5Sselect_none(file.id()), "H5Sselect_none", place_);
    // Values of one index of dimension 1; a run of columns that are whole multiples of it is one
    // box, anything else goes value by value.
    std::uint64_t inner = 1;
    for (std::size_t d = 2; d < shape_.size(); ++d) inner *= shape_[d];
    const auto select = [&](std::uint64_t from, std::uint64_t n) {
        Extent start(shape_.size(), 0), box = shape_;
        if (shape_.size() > 1) {
            if (n > 1 || inner == 1) {
                start[1] = from / inner;
                box[1] = n / inner;
            } else {
                for (std::size_t d = shape_.size(); d-- > 1; from /= shape_[d]) {
                    start[d] = from % shape_[d];
                    box[d] = 1;
                }
            }
        }
        select_box(file, H5S_SELECT_OR, start, box, place_);
    };
    for (std::size_t i = 0; i < columns.size();) {
        std::size_t n = 1;
        while (i + n < columns.size() && columns[i + n] == columns[i] + static_cast<int>(n)) ++n;
        const auto from = static_cast<std::uint64_t>(columns[i]);
        if (from % inner == 0 && n % inner == 0) {
            select(from, n);
        } else {
            for (std::size_t k = 0; k < n; ++k) select(from + k, 1);
        }
        i += n;
    }
    const std::uint64_t samples = shape_.at(0);
    const Hdf5Handle memory = space_of({samples * columns.size()}, place_);
    if (columns.empty()) checked(H5Sselect_none(memory.id()), "H5Sselect_none", place_);
    const Hdf5Handle how = transfer_properties(collective_, place_);
    checked(H5Dwrite(id_.id(), memory_type(single), memory.id(), file.id(), how.id(), values),
            "H5Dwrite", place_);
}

std::vector<double> Hdf5Dataset::read_column(std::uint64_t column) const {
    Extent start(shape_.size(), 0), box(shape_.size(), 1);
    box.at(0) = shape_.at(0);
    for (std::size_t d = shape_.size(); d-- > 1; column /= shape_[d]) start[d] = column % shape_[d];
    std::vector<double> values(shape_.at(0));
    const Hdf5Handle file = file_space(id_, place_), memory = space_of({shape_.at(0)}, place_);
    select_box(file, H5S_SELECT_SET, start, box, place_);
    checked(
        H5Dread(id_.id(), H5T_NATIVE_DOUBLE, memory.id(), file.id(), H5P_DEFAULT, values.data()),
        "H5Dread", place_);
    return values;
}

void Hdf5Dataset::attribute(const std::string& name, const std::string& value) {
    write_text_attribute(id_.id(), name, value, collective_, place_);
}

// --- files -----------------------------------------------------------------------------------

Hdf5File Hdf5File::create(const std::filesystem::path& path, const Link* link) {
    prepare_library();
    Hdf5File file;
    file.path_ = path;
    file.collective_ = link != nullptr && link->size() > 1;
    const Hdf5Handle access = properties(H5P_FILE_ACCESS, path.string());
    if (file.collective_) {
        checked(H5Pset_fapl_mpio(access.id(), communicator(*link), MPI_INFO_NULL),
                "H5Pset_fapl_mpio", path.string());
        checked(H5Pset_coll_metadata_write(access.id(), true), "H5Pset_coll_metadata_write",
                path.string());
        checked(H5Pset_all_coll_metadata_ops(access.id(), true), "H5Pset_all_coll_metadata_ops",
                path.string());
    }
    file.id_ = {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()),
                        "H5Fcreate", path.string()),
                close_file};
    return file;
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
    prepare_library();
    Hdf5File file;
    file.path_ = path;
    file.id_ = {
        checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "H5Fopen", path.string()),
        close_file};
    return file;
}

void Hdf5File::close() {
    checked(H5Fflush(id_.id(), H5F_SCOPE_GLOBAL), "H5Fflush", path_.string());
    if (!id_.reset()) fail("H5Fclose", path_.string());
}

std::string Hdf5File::place(const std::string& path) const {
    return fmt::format("{}: {}", path_.string(), path);
}

bool Hdf5File::exists(const std::string& path) const {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        const std::string part = path.substr(0, end);
        if (part != "/" &&
            checked(H5Lexists(id_.id(), part.c_str(), H5P_DEFAULT), "H5Lexists", place(part)) == 0)
            return false;
        if (end == std::string::npos) return true;
    }
}

std::vector<std::string> Hdf5File::children(const std::string& path) const {
    const Hdf5Handle group(
        checked(H5Gopen2(id_.id(), path.c_str(), H5P_DEFAULT), "H5Gopen2", place(path)),
        close_group);
    std::vector<std::string> names;
    const auto take = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    checked(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names), "H5Literate",
            place(path));
    return names;
}

Hdf5Handle Hdf5File::create_raw(const std::string& path, std::int64_t type, std::int64_t space,
                                std::int64_t created) {
    const Hdf5Handle links = properties(H5P_LINK_CREATE, place(path));
    checked(H5Pset_create_intermediate_group(links.id(), 1), "H5Pset_create_intermediate_group",
            place(path));
    return {
        checked(H5Dcreate2(id_.id(), path.c_str(), type, space, links.id(), created, H5P_DEFAULT),
                "H5Dcreate2", place(path)),
        close_dataset};
}

Hdf5Dataset Hdf5File::create_dataset(const std::string& path, const Hdf5Layout& layout) {
    const std::string where = place(path);
    const hid_t type = layout.single_precision ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
    const Hdf5Handle created = properties(H5P_DATASET_CREATE, where);
    if (!layout.chunk.empty()) {
        const std::vector<hsize_t> chunk(layout.chunk.begin(), layout.chunk.end());
        checked(H5Pset_chunk(created.id(), static_cast<int>(chunk.size()), chunk.data()),
                "H5Pset_chunk", where);
        if (layout.deflate) {
            checked(H5Pset_shuffle(created.id()), "H5Pset_shuffle", where);
            checked(H5Pset_deflate(created.id(), 1), "H5Pset_deflate", where);
        }
    }
    if (layout.nan_fill) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        checked(H5Pset_fill_value(created.id(), H5T_NATIVE_DOUBLE, &nan), "H5Pset_fill_value",
                where);
    } else {
        checked(H5Pset_fill_time(created.id(), H5D_FILL_TIME_NEVER), "H5Pset_fill_time", where);
    }
    Hdf5Dataset dataset;
    dataset.id_ = create_raw(path, type, space_of(layout.shape, where).id(), created.id());
    dataset.shape_ = layout.shape;
    dataset.single_precision_ = layout.single_precision;
    dataset.collective_ = collective_;
    dataset.place_ = where;
    return dataset;
}

Hdf5Dataset Hdf5File::dataset(const std::string& path) const {
    Hdf5Dataset dataset;
    dataset.place_ = place(path);
    dataset.id_ = {
        checked(H5Dopen2(id_.id(), path.c_str(), H5P_DEFAULT), "H5Dopen2", dataset.place_),
        close_dataset};
    const Hdf5Handle space = file_space(dataset.id_, dataset.place_);
    dataset.shape_ = extent_of(space, dataset.place_);
    const Hdf5Handle type(checked(H5Dget_type(dataset.id_.id()), "H5Dget_type", dataset.place_),
                          close_type);
    dataset.single_precision_ = H5Tget_size(type.id()) == sizeof(float);
    dataset.collective_ = collective_;
    return dataset;
}

void Hdf5File::write(const std::string& path, std::span<const double> values, const Extent& shape) {
    const std::string where = place(path);
    const Hdf5Handle dataset =
        create_raw(path, H5T_IEEE_F64LE, space_of(shape, where).id(), H5P_DEFAULT);
    checked(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dwrite", where);
}

void Hdf5File::write(const std::string& path, std::span<const std::int64_t> values,
                     const Extent& shape) {
    const std::string where = place(path);
    const Hdf5Handle dataset =
        create_raw(path, H5T_STD_I64LE, space_of(shape, where).id(), H5P_DEFAULT);
    checked(H5Dwrite(dataset.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dwrite", where);
}

void Hdf5File::write_text(const std::string& path, const std::string& text) {
    const std::string where = place(path);
    const Hdf5Handle type = text_type(0, where);
    const Hdf5Handle dataset = create_raw(path, type.id(), space_of({}, where).id(), H5P_DEFAULT);
    const char* value = text.c_str();
    checked(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &value), "H5Dwrite",
            where);
}

void Hdf5File::write_texts(const std::string& path, const std::vector<std::string>& texts) {
    const std::string where = place(path);
    const Hdf5Handle type = text_type(0, where);
    const Hdf5Handle dataset =
        create_raw(path, type.id(), space_of({texts.size()}, where).id(), H5P_DEFAULT);
    std::vector<const char*> values;
    values.reserve(texts.size());
    for (const std::string& text : texts) values.push_back(text.c_str());
    if (values.empty()) return;
    checked(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dwrite", where);
}

void Hdf5File::write_table(const std::string& path, const std::vector<Hdf5Column>& columns) {
    const std::string where = place(path);
    // Each column is one member of the compound; a row is the members side by side.
    struct Member {
        std::size_t offset, size;
        Hdf5Handle type;
    };
    std::vector<Member> members;
    std::size_t row = 0, rows = 0;
    for (const Hdf5Column& column : columns) {
        std::size_t size = 8;
        Hdf5Handle type;
        if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
            size = 1;
            for (const std::string& text : *texts) size = std::max(size, text.size());
            type = text_type(size, where);
        } else {
            const bool real = std::holds_alternative<std::vector<double>>(column.values);
            type = {checked(H5Tcopy(real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64), "H5Tcopy", where),
                    close_type};
        }
        members.push_back({row, size, std::move(type)});
        row += size;
        rows = std::visit([](const auto& values) { return values.size(); }, column.values);
    }
    const Hdf5Handle table(checked(H5Tcreate(H5T_COMPOUND, row), "H5Tcreate", where), close_type);
    std::vector<char> bytes(row * rows, '\0');
    for (std::size_t c = 0; c < columns.size(); ++c) {
        checked(
            H5Tinsert(table.id(), columns[c].name.c_str(), members[c].offset, members[c].type.id()),
            "H5Tinsert", where);
        for (std::size_t r = 0; r < rows; ++r) {
            char* to = bytes.data() + r * row + members[c].offset;
            std::visit(
                [&](const auto& values) {
                    const auto& value = values.at(r);
                    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
                        std::memcpy(to, value.data(), value.size());
                    } else {
                        std::memcpy(to, &value, sizeof value);
                    }
                },
                columns[c].values);
        }
    }
    const Hdf5Handle dataset =
        create_raw(path, table.id(), space_of({rows}, where).id(), H5P_DEFAULT);
    if (rows == 0) return;
    checked(H5Dwrite(dataset.id(), table.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
            "H5Dwrite", where);
}

std::vector<double> Hdf5File::read(const std::string& path) const {
    const Hdf5Dataset data = dataset(path);
    std::uint64_t n = 1;
    for (const std::uint64_t k : data.shape()) n *= k;
    std::vector<double> values(n);
    if (n == 0) return values;
    checked(H5Dread(data.id_.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dread", data.place_);
    return values;
}

std::vector<std::string> Hdf5File::read_texts(const std::string& path) const {
    const Hdf5Dataset data = dataset(path);
    std::uint64_t n = 1;
    for (const std::uint64_t k : data.shape()) n *= k;
    std::vector<std::string> texts;
    if (n == 0) return texts;
    const Hdf5Handle type = text_type(0, data.place_), space = file_space(data.id_, data.place_);
    std::vector<char*> values(n, nullptr);
    checked(H5Dread(data.id_.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dread", data.place_);
    for (const char* value : values) texts.emplace_back(value != nullptr ? value : "");
    checked(H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, values.data()), "H5Dvlen_reclaim",
            data.place_);
    return texts;
}

std::string Hdf5File::read_text(const std::string& path) const { return read_texts(path).at(0); }

void Hdf5File::write_virtual(const std::string& path, const Extent& shape,
                             const std::string& source, const Hdf5Box& box) {
    const std::string where = place(path);
    const Hdf5Dataset from = dataset(source);
    const Hdf5Handle from_space = space_of(from.shape(), where), space = space_of(shape, where);
    select_box(from_space, H5S_SELECT_SET, box.start, box.count, where);
    const Hdf5Handle created = properties(H5P_DATASET_CREATE, where);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    checked(H5Pset_fill_value(created.id(), H5T_NATIVE_DOUBLE, &nan), "H5Pset_fill_value", where);
    checked(H5Pset_virtual(created.id(), space.id(), ".", source.c_str(), from_space.id()),
            "H5Pset_virtual", where);
    const hid_t type = from.single_precision() ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
    create_raw(path, type, space.id(), created.id());
}

void Hdf5File::attribute(const std::string& path, const std::string& name,
                         const std::string& value) {
    const Hdf5Handle object(
        checked(H5Oopen(id_.id(), path.c_str(), H5P_DEFAULT), "H5Oopen", place(path)),
        close_object);
    write_text_attribute(object.id(), name, value, collective_, place(path));
}

void Hdf5File::attribute(const std::string& path, const std::string& name, std::int64_t value) {
    const Hdf5Handle object(
        checked(H5Oopen(id_.id(), path.c_str(), H5P_DEFAULT), "H5Oopen", place(path)),
        close_object);
    write_attribute(object.id(), name, H5T_NATIVE_INT64, &value, place(path));
}

void Hdf5File::attribute(const std::string& path, const std::string& name, bool value) {
    const std::string where = place(path);
    const Hdf5Handle object(checked(H5Oopen(id_.id(), path.c_str(), H5P_DEFAULT), "H5Oopen", where),
                            close_object);
    // The enumeration that h5py reads as a bool.
    const Hdf5Handle type(checked(H5Tenum_create(H5T_STD_I8LE), "H5Tenum_create", where),
                          close_type);
    const signed char no = 0, yes = 1, stored = value ? yes : no;
    checked(H5Tenum_insert(type.id(), "FALSE", &no), "H5Tenum_insert", where);
    checked(H5Tenum_insert(type.id(), "TRUE", &yes), "H5Tenum_insert", where);
    write_attribute(object.id(), name, type.id(), &stored, where);
}

std::string Hdf5File::text_attribute(const std::string& path, const std::string& name) const {
    const std::string where = place(path);
    const Hdf5Handle attribute(
        checked(H5Aopen_by_name(id_.id(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                "H5Aopen_by_name", where),
        close_attribute);
    const Hdf5Handle type(checked(H5Aget_type(attribute.id()), "H5Aget_type", where), close_type);
    if (checked(H5Tis_variable_str(type.id()), "H5Tis_variable_str", where) > 0) {
        char* text = nullptr;
        checked(H5Aread(attribute.id(), type.id(), &text), "H5Aread", where);
        std::string value = text != nullptr ? text : "";
        checked(H5free_memory(text), "H5free_memory", where);
        return value;
    }
    std::string value(H5Tget_size(type.id()), '\0');
    checked(H5Aread(attribute.id(), type.id(), value.data()), "H5Aread", where);
    value.erase(std::find(value.begin(), value.end(), '\0'), value.end());
    return value;
}

std::string hdf5_version() {
    prepare_library();
    unsigned major = 0, minor = 0, release = 0;
    checked(H5get_libversion(&major, &minor, &release), "H5get_libversion", "HDF5");
    return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace hawser::io
