// What becomes of output on machines and under names that are not ours.
#include "demos/tools/words.h"
#include "strangers.h"
#include "tests/render/any_png.h"
#include "tests/scratch_folder.h"

using namespace plait;
using namespace plait::test;

namespace fs = std::filesystem;

namespace {

// plait in a shell; stderr is in `err`.
Outcome shell(const TemporaryFolder& folder, const std::string& command) {
    const int status =
        std::system((command + " 2>" + shellWord((folder / "stderr").string())).c_str());
    return {WEXITSTATUS(status), "", contents(folder / "stderr")};
}

}  // namespace

TEST_CASE("standard output that is lost is an error", "[program][strangers]") {
    const TemporaryFolder folder;
    const std::string program = shellWord(PLAIT_PROGRAM), picture = folder / "a.png";
    writeAnyPng(picture, 2, 2, 8, "abc", "abc");
    for (const std::string& words :
         {std::string("list"), std::string("--help"), std::string("run --help"),
          std::string("describe pendulum"), std::string("study"), std::string("stability"),
          "compare " + picture + " " + picture}) {
        INFO(words);
        refuses(shell(folder, program + " " + words + " >/dev/full"), 5,
                "standard output: cannot be written: No space left on device");
        refuses(shell(folder, program + " " + words + " >&-"), 5,
                "standard output: cannot be written: Bad file descriptor");
    }
    // Nothing is said, so nothing is lost; and no file takes the place of what is closed.
    CHECK(shell(folder, program +
                            " run pendulum -q draft --seconds 0.1 --no-render --quiet --out " +
                            shellWord(folder / "run") + " <&- >&-")
              .status == 0);
    CHECK(contents(folder / "run/metrics.csv").starts_with("frame,"));
}

TEST_CASE("a full disk leaves nothing of an export and says why", "[program][strangers]") {
    const TemporaryFolder folder;
    const std::vector<std::string> words{
        "run",   "hanging-sheet", "--no-render", "--quiet", "-q",
        "draft", "--seconds",     "1",           "--out",   (folder / "run").string()};
    REQUIRE(plait::test::plait(folder, words).status == 0);
    const auto on = [&](rlim_t bytes, const std::string& format) {
        const FullDisk full(bytes);
        return plait::test::plait(folder, with(words, {"--resume", "--export", format}));
    };
    refuses(on(60000, "pc2"), 5, "export/points.pc2: cannot be written: File too large");
    CHECK(fs::is_empty(folder / "run/export"));
    refuses(on(5000, "obj"), 5, "export/00000.obj: cannot be written: File too large");
    CHECK(fs::is_empty(folder / "run/export"));
    CHECK(plait::test::plait(folder, with(words, {"--resume", "--export", "pc2"})).status == 0);
    CHECK(fs::file_size(folder / "run/export/points.pc2") > 60000);
}

TEST_CASE("compare sees alpha and tells what a file is made of", "[program][strangers]") {
    const TemporaryFolder folder;
    const std::string opaque = "abc\xff", clear("abc\0", 4), most = "abc\xfe";
    const auto write = [&](const char* name, int bits, const std::string& first,
                           const std::string& pixel) {
        writeAnyPng(folder / name, 64, 64, bits, first, pixel);
    };
    write("opaque", 8, opaque, opaque);
    write("clear", 8, clear, clear);
    write("one-clear", 8, clear, opaque);
    write("one-nearly", 8, most, opaque);
    write("plain", 8, "abc", "abc");
    write("deep", 16, std::string("a\0b\0c\0", 6), "aabbcc");
    write("grey", 8, "a", "a");
    write("grey-clear", 8, std::string("a\0", 2), std::string("a\0", 2));
    const auto compare = [&](const char* a, const char* b) {
        return plait::test::plait(folder, {"compare", folder / a, folder / b});
    };
    CHECK(compare("opaque", "opaque").status == 0);
    CHECK(compare("clear", "clear").status == 0);
    for (const char* other : {"clear", "one-clear", "one-nearly"}) {
        const Outcome outcome = compare("opaque", other);
        INFO(outcome.out);
        CHECK(outcome.status == 1);
        CHECK(contains(outcome.out, "DIFFERENT"));
        CHECK(contains(outcome.out, "alpha: "));
    }
    CHECK(compare("plain", "clear").status == 1);
    CHECK(compare("grey", "grey-clear").status == 1);
    const Outcome deep = compare("plain", "deep"), same = compare("plain", "opaque");
    CHECK(contains(deep.out, "channels: 3 x 8 bits against 3 x 16 bits"));
    CHECK(same.status == 0);
    CHECK(contains(same.out, "channels: 3 x 8 bits against 4 x 8 bits"));
}

