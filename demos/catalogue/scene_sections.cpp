// Sections of a scene's page: knobs, metrics, needs, charts, tests, sources, commands.
#include "demos/tools/words.h"
#include "films.h"
#include "site.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plait {
namespace {

std::string shortNumber(double value) {
    char word[32];
    std::snprintf(word, sizeof word, "%.3g", value);
    return word;
}

std::string withUnit(const std::string& value, const std::string& unit) {
    return escaped(unit.empty() ? value : value + " " + unit);
}

std::string bandWords(const Metric& metric) {
    const bool low = std::isfinite(metric.low), high = std::isfinite(metric.high);
    if (low && high && metric.low == metric.high) return "exactly " + text(metric.low);
    if (low && high) return text(metric.low) + " to " + text(metric.high);
    if (high) return "at most " + text(metric.high);
    if (low) return "at least " + text(metric.low);
    return "shown, not held";
}

// Maps that are drawn with what is a scene here; they have worlds of their own, like the scene's.
const std::multimap<std::string, std::string> mapsOfScenes{{"bullet", "speed-thickness"},
                                                           {"chain", "mass-ratio"},
                                                           {"chain", "stiffness-ratio"},
                                                           {"chain", "chain-length"},
                                                           {"chain", "rotation"},
                                                           {"hanging-sheet", "resolution"},
                                                           {"hanging-sheet", "bdf2-sweeps"},
                                                           {"heavy-rod", "rod-segments"},
                                                           {"layered-sheets", "layers-passes"},
                                                           {"slinky", "stairs"},
                                                           {"unit-spring", "step-stiffness"}};

// Those of the scene; else the one that says most of what it is made of.
std::vector<std::string> mapsShown(const SceneFacts& scene) {
    std::vector<std::string> maps;
    const auto [from, to] = mapsOfScenes.equal_range(scene.entry->name);
    for (auto at = from; at != to; ++at) maps.push_back(at->second);
    for (const Topic* topic : scene.topics())
        if (maps.empty() && topic->sort == TopicSort::constraint && topic->name != "stretch" &&
            !topic->maps.empty())
            maps.push_back(topic->maps.front());
    return maps;
}

// Where the pages of its ingredients show how these fail.
std::vector<std::string> otherMaps(const SceneFacts& scene, const std::vector<std::string>& shown) {
    std::vector<std::string> links;
    for (const Topic* topic : scene.topics())
        for (const std::string& map : topic->maps)
            if (std::ranges::count(shown, map) == 0)
                links.push_back(
                    linkTo("../" + folderOf(topic->sort) + "/" + topic->name + ".html#failures",
                           topic->title + ": " + stabilityMapNamed(map).title));
    return links;
}

}  // namespace

namespace {

// Clips of a knob side by side, or "" where none was filmed.
std::string knobClips(const Site& site, const SceneFacts& scene, const Knob& knob) {
    const std::string& name = scene.entry->name;
    std::string html;
    for (const std::string& value : shownValues(knob)) {
        const std::string clip = site.left.knobClip(name, knob.name, value);
        if (clip.empty()) continue;
        const std::string words =
            knob.name + " " + value + (knob.unit.empty() ? "" : " " + knob.unit);
        const std::string own = knob.isNumber() ? text(knob.value) : knob.text;
        html += "<figure>" +
                clipOf("../" + clip, "../" + site.left.knobPicture(name, knob.name, value),
                       scene.entry->title + " with " + words) +
                "<figcaption>" + escaped(words) + (value == own ? ", as it is by itself" : "") +
                "</figcaption></figure>\n";
    }
    return html.empty() ? "" : "<div class=\"beside\">\n" + html + "</div>\n";
}

}  // namespace

