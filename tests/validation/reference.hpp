// Numbers that other programs made are not part of the project: a folder given to scripts/validate
// with --reference holds them, and their rows say SKIPPED without it.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace hawser {

/// Folder given with --reference, empty if none.
inline std::string reference_folder() {
    const char* folder = std::getenv("HAWSER_REFERENCE");
    return folder ? folder : "";
}

/// Prints the row of a comparison that cannot be made without the folder.
inline void skip_row(const char* id, const char* what) {
    std::printf("%s | %s | - | - | - | - | SKIPPED\n", id, what);
}

/// Rows of numbers of a file of comma-separated values; lines that do not start with a number are
/// headings. Empty if the file cannot be read.
inline std::vector<std::vector<double>> read_table(const std::string& file) {
    std::vector<std::vector<double>> rows;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::vector<double> row;
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) {
            char* end = nullptr;
            const double x = std::strtod(field.c_str(), &end);
            if (end == field.c_str()) break;
            row.push_back(x);
        }
        if (!row.empty()) rows.push_back(row);
    }
    return rows;
}

}  // namespace hawser
