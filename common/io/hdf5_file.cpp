#include <fmt/format.h>

#include <limits>

#include "io/hdf5_calls.hpp"
#include "io/link.hpp"
#include "io/link_mpi.hpp"

namespace hawser::io {

using namespace hdf5;

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

}  // namespace hawser::io
