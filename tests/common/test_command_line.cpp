#include <gtest/gtest.h>

#include <vector>

#include "io/command_line.hpp"

namespace hawser::io {
namespace {

CommandLine parse(std::vector<const char*> words) {
    words.insert(words.begin(), "hawser");
    return parse_command_line(static_cast<int>(words.size()), words.data());
}

TEST(CommandLine, RunTakesItsOptions) {
    const CommandLine line =
        parse({"run", "a.yml", "--out", "there", "--force", "--set", "environment.waves[0].Hs=12 m",
               "--set", "parameters.x=a=b", "--duration", "600 s", "--seed", "7", "--dry-run",
               "--progress", "none", "-q"});
    ASSERT_FALSE(line.finished) << line.message;
    EXPECT_EQ(line.command, CommandLine::Command::run);
    EXPECT_EQ(line.case_file, "a.yml");
    EXPECT_EQ(line.out, "there");
    EXPECT_TRUE(line.force && line.dry_run && line.quiet);
    EXPECT_EQ(line.progress, ProgressStyle::none);
    const std::vector<std::pair<std::string, std::string>> expected{
        {"environment.waves[0].Hs", "12 m"},
        {"parameters.x", "a=b"},
        {"analysis.dynamics.duration", "600 s"},
        {"environment.waves[0].seed", "7"}};
    EXPECT_EQ(line.overrides, expected);
    EXPECT_NE(line.text.find("'environment.waves[0].Hs=12 m'"), std::string::npos);
}

TEST(CommandLine, OtherCommandsTakeTheirs) {
    const CommandLine check = parse({"check", "a.yml", "--echo", "--json", "--set", "a.b=1"});
    EXPECT_EQ(check.command, CommandLine::Command::check);
    EXPECT_TRUE(check.echo && check.json);
    EXPECT_EQ(check.overrides.size(), 1U);
    const CommandLine schema = parse({"schema", "--reference", "-o", "r.yml"});
    EXPECT_EQ(schema.command, CommandLine::Command::schema);
    EXPECT_TRUE(schema.reference);
    EXPECT_EQ(schema.output_file, "r.yml");
    const CommandLine statics = parse({"statics", "a.yml", "--offset", "0:10:2.5", "--heading",
                                       "90", "--lines", "ml*", "-o", "c.csv"});
    EXPECT_EQ(statics.command, CommandLine::Command::statics);
    EXPECT_EQ(statics.statics.offsets, (std::vector<double>{0, 2.5, 5, 7.5, 10}));
    EXPECT_DOUBLE_EQ(statics.statics.heading, M_PI / 2);
    EXPECT_EQ(statics.statics.lines, "ml*");
    EXPECT_FALSE(statics.statics.free);
    const auto free =
        parse({"statics", "a.yml", "--offset", "5", "--free", "heave,pitch"}).statics.free;
    ASSERT_TRUE(free);
    EXPECT_TRUE(free->heave && free->pitch && !free->roll && !free->yaw && !free->transverse);
    EXPECT_FALSE(
        parse({"statics", "a.yml", "--offset", "5", "--free", "none"}).statics.free->any());
    EXPECT_TRUE(
        parse({"statics", "a.yml", "--offset", "5", "--free", "all"}).statics.free->transverse);
    EXPECT_EQ(parse({"statics", "a.yml", "--offset", "5", "--free", "surge"}).finished,
              ExitCode::command_line);
    EXPECT_EQ(parse({"statics", "a.yml", "--offset", "-5,0,5"}).statics.offsets,
              (std::vector<double>{-5, 0, 5}));
    EXPECT_TRUE(parse({"check", "a.yml", "--statics"}).with_statics);
    const CommandLine modes = parse({"modes", "a.yml", "--count", "7", "--line", "scr*", "--json"});
    EXPECT_EQ(modes.command, CommandLine::Command::modes);
    EXPECT_EQ(modes.modes.count, 7);
    EXPECT_EQ(modes.modes.lines, "scr*");
    EXPECT_EQ(parse({"version"}).command, CommandLine::Command::version);
}

TEST(CommandLine, WrongOnesEndWithCodeTwo) {
    const std::vector<std::vector<const char*>> wrong{
        {},
        {"sail"},
        {"run"},
        {"run", "a.yml", "--colour"},
        {"run", "a.yml", "b.yml"},
        {"run", "a.yml", "--progress", "loud"},
        {"run", "a.yml", "--set", "environment"},
        {"run", "a.yml", "--set"},
        {"check", "a.yml", "--out", "x"},
        {"version", "x"},
        {"statics", "a.yml", "--offset", "0:10"},
        {"statics", "a.yml", "--offset", "0:10:-1"},
        {"statics", "a.yml", "--offset", "five"},
        {"statics", "a.yml", "--heading", "90"},  // of the offset
        {"statics", "a.yml", "--free", "heave"},
        {"statics", "a.yml", "--lines", "ml*"},
        {"modes", "a.yml", "--count", "0"},
    };
    for (const auto& words : wrong) {
        const CommandLine line = parse(words);
        ASSERT_TRUE(line.finished) << (words.empty() ? "" : words.back());
        EXPECT_EQ(*line.finished, ExitCode::command_line);
        EXPECT_FALSE(line.message.empty());
    }
}

TEST(CommandLine, HelpTellsEveryOption) {
    const CommandLine all = parse({"--help"});
    ASSERT_EQ(all.finished, ExitCode::done);
    for (const char* command : {"run", "check", "schema", "version"}) {
        EXPECT_NE(all.message.find(command), std::string::npos) << command;
    }
    const CommandLine run = parse({"run", "--help"});
    ASSERT_EQ(run.finished, ExitCode::done);
    for (const char* option : {"--out", "--force", "--set", "--duration", "--seed", "--dry-run",
                               "--progress", "--quiet", "Exit codes", "runs/"}) {
        EXPECT_NE(run.message.find(option), std::string::npos) << option;
    }
}

}  // namespace
}  // namespace hawser::io
