// The run's folder: an earlier result is safe, foreign files are never touched, a status is whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "common/io/folder.hpp"
#include "io/files.hpp"
#include "io/run_folder.hpp"

namespace {

using namespace hawser;
using namespace hawser::io;
using testing::HasSubstr;
namespace fs = std::filesystem;

void touch(const fs::path& path) { std::ofstream(path) << "x"; }

std::string text_of(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The error of a call that must fail.
template <class Call>
RunError error_of(Call&& call) {
    try {
        call();
    } catch (const RunError& error) {
        return error;
    }
    return RunError(ExitCode::done, "nothing was thrown");
}

TEST(RunFolder, IsMadeWithItsParents) {
    const test::Folder folder;
    prepare_run_folder(folder.path / "runs" / "case", false);
    EXPECT_TRUE(fs::is_directory(folder.path / "runs" / "case"));
    EXPECT_EQ(default_run_folder("truss_spar"), fs::path("runs") / "truss_spar");
}

TEST(RunFolder, KeepsAnEarlierResultUnlessForced) {
    for (const char* trace : {"result.h5", "status.json", "segment_00003.h5"}) {
        const test::Folder folder;
        touch(folder.path / trace);
        const RunError error = error_of([&] { prepare_run_folder(folder.path, false); });
        EXPECT_EQ(error.code(), ExitCode::io);
        EXPECT_THAT(error.what(), HasSubstr(folder.path.string()));
        EXPECT_THAT(error.what(), HasSubstr("--force"));
        EXPECT_TRUE(fs::exists(folder.path / trace));
        prepare_run_folder(folder.path, true);
        EXPECT_FALSE(fs::exists(folder.path / trace));
    }
}

TEST(RunFolder, DeletesOnlyFilesItKnows) {
    const test::Folder folder;
    const std::vector<std::string> own{
        "result.h5",   "result.h5.part", "summary.txt",      "statistics.csv",       "log.txt",
        "status.json", "STOP",           "segment_00001.h5", "segment_00002.h5.part"};
    const std::vector<std::string> foreign{"notes.txt", "result.h5.bak", "segment_one.h5",
                                           "case.yml", "old_segment_00001.h5"};
    for (const std::string& name : own) touch(folder.path / name);
    for (const std::string& name : foreign) touch(folder.path / name);
    fs::create_directory(folder.path / "figures");
    touch(folder.path / "figures" / "result.h5");
    prepare_run_folder(folder.path, true);
    for (const std::string& name : own) EXPECT_FALSE(fs::exists(folder.path / name)) << name;
    for (const std::string& name : foreign) EXPECT_TRUE(fs::exists(folder.path / name)) << name;
    EXPECT_TRUE(fs::exists(folder.path / "figures" / "result.h5"));
}

TEST(RunFolder, ThatIsAFileIsRefused) {
    const test::Folder folder;
    touch(folder.path / "file");
    const RunError error = error_of([&] { prepare_run_folder(folder.path / "file", true); });
    EXPECT_EQ(error.code(), ExitCode::io);
    EXPECT_THAT(error.what(), HasSubstr("is a file"));
}

TEST(RunFolder, SeesAStopFile) {
    const test::Folder folder;
    EXPECT_FALSE(stop_requested(folder.path));
    touch(folder.path / "STOP");
    EXPECT_TRUE(stop_requested(folder.path));
}

TEST(Status, IsJsonWithItsKeysAndQuotesItsMessage) {
    const RunState state{.state = RunState::State::failed,
                         .exit_code = ExitCode::diverged,
                         .message = "line \"scr\"\n\\ t = 3",
                         .t = 31.25,
                         .saved_to = 30.0,
                         .wall_s = 0.1};
    const std::string text = to_json(state);
    EXPECT_THAT(
        text,
        testing::StartsWith(
            "{\"state\": \"failed\", \"exit_code\": 5, \"message\": \"line \\\"scr\\\"\\u000a\\\\ "
            "t = 3\", \"t\": 31.25, \"saved_to\": 30, \"wall_s\": 0.1, \"pid\": " +
            std::to_string(::getpid()) + ", \"host\": \""));
    EXPECT_THAT(text, testing::EndsWith("\"}\n"));
}

TEST(Status, IsReplacedWhole) {
    const test::Folder folder;
    write_status(folder.path, {});
    EXPECT_THAT(text_of(folder.path / "status.json"), HasSubstr("\"running\""));
    write_status(folder.path, {.state = RunState::State::done, .message = ""});
    EXPECT_THAT(text_of(folder.path / "status.json"), HasSubstr("\"done\""));
    EXPECT_FALSE(fs::exists(folder.path / "status.json.part"));
}

TEST(Files, ThatCannotBeWrittenAreErrorsOfInputAndOutputWithTheirPath) {
    const RunError error =
        error_of([] { write_atomically("/proc/no_such_place/status.json", "text"); });
    EXPECT_EQ(error.code(), ExitCode::io);
    EXPECT_THAT(error.what(), HasSubstr("/proc/no_such_place/status.json"));
    EXPECT_THAT(error.what(), HasSubstr("No such file"));
}

TEST(Files, OnAFullDiskAreErrorsWithTheSystemsWords) {
    // /dev/full is a disk without room: every write to it fails.
    const test::Folder folder;
    fs::create_symlink("/dev/full", folder.path / "summary.txt.part");
    const RunError error = error_of([&] { write_atomically(folder.path / "summary.txt", "text"); });
    EXPECT_EQ(error.code(), ExitCode::io);
    EXPECT_THAT(error.what(), HasSubstr("No space left on device"));
}

TEST(Log, GrowsLineByLine) {
    const test::Folder folder;
    RunLog log(folder.path);
    log.line("first");
    EXPECT_THAT(text_of(folder.path / "log.txt"), HasSubstr("Z  first\n"));
    log.line("second");
    EXPECT_THAT(text_of(folder.path / "log.txt"), HasSubstr("Z  second\n"));
    RunLog().line("nowhere");  // a log without a folder keeps quiet
}

}  // namespace
