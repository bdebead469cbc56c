// Every class of mistake has a small case in cases/refused; beside it, in a file .expected, stands
// what the reader says of it, line by line. Cases that are valid but doubtful are in
// cases/doubtful.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/case_file.hpp"

namespace hawser::io {
namespace {

namespace fs = std::filesystem;
const fs::path cases = fs::path(HAWSER_SOURCE_DIR) / "tests/common/cases";
const fs::path folder = cases / "refused";

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Without the folders before the names of files.
std::string shortened(std::string text) {
    for (const fs::path& prefix : {folder, cases / "doubtful", cases}) {
        const std::string name = prefix.string() + "/";
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
            text.erase(at, name.size());
        }
    }
    return text;
}

std::string complaint(const fs::path& file) {
    try {
        read_case(file, {});
    } catch (const InputError& e) {
        EXPECT_EQ(e.code(), ExitCode::input);
        return shortened(e.what()) + "\n";
    }
    return "valid\n";
}

TEST(DoubtfulCase, IsReadWithWarningsAndNotes) {
    for (const char* name : {"lines", "mesh", "phase", "platform", "water", "waves"}) {
        std::string said;
        for (const std::string& note :
             read_case(cases / "doubtful" / (std::string(name) + ".yml"), {}).notes) {
            said += shortened(note) + "\n";
        }
        EXPECT_EQ(said, text_of(cases / "doubtful" / (std::string(name) + ".expected")));
    }
}

class WrongCase : public testing::TestWithParam<std::string> {};

TEST_P(WrongCase, IsRefusedWithEveryProblemNamed) {
    const fs::path file = folder / GetParam();
    EXPECT_EQ(complaint(file), text_of(fs::path(file).replace_extension(".expected")));
}

std::vector<std::string> wrong_cases() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yml") names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Folder, WrongCase, testing::ValuesIn(wrong_cases()),
                         [](const auto& test) { return fs::path(test.param).stem().string(); });

}  // namespace
}  // namespace hawser::io
