// What the files of the HDF5 door share: checked calls, their failures in words, and the small
// objects of the library. Private to hdf5_*.cpp.
#pragma once

#include <hdf5.h>

#include <string>

#include "io/hdf5.hpp"

namespace hawser::io::hdf5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// Throws RunError(ExitCode::io): the place (file: /path), the call, the library's own words.
[[noreturn]] void fail(const char* call, const std::string& place);

/// The result of a call, checked: HDF5 says failure with a negative number.
template <class T>
T checked(T result, const char* call, const std::string& place) {
    if (result < 0) fail(call, place);
    return result;
}

// Closers of the library as functions of one type.
inline int close_file(std::int64_t id) { return H5Fclose(id); }
inline int close_group(std::int64_t id) { return H5Gclose(id); }
inline int close_dataset(std::int64_t id) { return H5Dclose(id); }
inline int close_space(std::int64_t id) { return H5Sclose(id); }
inline int close_type(std::int64_t id) { return H5Tclose(id); }
inline int close_properties(std::int64_t id) { return H5Pclose(id); }
inline int close_attribute(std::int64_t id) { return H5Aclose(id); }
inline int close_object(std::int64_t id) { return H5Oclose(id); }

/// Before the first call: errors are reported by RunError alone, not printed by the library as
/// well, and the library does not tidy up when the program ends: everything is closed by its owner,
/// and what could not be closed because the disk is full would crash it there (seen with 1.10.8).
void prepare_library();

Hdf5Handle properties(hid_t cls, const std::string& place);
Hdf5Handle space_of(const Extent& shape, const std::string& place);
Hdf5Handle file_space(const Hdf5Handle& dataset, const std::string& place);
Extent extent_of(const Hdf5Handle& space, const std::string& place);
void select_box(const Hdf5Handle& space, H5S_seloper_t how, const Extent& start,
                const Extent& count, const std::string& place);
/// Text of variable length, UTF-8; of fixed length where `length` > 0.
Hdf5Handle text_type(std::size_t length, const std::string& place);

/// A scalar attribute of an open object.
void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value,
                     const std::string& place);
/// Of variable length, which readers take as text; of fixed length in a file that several ranks
/// write, where HDF5 does not promise variable ones.
void write_text_attribute(hid_t object, const std::string& name, const std::string& value,
                          bool collective, const std::string& place);

}  // namespace hawser::io::hdf5
