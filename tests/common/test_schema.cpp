// cases/case.schema.json and cases/reference.yml are what the program writes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "case/declared.hpp"
#include "io/case_file.hpp"
#include "io/case_schema.hpp"

namespace hawser::io {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

const std::filesystem::path cases = std::filesystem::path(HAWSER_SOURCE_DIR) / "cases";

TEST(Schema, TheFileInCasesIsUpToDate) {
    EXPECT_TRUE(case_schema() == text_of(cases / "case.schema.json"))
        << "run: hawser schema -o cases/case.schema.json";
}

TEST(Schema, TheReferenceInCasesIsUpToDate) {
    EXPECT_TRUE(reference_case() == text_of(cases / "reference.yml"))
        << "run: hawser schema --reference -o cases/reference.yml";
}

/// Every available key below a table, by name.
void collect(const Table& table, std::vector<const Key*>& all) {
    for (const Key& key : table.keys) {
        if (key.is_later) continue;
        all.push_back(&key);
        if (key.table != nullptr) collect(key.table(), all);
    }
}

TEST(Keys, EachSaysWhatItMeansAndItsDefaultIsReadable) {
    std::vector<const Key*> keys;
    collect(case_keys(), keys);
    EXPECT_GT(keys.size(), 200U);
    const std::string reference = reference_case();
    for (const Key* key : keys) {
        EXPECT_GT(key->sentence.size(), 3U) << key->name;
        EXPECT_NE(reference.find(key->name + ":"), std::string::npos) << key->name;
    }
}

}  // namespace
}  // namespace hawser::io
