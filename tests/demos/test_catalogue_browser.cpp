// The effects catalogue in a real browser: no error, clips that play, keys alone, narrow and wide,
// light, dark and on paper.
#include "browser.h"
#include "page_checks.h"
#include "scenes/scene.h"
#include "site_reader.h"
#include "tests/catch.h"

#include <chrono>
#include <cstdlib>
#include <thread>

using namespace plait;
using namespace plait::test;

namespace {

namespace fs = std::filesystem;

// A site with two clips, made once.
const fs::path& siteRoot() {
    static const TemporaryFolder folder;
    static const fs::path root = [] {
        for (const char* scene : {"pendulum", "band"})
            REQUIRE(plait::test::plait(folder, {"run", scene, "-q", "draft", "--seconds", "0.5",
                                                "--size", "320x180", "--quiet", "--out",
                                                (folder / "runs").string() + "/" + scene})
                        .status == 0);
        const Outcome made = plait::test::plait(
            folder, {"catalogue", "--quiet", "--sources", PLAIT_ROOT, "--out",
                     (folder / "site").string(), "--runs", (folder / "runs").string()});
        INFO(made.err);
        REQUIRE(made.status == 0);
        return folder / "site";
    }();
    return root;
}

std::string addressOf(const std::string& page) { return "file://" + (siteRoot() / page).string(); }

// Of each sort one or more: the front, demos and lessons, topics, the dictionary, a source.
const std::vector<std::string> pagesToSee{"index.html",
                                          "scenes/flag.html",
                                          "scenes/pendulum.html",
                                          "scenes/liquid.html",
                                          "scenes/slinky.html",
                                          "scenes/band.html",
                                          "constraints/bend.html",
                                          "constraints/contact.html",
                                          "constraints/index.html",
                                          "methods/xpbd.html",
                                          "methods/index.html",
                                          "air/air.html",
                                          "dictionary.html",
                                          "validated.html",
                                          "limits.html",
                                          "source/scenes/flag.cpp.html"};

void saysNothing(Browser& browser) {
    for (const std::string& line : browser.console()) FAIL_CHECK(line);
}

// One folder for what a person may look at.
void keep(Browser& browser, const std::string& name) {
    const fs::path folder = fs::path(PLAIT_PAGES) / "catalogue";
    fs::create_directories(folder);
    std::ofstream(folder / (name + ".png"), std::ios::binary) << browser.picture();
}

// What a script returns, as soon as it returns that; after 10 s, whatever it returns.
std::string soon(Browser& browser, const std::string& script, const std::string& expected) {
    std::string said = browser.run(script);
    for (int n = 0; n < 200 && said != expected; ++n) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        said = browser.run(script);
    }
    return said;
}

// One for all tests: it takes seconds to begin.
Browser& theBrowser() {
    static const TemporaryFolder home;
    static Browser browser(home / "");
    browser.emulate("screen", "light");
    browser.resize(1440, 900);
    return browser;
}

bool noBrowser() {
    if (Browser::isHere()) return false;
    SUCCEED();  // a test without any assertion fails
    WARN("skipped: chromium and chromedriver are not here (apt install chromium chromium-driver)");
    return true;
}

}  // namespace

TEST_CASE(
    "catalogue in a browser: no error, nothing cut off, nothing faint, narrow and wide, light "
    "and dark",
    "[effects-catalogue][browser]") {
    if (noBrowser()) return;
    Browser& browser = theBrowser();
    for (const std::string& page : pagesToSee) {
        browser.open(addressOf(page));
        for (const int width : {1440, 390}) {
            browser.resize(width, 900);
            INFO(page << " at " << width);
            CHECK(browser.run(
                      "return Math.max(0, document.documentElement.scrollWidth - innerWidth)") ==
                  "0");
            CHECK(browser.run("return [...document.images].filter(i => i.loading !== 'lazy' && "
                              "!i.naturalWidth).map(i => i.src)") == "");
            for (const char* colors : {"light", "dark"}) {
                browser.emulate("screen", colors);
                INFO(colors);
                if (width == 1440) CHECK(browser.run(faintWords) == "");
                if (page == "index.html" || page == "scenes/flag.html" ||
                    page == "dictionary.html" || page == "validated.html" || page == "limits.html")
                    keep(browser, fs::path(page).stem().string() + "-" + std::to_string(width) +
                                      "-" + colors);
            }
        }
        INFO(page);
        CHECK(browser.run(unnamed) == "");
        saysNothing(browser);
    }
}

TEST_CASE("catalogue in a browser: every clip plays, over and over, without sound",
          "[effects-catalogue][browser]") {
    if (noBrowser()) return;
    Browser& browser = theBrowser();
    for (const char* page : {"index.html", "scenes/pendulum.html", "scenes/band.html"}) {
        INFO(page);
        browser.open(addressOf(page));
        const std::string played = browser.run(R"(
            const clips = [...document.querySelectorAll('video')], stuck = [];
            for (const clip of clips) {
                clip.scrollIntoView({block: 'center'});
                const end = performance.now() + 8000;
                let ended = false, before = 0;
                while (performance.now() < end && !ended) {
                    await new Promise(wake => setTimeout(wake, 50));
                    ended = clip.currentTime < before;  // round again
                    before = clip.currentTime;
                }
                if (!ended || clip.error || !clip.muted || !clip.videoWidth)
                    stuck.push(clip.src + ' at ' + clip.currentTime);
            }
            return clips.length + ' ' + stuck.join(' ');)");
        CHECK(played == (std::string(page) == "index.html" ? "2 " : "1 "));
        saysNothing(browser);
    }
}

