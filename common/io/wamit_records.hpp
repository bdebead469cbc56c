// WAMIT numeric files as rows of numbers with their line numbers, and a collector of what is wrong
// with them. WAMIT manual ch. 4: free format, one record a line, at most one header line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hawser::io {

/// One complaint about a file; line 0: the file as a whole.
struct FileProblem {
    std::string file;
    int line = 0;
    std::string message;
};

/// Collects problems so that all of them are reported at once.
class FileProblems {
 public:
    void add(const std::filesystem::path& file, int line, std::string message);
    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] const std::vector<FileProblem>& list() const { return list_; }
    /// One line each: `truss_spar.3:17: error: ...`. After 20 of one file, how many more there are.
    [[nodiscard]] std::string text() const;

 private:
    std::vector<FileProblem> list_;
};

/// A number as Fortran may write it: 1.0, +1.0E+01, 1.0D+01. None if the word is no finite number.
std::optional<double> fortran_number(std::string word);

struct Record {
    int line = 0;
    std::vector<double> numbers;
};

/// Records of a file. A first line whose first word is not a number is a header; empty lines are
/// skipped; anything else that is not a number, or fewer than `columns` numbers, is a problem.
std::vector<Record> read_records(const std::filesystem::path& file, std::size_t columns,
                                 FileProblems& problems);

}  // namespace hawser::io
