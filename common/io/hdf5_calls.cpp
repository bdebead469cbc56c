#include "io/hdf5_calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "status.hpp"

namespace hawser::io {

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

namespace hdf5 {
namespace {

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

}  // namespace

void fail(const char* call, const std::string& place) {
    throw RunError(ExitCode::io, fmt::format("{}: {}: {}", place, call, library_words()));
}

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

void select_box(const Hdf5Handle& space, H5S_seloper_t how, const Extent& start,
                const Extent& count, const std::string& place) {
    const std::vector<hsize_t> s(start.begin(), start.end()), c(count.begin(), count.end());
    checked(H5Sselect_hyperslab(space.id(), how, s.data(), nullptr, c.data(), nullptr),
            "H5Sselect_hyperslab", place);
}

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

}  // namespace hdf5

std::string hdf5_version() {
    hdf5::prepare_library();
    unsigned major = 0, minor = 0, release = 0;
    hdf5::checked(H5get_libversion(&major, &minor, &release), "H5get_libversion", "HDF5");
    return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace hawser::io