std::string knobSection(const Site& site, const SceneFacts& scene) {
    std::vector<std::vector<std::string>> rows;
    for (const Knob& knob : scene.entry->knobs) {
        std::string range = knob.isFile() ? "a file" : escaped(joined(knob.choices));
        if (knob.isNumber()) range = withUnit(text(knob.low) + " to " + text(knob.high), knob.unit);
        const std::string value = knob.isNumber()     ? withUnit(text(knob.value), knob.unit)
                                  : knob.text.empty() ? "none"
                                                      : escaped(knob.text);
        rows.push_back(
            {"<code>" + escaped(knob.name) + "</code>", escaped(knob.meaning), value, range});
    }
    if (rows.empty())
        return sectionOf(
            "knobs", "What you can turn",
            "<p>It has no knobs of its own. Any option of the solver can be changed, as "
            "the length of a step:</p>" +
                commandLine("build/plait run " + scene.entry->name + " -q " + scene.quality +
                            " --substeps " + std::to_string(std::max(1, scene.substeps / 2))));
    std::string clips;
    bool all = true;
    for (const Knob& knob : scene.entry->knobs) {
        clips += knobClips(site, scene, knob);
        all = all && std::ranges::none_of(shownValues(knob), [&](const std::string& value) {
                  return site.left.knobClip(scene.entry->name, knob.name, value).empty();
              });
    }
    if (!all)
        clips += missing(
            clips.empty() ? "Nobody has filmed its knobs at other values yet."
                          : "Not all values of its knobs are filmed yet.",
            "build/plait catalogue --film --only " + scene.entry->name + " -q " + scene.quality);
    const Knob& first = scene.entry->knobs.front();
    const std::string other = first.isNumber() ? text(first.high)
                              : first.isFile() ? "FILE"
                                               : first.choices.back();
    return sectionOf(
        "knobs", "What you can turn",
        tableOf("Knobs", {"knob", "what it is", "by itself", "may be"}, rows) + clips +
            "<p>Turn one like this:</p>" +
            commandLine("build/plait run " + scene.entry->name + " -q " + scene.quality +
                        " --set " + shellWord(first.name + "=" + other)));
}

std::string metricSection(const Site& site, const SceneFacts& scene) {
    const std::string& name = scene.entry->name;
    const std::vector<MetricRow> measured = site.left.measured(name, scene.metrics);
    std::vector<std::string> header{"metric", "unit", "must be", "from"};
    if (!measured.empty()) header.insert(header.end(), {"least", "most", "verdict"});
    std::vector<std::vector<std::string>> rows;
    for (std::size_t m = 0; m < scene.metrics.size(); ++m) {
        const Metric& metric = scene.metrics[m];
        std::vector<std::string>& row = rows.emplace_back(std::vector<std::string>{
            "<code>" + escaped(metric.name) + "</code>", escaped(metric.unit),
            escaped(bandWords(metric)), metric.from > 0 ? text(metric.from) + " s" : "the start"});
        if (measured.empty()) continue;
        const Verdict verdict = verdictOn(metric, m, measured);
        row.insert(row.end(), {shortNumber(verdict.least), shortNumber(verdict.most),
                               bandOf(metric).empty() ? "–"
                               : verdict.firstOutside < 0
                                   ? "holds"
                                   : "broken at frame " + std::to_string(verdict.firstOutside)});
    }
    std::string html =
        "<p>Each run is measured frame by frame, and must stay within these bands.</p>" +
        tableOf("Metrics at " + scene.quality, header, rows);
    for (const std::string& fact : scene.closedForms)
        html += "<p class=\"note\">By a closed form: " + escaped(fact) + "</p>";
    html += measured.empty() ? missing("No run has been measured here.",
                                       "build/plait check " + name + " -q " + scene.quality)
                             : "<p>Measured in the run that the clip shows.</p>\n";
    return sectionOf("metrics", "What is measured", html);
}

std::string ledgerSection(const Site& site, const SceneFacts& scene) {
    const std::string& name = scene.entry->name;
    const std::string ask = "build/plait ablate " + name + " -q " + scene.quality;
    const std::optional<Ledger> ledger = site.left.ledger(name);
    if (!ledger)
        return sectionOf(
            "needs", "What it needs",
            missing("Nobody has asked yet which of its ingredients this scene needs.", ask));
    std::vector<std::vector<std::string>> rows;
    for (const LedgerRow& row : ledger->rows) {
        const bool moved = !row.changes.empty() && row.changes[row.mostMoved()] > 0;
        rows.push_back(
            {escaped(row.part), escaped(row.change), shortNumber(100 * row.work) + " %",
             row.ending != "complete" ? "it ends early"
             : moved                  ? escaped(ledger->metrics[row.mostMoved()].name)
                                      : "none",
             moved ? rounded("%.2g", row.changes[row.mostMoved()]) : "0",
             "<span class=\"need " + wordOf(row.need) + "\">" + wordOf(row.need) + "</span>"});
    }
    const std::string chart = site.left.ledgerChart(name);
    std::string html =
        "<p>Each ingredient was left out, or made cheaper, by itself. It is needed if a metric "
        "moves by "
        "more than its tolerance; needless if it costs more than 2 % of the counted work and moves "
        "nothing.</p>";
    if (!chart.empty())
        html += R"(<img class="chart" src="../)" + chart +
                "\" alt=\"What each ingredient saves and "
                "what it moves\">";
    html += tableOf(
        "Needs of " + scene.entry->title + " at " + valueOf(ledger->settings, "quality"),
        {"ingredient", "change", "work saved", "moves most", "tolerances", "verdict"}, rows);
    return sectionOf("needs", "What it needs", html + "<p>Made by:</p>" + commandLine(ask));
}