TEST_CASE("no film of another run outlives it", "[program][strangers]") {
    const TemporaryFolder folder;
    REQUIRE(plait::test::plait(folder, pendulumRun(folder, {"--no-render"})).status == 0);
    fs::create_directories(folder / "run/export");
    fs::create_directories(folder / "run/frames");
    const std::vector<std::string> old{"clip.webp", "clip.mp4", "contact.png", "export/00000.ply",
                                       "frames/00001.png"};
    for (const std::string& name : old) std::ofstream(folder / ("run/" + name)) << "old";
    const std::vector<std::string> other{"--no-render", "--set", "length=2", "--force"};
    REQUIRE(plait::test::plait(folder, pendulumRun(folder, other)).status == 0);
    for (const std::string& name : old) {
        INFO(name);
        CHECK_FALSE(fs::exists(folder / ("run/" + name)));
    }
}

TEST_CASE("a word of a shell is the word that it was", "[program][strangers]") {
    const TemporaryFolder folder;
    for (const std::string word : {"plain", "", "a b", "it's", "$HOME", "`x`", "a\"b", "a;b", "~",
                                   "*", "!", "#", "\\", "tab\there", "äö"}) {
        REQUIRE(std::system(
                    ("printf %s " + shellWord(word) + " >" + shellWord((folder / "word").string()))
                        .c_str()) == 0);
        CHECK(contents(folder / "word") == word);
    }
    CHECK(shellWord("out/study-2/a.b") == "out/study-2/a.b");
}

TEST_CASE("every task of a study is a command that runs", "[program][strangers]") {
    const TemporaryFolder folder;
    const std::string out = folder / "my $HOME's drive/st";
    REQUIRE(plait::test::plait(folder, {"study", "unit-spring", "--repeats", "1", "--tasks",
                                        folder / "tasks", "--out", out})
                .status == 0);
    const Outcome first =
        shell(folder, "cd / && sed -n 1p " + shellWord(folder / "tasks") + " | sh >/dev/null");
    INFO(first.err);
    CHECK(first.status == 0);
    CHECK_FALSE(fs::is_empty(fs::path(out) / "rows"));
}

TEST_CASE("pictures of any size are filmed or refused at once", "[program][strangers]") {
    const TemporaryFolder folder;
    for (const char* size : {"16x7680", "7680x16"}) {
        const Outcome outcome =
            plait::test::plait(folder, pendulumRun(folder, {"--frames", "1:1", "--size", size}));
        INFO(size << " " << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(fs::exists(folder / "run/clip.mp4"));
        CHECK(fs::file_size(folder / "run/contact.png") < 1000000);
    }
    for (const char* size : {"100000x100000", "4294967312x16", "16x7681", "-16x16", "0x0"})
        refuses(plait::test::plait(folder, pendulumRun(folder, {"--size", size})), 2, "16 to 7680");
}

TEST_CASE("a frame rate is told how to be written", "[program][strangers]") {
    const TemporaryFolder folder;
    for (const char* rate : {"29.97", "23.976", "59.94", "29,97", "0", "-24", "1e9", "24/0", "24/",
                             "/2", "24/1/1", "inf"})
        refuses(plait::test::plait(folder, pendulumRun(folder, {"--fps", rate})), 2,
                "29.97 is 30000/1001");
    refuses(
        plait::test::plait(folder, {"run", "pendulum", "--fps", "1000000", "--seconds", "3600"}), 2,
        "frames are more than");
}
