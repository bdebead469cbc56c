#include <algorithm>
#include <cstring>

#include "io/hdf5_calls.hpp"

namespace hawser::io {

using namespace hdf5;

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
    const Hdf5Handle stored(checked(H5Dget_type(data.id_.id()), "H5Dget_type", data.place_),
                            close_type);
    if (checked(H5Tis_variable_str(stored.id()), "H5Tis_variable_str", data.place_) == 0) {
        std::size_t length = H5Tget_size(stored.id());
        std::string all(n * length, '\0');
        checked(H5Dread(data.id_.id(), stored.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()),
                "H5Dread", data.place_);
        if (length == 1 && !data.shape().empty()) length = data.shape().back();
        for (std::size_t i = 0; i < all.size(); i += length) {
            std::string text = all.substr(i, length);
            text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
            texts.push_back(std::move(text));
        }
        return texts;
    }
    const Hdf5Handle type = text_type(0, data.place_), space = file_space(data.id_, data.place_);
    // The library does not convert between character sets.
    checked(H5Tset_cset(type.id(), H5Tget_cset(stored.id())), "H5Tset_cset", data.place_);
    std::vector<char*> values(n, nullptr);
    checked(H5Dread(data.id_.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "H5Dread", data.place_);
    for (const char* value : values) texts.emplace_back(value != nullptr ? value : "");
    checked(H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, values.data()), "H5Dvlen_reclaim",
            data.place_);
    return texts;
}

std::vector<std::string> Hdf5File::dimensions(const std::string& path) const {
    const Hdf5Dataset data = dataset(path);
    std::vector<std::string> names;
    const std::size_t rank = data.shape().size();
    const auto name_of = [&](hid_t object) {
        std::string name(256, '\0');
        const auto length =
            checked(H5Iget_name(object, name.data(), name.size()), "H5Iget_name", data.place_);
        name.resize(std::min<std::size_t>(static_cast<std::size_t>(length), 255));
        return name.substr(name.rfind('/') + 1);
    };
    const char* list = "DIMENSION_LIST";
    if (checked(H5Aexists(data.id_.id(), list), "H5Aexists", data.place_) == 0) {
        if (rank == 1) names.push_back(name_of(data.id_.id()));  // a scale of its own
        return names;
    }
    const Hdf5Handle attribute(
        checked(H5Aopen(data.id_.id(), list, H5P_DEFAULT), "H5Aopen", data.place_),
        close_attribute);
    const Hdf5Handle type(checked(H5Tvlen_create(H5T_STD_REF_OBJ), "H5Tvlen_create", data.place_),
                          close_type);
    std::vector<hvl_t> scales(rank, hvl_t{0, nullptr});
    checked(H5Aread(attribute.id(), type.id(), scales.data()), "H5Aread", data.place_);
    for (const hvl_t& scale : scales) {
        if (scale.len == 0) {
            names.emplace_back();
            continue;
        }
        const Hdf5Handle object(
            checked(H5Rdereference2(data.id_.id(), H5P_DEFAULT, H5R_OBJECT, scale.p),
                    "H5Rdereference2", data.place_),
            close_object);
        names.push_back(name_of(object.id()));
    }
    const Hdf5Handle space = space_of({rank}, data.place_);
    checked(H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, scales.data()), "H5Dvlen_reclaim",
            data.place_);
    return names;
}

std::string Hdf5File::read_text(const std::string& path) const { return read_texts(path).at(0); }

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

void Hdf5File::attribute(const std::string& path, const std::string& name,
                         std::span<const double> values) {
    const std::string where = place(path);
    const Hdf5Handle object(checked(H5Oopen(id_.id(), path.c_str(), H5P_DEFAULT), "H5Oopen", where),
                            close_object);
    const Hdf5Handle space = space_of({values.size()}, where);
    const Hdf5Handle attribute(checked(H5Acreate2(object.id(), name.c_str(), H5T_NATIVE_DOUBLE,
                                                  space.id(), H5P_DEFAULT, H5P_DEFAULT),
                                       "H5Acreate2", where),
                               close_attribute);
    checked(H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, values.data()), "H5Awrite", where);
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

}  // namespace hawser::io