std::string studySection(const Site& site, const SceneFacts& scene) {
    std::string html;
    for (const Study& study : studies()) {
        if (valueOf(study.model, "scene") != scene.entry->name) continue;
        const std::string chart = site.left.studyChart(study.name),
                          ask = "build/plait study " + study.name;
        html += "<h3>" + escaped(study.title) + "</h3>";
        html += chart.empty()
                    ? missing("This study has not been run here.", ask)
                    : R"(<img class="chart" src="../)" + chart + "\" alt=\"" +
                          escaped("Error against time: " + study.title) + "\">" + commandLine(ask);
    }
    if (html.empty()) return "";
    return sectionOf(
        "accuracy", "Speed against accuracy",
        "<p>Each mark is a method with a setting: how long it takes, and how far it is "
        "from one converged reference of the same model. Low and to the left is best.</p>" +
            html);
}

std::string failureSection(const Site& site, const SceneFacts& scene) {
    const std::vector<std::string> shown = mapsShown(scene);
    std::string html;
    for (const std::string& name : shown) html += mapFigure(site, stabilityMapNamed(name));
    if (const std::vector<std::string> others = otherMaps(scene, shown); !others.empty())
        html += "<h3>Its ingredients and its method, each by itself</h3>" + listOf(others);
    if (html.empty()) return "";
    return sectionOf("failures", "Where it fails",
                     "<p>What this scene is made of, taken to where it breaks.</p>" + html);
}

std::string mapFigure(const Site& site, const StabilityMap& map) {
    const std::string chart = site.left.mapChart(map), ask = "build/plait stability " + map.name;
    return "<h3>" + escaped(map.title) + "</h3><p>" + escaped(map.words) + "</p>" +
           (chart.empty() ? missing("This map has not been drawn here.", ask)
                          : R"(<img class="chart" src="../)" + chart + "\" alt=\"" +
                                escaped("Where methods hold and fail: " + map.title) +
                                R"(" loading="lazy">)" + commandLine(ask));
}

std::string testSection(Site& site, const SceneFacts& scene) {
    std::vector<std::string> items;
    std::vector<std::string> ids;
    for (const SeedTest* test : site.seeds.running(scene.entry->name)) {
        items.push_back(site.sourceLink("../", test->file, test->line, test->name) +
                        (test->isLong() ? " <small>(long)</small>" : ""));
        for (const std::string& id : test->rows())
            if (std::ranges::count(ids, id) == 0) ids.push_back(id);
    }
    std::string html =
        items.empty()
            ? "<p>No test runs this scene by its name but those that every scene passes: its "
              "bands, its pictures, its bits on any number of threads.</p>"
            : "<p>Tests that run this scene, beside those that every scene passes: its bands, "
              "its pictures, its bits on any number of threads. Each says what it holds.</p>" +
                  listOf(items);
    if (!ids.empty())
        html += "<h3>Rows of the seeds that these hold</h3>" + listOf(site.rowLinks(ids, "../"));
    return sectionOf(
        "tests", "What it is validated against",
        html + commandLine("build/plait check " + scene.entry->name + " -q " + scene.quality));
}

std::string sourceSection(Site& site, const SceneFacts& scene) {
    const Sources::Place place = site.sources.sceneBuilder(scene.entry->name);
    std::vector<std::string> items{
        "The scene: " + site.sourceLink("../", place.file, place.line),
        "Its lesson, knobs and what it leaves out: " +
            site.sourceLink(
                "../", "scenes/scene.cpp",
                site.sources.lineOf("scenes/scene.cpp", ".name = \"" + scene.entry->name + "\","))};
    for (const Topic* topic : scene.topics())
        items.push_back(escaped(topic->title) + ": " + site.sourceLink("../", topic->header, 0));
    return sectionOf("source", "Its source", listOf(items));
}

std::string commandSection(const SceneFacts& scene) {
    const std::string name = scene.entry->name, quality = " -q " + scene.quality;
    const std::vector<std::vector<std::string>> rows{
        {"the clip", commandLine("demos/run " + name)},
        {"the same, small and soon", commandLine("build/plait run " + name + quality)},
        {"all that the scene says of itself",
         commandLine("build/plait describe " + name + quality)},
        {"whether its metrics stay in their bands",
         commandLine("build/plait check " + name + quality)},
        {"the table of needs", commandLine("build/plait ablate " + name + quality)},
        {"the cheapest settings that keep its metrics",
         commandLine("build/plait tune " + name + quality)},
        {"this page", commandLine("build/plait catalogue --only " + name)}};
    return sectionOf("commands", "Make it yourself", tableOf("Commands", {"what", "by"}, rows));
}

}  // namespace plait
