// The program's parts, from inside.
#include "demos/output/metric_table.h"
#include "demos/runs/run_folder.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/json.h"
#include "demos/tools/pipe.h"
#include "demos/tools/words.h"
#include "program.h"
#include "tests/catch.h"
#include "tests/scratch_folder.h"

#include <plait/solver.h>

#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <limits>
#include <thread>

using namespace plait;
using namespace plait::test;

TEST_CASE("distance of words", "[program]") {
    CHECK(editDistance("", "") == 0);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("kitten", "sitting") == 3);
    CHECK(editDistance("wind", "wnid") == 1);  // a swap
    CHECK(editDistance("ca", "abc") == 3);     // optimal alignment, not Damerau's 2
    CHECK(nearest("seqential", {"interleaved", "sequential"}) == "sequential");
    CHECK(nearest("x", {}).empty());
}

TEST_CASE("numbers are read whole and within their range", "[program]") {
    CHECK(parseNumber("n", "2.5e-1", 0, 1) == 0.25);
    CHECK(parseInteger("n", "-3", -5, 5) == -3);
    for (const char* word : {"", " 1", "1 ", "1x", "inf", "nan", "2", "-0.1", "0x1"})
        CHECK_THROWS_AS(parseNumber("n", word, 0, 1), UsageError);
    CHECK(text(0.1) == "0.1");
    CHECK(text(1.0F / 3) == "0.33333334");
}

TEST_CASE("JSON nests and escapes", "[program]") {
    JsonWriter json;
    json.field("a", "say \"hi\"\n\\").field("b", 0.1).field("c", true);
    json.beginArray("d").field("", 1).field("", 2L).end();
    json.beginObject("e").end();
    json.beginObject("f").field("g", std::numeric_limits<double>::quiet_NaN());
    CHECK(json.finish() ==
          "{\n  \"a\": \"say \\\"hi\\\"\\u000a\\\\\",\n  \"b\": 0.1,\n  \"c\": true,\n"
          "  \"d\": [\n    1,\n    2\n  ],\n  \"e\": {},\n  \"f\": {\n    \"g\": null\n  }\n}\n");
}

TEST_CASE("metrics are written and read back bit for bit", "[program]") {
    const std::vector<Metric> metrics{{.name = "strain", .unit = "%", .measure = {}},
                                      {.name = "count", .unit = "", .measure = {}}};
    const std::vector<MetricRow> rows{{0, 0, 0, {1.0 / 3, 0}}, {1, 0.1, 1L << 40, {-1e-300, 7}}};
    const std::string csv = csvOf(metrics, rows);
    CHECK(csv.starts_with("frame,time[s],evaluations,strain[%],count\n"));
    const auto back = rowsFrom(csv, metrics, "metrics.csv");
    REQUIRE(back.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(back[i].frame == rows[i].frame);
        CHECK(back[i].time == rows[i].time);
        CHECK(back[i].evaluations == rows[i].evaluations);
        CHECK(back[i].values == rows[i].values);
    }
    CHECK_THROWS_AS(rowsFrom("frame\n", metrics, "m"), FileError);
    CHECK_THROWS_AS(rowsFrom(csv + "1,2,3\n", metrics, "m"), FileError);
    CHECK_THROWS_AS(rowsFrom(csv + "1,2,3,4,five\n", metrics, "m"), FileError);
}

TEST_CASE("bands hold from their time on, and NaN lies in none", "[program]") {
    const Metric metric{.name = "m", .unit = "", .measure = {}, .low = 0, .high = 1, .from = 1};
    const auto first = [&](std::vector<MetricRow> rows) {
        return verdictOn(metric, 0, rows).firstOutside;
    };
    CHECK(first({{0, 0, 0, {5}}, {1, 1, 0, {1}}, {2, 2, 0, {0}}}) == -1);
    CHECK(first({{0, 0, 0, {5}}, {1, 1, 0, {1.1}}}) == 1);
    CHECK(first({{1, 1, 0, {std::numeric_limits<double>::quiet_NaN()}}}) == 1);
    CHECK(contains(verdictTable({metric}, {{0, 0, 0, {5}}}), "not reached"));
    CHECK(bandOf(metric) == "[0, 1] from 1 s");
}

TEST_CASE("settings are words that make the same run again", "[program]") {
    const Run run = makeRun({{"method", "nucleus"},
                             {"substeps", "7"},
                             {"knob.length", "0.7"},
                             {"quality", "draft"},
                             {"scene", "pendulum"},
                             {"fps", "30000/1001"}});
    CHECK(run.scene.options.method == Method::nucleus);
    CHECK(run.scene.options.schedule.substeps == 7);
    CHECK(run.frames() == 120);
    const std::string words = textOf(settingsOf(run));
    CHECK(textOf(settingsOf(makeRun(settingsFrom(words)))) == words);
}

// The tasks of a study are processes, and the first ones all write its reference.
// With no outer force a sheet that hangs from two pins does not fall, and goes as one that never
// had any.
TEST_CASE("sets and forces are left out by name", "[program][IN30]") {
    const Settings words{{"scene", "hanging-sheet"}, {"quality", "draft"}, {"without", "gravity"}};
    const Run run = makeRun(words);
    CHECK(valueOf(settingsOf(run), "without") == "gravity");
    CHECK(settingsOf(makeRun(settingsOf(run))) == settingsOf(run));
    CHECK(run.scene.world.forces.empty());
    Run never = makeRun({{"scene", "hanging-sheet"}, {"quality", "draft"}});
    CHECK(valueOf(settingsOf(never), "without").empty());
    never.scene.world.forces.clear();
    const auto after = [](const Run& of) {
        Solver<float> solver(of.scene.world, of.scene.options);
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        const std::vector<Vec<double>> x = solver.positions();
        double moved = 0;
        for (std::size_t v = 0; v < x.size(); ++v)
            moved = std::max(moved, length(x[v] - of.scene.world.start[v]));
        CHECK(moved < 1e-6);
        return solver.hash();
    };
    CHECK(after(run) == after(never));

    const std::size_t parts = partsOf(run).size();
    const Run bare =
        makeRun({{"scene", "hanging-sheet"}, {"quality", "draft"}, {"without", "gravity,mending"}});
    CHECK(partsOf(bare).size() == parts - 1);
    CHECK_THROWS_AS(
        makeRun({{"scene", "hanging-sheet"}, {"quality", "draft"}, {"without", "grvity"}}),
        UsageError);
}

TEST_CASE("two processes may write the same file", "[program]") {
    const ScratchFolder scratch;
    const std::filesystem::path path = scratch / "file";
    const auto writeOften = [&] {
        for (int i = 0; i < 2000; ++i) writeWhole(path, "whole");
    };
    const pid_t other = fork();
    if (other == 0) {
        try {
            writeOften();
        } catch (const FileError&) {
            _exit(1);
        }
        _exit(0);
    }
    REQUIRE(other > 0);
    CHECK_NOTHROW(writeOften());
    int status = -1;
    waitpid(other, &status, 0);
    CHECK(status == 0);
    CHECK(readWhole(path) == "whole");
    CHECK(scratch.count() == 1);
}

TEST_CASE("a pipe waits for room and for items, and ends", "[program][threads]") {
    Pipe<int> pipe(2);
    int sum = 0;
    std::jthread taker([&] {
        while (const auto item = pipe.pop()) sum += *item;
    });
    for (int i = 1; i <= 1000; ++i) CHECK(pipe.push(i));
    pipe.close();
    taker.join();
    CHECK(sum == 500500);
    CHECK_FALSE(pipe.push(1));
}