TEST_CASE("catalogue in a browser: keys alone find, filter, open and lecture",
          "[effects-catalogue][browser]") {
    if (noBrowser()) return;
    Browser& browser = theBrowser();
    browser.open("about:blank");
    browser.open(addressOf("index.html"));
    const auto shown = [&] {
        return browser.run(
            "return [...document.querySelectorAll('.card:not([hidden]) h2')].map("
            "h => h.textContent).join()");
    };
    SECTION("the first key leads to the content, and what has the focus is seen") {
        browser.press("Tab");
        CHECK(browser.run("return document.activeElement.textContent") == "Skip to the content");
        for (int n = 0; n < 20; ++n) {
            browser.press("Tab");
            CHECK(browser.run("const e = document.activeElement, box = e.getBoundingClientRect();"
                              "return getComputedStyle(e).outlineStyle + (box.bottom > 0 && "
                              "box.top < innerHeight)") == "solidtrue");
        }
    }
    SECTION("search finds scenes, and words that are on no card") {
        browser.press("/");
        for (const char* letter : {"s", "l", "i", "n", "k", "y"}) browser.press(letter);
        CHECK(contains(shown(), "Slinky on the stairs"));
        CHECK_FALSE(contains(shown(), "Flag"));
        CHECK(
            contains(browser.run("return document.querySelector('#found').textContent"), "scenes"));
        CHECK(contains(browser.run("return location.hash"), "search=slinky"));
        browser.open(addressOf("index.html#search=friction"));
        CHECK(contains(browser.run("return document.querySelector('.other').textContent"),
                       "Static Threshold"));
    }
    SECTION("filters by effect, constraint, method and section of the seeds") {
        for (const auto& [hash, there, gone] :
             {std::tuple{"effect=liquid", "Liquid", "Flag"},
              {"constraint=rod", "Slinky on the stairs", "Liquid"},
              {"method=newton", "Pendulum", "Liquid"},
              {"seeds=fl", "Liquid", "Pendulum"}}) {
            browser.open(addressOf("dictionary.html"));
            browser.open(addressOf(std::string("index.html#") + hash));
            INFO(hash);
            CHECK(contains(shown(), there));
            CHECK_FALSE(contains(shown(), gone));
        }
    }
    SECTION("a lecture goes from thing to thing, and from scene to scene") {
        browser.open(addressOf("scenes/band.html"));
        browser.press("l");
        const auto heading = [&](const std::string& expected) {
            return soon(browser,
                        "return [...document.querySelectorAll('.slide')].filter(s => "
                        "s.checkVisibility()).map(s => s.querySelector('h1, h2').textContent)",
                        expected);
        };
        CHECK(heading("Band") == "Band");
        keep(browser, "lecture");
        browser.press("ArrowRight");
        CHECK(heading("What it is made of") == "What it is made of");
        keep(browser, "lecture-schedule");
        browser.press("Space");
        CHECK(heading("Its equations") == "Its equations");
        keep(browser, "lecture-equations");
        browser.press("ArrowLeft");
        CHECK(heading("What it is made of") == "What it is made of");
        browser.press("Escape");
        CHECK(soon(browser, "return document.body.className", "") == "");
        browser.open(addressOf("scenes/band.html#lecture-end"));
        browser.press("ArrowRight");
        CHECK(soon(browser, "return document.title", "Bullet · Plait") == "Bullet · Plait");
        CHECK(soon(browser, "return document.body.className", "lecture") == "lecture");
    }
    SECTION("the keys are told") {
        browser.press("?");
        CHECK(soon(browser, "return document.querySelector('dialog')?.open", "true") == "true");
        browser.press("Escape");
        CHECK(soon(browser, "return document.querySelector('dialog')", "null") == "null");
    }
    saysNothing(browser);
}

TEST_CASE("catalogue in a browser: on paper there is what it says, and nothing to click",
          "[effects-catalogue][browser]") {
    if (noBrowser()) return;
    Browser& browser = theBrowser();
    browser.resize(760, 1000);
    browser.emulate("print", "light");
    for (const char* page : {"index.html", "scenes/flag.html", "dictionary.html"}) {
        INFO(page);
        browser.open(addressOf(page));
        CHECK(browser.run("return [...document.querySelectorAll('nav, form, footer')].filter("
                          "e => e.checkVisibility()).length") == "0");
        CHECK(browser.run(
                  "return Math.max(0, document.documentElement.scrollWidth - innerWidth)") == "0");
        CHECK(browser.run(faintWords) == "");
        keep(browser, fs::path(page).stem().string() + "-print");
    }
}

// axe-core is no package of Debian: its file is named by who has it.
TEST_CASE("catalogue in a browser: axe-core finds nothing", "[effects-catalogue][browser]") {
    const char* const axe = std::getenv("PLAIT_AXE");
    if (!axe) {
        SUCCEED();
        WARN("skipped: PLAIT_AXE names no axe.min.js");
        return;
    }
    if (noBrowser()) return;
    Browser& browser = theBrowser();
    const std::string script = contents(axe);
    for (const std::string& page : pagesToSee)
        for (const char* colors : {"light", "dark"}) {
            INFO(page << ", " << colors);
            browser.emulate("screen", colors);
            browser.open(addressOf(page));
            CHECK(browser.run(script +
                              "\n;const found = await axe.run(); return found.violations.map("
                              "v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, "
                              "120)).join(' | ')).join('\\n')") == "");
        }
}
