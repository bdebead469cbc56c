#include "io/hdf5_calls.hpp"

namespace hawser::io {

using namespace hdf5;

namespace {

Hdf5Handle transfer_properties(bool collective, const std::string& place) {
    Hdf5Handle p = properties(H5P_DATASET_XFER, place);
    if (collective) {
        checked(H5Pset_dxpl_mpio(p.id(), H5FD_MPIO_COLLECTIVE), "H5Pset_dxpl_mpio", place);
    }
    return p;
}

hid_t memory_type(bool single) { return single ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE; }

}  // namespace

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

}  // namespace hawser::io
